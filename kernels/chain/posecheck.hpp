// How far a 4x4 matrix is from a rigid motion, and the rigid motion nearest to it.
// The check is a template over the number type; straightening, which is rare, is scalar.
#pragma once

#include "lanes/batch.hpp"

namespace pieper::PIEPER_ISA {

template <class F> PIEPER_INLINE F rotation_deviation(const RigidT<F>& T) {
  F worst = F(0.0);
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      F dot = T.r(0, a) * T.r(0, b) + T.r(1, a) * T.r(1, b) + T.r(2, a) * T.r(2, b);
      F off = abs(a == b ? dot - 1.0 : dot);
      worst = select(off <= worst, worst, select(worst == worst, off, worst));  // NaN stays once it is there
    }
  F determinant = T.r(0, 0) * (T.r(1, 1) * T.r(2, 2) - T.r(1, 2) * T.r(2, 1)) -
                  T.r(0, 1) * (T.r(1, 0) * T.r(2, 2) - T.r(1, 2) * T.r(2, 0)) +
                  T.r(0, 2) * (T.r(1, 0) * T.r(2, 1) - T.r(1, 1) * T.r(2, 0));
  worst = select(determinant < 0.0, max(worst, F(2.0)), worst);
  F finite = (T.p(0) - T.p(0)) + (T.p(1) - T.p(1)) + (T.p(2) - T.p(2));  // 0, or NaN
  return worst + finite;
}

inline double pose_deviation(const double* T, long count, double* out) {
  constexpr int W = PIEPER_LANES;
  double largest = 0.0;
  for (long first = 0; first < count; first += W) {
    const int lanes = count - first < W ? static_cast<int>(count - first) : W;
    double value[W];
    if (lanes == W) store(value, rotation_deviation(load_poses<Lanes<W>>(T + 16 * first)));
    else
      for (int i = 0; i < lanes; ++i) value[i] = rotation_deviation(load_poses<double>(T + 16 * (first + i)));
    for (int i = 0; i < lanes; ++i) {
      const double* last = T + 16 * (first + i) + 12;
      double row =
          __builtin_fabs(last[0]) + __builtin_fabs(last[1]) + __builtin_fabs(last[2]) + __builtin_fabs(last[3] - 1.0);
      double d = value[i];
      if (!(row <= d)) d = d == d ? row : d;
      out[first + i] = d;
      if (!(d <= largest)) largest = largest == largest ? d : largest;
    }
  }
  return largest;
}

// Newton's iteration for the polar factor, X <- X (3 - X^T X) / 2 (Higham, 1986): each step squares the deviation.
inline void pose_straighten(const double* T, const double* deviation, double exact, long count, double* out) {
  for (long i = 0; i < count; ++i) {
    double* X = out + 16 * i;
    for (int k = 0; k < 16; ++k) X[k] = T[16 * i + k];
    if (deviation[i] <= exact) continue;
    X[12] = X[13] = X[14] = 0.0;
    X[15] = 1.0;
    for (int step = 0; step < 4; ++step) {
      double G[3][3], Y[3][3];
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) G[a][b] = X[a] * X[b] + X[4 + a] * X[4 + b] + X[8 + a] * X[8 + b];
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          Y[a][b] = 1.5 * X[4 * a + b] - 0.5 * (X[4 * a] * G[0][b] + X[4 * a + 1] * G[1][b] + X[4 * a + 2] * G[2][b]);
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) X[4 * a + b] = Y[a][b];
    }
  }
}

}  // namespace pieper::PIEPER_ISA
