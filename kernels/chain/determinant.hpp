// The determinant of six columns of six. Scalar.
#pragma once

#include <algorithm>
#include <cmath>

namespace pieper::PIEPER_ISA {

inline double determinant(const double (*J)[6]) {
  double A[6][6], det = 1;
  std::copy(&J[0][0], &J[0][0] + 36, &A[0][0]);
  for (int k = 0; k < 6; ++k) {
    int best = k;
    for (int i = k + 1; i < 6; ++i)
      if (std::fabs(A[i][k]) > std::fabs(A[best][k])) best = i;
    if (A[best][k] == 0) return 0;
    if (best != k) std::swap_ranges(A[best], A[best] + 6, A[k]), det = -det;
    det *= A[k][k];
    for (int i = k + 1; i < 6; ++i)
      for (int j = 6 - 1; j >= k; --j) A[i][j] -= A[i][k] / A[k][k] * A[k][j];
  }
  return det;
}

}  // namespace pieper::PIEPER_ISA
