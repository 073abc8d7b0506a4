// A row whose axes miss being in place by what rounding of the pose leaves open: where the other joints are near a fold, a pose known
// to its last digit fixes them to few. Newton's method on the pose and the missing gap together. Scalar.
#pragma once

#include "singular/six.hpp"

namespace pieper::PIEPER_ISA {

// Moves q so that gap(Standing, double[6]) vanishes and the pose is held, in the least squares; what is missed of the pose is returned.
template <class Gap> double into_place(const SixJoints& arm, const Rigid& T, Gap gap, double* q) {
  constexpr int kSteps = 3;
  for (int step = 0; step < kSteps; ++step) {
    const Standing at(arm, q);
    double e[6], g[6], slope[6][6], A[6][6], b[6];
    at.missing(T, e);
    gap(at, g);
    for (int i = 0; i < kSix; ++i) {
      double aside[6];
      std::copy(q, q + kSix, aside);
      aside[i] += kIntoPlaceStep;
      gap(Standing(arm, aside), slope[i]);
      for (int r = 0; r < 6; ++r) slope[i][r] = (slope[i][r] - g[r]) / kIntoPlaceStep;
    }
    for (int i = 0; i < kSix; ++i) {
      b[i] = 0;
      for (int r = 0; r < 6; ++r) b[i] += at.J[i][r] * e[r] - slope[i][r] * g[r];
      for (int j = 0; j < kSix; ++j) {
        A[i][j] = 0;
        for (int r = 0; r < 6; ++r) A[i][j] += at.J[i][r] * at.J[j][r] + slope[i][r] * slope[j][r];
      }
    }
    step_along(SingularSix(A), b, kIntoPlaceRank, -1, kNextToLinkage, q);
  }
  return missed_at(arm, q, T);
}

}  // namespace pieper::PIEPER_ISA
