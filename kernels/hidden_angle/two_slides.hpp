// Six joints of which two slide, in any order.
//
// Slides do not turn anything, so the four turning joints alone make the orientation. Walk the loop from one of them, the hidden
// one: with its angle theta chosen the other three, x, y, z in loop order, are a wrist: the cosine of y is of degree one in
// theta, its sine a square root S of either sign, and x and z follow. What is then left of the loop is a vector p that the slides must
// undo along their directions s1, s2: one condition,
//
//   f(S) = p . (s1 x s2) = 0,
//
// and f(S) f(-S) (1 - X33^2), X33 the cosine between the axes of x and z, is a trigonometric polynomial of degree 4 in theta
// wherever the slides stand: at most eight solutions. Roots: hidden_angle.hpp. Templates over the number type.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

struct TwoSlides : HiddenAngle {
  static constexpr const char* name = "two_slides";
  static constexpr const char* doc = "Four turning and two sliding joints in any order.";
  static constexpr int joints = 6, slots = 8;
  Choice hidden;  // turning joints (0-based) whose angle may be the unknown, best first

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    HiddenAngle::fields(self, visit);
    visit("slides", self.slides), visit("hidden", self.hidden);
  }
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "hidden_angle/hidden_angle.hpp"

namespace pieper::PIEPER_ISA::two_slides {

using namespace hidden_angle;

// The arm seen with one of its joints hidden, and the places of the loop counted from there.
struct Arm {
  Rigid links[7];  // lengths of one
  double length;   // m
  int hidden;
  bool slides[6];  // by role
  int turning[4];  // roles
  Arm() = default;
  Arm(const TwoSlides& arm, int hides) : length(arm.length), hidden(hides) {
    read_links(arm.links, arm.length, links);
    for (int role = 0, n = 0; role < 6; ++role) {
      slides[role] = arm.slides[joint(role)];
      if (!slides[role] && n < 4) turning[n++] = role;
    }
  }
  int joint(int role) const { return (hidden + role) % 6; }
};

// A pose as the arm sees it, roles counted from the hidden joint on.
template <class F> struct Target {
  RigidT<F> closing;  // the link that holds the pose
  // rotations between neighbouring turning joints: hidden to x, x to y, y to z, z to hidden
  Vec3T<F> first[3], second[3], third[3], fourth[3];  // columns
};

template <class F> PIEPER_INLINE RigidT<F> link_of(const Arm& arm, const Target<F>& target, int joint) {
  return loop_link(arm.links, target.closing, joint);
}

template <class F> Target<F> see(const Arm& arm, const RigidT<F>& pose) {
  Target<F> out;
  out.closing = closing_link(arm.links, in_lengths(pose, arm.length));
  Vec3T<F>* const between[4] = {out.first, out.second, out.third, out.fourth};
  for (int k = 0; k < 4; ++k) {
    RigidT<F> R = link_of(arm, out, arm.joint(arm.turning[k]));
    for (int role = arm.turning[k] + 1; role < (k < 3 ? arm.turning[k + 1] : 6); ++role)
      R = R * link_of(arm, out, arm.joint(role));
    between[k][0] = R.x, between[k][1] = R.y, between[k][2] = R.z;
  }
  return out;
}

// Where numbers come from: how a constant, the root S and a reciprocal are written in each kind of number.
template <class F> struct PlainNumbers {
  F side;
  F lift(F x) const { return x; }
  F root(F a) const { return side * sqrt(max(a, F(0.0))); }
  F reciprocal(F a) const { return 1.0 / select(a == 0.0, F(kTiny), a); }
};
template <class F> struct DualNumbers {
  F side;
  Dual<F> lift(F x) const { return {x, F(0.0)}; }
  Dual<F> root(Dual<F> a) const {
    const Dual<F> r = hidden_angle::root(a);
    return {side * r.x, side * r.d};
  }
  Dual<F> reciprocal(Dual<F> a) const { return over(lift(F(1.0)), a); }
};
template <class F> struct SurdNumbers {
  F square;
  Surd<F> lift(F x) const { return {x, F(0.0), square}; }
  Surd<F> root(Surd<F>) const { return {F(0.0), F(1.0), square}; }
  Surd<F> reciprocal(Surd<F> a) const { return lift(1.0 / select(a.x == 0.0, F(kTiny), a.x)); }  // of what has no S
};

// All that follows from the hidden angle: the other angles, what is left of the loop, the slides' directions, the condition.
template <class X> struct Evaluated {
  Motion<X> turn[4];
  Vec3T<X> rest, slide[2], across;  // across: s1 x s2
  X room, open, f;                  // S^2, 1 - X33^2
};

template <class F, class X>
PIEPER_INLINE Vec3T<X> mixed(const Vec3T<X>& x, const Vec3T<X>& y, const Vec3T<X>& z, Vec3T<F> v) {
  return {v.x * x.x + v.y * y.x + v.z * z.x, v.x * x.y + v.y * y.y + v.z * z.y, v.x * x.z + v.y * y.z + v.z * z.z};
}

// cos(y) = (A E - B S) / n, sin(y) = (B E + A S) / n with E of degree one in theta.
template <class F> struct Bend {
  F A, B, n, cosine, sine, constant, both;
};
template <class F> PIEPER_INLINE Bend<F> bend_of(const Target<F>& t) {
  const Vec3T<F> row = {t.second[0].z, t.second[1].z, t.second[2].z}, column = t.third[2];
  const Vec3T<F> u = t.first[2], w = {t.fourth[0].z, t.fourth[1].z, t.fourth[2].z};
  Bend<F> b;
  b.A = row.x * column.x + row.y * column.y;
  b.B = row.y * column.x - row.x * column.y;
  b.n = b.A * b.A + b.B * b.B;
  b.cosine = u.x * w.x + u.y * w.y;
  b.sine = u.x * w.y - u.y * w.x;
  b.both = row.z * column.z;
  b.constant = u.z * w.z - b.both;
  return b;
}

template <class Numbers, class X, class F> PIEPER_INLINE Evaluated<X> evaluate(const Numbers& numbers, const Arm& arm,
                                                                               const Target<F>& t, const Bend<F>& b,
                                                                               X c, X s) {
  Evaluated<X> out;
  const X E = b.cosine * c + b.sine * s + numbers.lift(b.constant);
  out.room = numbers.lift(b.n) - E * E;
  const X S = numbers.root(out.room);
  const F per = 1.0 / max(b.n, F(kTiny)), ka = b.A * per, kb = b.B * per;
  const X cy = ka * E - kb * S, sy = kb * E + ka * S;
  const X X33 = E + numbers.lift(b.both);
  out.open = numbers.lift(F(1.0)) - X33 * X33;
  const X inv = numbers.reciprocal(out.open);
  const Vec3T<F> row = {t.second[0].z, t.second[1].z, t.second[2].z}, column = t.third[2];
  const Vec3T<F> u = t.first[2], w = {t.fourth[0].z, t.fourth[1].z, t.fourth[2].z};
  {  // x: takes g = Q2 Rz(y) q3 to h = Q1^T Rz(-theta) w
    const X yx = column.x * cy - column.y * sy, yy = column.x * sy + column.y * cy, yz = numbers.lift(column.z);
    const X gx = t.second[0].x * yx + t.second[1].x * yy + t.second[2].x * yz;
    const X gy = t.second[0].y * yx + t.second[1].y * yy + t.second[2].y * yz;
    const X vx = w.x * c + w.y * s, vy = w.y * c - w.x * s, vz = numbers.lift(w.z);
    const X hx = t.first[0].x * vx + t.first[0].y * vy + t.first[0].z * vz;
    const X hy = t.first[1].x * vx + t.first[1].y * vy + t.first[1].z * vz;
    out.turn[1] = {(gx * hx + gy * hy) * inv, (gx * hy - gy * hx) * inv};
  }
  {  // z: the same seen from the other end
    const X yx = row.x * cy + row.y * sy, yy = row.y * cy - row.x * sy, yz = numbers.lift(row.z);
    const X gx = t.third[0].x * yx + t.third[0].y * yy + t.third[0].z * yz;
    const X gy = t.third[1].x * yx + t.third[1].y * yy + t.third[1].z * yz;
    const X vx = u.x * c - u.y * s, vy = u.x * s + u.y * c, vz = numbers.lift(u.z);
    const X hx = t.fourth[0].x * vx + t.fourth[1].x * vy + t.fourth[2].x * vz;
    const X hy = t.fourth[0].y * vx + t.fourth[1].y * vy + t.fourth[2].y * vz;
    out.turn[3] = {(gx * hx + gy * hy) * inv, (gy * hx - gx * hy) * inv};
  }
  out.turn[0] = {c, s};
  out.turn[2] = {cy, sy};
  const X zero = numbers.lift(F(0.0)), one = numbers.lift(F(1.0));
  Vec3T<X> x = {one, zero, zero}, y = {zero, one, zero}, z = {zero, zero, one};
  out.rest = {zero, zero, zero};
  int turns = 0, slides = 0;
  for (int role = 0; role < 6; ++role) {
    if (arm.slides[role]) {
      out.slide[slides++] = z;
    } else {
      const Motion<X> m = out.turn[turns++];
      const Vec3T<X> old = x;
      x = {m.c * old.x + m.s * y.x, m.c * old.y + m.s * y.y, m.c * old.z + m.s * y.z};
      y = {m.c * y.x - m.s * old.x, m.c * y.y - m.s * old.y, m.c * y.z - m.s * old.z};
    }
    const RigidT<F> link = link_of(arm, t, arm.joint(role));
    out.rest = out.rest + mixed(x, y, z, link.t);
    const Vec3T<X> nx = mixed(x, y, z, link.x), ny = mixed(x, y, z, link.y), nz = mixed(x, y, z, link.z);
    x = nx, y = ny, z = nz;
  }
  out.across = cross(out.slide[0], out.slide[1]);
  out.f = dot(out.rest, out.across);
  return out;
}

template <class F> F polynomial(const Arm& arm, const Target<F>& target, Motion<F> angle) {
  const Bend<F> b = bend_of(target);
  const F E = b.cosine * angle.c + b.sine * angle.s + b.constant;
  const SurdNumbers<F> numbers = {b.n - E * E};
  const Evaluated<Surd<F>> at = evaluate(numbers, arm, target, b, numbers.lift(angle.c), numbers.lift(angle.s));
  return (at.f.x * at.f.x - numbers.square * at.f.y * at.f.y) * at.open.x;
}

// Where the axes of x and z can line up solutions stand that the polynomial does not know of: only the sum of the two angles is given, and
// f has a pole where it should have a root. The hidden angle must bring the two together, and y must.
template <class F> Mask<F> wanting(const Target<F>& target) {
  const Bend<F> b = bend_of(target);
  const F turned = sqrt(b.cosine * b.cosine + b.sine * b.sine), bent = sqrt(b.n), middle = b.constant + b.both;
  const F lined = 1.0 - kHiddenRoom;
  return ((middle + turned > lined) & (b.both + bent > lined)) | ((turned - middle > lined) & (bent - b.both > lined)) |
         (b.n < kHiddenRoom);
}

template <class F> struct Settled {
  Evaluated<F> at;
  F per;  // one over the square of the sine between the slides
};

// Where two of the four axes line up, the slides are parallel or roots merge, a solution is not clear.
template <class F> Settled<F> settle(const Arm& arm, const Target<F>& target, Motion<F> theta, Mask<F>& unclear) {
  const Bend<F> b = bend_of(target);
  const F up = abs(evaluate(PlainNumbers<F>{F(1.0)}, arm, target, b, theta.c, theta.s).f);
  const F down = abs(evaluate(PlainNumbers<F>{F(-1.0)}, arm, target, b, theta.c, theta.s).f);
  const F side = select(up <= down, F(1.0), F(-1.0));
  unclear = !(min(up, down) < kHiddenSide * max(up, down));
  for (int step = 0; step < 2; ++step) {
    const Evaluated<Dual<F>> at =
        evaluate(DualNumbers<F>{side}, arm, target, b, Dual<F>{theta.c, -theta.s}, Dual<F>{theta.s, theta.c});
    const F slope = at.f.d, change = -at.f.x / select(slope == 0.0, F(kTiny), slope);
    const F size = 1.0 + abs(at.rest.x.x) + abs(at.rest.y.x) + abs(at.rest.z.x);
    unclear =
        unclear | !(abs(change) < (step ? kHiddenLastStep : kHiddenFirstStep)) | !(abs(slope) > kHiddenSlope * size);
    theta = advanced(theta, change);
  }
  Settled<F> root = {evaluate(PlainNumbers<F>{side}, arm, target, b, theta.c, theta.s), F(0.0)};
  const F size = dot(root.at.across, root.at.across);
  root.per = 1.0 / max(size, F(kTiny));
  unclear = unclear | !(root.at.room > kHiddenRoom * b.n) | !(root.at.open > kHiddenRoom) | !(size > kHiddenParallel);
  return root;
}

template <class F> void posture(const Arm& arm, const Settled<F>& root, Motion<F>* q) {
  const Evaluated<F>& at = root.at;
  int turns = 0, slides = 0;
  for (int role = 0; role < 6; ++role) {
    Motion<F>& out = q[arm.joint(role)];
    if (arm.slides[role]) {
      // rest + d1 s1 + d2 s2 = 0, crossed with the other slide
      const F d = slides ? dot(cross(at.rest, at.slide[0]), at.across) : -dot(cross(at.rest, at.slide[1]), at.across);
      out = {d * root.per, F(0.0)};
      ++slides;
    } else {
      out = unit(at.turn[turns].c, at.turn[turns].s);
      ++turns;
    }
  }
}

struct Family {
  static constexpr int degree = 4, samples = 12, slots = 8;
  static constexpr bool both = false;
  using Arm = two_slides::Arm;
  template <class F> using Target = two_slides::Target<F>;
  template <class F> static Target<F> see(const Arm& arm, const RigidT<F>& pose) { return two_slides::see(arm, pose); }
  template <class F> static F polynomial(const Arm& arm, const Target<F>& target, Motion<F> angle) {
    return two_slides::polynomial(arm, target, angle);
  }
  template <class F> static Mask<F> wanting(const Arm&, const Target<F>& target) { return two_slides::wanting(target); }
  template <class F> using Settled = two_slides::Settled<F>;
  template <class F>
  static Settled<F> settle(const Arm& arm, const Target<F>& target, Motion<F> root, F, Mask<F>& unclear) {
    return two_slides::settle(arm, target, root, unclear);
  }
  template <class F>
  static void posture(const Arm& arm, const Target<F>&, const Settled<F>& root, double, Motion<F>* q) {
    two_slides::posture(arm, root, q);
  }
};

}  // namespace pieper::PIEPER_ISA::two_slides

namespace pieper::PIEPER_ISA {

class TwoSlidesKernel {
 public:
  static constexpr bool in_order = true;
  explicit TwoSlidesKernel(const TwoSlides& arm) : arm_(arm) {
    for (int k = 0; k < arm.hidden.count; ++k) way_[k] = two_slides::Arm(arm, arm.hidden.at[k]);
  }
  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    hidden_angle::solve<two_slides::Family>(arm_, way_, arm_.hidden.count, T, count, nullptr,
                                            {q, valid, nullptr, flag, nullptr});
  }
  bool solve_inside(const double* T, long count, const Directly& how, const Answers& to) const {
    return hidden_angle::solve<two_slides::Family>(arm_, way_, arm_.hidden.count, T, count, &how, to);
  }

 private:
  const TwoSlides& arm_;
  two_slides::Arm way_[6];
};

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
