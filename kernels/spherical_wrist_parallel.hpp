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
//
// params: see `Layout`. iparams[0]: 1 when tau is not zero.
#pragma once

#include "batch.hpp"
#include "math.hpp"

namespace pieper::PIEPER_ISA {

struct SphericalWristParallel {
  static constexpr int joints = 6, slots = 8;

  enum Layout {
    kBase = 0,            // 9: rotation that takes world directions to B, row by row
    kTool = 9,            // 9: rotation C, the end frame of the wrist's angles seen from the tool
    kOrigin = 18,         // 3: minus B's origin, in B
    kCentre = 21,         // 3: wrist centre seen from the tool point, in C's frame, m
    kA1 = 24, kB, kL2, kL3,                 // m
    kCosPsi, kSinPsi, kCosTau, kSinTau,
    kOffset2, kOffset3, kOffset4, kOffset5, // rad: th2 = q2 + offset, th3 = sign q3 + offset, ...
    kSign3,
    kCosOffset4, kSinOffset4,
    kScale,                                 // length that positions are compared with, m
    kParams
  };

  // Relative to kScale, or radians. Rounding of a pose made by forward kinematics is a few 1e-16.
  static constexpr double kOnSingularity = 1e-13;   // closer: one representative stands for the family
  static constexpr double kNearSingularity = 1e-7;  // closer: flagged, so that the careful path looks at it
  static constexpr double kMerged = 64 * 2.2e-16;   // squares below this are rounding: a double root
  static constexpr double kOvershoot = 5e-13;       // a reach exceeded by no more than this is the edge of reach
  static constexpr double kVerified = 1e-11;        // forward kinematics must return the pose this closely

  template <class F>
  PIEPER_INLINE static void solve(const double* P, const int* I, const Pose<F>& T, Branches<F, 8, 6>& out) {
    const double b = P[kB], a1 = P[kA1], scale = P[kScale];
    F M[3][3], w[3];  // rotation and wrist centre seen from B
    into_base(P, T, M, w);

    F R2 = w[0] * w[0] + w[1] * w[1], x2 = R2 - b * b;
    F x = sqrt(max(x2, F(0.0))), over_R2 = 1.0 / R2;
    Mask<F> reached = x2 >= 0.0, two_sides = reached, degenerate = mask_of<F>(false);
    F c1[2], s1[2];
    for (int side = 0; side < 2; ++side) {
      F signed_x = side ? -x : x;
      c1[side] = (signed_x * w[0] + b * w[1]) * over_R2;
      s1[side] = (signed_x * w[1] - b * w[0]) * over_R2;
    }
    const double near2 = kNearSingularity * kNearSingularity * scale * scale + 1e3 * kMerged * __builtin_fabs(b) * scale;
    if (__builtin_expect(any(x2 < near2), 0)) shoulder_edge(P, w, R2, x2, x, c1[0], s1[0], reached, two_sides, degenerate);

    for (int side = 0; side < 2; ++side) {
      Mask<F> shoulder_ok = side ? (reached & two_sides) : reached;
      F c = c1[side], s = s1[side], q1 = atan2(s, c);
      F ux[3], uy[3];
      for (int k = 0; k < 3; ++k) {
        ux[k] = c * M[0][k] + s * M[1][k];
        uy[k] = c * M[1][k] - s * M[0][k];
      }
      F X = (side ? -x : x) - a1, Z = w[2];
      F q2[2], q3[2], c23[2], s23[2];
      Mask<F> elbow_ok = shoulder_ok, two_elbows = shoulder_ok;
      elbow(P, X, Z, side, q2, q3, c23, s23, elbow_ok, two_elbows, degenerate);
      F sv, cv;
      sincos_of_turns(q1, sv, cv);
      for (int e = 0; e < 2; ++e) {
        Mask<F> ok = e ? (elbow_ok & two_elbows) : elbow_ok;
        F q4, q5, q6;
        Mask<F> on_wrist_singularity = mask_of<F>(false);
        wrist(P, I, ux, uy, M[2], c23[e], s23[e], q4, q5, q6, on_wrist_singularity, degenerate, ok);
        ok = ok & verify(P, I, M, w, cv, sv, q2[e], q3[e], q4, q5, q6);
        const int slot = 4 * side + 2 * e;
        F q[6] = {q1, q2[e], q3[e], wrapped(q4 - P[kOffset4]), wrapped(q5 - P[kOffset5]), q6};
        for (int j = 0; j < 6; ++j) out.q[slot][j] = q[j];
        out.valid[slot] = ok;
        // the other turn of the wrist: th4 + pi, -th5, th6 + pi, the same rotation exactly
        for (int j = 0; j < 3; ++j) out.q[slot + 1][j] = q[j];
        out.q[slot + 1][3] = select(q[3] > 0.0, q[3] - kPi, q[3] + kPi);
        out.q[slot + 1][4] = wrapped(-q5 - P[kOffset5]);
        out.q[slot + 1][5] = select(q6 > 0.0, q6 - kPi, q6 + kPi);
        out.valid[slot + 1] = ok & !on_wrist_singularity;
      }
    }
    Mask<F> none = !(out.valid[0] | out.valid[2] | out.valid[4] | out.valid[6]);
    out.degenerate = degenerate;
    out.uncertain = none & reached & degenerate;
    out.out_of_reach = none;
  }

  // The pose seen from B, with the tool taken off: M = B^-1 R C and the wrist centre.
  template <class F> PIEPER_INLINE static void into_base(const double* P, const Pose<F>& T, F (&M)[3][3], F (&w)[3]) {
    F half[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        half[i][j] = T.r[i][0] * P[kTool + j] + (T.r[i][1] * P[kTool + 3 + j] + T.r[i][2] * P[kTool + 6 + j]);
    for (int i = 0; i < 3; ++i) {
      const double* row = P + kBase + 3 * i;
      for (int j = 0; j < 3; ++j) M[i][j] = row[0] * half[0][j] + (row[1] * half[1][j] + row[2] * half[2][j]);
      F p = P[kOrigin + i] + (row[0] * T.p[0] + (row[1] * T.p[1] + row[2] * T.p[2]));
      w[i] = p + (M[i][0] * P[kCentre] + (M[i][1] * P[kCentre + 1] + M[i][2] * P[kCentre + 2]));
    }
  }

  // Wrist centre near axis 1, or near the circle around it inside which the lateral offset b keeps the arm.
  template <class F, class M>
  __attribute__((noinline)) static void shoulder_edge(const double* P, const F (&w)[3], const F& R2, const F& x2, F& x,
                                                      F& c1, F& s1, M& reached, M& two_sides, M& degenerate) {
    const double b = P[kB], scale = P[kScale], here = kOnSingularity * scale;
    const double rounding = here * here + kMerged * __builtin_fabs(b) * scale;
    const double near2 = kNearSingularity * kNearSingularity * scale * scale + 1e3 * kMerged * __builtin_fabs(b) * scale;
    F rho = sqrt(R2);
    auto near = x2 < near2;
    degenerate = degenerate | near;
    auto beyond = x2 < 0.0, edge = beyond & (__builtin_fabs(b) - rho <= kOvershoot * scale);
    reached = reached | edge;
    // at the edge x = 0 and the direction is that of (b y, -b x), made a unit vector anew
    F over = b / (__builtin_fabs(b) * rho);
    c1 = select(edge, w[1] * over, c1);
    s1 = select(edge, -w[0] * over, s1);
    auto on_axis = (rho <= here) & mask_of<F>(__builtin_fabs(b) <= here);
    reached = reached | on_axis;
    c1 = select(on_axis, F(1.0), c1);
    s1 = select(on_axis, F(0.0), s1);
    x = select(on_axis, w[0], x);
    two_sides = two_sides & !(x2 <= rounding) & !on_axis & !edge;
  }

  // The planar two-link problem for wrist centre (X, Z): th2, th3 (as q2, q3) and the forearm's direction, both elbows.
  template <class F, class M>
  PIEPER_INLINE static void elbow(const double* P, F X, F Z, int side, F (&q2)[2], F (&q3)[2], F (&c23)[2], F (&s23)[2],
                                  M& ok, M& two, M& degenerate) {
    const double L2 = P[kL2], L3 = P[kL3], scale = P[kScale];
    F D = X * X + Z * Z;
    F c3 = (D - (L2 * L2 + L3 * L3)) * (0.5 / (L2 * L3));
    F square = (1.0 - c3) * (1.0 + c3);
    F s3 = sqrt(max(square, F(0.0)));
    F over_D = 1.0 / D;
    M inside = square >= 0.0;
    M centred = mask_of<F>(false);
    const double near = 1e3 * kMerged * scale * scale / (L2 * L3);
    if (__builtin_expect(any((square < near) | (D < 0.01 * (L2 * L3))), 0))
      elbow_edge(P, D, c3, square, s3, over_D, inside, two, centred, degenerate);
    ok = ok & inside;
    F th3 = atan2(s3, c3);
    for (int e = 0; e < 2; ++e) {
      const double sense = (side == e) ? -1.0 : 1.0;
      F sine = sense * s3;
      // w = e^{i th2} (L2 + L3 e^{i th3}) = e^{i (th2 + th3)} (L3 + L2 e^{-i th3})
      F along = L2 + L3 * c3, across = L3 * sine;
      F th2 = atan2(Z * along - X * across, X * along + Z * across);
      F forward = L3 + L2 * c3, sideways = L2 * sine;
      c23[e] = (X * forward - Z * sideways) * over_D;
      s23[e] = (Z * forward + X * sideways) * over_D;
      if (__builtin_expect(any(centred), 0)) {  // only when L2 = L3: folded back onto axis 2, th2 is free
        F c2, s2, th20 = F(P[kOffset2]);
        sincos_of_turns(th20, s2, c2);
        th2 = select(centred, th20, th2);
        c23[e] = select(centred, -c2, c23[e]);
        s23[e] = select(centred, -s2, s23[e]);
      }
      q2[e] = wrapped(th2 - P[kOffset2]);
      q3[e] = P[kSign3] * (sense * th3 - P[kOffset3]);
      q3[e] = wrapped(q3[e]);
    }
  }

  // Arm nearly stretched or folded, or wrist centre near axis 2.
  template <class F, class M>
  __attribute__((noinline)) static void elbow_edge(const double* P, const F& D, F& c3, const F& square, F& s3, F& over_D,
                                                   M& inside, M& two, M& centred, M& degenerate) {
    const double L2 = P[kL2], L3 = P[kL3], scale = P[kScale], here = kOnSingularity * scale;
    const double rounding = kMerged * scale * scale / (L2 * L3), near = 1e3 * rounding;
    F r = sqrt(D);
    F excess = max(r - (L2 + L3), __builtin_fabs(L2 - L3) - r);
    auto edge = (square < 0.0) & (excess <= kOvershoot * scale);
    inside = inside | edge;
    c3 = select(edge, select(c3 > 0.0, F(1.0), F(-1.0)), c3);
    s3 = select(edge, F(0.0), s3);
    centred = (r <= here) & inside;
    c3 = select(centred, F(-1.0), c3);
    s3 = select(centred, F(0.0), s3);
    two = two & !(square <= rounding) & !edge & !centred;
    degenerate = degenerate | (inside & ((square < near) | (r < kNearSingularity * scale)));
    // 1/D loses digits where D does; |L2 + L3 e^{i th3}| is the same length without the loss
    F along = L2 + L3 * c3, across = L3 * s3;
    F length2 = along * along + across * across;
    over_D = select((length2 > 0.0) & (D > 0.0), 1.0 / sqrt(D * length2), over_D);
  }

  // The wrist's angles for one forearm direction, sin th5 >= 0.
  template <class F, class M>
  PIEPER_INLINE static void wrist(const double* P, const int* I, const F (&ux)[3], const F (&uy)[3], const F (&uz)[3],
                                  F c23, F s23, F& th4, F& th5, F& q6, M& on_singularity, M& degenerate, M ok) {
    F c = c23 * P[kCosPsi] - s23 * P[kSinPsi], s = s23 * P[kCosPsi] + c23 * P[kSinPsi];
    F mx[3], my[3], mz;
    for (int k = 0; k < 3; ++k) {
      mx[k] = c * ux[k] + s * uz[k];
      my[k] = uy[k];
    }
    mz = c * uz[2] - s * ux[2];
    if (I[0]) {
      for (int k = 0; k < 2; ++k) my[k] = P[kCosTau] * uy[k] - P[kSinTau] * (c * uz[k] - s * ux[k]);
      my[2] = P[kCosTau] * uy[2] - P[kSinTau] * mz;
      mz = P[kSinTau] * uy[2] + P[kCosTau] * mz;
    }
    F sine = sqrt(mx[2] * mx[2] + my[2] * my[2]);
    on_singularity = sine < kOnSingularity;
    degenerate = degenerate | ((sine < kNearSingularity) & ok);
    F over = 1.0 / select(on_singularity, F(1.0), sine);
    // the same rounded direction serves th4 and th6, so their sum is right even where each alone is not
    F c4 = select(on_singularity, F(P[kCosOffset4]), mx[2] * over);
    F s4 = select(on_singularity, F(P[kSinOffset4]), my[2] * over);
    th4 = atan2(s4, c4);
    th5 = atan2(c4 * mx[2] + s4 * my[2], mz);
    q6 = atan2(c4 * my[0] - s4 * mx[0], c4 * my[1] - s4 * mx[1]);
  }

  // Forward kinematics of the rounded answer against the pose.
  template <class F>
  PIEPER_INLINE static Mask<F> verify(const double* P, const int* I, const F (&M)[3][3], const F (&w)[3], F c1, F s1, F q2,
                                      F q3, F th4, F th5, F q6) {
    F c2, s2, c3, s3, c4, s4, c5, s5, c6, s6;
    sincos_of_turns(q2 + P[kOffset2], s2, c2);
    sincos_of_turns(P[kSign3] * q3 + P[kOffset3], s3, c3);
    sincos_of_turns(th4, s4, c4);
    sincos_of_turns(th5, s5, c5);
    sincos_of_turns(q6, s6, c6);
    F c23 = c2 * c3 - s2 * s3, s23 = s2 * c3 + c2 * s3;
    F X = P[kA1] + (P[kL2] * c2 + P[kL3] * c23), Z = P[kL2] * s2 + P[kL3] * s23;
    F off = abs(c1 * X - s1 * P[kB] - w[0]);
    off = max(off, abs(s1 * X + c1 * P[kB] - w[1]));
    off = max(off, abs(Z - w[2])) * (1.0 / P[kScale]);
    F c = c23 * P[kCosPsi] - s23 * P[kSinPsi], s = s23 * P[kCosPsi] + c23 * P[kSinPsi];
    // rows of Rz(th4) Ry(th5) Rz(th6), then tilt, forearm and first joint applied to each column
    F cc = c4 * c5, sc = s4 * c5;
    F N[3][3] = {{cc * c6 - s4 * s6, -(cc * s6) - s4 * c6, c4 * s5},
                 {sc * c6 + c4 * s6, c4 * c6 - sc * s6, s4 * s5},
                 {-(s5 * c6), s5 * s6, c5}};
    for (int k = 0; k < 3; ++k) {
      F x = N[0][k], y = N[1][k], z = N[2][k];
      if (I[0]) {
        F turned_y = P[kCosTau] * y + P[kSinTau] * z;
        z = P[kCosTau] * z - P[kSinTau] * y;
        y = turned_y;
      }
      F along = c * x - s * z, up = s * x + c * z;
      off = max(off, abs(c1 * along - s1 * y - M[0][k]));
      off = max(off, abs(s1 * along + c1 * y - M[1][k]));
      off = max(off, abs(up - M[2][k]));
    }
    return off <= kVerified;
  }
};

}  // namespace pieper::PIEPER_ISA
