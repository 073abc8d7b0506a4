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
  // row i of the points' bends: the slope behind it less the slope before
  auto bends = [&](long i, double* to) {
    const double after = 1 / step(i), before = 1 / step(i - 1);
    const double *here = q + i * n, *next = here + n, *past = here - n;
    for (int j = 0; j < n; ++j) to[j] = (next[j] - here[j]) * after - (here[j] - past[j]) * before;
  };
  if (count == 3) {
    bends(1, out);
    for (int j = 0; j < n; ++j) out[2 * n + j] = out[n + j] = out[j] = 2.0 * out[j] / (step(0) + step(1));
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
    const double per = 1 / (i == 1 ? middle : middle - left * above[i - 1]);
    above[i] = right * per;
    double *to = out + i * n, *past = to - n;
    bends(i, to);
    for (int j = 0; j < n; ++j) to[j] = (to[j] - left * past[j]) * per;
  }
  for (long i = last - 2; i >= 1; --i)
    for (int j = 0; j < n; ++j) out[i * n + j] -= above[i] * out[(i + 1) * n + j];
  for (int j = 0; j < n; ++j) {
    out[j] = out[n + j] * (1 + first) - out[2 * n + j] * first;
    out[last * n + j] = out[(last - 1) * n + j] * (1 + end) - out[(last - 2) * n + j] * end;
  }
}

// The derivatives (count - 1) x n at the beginning of each piece of that spline.
inline void spline_pieces(const double* s, const double* q, long count, int n, double* d1, double* d2, double* d3) {
  std::vector<double> bend(count * n);
  spline_second_derivatives(s, q, count, n, bend.data());
  for (long i = 0; i + 1 < count; ++i) {
    const double h = s[i + 1] - s[i], per = 1 / h;
    for (long k = i * n; k < (i + 1) * n; ++k) {
      d1[k] = (q[k + n] - q[k]) * per - h * (bend[k + n] + 2 * bend[k]) / 6;
      d2[k] = bend[k];
      d3[k] = (bend[k + n] - bend[k]) * per;
    }
  }
}

// How far a curve's pieces stray from their own chords, the largest of all joints: a cubic minus its chord is u (1 - u)
// times a line, and u (1 - u) is at most 1/4.
inline double strays(const double* s, const double* d2, const double* d3, long cells, int n) {
  double most = 0;
  for (long i = 0; i < cells; ++i) {
    const double h = s[i + 1] - s[i], square = h * h;
    for (long k = i * n; k < (i + 1) * n; ++k) {
      const double left = square * (d2[k] / 2 + h / 6 * d3[k]), right = square * (d2[k] / 2 + h / 3 * d3[k]);
      const double one = left < 0 ? -left : left, other = right < 0 ? -right : right;
      most = one > most ? one : most;
      most = other > most ? other : most;
    }
  }
  return most / 4;
}

}  // namespace pieper
