// What is measured of postures of six joints: the determinant of the Jacobian and its smallest singular value.
// Templates over the number type.
#pragma once

#include "lanes/batch.hpp"
#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA {

// Mirrors so that of `count` numbers, `apart` from each other, only the first is left, which is returned, and does the same to the
// `lines` beside them, `beside` apart (Householder, 1958); `turn` changes its sign. Nothing is done where the squares round to 0.
template <class F> PIEPER_INLINE F mirrored(F* x, int count, int apart, int lines, int beside, F& turn) {
  F squares = 0.0;
  for (int i = 0; i < count; ++i) squares += x[i * apart] * x[i * apart];
  const Mask<F> there = squares > __DBL_MIN__;
  const F size = sqrt(squares), first = select(there, -with_sign_of(size, x[0]), x[0]);
  x[0] = x[0] - first;
  const F scale = select(there, 1.0 / (size * abs(x[0])), 0.0);
  for (F* line = x + beside; lines > 0; --lines, line += beside) {
    F along = 0.0;
    for (int i = 0; i < count; ++i) along += x[i * apart] * line[i * apart];
    along = along * scale;
    for (int i = 0; i < count; ++i) line[i * apart] = line[i * apart] - along * x[i * apart];
  }
  turn = select(there, -turn, turn);
  return first;
}

// det A of a 6 x 6 matrix (row-major, spoilt), and its smallest singular value. Mirrors from both sides leave an upper bidiagonal B
// (Golub and Kahan, 1965). The least root of det(B^T B - x) is met from below by Laguerre's steps, each cubic, from the sums of
// 1 / (root - x) and of its square, which are the derivatives of the logarithms of the quotients q of the shifted transform
// (Fernando and Parlett, 1994): no term of theirs cancels, so that a small value is as good as the mirrors leave it, about 1e-16 of
// the largest.
template <class F> PIEPER_INLINE F smallest_singular_value(F* A, F& determinant) {
  constexpr int n = 6, most = 60;
  F q[n], e[n];
  determinant = 1.0;
  for (int k = 0; k < n; ++k) {
    F* at = A + (n + 1) * k;
    const F on = k < n - 1 ? mirrored(at, n - k, n, n - 1 - k, 1, determinant) : at[0];
    const F off = k < n - 2 ? mirrored(at + 1, n - 1 - k, 1, n - 1 - k, n, determinant) : k < n - 1 ? at[1] : F(0.0);
    determinant = determinant * on;
    q[k] = on * on;
    e[k] = off * off;
  }
  F x = 0.0;
  Mask<F> going = mask_of<F>(true);
  for (int step = 0; step < most && any(going); ++step) {
    F d = q[0] - x, slope = 1.0, bend = 0.0, once = 0.0, twice = 0.0;  // d, and its two derivatives, signs turned
    Mask<F> below = mask_of<F>(true);
    for (int k = 0; k < n; ++k) {
      const F quotient = d + e[k], over = 1.0 / quotient, share = slope * over;
      below = below & (quotient > 0.0);
      once += share;
      twice += bend * over + share * share;
      if (k == n - 1) break;
      const F by = q[k + 1] * over, left = by * e[k] * over;
      bend = left * (bend + 2.0 * slope * share);
      slope = 1.0 + left * slope;
      d = d * by - x;
    }
    const F by = n / (once + sqrt(max(F(0.0), (n - 1.0) * (n * twice - once * once))));
    const F next = x + by;
    going = going & below & (next > x);
    x = select(going, next, x);
    going = going & (by > 2 * __DBL_EPSILON__ * x);
  }
  return sqrt(x);
}

// J: count x 36, row-major, linear rows first; out: count x 2, the determinant as it comes, the smallest singular value with
// lengths divided by `length`.
inline void posture_measures(const double* J, long count, double length, double* out) {
  using F = Lanes<PIEPER_LANES>;
  constexpr int W = PIEPER_LANES, size = 36, whole = size - size % W;
  for (long done = 0; done < count; done += W) {
    const int lanes = count - done < W ? static_cast<int>(count - done) : W;
    F A[size], block[W];
    for (int first = 0; first < size; first += W) {
      for (int i = 0; i < W; ++i) {
        const double* own = J + size * (done + (i < lanes ? i : lanes - 1)) + first;
        if (first < whole) block[i] = load<F>(own);
        else
          for (int k = 0; k < size - whole; ++k) block[i].v[k] = own[k];
      }
      transpose(block);
      for (int k = 0; k < W && first + k < size; ++k) A[first + k] = block[k];
    }
    const double less = 1 / length;
    for (int k = 0; k < size / 2; ++k) A[k] = A[k] * less;
    F value[2];
    value[1] = smallest_singular_value(A, value[0]);
    value[0] = value[0] * (length * length * length);
    for (int i = 0; i < lanes; ++i)
      for (int k = 0; k < 2; ++k) out[2 * (done + i) + k] = lane(value[k], i);
  }
}

}  // namespace pieper::PIEPER_ISA
