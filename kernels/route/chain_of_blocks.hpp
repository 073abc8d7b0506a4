// A symmetric positive definite system whose unknowns hang together as a chain of small blocks, by Cholesky. Scalar.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace pieper {

// diagonal (count, d, d), beside (count - 1, d, d): block (i, i + 1); right and x (count, d). False where the matrix is
// not positive definite; x is of no use then.
inline bool chain_of_blocks(const double* diagonal, const double* beside, const double* right, std::int64_t count,
                            int d, double* x) {
  const int dd = d * d;
  std::vector<double> factor(static_cast<std::size_t>(count) * dd), link(static_cast<std::size_t>(count) * dd);
  for (std::int64_t i = 0; i < count; ++i) {
    double* L = &factor[i * dd];
    for (int k = 0; k < dd; ++k) L[k] = diagonal[i * dd + k];
    double* y = x + i * d;
    for (int a = 0; a < d; ++a) y[a] = right[i * d + a];
    if (i > 0) {
      // link = L_(i-1)^-1 E_(i-1), taken off as link^T link
      const double* M = &factor[(i - 1) * dd];
      double* K = &link[i * dd];
      for (int c = 0; c < d; ++c)
        for (int r = 0; r < d; ++r) {
          double sum = beside[(i - 1) * dd + r * d + c];
          for (int k = 0; k < r; ++k) sum -= M[r * d + k] * K[k * d + c];
          K[r * d + c] = sum / M[r * d + r];
        }
      for (int a = 0; a < d; ++a) {
        for (int b = 0; b < d; ++b)
          for (int k = 0; k < d; ++k) L[a * d + b] -= K[k * d + a] * K[k * d + b];
        for (int k = 0; k < d; ++k) y[a] -= K[k * d + a] * x[(i - 1) * d + k];
      }
    }
    for (int r = 0; r < d; ++r)
      for (int c = 0; c <= r; ++c) {
        double sum = L[r * d + c];
        for (int k = 0; k < c; ++k) sum -= L[r * d + k] * L[c * d + k];
        if (r == c) {
          if (!(sum > 0.0)) return false;
          L[r * d + r] = std::sqrt(sum);
        } else {
          L[r * d + c] = sum / L[c * d + c];
        }
      }
    for (int r = 0; r < d; ++r) {
      for (int k = 0; k < r; ++k) y[r] -= L[r * d + k] * y[k];
      y[r] /= L[r * d + r];
    }
  }
  for (std::int64_t i = count - 1; i >= 0; --i) {
    double* y = x + i * d;
    if (i + 1 < count)
      for (int r = 0; r < d; ++r)
        for (int k = 0; k < d; ++k) y[r] -= link[(i + 1) * dd + r * d + k] * x[(i + 1) * d + k];
    const double* L = &factor[i * dd];
    for (int r = d - 1; r >= 0; --r) {
      for (int k = r + 1; k < d; ++k) y[r] -= L[k * d + r] * y[k];
      y[r] /= L[r * d + r];
    }
  }
  return true;
}

}  // namespace pieper
