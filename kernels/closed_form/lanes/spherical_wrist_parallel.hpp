// Six revolute joints: the first perpendicular to the second, the second and third parallel, a spherical wrist of
// three mutually perpendicular neighbours at the end. Eight solutions in closed form (Pieper, 1968).
//
// In the base frame B (origin on axis 1 at the height of axis 2; z along axis 1, y against axis 2) the arm is
//     B^-1 T C = Rz(th1) [x = a1 + L2 cos th2 + L3 cos(th2 + th3), y = b, z = L2 sin th2 + L3 sin(th2 + th3)]   wrist centre
//     rotation = Rz(th1) S(th2 + th3 + psi) X(tau) Rz(th4) Ry(th5) Rz(th6)
// where S turns x towards z and X(tau) tilts axis 4 out of the arm's plane (zero for every usual arm).
//
// Slot = 4 shoulder + 2 elbow + wrist:
//     shoulder 0: the wrist centre on the positive x side of the turned base frame, 1: on the negative side
//     elbow    0: sin th3 negative in front (positive behind): the elbow above the line from shoulder to wrist
//     wrist    0: sin th5 positive, 1: negative
// At a double root only the slot with the 0 is filled: wrist centre on axis 1 (th1 is free; q1 = 0 stands for it) or at
// the shoulder's inner reach, arm stretched or folded (th3 double; wrist centre on axis 2: q2 = 0), sin th5 = 0 (th4 and
// th6 count only as sum or difference; q4 = 0).
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

struct SphericalWristParallel : Geometry {
  static constexpr const char* name = "spherical_wrist_parallel";
  static constexpr const char* doc =
      "Parallel second and third axes, the first across them, a spherical wrist of right angles at the end.";
  static constexpr int joints = 6, slots = 8;
  double base[3][3];          // takes world directions to B
  double tool[3][3];          // C, the end frame of the wrist's angles seen from the tool
  Vector origin;              // minus B's origin, in B, m
  Vector centre;              // wrist centre seen from the tool point, in C's frame, m
  double a1, b, upper, fore;  // m; L2 and L3 above
  double cos_psi, sin_psi, cos_tau, sin_tau;
  double offset2, offset3, offset4, offset5;  // rad: th2 = q2 + offset2, th3 = sign3 q3 + offset3, ...
  double sign3, cos_offset4, sin_offset4;
  double scale;  // length that positions are compared with, m
  bool tilted;   // tau is not zero

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    visit("base", self.base), visit("tool", self.tool), visit("origin", self.origin), visit("centre", self.centre);
    visit("a1", self.a1), visit("b", self.b), visit("upper", self.upper), visit("fore", self.fore);
    visit("cos_psi", self.cos_psi), visit("sin_psi", self.sin_psi), visit("cos_tau", self.cos_tau),
        visit("sin_tau", self.sin_tau);
    visit("offset2", self.offset2), visit("offset3", self.offset3), visit("offset4", self.offset4),
        visit("offset5", self.offset5);
    visit("sign3", self.sign3), visit("cos_offset4", self.cos_offset4), visit("sin_offset4", self.sin_offset4);
    visit("scale", self.scale), visit("tilted", self.tilted);
  }
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "lanes/batch.hpp"
#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA {

class SphericalWristParallelKernel {
 public:
  static constexpr bool in_order = true;
  explicit SphericalWristParallelKernel(const SphericalWristParallel& arm) : arm_(arm) {}

  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    if (count == 1) return solve_alone(arm_, load_poses<double>(T), q, valid, flag);
    solve_batch<SphericalWristParallelKernel>(arm_, T, count, nullptr, q, valid, flag, nullptr);
  }
  void solve_inside(const double* T, long count, const JointLimits& limits, double* q, std::uint8_t* valid,
                    std::uint8_t* flag, std::uint8_t* in_limits) const {
    solve_batch<SphericalWristParallelKernel>(arm_, T, count, &limits, q, valid, flag, in_limits);
  }

  // All branches of W poses: lanes are poses, the branches follow one another.
  template <class F>
  PIEPER_INLINE static void branches(const SphericalWristParallel& P, const RigidT<F>& T, Branches<F, 8, 6>& out) {
    F M[3][3], w[3];
    into_base(P, T, M, w);
    Shoulder<F> shoulder = start_shoulder(P, w);
    Mask<F> none = mask_of<F>(true), beyond = mask_of<F>(true), missed = mask_of<F>(false);
#pragma GCC unroll 2
    for (int side = 0; side < 2; ++side) {
      Arm<F> arm = turn_shoulder(P, M, w, shoulder, F(side ? -1.0 : 1.0));
      if (side) arm.ok = arm.ok & shoulder.two_sides;
      Elbow<F> elbow = start_elbow(P, arm);
#pragma GCC unroll 2
      for (int e = 0; e < 2; ++e) {
        Answer<F> answer = bend_and_turn_wrist(P, M, arm, elbow, F(side == e ? -1.0 : 1.0));
        const Mask<F> ok = e ? answer.ok & elbow.two : answer.ok;
        const int slot = 4 * side + 2 * e;
        for (int j = 0; j < 6; ++j) out.q[slot][j] = answer.q[j];
        out.valid[slot] = ok;
        out.reached[slot] = e ? answer.reached & elbow.two : answer.reached;
        missed = missed | (out.reached[slot] & !ok);
        // the other turn of the wrist: th4 + pi, -th5, th6 + pi, the same rotation exactly
        for (int j = 0; j < 3; ++j) out.q[slot + 1][j] = answer.q[j], out.q[slot + 1][3 + j] = answer.flipped[j];
        out.valid[slot + 1] = ok & answer.two;
        out.reached[slot + 1] = out.reached[slot] & answer.two;
        shoulder.degenerate = shoulder.degenerate | (answer.degenerate & ok);
        none = none & !ok;
      }
      shoulder.degenerate = shoulder.degenerate | elbow.degenerate;
      beyond = beyond & elbow.beyond;
    }
    out.degenerate = shoulder.degenerate, out.missed = missed;
    out.uncertain = (none & shoulder.degenerate & shoulder.reached) | missed;
    out.out_of_reach = none;
    out.edge = none & !(shoulder.beyond | beyond);
  }

  // One pose alone: lanes are the four postures of shoulder and elbow.
  PIEPER_INLINE static void solve_alone(const SphericalWristParallel& P, const Rigid& T, double* q, std::uint8_t* valid,
                                        std::uint8_t* flag) {
    using F = Lanes<4>;
    double M1[3][3], w1[3];
    into_base(P, T, M1, w1);
    F M[3][3], w[3];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) M[i][j] = F(M1[i][j]);
      w[i] = F(w1[i]);
    }
    F side, sense;
    for (int k = 0; k < 4; ++k) side.v[k] = k < 2 ? 1.0 : -1.0, sense.v[k] = k == 0 || k == 3 ? -1.0 : 1.0;
    Shoulder<F> shoulder = start_shoulder(P, w);
    Arm<F> arm = turn_shoulder(P, M, w, shoulder, side);
    arm.ok = arm.ok & (shoulder.two_sides | (side > 0.0));
    Elbow<F> elbow = start_elbow(P, arm);
    Answer<F> answer = bend_and_turn_wrist(P, M, arm, elbow, sense);
    Mask<F> second = (side * sense) > 0.0;  // slot with elbow 1
    const Mask<F> there = elbow.two | !second, ok = answer.ok & there;
    const unsigned bits = bits_of(ok), two = bits_of(answer.two);
    const bool degenerate = any(shoulder.degenerate | elbow.degenerate | (answer.degenerate & ok));
    for (int k = 0; k < 4; ++k) {
      const bool first_ok = (bits >> k) & 1u, both_ok = first_ok & ((two >> k) & 1u);
      valid[2 * k] = first_ok;
      valid[2 * k + 1] = both_ok;
      double *a = q + 12 * k, *b = a + 6;
      for (int j = 0; j < 6; ++j) {
        a[j] = first_ok ? answer.q[j].v[k] : 0.0;
        b[j] = both_ok ? (j < 3 ? answer.q[j].v[k] : answer.flipped[j < 3 ? 0 : j - 3].v[k]) : 0.0;
      }
    }
    *flag = static_cast<std::uint8_t>(
        (degenerate ? kDegenerate : 0) | (bits ? 0 : kOutOfReach) |
        ((!bits && degenerate && any(shoulder.reached)) || any(answer.reached & there & !ok) ? kUncertain : 0) |
        (bits || all(shoulder.beyond | elbow.beyond) ? 0 : kEdge));
  }

 private:
  template <class F> struct Shoulder {
    F R2, x2, x, over_R2;
    Mask<F> reached, two_sides, degenerate, beyond;  // beyond: out of reach, and so is every pose beside this one
    Mask<F> fixed;                                   // direction given by c, s below, not by x
    F c, s;
  };
  template <class F> struct Arm {  // after the first joint has turned
    F c, s, q1;
    F ux[3], uy[3];  // the rotation's first two rows, turned back
    F X, Z;          // wrist centre in the arm's plane, from axis 2
    F off;           // by how much of what is held so far the pose is missed, see `held`
    Mask<F> ok;
  };
  template <class F> struct Elbow {
    F D, c3, s3, th3, over_D;
    F along, forward;  // L2 + L3 cos th3, L3 + L2 cos th3
    Mask<F> ok, two, centred, degenerate, beyond;
  };
  template <class F> struct Answer {
    F q[6], flipped[3];                    // flipped: q4, q5, q6 of the wrist's other turn
    Mask<F> ok, two, degenerate, reached;  // reached: verified or not
  };

  // The pose seen from B, with the tool taken off: M = B^-1 R C and the wrist centre.
  template <class F>
  PIEPER_INLINE static void into_base(const SphericalWristParallel& P, const RigidT<F>& T, F (&M)[3][3], F (&w)[3]) {
    F half[3][3];
    const double origin[3] = {P.origin.x, P.origin.y, P.origin.z};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        half[i][j] = T.r(i, 0) * P.tool[0][j] + (T.r(i, 1) * P.tool[1][j] + T.r(i, 2) * P.tool[2][j]);
    for (int i = 0; i < 3; ++i) {
      const double* row = P.base[i];
      for (int j = 0; j < 3; ++j) M[i][j] = row[0] * half[0][j] + (row[1] * half[1][j] + row[2] * half[2][j]);
      F p = origin[i] + (row[0] * T.p(0) + (row[1] * T.p(1) + row[2] * T.p(2)));
      w[i] = p + (M[i][0] * P.centre.x + (M[i][1] * P.centre.y + M[i][2] * P.centre.z));
    }
  }

  // Below this x^2 = wx^2 + wy^2 - b^2 is looked at closely, m^2: x itself small, or the two roots x and -x one direction.
  PIEPER_INLINE static double shoulder_near(const SphericalWristParallel& P) {
    const double b = __builtin_fabs(P.b), length = kSwpNearSingularity * P.scale, side = kSwpNearDouble * b;
    return length * length + side * side + 8 * kSwpRounding * b * P.scale;
  }

  template <class F> PIEPER_INLINE static Shoulder<F> start_shoulder(const SphericalWristParallel& P, const F (&w)[3]) {
    Shoulder<F> a;
    a.R2 = w[0] * w[0] + w[1] * w[1];
    a.x2 = a.R2 - P.b * P.b;
    a.x = sqrt(max(a.x2, F(0.0)));
    a.over_R2 = 1.0 / a.R2;
    a.reached = a.two_sides = a.x2 >= 0.0, a.c = a.s = F(0.0);
    a.degenerate = a.fixed = a.beyond = mask_of<F>(false);
    if (__builtin_expect(any(a.x2 < shoulder_near(P)), 0)) shoulder_edge(P, w, a);
    return a;
  }

  // Wrist centre near axis 1, or near the circle around it inside which the lateral offset b keeps the arm.
  template <class F> __attribute__((noinline)) static void shoulder_edge(const SphericalWristParallel& P,
                                                                         const F (&w)[3], Shoulder<F>& a) {
    const double b = P.b, scale = P.scale, here = kSwpOnSingularity * scale;
    F rho = sqrt(a.R2), gap = rho - __builtin_fabs(b);
    a.beyond = gap < -kSwpBeyond * scale;
    a.degenerate = (a.x2 < shoulder_near(P)) & !a.beyond;  // well inside the circle there is nothing to look at
    Mask<F> edge = (gap < 0.0) & (gap >= -kSwpOvershoot * scale);
    Mask<F> on_axis = (rho <= here) & mask_of<F>(__builtin_fabs(b) <= here);
    a.x = sqrt(max(gap * (rho + __builtin_fabs(b)), F(0.0)));
    a.reached = (gap >= 0.0) | edge | on_axis;
    // on the axis both sides hold the same families; at the edge they are a double root
    a.two_sides =
        (gap > 0.0) & (a.x > here) & ((gap > kSwpRounding * scale) | mask_of<F>(__builtin_fabs(b) <= here)) & !on_axis;
    // at the edge x = 0 and the direction is that of (b y, -b x), made a unit vector anew; on the axis q1 = 0
    a.fixed = edge | on_axis;
    F over = b / (__builtin_fabs(b) * rho);
    a.c = select(on_axis, F(1.0), w[1] * over);
    a.s = select(on_axis, F(0.0), -w[0] * over);
    a.x = select(on_axis, w[0], a.x);
  }

  template <class F> PIEPER_INLINE static Arm<F> turn_shoulder(const SphericalWristParallel& P, const F (&M)[3][3],
                                                               const F (&w)[3], const Shoulder<F>& a, F side) {
    Arm<F> arm;
    F x = side * a.x;
    arm.c = (x * w[0] + P.b * w[1]) * a.over_R2;
    arm.s = (x * w[1] - P.b * w[0]) * a.over_R2;
    if (__builtin_expect(any(a.fixed), 0)) {
      arm.c = select(a.fixed, a.c, arm.c);
      arm.s = select(a.fixed, a.s, arm.s);
    }
    arm.q1 = atan2(arm.s, arm.c);
    arm.off = (abs(arm.c * x - arm.s * P.b - w[0]) + abs(arm.s * x + arm.c * P.b - w[1])) * (1.0 / P.scale) +
              lever(P) * abs((arm.c * arm.c - 1.0) + arm.s * arm.s);
    for (int k = 0; k < 3; ++k) {
      arm.ux[k] = arm.c * M[0][k] + arm.s * M[1][k];
      arm.uy[k] = arm.c * M[1][k] - arm.s * M[0][k];
    }
    arm.X = x - P.a1, arm.Z = w[2];
    arm.ok = a.reached;
    return arm;
  }

  // What both elbows of the two-link problem for wrist centre (X, Z) share: |th3|.
  template <class F> PIEPER_INLINE static Elbow<F> start_elbow(const SphericalWristParallel& P, const Arm<F>& arm) {
    const double L2 = P.upper, L3 = P.fore;
    Elbow<F> e;
    e.D = arm.X * arm.X + arm.Z * arm.Z;
    F c3 = (e.D - (L2 * L2 + L3 * L3)) * (0.5 / (L2 * L3));
    F square = (1.0 - c3) * (1.0 + c3);
    e.s3 = sqrt(max(square, F(0.0)));
    e.over_D = 1.0 / e.D;
    e.along = L2 + L3 * c3;
    e.forward = L3 + L2 * c3;
    e.two = square >= 0.0;
    e.ok = arm.ok & e.two;
    e.centred = e.degenerate = e.beyond = mask_of<F>(false);
    if (__builtin_expect(any(square < kSwpEdgeOfElbow), 0)) elbow_edge(P, arm, c3, square, e);
    e.c3 = c3;
    e.th3 = atan2(e.s3, c3);
    return e;
  }

  // Arm nearly stretched or folded: the same quantities from the small distance to the edge of reach, without cancellation.
  template <class F> __attribute__((noinline)) static void elbow_edge(const SphericalWristParallel& P,
                                                                      const Arm<F>& arm, F& c3, const F& square,
                                                                      Elbow<F>& e) {
    const double L2 = P.upper, L3 = P.fore, scale = P.scale, here = kSwpOnSingularity * scale;
    const double outer = L2 + L3, inner = __builtin_fabs(L2 - L3), over = 0.5 / (L2 * L3);
    F r = sqrt(e.D);
    Mask<F> folded = c3 < 0.0, close = square < kSwpEdgeOfElbow;
    F gap = select(folded, r - inner, outer - r);
    // where the shoulder is near its own edge, rounding of x = sqrt(x^2) adds to the overshoot
    F overshoot = kSwpOvershoot * scale + (2 * kSwpRounding * scale * scale) / max(abs(arm.X + P.a1), F(here));
    Mask<F> edge = close & (gap < 0.0) & (gap >= -overshoot);
    // 1 - |cos th3| and what follows from it
    F rest = select(folded, gap * (r + inner), gap * (outer + r)) * over;
    rest = max(rest, F(0.0));
    F cosine = select(folded, rest - 1.0, 1.0 - rest);
    F sine2 = rest * (2.0 - rest);
    c3 = select(close, cosine, c3);
    e.s3 = select(close, sqrt(sine2), e.s3);
    e.along = select(close, select(folded, (L2 - L3) + L3 * rest, (L2 + L3) - L3 * rest), e.along);
    e.forward = select(close, select(folded, (L3 - L2) + L2 * rest, (L2 + L3) - L2 * rest), e.forward);
    Mask<F> within = select(close, gap, square) >= 0.0;
    e.ok = arm.ok & (within | edge);
    e.centred = (r <= here) & e.ok;
    // what moves the wrist centre by d moves x, where the shoulder is near its own edge, by d times the distance over x
    e.beyond = close & (gap < (-kSwpBeyond * scale * scale) / max(abs(arm.X + P.a1), F(here)));
    e.two = within & !(close & (gap <= kSwpRounding * scale)) & !e.centred;
    e.degenerate = e.ok & close &
                   ((sine2 < kSwpNearDouble * kSwpNearDouble) | (gap < overshoot) | (r < kSwpNearSingularity * scale));
    // beyond the edge D is not |L2 + L3 e^{i th3}|^2, and the forearm's direction must be a unit vector all the same
    e.over_D = select(edge, 1.0 / (r * select(folded, F(inner), F(outer))), e.over_D);
    if (any(e.centred)) {
      c3 = select(e.centred, F(-1.0), c3);
      e.s3 = select(e.centred, F(0.0), e.s3);
      e.over_D = select(e.centred, F(1.0), e.over_D);
    }
  }

  // One elbow (the sign of th3) and its wrist with sin th5 >= 0, verified.
  template <class F> PIEPER_INLINE static Answer<F> bend_and_turn_wrist(const SphericalWristParallel& P,
                                                                        const F (&M)[3][3], const Arm<F>& arm,
                                                                        const Elbow<F>& e, F sense) {
    Answer<F> out;
    // w = e^{i th2} (L2 + L3 e^{i th3}) = e^{i (th2 + th3)} (L3 + L2 e^{-i th3})
    F sine3 = sense * e.s3, across = P.fore * sine3, sideways = P.upper * sine3;
    F s2 = arm.Z * e.along - arm.X * across, c2 = arm.X * e.along + arm.Z * across;
    F th2 = atan2_closed(s2, c2);
    s2 *= e.over_D, c2 *= e.over_D;
    F c23 = (arm.X * e.forward - arm.Z * sideways) * e.over_D;
    F s23 = (arm.Z * e.forward + arm.X * sideways) * e.over_D;
    if (__builtin_expect(any(e.centred), 0)) {  // only when L2 = L3: folded back onto axis 2, th2 is free
      F c20, s20, th20 = F(P.offset2);
      sincos_of_turns(th20, s20, c20);
      th2 = select(e.centred, th20, th2);
      c2 = select(e.centred, c20, c2), s2 = select(e.centred, s20, s2);
      c23 = select(e.centred, -c20, c23), s23 = select(e.centred, -s20, s23);
    }
    out.q[0] = arm.q1;
    out.q[1] = wrapped(th2 - P.offset2);
    out.q[2] = wrapped(P.sign3 * (sense * e.th3 - P.offset3));

    F c = c23 * P.cos_psi - s23 * P.sin_psi, s = s23 * P.cos_psi + c23 * P.sin_psi;
    F mx[3], my[3], mz = c * M[2][2] - s * arm.ux[2], mz0 = c * M[2][0] - s * arm.ux[0];
    for (int k = 0; k < 3; ++k) {
      mx[k] = c * arm.ux[k] + s * M[2][k];
      my[k] = arm.uy[k];
    }
    if (P.tilted) {
      my[1] = P.cos_tau * my[1] - P.sin_tau * (c * M[2][1] - s * arm.ux[1]);
      F y = my[2], y0 = my[0];
      my[2] = P.cos_tau * y - P.sin_tau * mz;
      mz = P.sin_tau * y + P.cos_tau * mz;
      my[0] = P.cos_tau * y0 - P.sin_tau * mz0;
      mz0 = P.sin_tau * y0 + P.cos_tau * mz0;
    }
    F sine = sqrt(mx[2] * mx[2] + my[2] * my[2]);
    Mask<F> on_singularity = sine < kSwpOnSingularity;
    out.degenerate = sine < kSwpNearSingularity;
    F over = 1.0 / select(on_singularity, F(1.0), sine);
    // the same rounded direction serves th4 and th6, so their sum is right even where each alone is not
    F c4 = select(on_singularity, F(P.cos_offset4), mx[2] * over);
    F s4 = select(on_singularity, F(P.sin_offset4), my[2] * over);
    F th4 = atan2_closed(s4, c4);
    F s5 = c4 * mx[2] + s4 * my[2], th5 = atan2_closed(s5, mz);
    F s6 = c4 * my[0] - s4 * mx[0], c6 = c4 * my[1] - s4 * mx[1], q6 = atan2(s6, c6);
    out.q[3] = wrapped(th4 - P.offset4);
    out.q[4] = wrapped(th5 - P.offset5);
    out.q[5] = q6;
    out.flipped[0] = half_a_turn_on(out.q[3]);
    out.flipped[1] = wrapped(-th5 - P.offset5);
    out.flipped[2] = half_a_turn_on(q6);
    out.two = !on_singularity;
    // the arm's plane: the wrist centre, and the forearm's direction as it was used against that of joints 2 and 3
    F off = (abs(P.upper * c2 + P.fore * c23 - arm.X) + abs(P.upper * s2 + P.fore * s23 - arm.Z)) * (1.0 / P.scale);
    off += lever(P) * (abs(c2 * e.c3 - s2 * sine3 - c23) + abs(s2 * e.c3 + c2 * sine3 - s23) +
                       abs((c2 * c2 - 1.0) + s2 * s2) + abs((c23 * c23 - 1.0) + s23 * s23));
    // the first and the last column of Rz(th4) Ry(th5) Rz(th6), seen from the forearm
    F turned_x = mz * c6;
    off += abs(c4 * turned_x - s4 * s6 - mx[0]) + abs(s4 * turned_x + c4 * s6 - my[0]) + abs(s5 * c6 + mz0);
    off += abs(c4 * s5 - mx[2]) + abs(s4 * s5 - my[2]);
    off += kTwoColumns * (abs((s5 * s5 - 1.0) + mz * mz) + abs((s6 * s6 - 1.0) + c6 * c6));
    out.reached = e.ok, out.ok = e.ok & (arm.off + off <= verified_within(P));
    return out;
  }

  // Verification. An answer is the rounded angles of pairs (c, s) that are held; forward kinematics of the angles is that of the
  // pairs, but for three things, each of which has a bound:
  //   - a pair is not of length one: |c^2 + s^2 - 1| = d turns nothing, and scales what the joint carries by at most d / 2 (1 + d);
  //   - atan2 misses the pair's angle by at most kAngleError (lanes/math.hpp), and taking off the joint's offset, the change of
  //     sense, whole turns and the other turn of the wrist round four more times below 2 pi: kJointError together;
  //   - a joint that is turned by delta moves the wrist centre, in lengths of the scale, and each of the two columns that are
  //     compared by at most delta times its lever, sqrt(3) times that in the sum of absolute values.
  // So the sum of what the pairs miss, of what their lengths miss times the levers and of the levers times kJointError, joint for
  // joint, is no smaller than what forward kinematics of the rounded angles misses: it must stay below kSwpVerified. Two columns of
  // a rotation fix the third. A sum, because NaN survives it.
  static constexpr double kSqrt3 = 1.7320508075688773, kTwoColumns = 2 * kSqrt3;
  static constexpr double kJointError = kAngleError + 4 * kTurnRounding;

  // Of joints 1, 2 and 3: they carry the wrist centre and both columns.
  PIEPER_INLINE static double lever(const SphericalWristParallel& P) {
    const double reach = __builtin_fabs(P.a1) + __builtin_fabs(P.b) + __builtin_fabs(P.upper) + __builtin_fabs(P.fore);
    return kTwoColumns + kSqrt3 * reach / P.scale;
  }
  PIEPER_INLINE static double verified_within(const SphericalWristParallel& P) {
    return kSwpVerified - kJointError * 3 * (lever(P) + kTwoColumns);
  }

  const SphericalWristParallel& arm_;
};

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
