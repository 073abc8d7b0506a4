// The cubic spline through points, twice continuously differentiable, its first two and last two pieces one cubic each.
#pragma once

#include <vector>

namespace pieper {

// s: count increasing parameters; q: count x n. out: count x n second derivatives at the points.
// Two points give a line, three a parabola.
inline void spline_second_derivatives(const double* s, const double* q, long count, int n, double* out) {
  for (long i = 0; i < count * n; ++i) out[i] = 0.0;
  if (count < 3) return;
  const long last = count - 1;
  auto step = [&](long i) { return s[i + 1] - s[i]; };
  auto bend = [&](long i, int j) {
    return (q[(i + 1) * n + j] - q[i * n + j]) / step(i) - (q[i * n + j] - q[(i - 1) * n + j]) / step(i - 1);
  };
  if (count == 3) {
    for (int j = 0; j < n; ++j) {
      const double second = 2.0 * bend(1, j) / (step(0) + step(1));
      for (long i = 0; i < 3; ++i) out[i * n + j] = second;
    }
    return;
  }
  // Rows 1 .. last - 1 of the tridiagonal system; the outer unknowns are put in terms of their neighbours.
  std::vector<double> above(count);
  const double first = step(0) / step(1), end = step(last - 1) / step(last - 2);
  for (long i = 1; i < last; ++i) {
    const double h0 = step(i - 1), h1 = step(i);
    double left = h0 / 6, middle = (h0 + h1) / 3, right = h1 / 6;
    if (i == 1) middle += left * (1 + first), right -= left * first, left = 0;
    if (i == last - 1) middle += right * (1 + end), left -= right * end, right = 0;
    const double pivot = i == 1 ? middle : middle - left * above[i - 1];
    above[i] = right / pivot;
    for (int j = 0; j < n; ++j) out[i * n + j] = (bend(i, j) - (i == 1 ? 0.0 : left * out[(i - 1) * n + j])) / pivot;
  }
  for (long i = last - 2; i >= 1; --i)
    for (int j = 0; j < n; ++j) out[i * n + j] -= above[i] * out[(i + 1) * n + j];
  for (int j = 0; j < n; ++j) {
    out[j] = out[n + j] * (1 + first) - out[2 * n + j] * first;
    out[last * n + j] = out[(last - 1) * n + j] * (1 + end) - out[(last - 2) * n + j] * end;
  }
}

}  // namespace pieper
