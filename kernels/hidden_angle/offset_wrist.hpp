// Six turning joints, the second and third parallel, across the first, the fourth and fifth meeting in a point P: the offset
// wrists of the Motoman EA1400N, the Fanuc CRX, the Kinova Jaco.
//
// With the last joint's angle theta chosen, P and the direction of axis 5 are known. P lies in the plane of upper arm and
// forearm, which fixes joint 1 up to two sides (+u and -u, its distance along the plane), and the triangle shoulder, elbow, P has two
// shapes. What is left is one condition: axis 4 must meet axis 5 under their constant angle. In the plane, with v from the
// shoulder to P, d from the elbow to P, and w the part of axis 5 that turns with d, it reads d.w = g beside
// d.v = K and |d| = l. Eliminating d,
//
//   N(u) = l^2 (v x w)^2 - K^2 |w|^2 + 2 K g v.w - g^2 |v|^2 = 0,
//
// and N(u) N(-u) rho^4, rho the distance of P from axis 1, is a trigonometric polynomial of degree 8 in theta: at most 16
// solutions. Where neither an offset nor a twist tells the two sides apart (CRX) N is even in u, N rho^2 has
// degree 4, and each of its 8 roots gives two solutions. Roots: trigonometric_roots.hpp. A pose where anything
// is delicate is handed to the general solver. Templates over the number type.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

// The arm with its joints at zero, in a frame with z along axis 1, y along axis 2, and axis 2 at height zero; lengths of one.
struct OffsetWrist : HiddenAngle {
  static constexpr const char* name = "offset_wrist";
  static constexpr const char* doc = "Parallel second and third axes across the first, the fourth and fifth meeting.";
  static constexpr int joints = 6, slots = 16;
  bool alike;                     // neither an offset nor a twist tells the arm's two sides apart
  double to_base[3][3], base[3];  // world -> that frame
  double from_tool[3][3];         // rotation: that frame -> tool, at zero
  Vector sixth;                   // from the tool's point to the foot of P on axis 6
  Vector lever, lever_turned;     // from there to P, and axis 6 crossed with it
  Vector fifth[3];                // axis 5: its part along axis 6, its part across it, axis 6 crossed with that
  Vector axis6;
  double shoulder, lateral, upper,
      fore;  // a1: axis 2 from axis 1; b: P out of axis 1's plane; lengths to and from the elbow
  double elbow_c, elbow_s, fore_c, fore_s;  // directions of upper arm and forearm in the plane (x, z)
  double lean_c, lean_s;                    // from the forearm's direction to axis 4's in the plane
  double tilt_c, tilt_s;                    // of axis 4 out of the plane
  double bend;                              // cosine of the angle of axes 4 and 5
  double sense3;                            // -1 where axis 3 points against axis 2
  // axis 4; what of axis 5 lies across it, over its length squared; axis 4 crossed with that; the same of axis 6 and axis 5
  Vector axis4, across4, over4, across5, over5;

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    HiddenAngle::fields(self, visit);
    visit("backward", self.backward), visit("alike", self.alike), visit("to_base", self.to_base),
        visit("base", self.base);
    visit("from_tool", self.from_tool), visit("sixth", self.sixth), visit("lever", self.lever);
    visit("lever_turned", self.lever_turned), visit("fifth", self.fifth), visit("axis6", self.axis6);
    visit("shoulder", self.shoulder), visit("lateral", self.lateral), visit("upper", self.upper),
        visit("fore", self.fore);
    visit("elbow_c", self.elbow_c), visit("elbow_s", self.elbow_s), visit("fore_c", self.fore_c),
        visit("fore_s", self.fore_s);
    visit("lean_c", self.lean_c), visit("lean_s", self.lean_s), visit("tilt_c", self.tilt_c),
        visit("tilt_s", self.tilt_s);
    visit("bend", self.bend), visit("sense3", self.sense3), visit("axis4", self.axis4), visit("across4", self.across4);
    visit("over4", self.over4), visit("across5", self.across5), visit("over5", self.over5);
  }
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "hidden_angle/hidden_angle.hpp"

namespace pieper::PIEPER_ISA::offset_wrist {

using namespace hidden_angle;
using Arm = OffsetWrist;

// A pose as the arm sees it.
template <class F> struct Target {
  F at[3], lever[3], lever_turned[3], fifth[3][3], axis6[3];
};

template <class F> PIEPER_INLINE void turned_from(const F (*D)[3], Vector v, F* out) {
  for (int i = 0; i < 3; ++i) out[i] = D[i][0] * v.x + D[i][1] * v.y + D[i][2] * v.z;
}

template <class F> PIEPER_INLINE Target<F> see(const Arm& arm, const RigidT<F>& pose) {
  F turned[3][3], D[3][3], p[3];
  for (int i = 0; i < 3; ++i) {
    const double* b = arm.to_base[i];
    for (int j = 0; j < 3; ++j) turned[i][j] = b[0] * pose.r(0, j) + b[1] * pose.r(1, j) + b[2] * pose.r(2, j);
    p[i] = (b[0] * (pose.p(0) - arm.base[0]) + b[1] * (pose.p(1) - arm.base[1]) + b[2] * (pose.p(2) - arm.base[2])) *
           (1 / arm.length);
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      D[i][j] =
          turned[i][0] * arm.from_tool[0][j] + turned[i][1] * arm.from_tool[1][j] + turned[i][2] * arm.from_tool[2][j];
  Target<F> out;
  turned_from(D, arm.sixth, out.at);
  for (int i = 0; i < 3; ++i) out.at[i] = out.at[i] + p[i];
  turned_from(D, arm.lever, out.lever);
  turned_from(D, arm.lever_turned, out.lever_turned);
  for (int k = 0; k < 3; ++k) turned_from(D, arm.fifth[k], out.fifth[k]);
  turned_from(D, arm.axis6, out.axis6);
  return out;
}

// The condition N, and the quantities on the way to it. X: a number or a Surd; Y: a number, of what is the same on both sides.
template <class X, class Y = X> struct Condition {
  X v0;
  Y v1;
  X w0, w1, K, g, N;
};

// u: P's distance along the plane; across, level: u5.r and u5.z; out: u5.n; h: P's height.
template <class X, class Y>
PIEPER_INLINE Condition<X, Y> condition(const Arm& arm, X u, X across, X out, Y level, Y h) {
  Condition<X, Y> c;
  const double l2 = arm.fore * arm.fore;
  c.v0 = u + (-arm.shoulder);
  c.v1 = h;
  c.w0 = arm.lean_c * across + arm.lean_s * level;
  c.w1 = (-arm.lean_s) * across + arm.lean_c * level;
  const X V = c.v0 * c.v0 + c.v1 * c.v1, s = c.v0 * c.w0 + c.v1 * c.w1, area = c.v0 * c.w1 - c.v1 * c.w0;
  c.K = 0.5 * (V + (l2 - arm.upper * arm.upper));
  c.g = (-arm.fore * arm.tilt_s / arm.tilt_c) * out + arm.bend * arm.fore / arm.tilt_c;
  const X W = (-1.0) * (out * out) + 1.0, kg = c.K * c.g;
  c.N = l2 * (area * area) - c.K * c.K * W + 2.0 * (kg * s) - c.g * c.g * V;
  return c;
}

// P and axis 5 at the angle (c, s) of the last joint.
template <class F> struct At {
  F P[3], axis5[3];
};
template <class F> PIEPER_INLINE At<F> at_angle(const Target<F>& t, F c, F s) {
  At<F> out;
  for (int i = 0; i < 3; ++i) {
    out.P[i] = t.at[i] + c * t.lever[i] - s * t.lever_turned[i];
    out.axis5[i] = t.fifth[0][i] + c * t.fifth[1][i] - s * t.fifth[2][i];
  }
  return out;
}

// N(u) N(-u) rho^4.
template <class F> F polynomial_of_sides(const Arm& arm, const Target<F>& t, F c, F s) {
  const At<F> at = at_angle(t, c, s);
  const F along = at.P[0] * at.axis5[0] + at.P[1] * at.axis5[1], past = at.P[0] * at.axis5[1] - at.P[1] * at.axis5[0];
  const F rho2 = at.P[0] * at.P[0] + at.P[1] * at.P[1], inv = 1.0 / max(rho2, F(kHiddenOnAxis));
  const double b = arm.lateral;
  const F u2 = rho2 - b * b;
  const Surd<F> u = {F(0.0), F(1.0), u2}, across = {-b * past * inv, along * inv, u2},
                out = {b * along * inv, past * inv, u2};
  const Surd<F> N = condition(arm, u, across, out, at.axis5[2], at.P[2]).N;
  return (N.x * N.x - u2 * N.y * N.y) * rho2 * rho2;
}

// N rho^2 where nothing tells the sides apart: a1 = b = 0, axis 4 along the forearm, in the plane.
template <class F> F polynomial_of_alike(const Arm& arm, const Target<F>& t, F c, F s) {
  const At<F> at = at_angle(t, c, s);
  const F along = at.P[0] * at.axis5[0] + at.P[1] * at.axis5[1], past = at.P[0] * at.axis5[1] - at.P[1] * at.axis5[0];
  const F rho2 = at.P[0] * at.P[0] + at.P[1] * at.P[1], h = at.P[2], level = at.axis5[2];
  const double l2 = arm.fore * arm.fore, g = arm.bend * arm.fore / arm.tilt_c;
  const F V = rho2 + h * h, K = 0.5 * (V + (l2 - arm.upper * arm.upper)), area = rho2 * level - h * along;
  const F dot = arm.lean_c * (along + h * level);
  return l2 * (area * area) - K * K * (rho2 - past * past) + rho2 * (g * (2.0 * (K * dot) - g * V));
}

// All of `from` where `here`, else what `to` is; both are made of nothing but numbers of type F.
template <class F, class X> PIEPER_INLINE void pick_where(Mask<F> here, const X& from, X& to) {
  const F* of = reinterpret_cast<const F*>(&from);
  F* into = reinterpret_cast<F*>(&to);
  for (unsigned k = 0; k < sizeof(X) / sizeof(F); ++k) into[k] = select(here, of[k], into[k]);
}

// What an angle says: P, axis 5, and the condition on one side.
template <class F> struct Seen {
  At<F> at;
  F along, past, rho2, over_rho2, u;  // u: without its sign
};
template <class F> PIEPER_INLINE Seen<F> see_at(const Arm& arm, const Target<F>& target, Motion<F> theta) {
  Seen<F> x;
  x.at = at_angle(target, theta.c, theta.s);
  const F *P = x.at.P, *e = x.at.axis5;
  x.along = P[0] * e[0] + P[1] * e[1];
  x.past = P[0] * e[1] - P[1] * e[0];
  x.rho2 = P[0] * P[0] + P[1] * P[1];
  x.over_rho2 = 1.0 / max(x.rho2, F(kHiddenOnAxis));
  x.u = sqrt(max(x.rho2 - arm.lateral * arm.lateral, F(0.0)));
  return x;
}
template <class F> struct OnSide {
  F u, across, out;
  Condition<F> on;
};
template <class F> PIEPER_INLINE OnSide<F> on_side(const Arm& arm, const Seen<F>& x, F side) {
  OnSide<F> s;
  s.u = side * x.u;
  s.across = (s.u * x.along - arm.lateral * x.past) * x.over_rho2;
  s.out = (s.u * x.past + arm.lateral * x.along) * x.over_rho2;
  s.on = condition(arm, s.u, s.across, s.out, x.at.axis5[2], x.at.P[2]);
  return s;
}

// The two shapes of the triangle, and by how much axis 4 fails to meet axis 5 in each: d.w - g.
template <class F> struct Triangle {
  F V, over_V, room, bent, up, down;
};
template <class F> PIEPER_INLINE Triangle<F> triangle_of(const Arm& arm, const Condition<F>& c) {
  Triangle<F> t;
  t.V = c.v0 * c.v0 + c.v1 * c.v1;
  t.over_V = 1.0 / max(t.V, F(kTiny));
  t.room = arm.fore * arm.fore * t.V - c.K * c.K;
  t.bent = sqrt(max(t.room, F(0.0)));
  const F even = c.K * (c.v0 * c.w0 + c.v1 * c.w1), odd = t.bent * (c.v0 * c.w1 - c.v1 * c.w0);
  t.up = (even + odd) * t.over_V - c.g;
  t.down = (even - odd) * t.over_V - c.g;
  return t;
}

// A root found on the arm's own condition, and by what the joints follow.
template <class F> struct Settled {
  Motion<F> theta;
  Seen<F> seen;
  OnSide<F> now;  // on the root's side; of sides that are alike on one, of which the other is the mirror image
  F sign;         // which shape of the triangle
  Mask<F> unclear;
};

// From a root of the polynomial with this slope. Where the sides are not alike the root's is found out.
template <class F, bool Alike> Settled<F> settle(const Arm& arm, const Target<F>& target, Motion<F> theta, F slope) {
  const double l = arm.fore, l2 = l * l;
  Seen<F> seen = see_at(arm, target, theta);
  auto size_of = [&](const Condition<F>& c) { return l2 * (c.v0 * c.v0 + c.v1 * c.v1) + c.K * c.K; };
  OnSide<F> now;
  Mask<F> unclear;
  F side(1.0);
  if constexpr (Alike) {
    // of N rho^2 where N vanishes
    now = on_side(arm, seen, side);
    slope = slope * seen.over_rho2;
    unclear = !(seen.u > kHiddenAside);
  } else {
    // of N(u) N(-u) rho^4 where N(u) vanishes: the root's side is the one on which the condition is nearer to holding
    const OnSide<F> plus = on_side(arm, seen, F(1.0)), minus = on_side(arm, seen, F(-1.0));
    const F up = abs(plus.on.N), down = abs(minus.on.N), nearer = min(up, down), farther = max(up, down);
    const auto first = up <= down;
    side = select(first, F(1.0), F(-1.0));
    now = minus;
    pick_where<F>(first, plus, now);
    const F other = select(first, minus.on.N, plus.on.N) * (seen.rho2 * seen.rho2);
    slope = slope / select(other == 0.0, F(kTiny), other);
    unclear = !(seen.u > kHiddenAside) | !(farther > kHiddenRoom * size_of(now.on)) | !(nearer < kHiddenSide * farther);
  }
  const F size = size_of(now.on);
  F sign(1.0), before(0.0), change(0.0);
  auto done = mask_of<F>(false);  // such lanes stay as they are, whatever the others need
  // steps of Newton's on d.w - g, which is less troubled by rounding than N: N = -|v|^2 times it times the same of the triangle's other
  // shape. The polynomial's root is so near as a rule that one is enough; where roots are close the slope is taken anew, by a secant.
  for (int step = 0; step < 4; ++step) {
    const Triangle<F> t = triangle_of(arm, now.on);
    const auto first = abs(t.up) <= abs(t.down);
    const F own = select(first, t.up, t.down), other = select(first, t.down, t.up), value = own * t.V * other;
    sign = select(done, sign, select(first, F(1.0), F(-1.0)));
    if (step) {
      const F secant = (before - value) / select(change == 0.0, F(kTiny), change);
      slope = select(abs(change) > kHiddenNearRoot, secant, slope);
    } else {
      unclear = unclear | !(t.room > kHiddenRoom * size) | !(abs(slope) > kHiddenSlope * size) |
                !(abs(other) > kHiddenSlope * l);
    }
    before = value;
    change = select(done, change, value / select(slope == 0.0, F(kTiny), slope));
    unclear = unclear | !(abs(change) < (step ? kHiddenLastStep : kHiddenFirstStep));
    const Motion<F> next = advanced(theta, change);
    theta = {select(done, theta.c, next.c), select(done, theta.s, next.s)};
    seen = see_at(arm, target, theta);
    now = on_side(arm, seen, side);
    done = done | (abs(change) < kHiddenNearRoot) | unclear;
    if (all(done)) break;
  }
  unclear = unclear | !(abs(change) < kHiddenNearRoot);
  return {theta, seen, now, sign, unclear};
}

// The joints of a settled root, or, where `side` is -1, of its mirror image in the plane of axis 1 and P's foot on it.
template <class F>
PIEPER_INLINE void posture(const Arm& arm, const Target<F>& target, const Settled<F>& root, double side, Motion<F>* q) {
  const double b = arm.lateral;
  const Seen<F>& seen = root.seen;
  const Triangle<F> t = triangle_of(arm, root.now.on);
  const At<F>& at = seen.at;
  const F u = side * root.now.u, across = side * root.now.across, out = side * root.now.out, level = at.axis5[2];
  const F v0 = side * root.now.on.v0, v1 = root.now.on.v1, K = root.now.on.K, bent = side * (root.sign * t.bent);
  const F invr = seen.over_rho2;
  const F d0 = (K * v0 - bent * v1) * t.over_V, d1 = (K * v1 + bent * v0) * t.over_V;
  const double per_upper = 1 / arm.upper, per_fore = 1 / arm.fore;
  const Motion<F> elbow = unit_again(per_upper * (v0 - d0), per_upper * (v1 - d1));
  const Motion<F> fore = unit_again(per_fore * d0, per_fore * d1);
  const Motion<F> r = unit_again((u * at.P[0] + b * at.P[1]) * invr, (u * at.P[1] - b * at.P[0]) * invr);
  q[0] = r;
  // a plane angle grows from x to z, a turn about y the other way
  q[1] = {arm.elbow_c * elbow.c + arm.elbow_s * elbow.s, arm.elbow_s * elbow.c - arm.elbow_c * elbow.s};
  const Motion<F> both = {arm.fore_c * fore.c + arm.fore_s * fore.s, arm.fore_s * fore.c - arm.fore_c * fore.s};
  q[2] = {both.c * q[1].c + both.s * q[1].s, arm.sense3 * (both.s * q[1].c - both.c * q[1].s)};
  // directions as the forearm saw them at zero
  auto back = [&](F along, F across_plane, F up_z, F* y) {
    y[0] = along * both.c - up_z * both.s;
    y[1] = across_plane;
    y[2] = along * both.s + up_z * both.c;
  };
  auto on = [](const F* y, Vector e) { return y[0] * e.x + y[1] * e.y + y[2] * e.z; };
  F y[3];
  back(across, out, level, y);
  q[3] = unit_again(on(y, arm.across4), on(y, arm.over4));
  const F* six = target.axis6;
  back(six[0] * r.c + six[1] * r.s, six[1] * r.c - six[0] * r.s, six[2], y);
  const Vector k = arm.axis4;  // and before joint 4 turned (Rodrigues' formula)
  const F lift = on(y, k) * (1.0 - q[3].c);
  const F z[3] = {y[0] * q[3].c - (k.y * y[2] - k.z * y[1]) * q[3].s + lift * k.x,
                  y[1] * q[3].c - (k.z * y[0] - k.x * y[2]) * q[3].s + lift * k.y,
                  y[2] * q[3].c - (k.x * y[1] - k.y * y[0]) * q[3].s + lift * k.z};
  q[4] = unit_again(on(z, arm.across5), on(z, arm.over5));
  q[5] = root.theta;
}

template <bool Alike> struct Family {
  static constexpr int degree = Alike ? 4 : 8, samples = Alike ? 12 : 20, slots = 16;
  static constexpr bool both = Alike;
  using Arm = offset_wrist::Arm;
  template <class F> using Target = offset_wrist::Target<F>;
  template <class F> static Target<F> see(const Arm& arm, const RigidT<F>& pose) {
    return offset_wrist::see(arm, pose);
  }
  template <class F> static F polynomial(const Arm& arm, const Target<F>& target, Motion<F> angle) {
    if constexpr (Alike) return polynomial_of_alike(arm, target, angle.c, angle.s);
    else return polynomial_of_sides(arm, target, angle.c, angle.s);
  }
  template <class F> static Mask<F> wanting(const Arm&, const Target<F>&) { return F(0.0) > F(1.0); }
  template <class F> using Settled = offset_wrist::Settled<F>;
  template <class F>
  static Settled<F> settle(const Arm& arm, const Target<F>& target, Motion<F> root, F slope, Mask<F>& unclear) {
    const Settled<F> settled = offset_wrist::settle<F, Alike>(arm, target, root, slope);
    unclear = settled.unclear;
    return settled;
  }
  template <class F>
  static void posture(const Arm& arm, const Target<F>& target, const Settled<F>& root, double side, Motion<F>* q) {
    offset_wrist::posture(arm, target, root, side, q);
  }
};

}  // namespace pieper::PIEPER_ISA::offset_wrist

namespace pieper::PIEPER_ISA {

class OffsetWristKernel {
 public:
  static constexpr bool in_order = true;
  explicit OffsetWristKernel(const OffsetWrist& arm) : arm_(arm) {}
  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    solve(T, count, nullptr, {q, valid, nullptr, flag, nullptr});
  }
  bool solve_inside(const double* T, long count, const Directly& how, const Answers& to) const {
    return solve(T, count, &how, to);
  }

 private:
  bool solve(const double* T, long count, const Directly* how, const Answers& to) const {
    return arm_.alike ? hidden_angle::solve<offset_wrist::Family<true>>(arm_, &arm_, 1, T, count, how, to)
                      : hidden_angle::solve<offset_wrist::Family<false>>(arm_, &arm_, 1, T, count, how, to);
  }
  const OffsetWrist& arm_;
};

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
