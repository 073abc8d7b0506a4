// The steps to a spherical wrist behind parallel second and third axes (spherical_wrist_parallel.hpp): shoulder, elbow, forearm, wrist, and
// what they miss. Templates over the number type.
#pragma once

#include "chain/rigid.hpp"
#include "lanes/unit_angle.hpp"

namespace pieper::PIEPER_ISA {

struct ParallelWristSteps {
  template <class F> struct Shoulder {
    F R2, x2, x, over_R2;
    Mask<F> reached, two_sides, degenerate, beyond;  // beyond: out of reach, and so is every pose beside this one
    Mask<F> fixed;                                   // direction given by c, s below, not by x
    F c, s;
  };
  template <class F> struct Arm {  // after the first joint has turned
    F c, s;
    F ux[3], uy[3];  // the rotation's first two rows, turned back
    F X, Z;          // wrist centre in the arm's plane, from axis 2
    F off;           // by how much of what is held so far the pose is missed, see `held`
    Mask<F> ok;
  };
  template <class F> struct Elbow {
    F c3, s3, D, over_D;
    F along, forward;  // L2 + L3 cos th3, L3 + L2 cos th3
    Mask<F> ok, two, centred, degenerate, beyond;
  };
  template <class F> struct Forearm {
    F s2, c2;
    F mx[3], my[3], mz, mz0;  // the rotation's rows from the forearm; of the third the last and the first entry
    F sine2;                  // the square of sin th5
    F off;                    // by how much of what is held so far the pose is missed
  };
  template <class F> struct Wrist {
    F s4, c4, s5, s6, c6;
    Mask<F> ok, two, degenerate, reached;  // reached: verified or not
  };
  template <class F> struct Angles {
    F th2, th4, th5;
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
    if (__builtin_expect(any(a.x2 < shoulder_near(P)), 0)) {
      // copies: what is handed on by reference would be kept in memory, in the usual case too
      const F at[3] = {w[0], w[1], w[2]};
      Shoulder<F> looked_at = a;
      shoulder_edge(P, at, looked_at);
      a = looked_at;
    }
    return a;
  }

  // Wrist centre near axis 1, or near the circle around it inside which the lateral offset b keeps the arm.
  template <class F> __attribute__((noinline)) static void shoulder_edge(const SphericalWristParallel& P,
                                                                         const F (&w)[3], Shoulder<F>& a) {
    const double b = P.b, scale = P.scale, here = kSwpOnSingularity * scale;
    F rho = sqrt(a.R2), gap = rho - __builtin_fabs(b);
    const Mask<F> near = a.x2 < shoulder_near(P);  // the other lanes keep their digits
    a.beyond = gap < -kSwpBeyond * scale;
    a.degenerate = near & !a.beyond;  // well inside the circle there is nothing to look at
    Mask<F> edge = (gap < 0.0) & (gap >= -kSwpOvershoot * scale);
    Mask<F> on_axis = (rho <= here) & mask_of<F>(__builtin_fabs(b) <= here);
    a.x = select(near, sqrt(max(gap * (rho + __builtin_fabs(b)), F(0.0))), a.x);
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
    e.c3 = c3;
    if (__builtin_expect(any(square < kSwpEdgeOfElbow), 0)) {
      const Arm<F> of = arm;
      Elbow<F> looked_at = e;
      elbow_edge(P, of, F(square), looked_at);
      e = looked_at;
    }
    return e;
  }

  // Arm nearly stretched or folded: the same quantities from the small distance to the edge of reach, without cancellation.
  template <class F> __attribute__((noinline)) static void elbow_edge(const SphericalWristParallel& P,
                                                                      const Arm<F>& arm, const F& square, Elbow<F>& e) {
    const double L2 = P.upper, L3 = P.fore, scale = P.scale, here = kSwpOnSingularity * scale;
    const double outer = L2 + L3, inner = __builtin_fabs(L2 - L3), over = 0.5 / (L2 * L3);
    F r = sqrt(e.D), c3 = e.c3;
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
    e.c3 = c3;
  }

  // One elbow, the sign of th3, and the rotation that is left to the wrist.
  template <class F> PIEPER_INLINE static Forearm<F> bend(const SphericalWristParallel& P, const F (&M)[3][3],
                                                          const Arm<F>& arm, const Elbow<F>& e, F sense) {
    Forearm<F> out;
    // w = e^{i th2} (L2 + L3 e^{i th3}) = e^{i (th2 + th3)} (L3 + L2 e^{-i th3})
    const F sine3 = sense * e.s3, across = P.fore * sine3, sideways = P.upper * sine3;
    F s2 = (arm.Z * e.along - arm.X * across) * e.over_D, c2 = (arm.X * e.along + arm.Z * across) * e.over_D;
    F c23 = (arm.X * e.forward - arm.Z * sideways) * e.over_D;
    F s23 = (arm.Z * e.forward + arm.X * sideways) * e.over_D;
    if (__builtin_expect(any(e.centred), 0)) {  // only when L2 = L3: folded back onto axis 2, th2 is free
      F c20, s20;
      sincos_of_turns(F(P.offset2), s20, c20);
      c2 = select(e.centred, c20, c2), s2 = select(e.centred, s20, s2);
      c23 = select(e.centred, -c20, c23), s23 = select(e.centred, -s20, s23);
    }
    out.s2 = s2, out.c2 = c2;
    const F c = c23 * P.cos_psi - s23 * P.sin_psi, s = s23 * P.cos_psi + c23 * P.sin_psi;
    out.mz = c * M[2][2] - s * arm.ux[2], out.mz0 = c * M[2][0] - s * arm.ux[0];
    for (int k = 0; k < 3; ++k) {
      out.mx[k] = c * arm.ux[k] + s * M[2][k];
      out.my[k] = arm.uy[k];
    }
    if (P.tilted) {
      out.my[1] = P.cos_tau * out.my[1] - P.sin_tau * (c * M[2][1] - s * arm.ux[1]);
      const F y = out.my[2], y0 = out.my[0], z = out.mz, z0 = out.mz0;
      out.my[2] = P.cos_tau * y - P.sin_tau * z, out.mz = P.sin_tau * y + P.cos_tau * z;
      out.my[0] = P.cos_tau * y0 - P.sin_tau * z0, out.mz0 = P.sin_tau * y0 + P.cos_tau * z0;
    }
    out.sine2 = out.mx[2] * out.mx[2] + out.my[2] * out.my[2];
    // the arm's plane: the wrist centre, and the forearm's direction as it was used against that of joints 2 and 3
    out.off =
        (abs(P.upper * c2 + P.fore * c23 - arm.X) + abs(P.upper * s2 + P.fore * s23 - arm.Z)) * (1.0 / P.scale) +
        (lever(P) * (1 + kUnitAngleSkew)) * (abs(c2 * e.c3 - s2 * sine3 - c23) + abs(s2 * e.c3 + c2 * sine3 - s23) +
                                             abs((c2 * c2 - 1.0) + s2 * s2) + abs((c23 * c23 - 1.0) + s23 * s23));
    return out;
  }

  // The wrist with sin th5 >= 0, verified.
  template <class F> PIEPER_INLINE static Wrist<F> turn_wrist(const SphericalWristParallel& P, const Arm<F>& arm,
                                                              const Elbow<F>& e, const Forearm<F>& f) {
    Wrist<F> out;
    F sine = sqrt(f.sine2);
    // the same rounded direction serves th4 and th6, so their sum is right even where each alone is not
    out.degenerate = sine < kSwpNearSingularity;
    out.two = !(sine < kSwpOnSingularity);
    if (__builtin_expect(any(out.degenerate), 0)) sine = select(out.two, sine, F(1.0));
    F over = 1.0 / sine, c4 = f.mx[2] * over, s4 = f.my[2] * over;
    if (__builtin_expect(any(out.degenerate), 0)) {
      c4 = select(out.two, c4, F(P.cos_offset4));
      s4 = select(out.two, s4, F(P.sin_offset4));
    }
    const F s5 = c4 * f.mx[2] + s4 * f.my[2], mz = f.mz;
    const F s6 = c4 * f.my[0] - s4 * f.mx[0], c6 = c4 * f.my[1] - s4 * f.mx[1];
    out.s4 = s4, out.c4 = c4, out.s5 = s5, out.s6 = s6, out.c6 = c6;
    // the first and the last column of Rz(th4) Ry(th5) Rz(th6), seen from the forearm
    const F turned_x = mz * c6;
    F off = abs(c4 * turned_x - s4 * s6 - f.mx[0]) + abs(s4 * turned_x + c4 * s6 - f.my[0]) + abs(s5 * c6 + f.mz0);
    off += abs(c4 * s5 - f.mx[2]) + abs(s4 * s5 - f.my[2]);
    off += kTwoColumns * (abs((s5 * s5 - 1.0) + mz * mz) + abs((s6 * s6 - 1.0) + c6 * c6));
    out.reached = e.ok, out.ok = e.ok & ((arm.off + f.off) + off <= verified_within(P));
    return out;
  }

  template <class F> PIEPER_INLINE static Angles<F> angles(const SphericalWristParallel& P, const Elbow<F>& e,
                                                           const Forearm<F>& f, const Wrist<F>& wrist) {
    Angles<F> out = {unit_angle(f.s2, f.c2), unit_angle(wrist.s4, wrist.c4), unit_angle(wrist.s5, f.mz)};
    if (__builtin_expect(any(e.centred), 0)) out.th2 = select(e.centred, F(P.offset2), out.th2);
    if (__builtin_expect(any(wrist.degenerate), 0)) out.th4 = select(wrist.two, out.th4, F(P.offset4));
    return out;
  }

  // Verification. An answer is the rounded angles of pairs (c, s) that are held; forward kinematics of the angles is that of the
  // pairs, but for three things, each of which has a bound:
  //   - a pair is not of length one: |c^2 + s^2 - 1| = d scales what the joint carries by at most d / 2 (1 + d), and takes its angle
  //     kUnitAngleSkew d / 2 aside (lanes/unit_angle.hpp): less than the d that is counted. Of joint 3 the length is that of the two
  //     pairs beside it and of what they miss, which is counted with that skew;
  //   - the angle of a pair is missed by at most kAngleError (lanes/math.hpp), and taking off the joint's offset, the change of
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
};

}  // namespace pieper::PIEPER_ISA
