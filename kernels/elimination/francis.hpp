// Francis' double-shift QR for several matrices at once: every lane has its own window and shifts, all sweep together.
//
// The sweeps, which are most of the work, run in lockstep over the union of the windows. Outside a lane's own window its reflection
// is the identity, so nothing needs a mask but the reflection's making. The next reflection is made as soon as its three numbers
// are there, before the rest of the rows and columns is turned: its root and its quotient would else be waited for.
// A template over the number type.
#pragma once

#include "elimination/hessenberg.hpp"

namespace pieper::PIEPER_ISA::general {

// The windows of all lanes, whole numbers: [low, high] is swept next; nothing is left where high < 0.
template <class F> struct Windows {
  F low, high, trial, norm;
};

// The last place in each window, counted from its lower end, where the matrix falls apart; 0 where it does not.
template <class F, int N, int Room> PIEPER_INLINE F parting(const F (&a)[N][Room], const Windows<F>& w, int top) {
  constexpr double eps = 2.220446049250313e-16;
  const F least = 0.1 * w.norm;
  const auto tired = w.trial > 15.0;
  F low = 0.0, before = abs(a[0][0]);
  for (int k = 1; k <= top; ++k) {
    const F here = abs(a[k][k]), size = before + here;
    // a cluster may keep rounding of the size of the whole matrix alive: after a while that counts as zero too
    const F s = select((size == 0.0) | (tired & (size < least)), least, size);
    low = select((abs(a[k][k - 1]) <= eps * s) & (w.high >= double(k)), F(double(k)), low);
    before = here;
  }
  return low;
}

// One or two eigenvalues of a lane, from the rows `low` to `high` where it falls apart.
template <class F, int N, int Room>
PIEPER_INLINE void take(const F (&a)[N][Room], int i, int low, int high, double* re, double* im) {
  const double x = lane(a[high][high], i);
  if (low == high) {
    re[0] = x;
    im[0] = 0;
    return;
  }
  const double y = lane(a[high - 1][high - 1], i), product = lane(a[high][high - 1], i) * lane(a[high - 1][high], i);
  const double half = 0.5 * (y - x), disc = half * half + product;
  if (disc >= 0) {
    const double z = half + __builtin_copysign(__builtin_sqrt(disc), half);
    re[0] = x + z;
    re[1] = z != 0 ? x - product / z : x + z;
    im[0] = im[1] = 0;
  } else {
    re[0] = re[1] = x + half;
    im[0] = __builtin_sqrt(-disc);
    im[1] = -im[0];
  }
}

// Takes eigenvalues off the lower ends of the windows while they have converged; afterwards each has high < 0 or size > 2. Returns
// the largest `high`.
template <class F, int N, int Room>
int deflate(F (&a)[N][Room], Windows<F>& w, double (*re)[N], double (*im)[N], int* found) {
  constexpr int W = width_of<F>;
  double high[W], low[W];
  for (;;) {
    store(high, w.high);
    int top = -1;
    for (int i = 0; i < W; ++i) top = high[i] > top ? static_cast<int>(high[i]) : top;
    if (top < 0) return top;
    w.low = parting(a, w, top);
    const unsigned converged = bits_of((w.high >= 0.0) & (w.low >= w.high - 1.0)), apart = bits_of(w.low > 0.0);
    store(low, w.low);
    for (unsigned left = apart; left; left &= left - 1) {
      const int i = __builtin_ctz(left), k = static_cast<int>(low[i]);
      set_lane(a[k][k - 1], i, 0.0);
    }
    if (!converged) return top;
    for (unsigned left = converged; left; left &= left - 1) {
      const int i = __builtin_ctz(left), l = static_cast<int>(low[i]), h = static_cast<int>(high[i]);
      take(a, i, l, h, re[i] + found[i], im[i] + found[i]);
      found[i] += h - l + 1;
      high[i] = l - 1;
    }
    const auto done = mask_of_bits<F>(converged);
    w.high = load<F>(high);
    w.trial = select(done, F(0.0), w.trial);
  }
}

// A reflection of three rows, I - (v0 v1 v2) (head q r)^T.
template <class F> struct Reflection {
  F head, q, r, v0, v1, v2;
};

// The first column of (A - s1)(A - s2), up to scale, for each window's own pair of shifts; 0 where nothing is left.
template <class F, int N, int Room> void first_column(const F (&a)[N][Room], Windows<F>& w, F (&column)[3]) {
  constexpr int W = width_of<F>;
  enum { kX, kY, kBelow, kBeside, kNext, kTop, kUnder, kOver, kSecond, kThird, kPlaces };
  F at[kPlaces];
  double low[W], high[W];
  store(low, w.low);
  store(high, w.high);
#pragma GCC unroll 8
  for (int i = 0; i < W; ++i) {
    const bool some = high[i] >= 0;
    const int h = some ? static_cast<int>(high[i]) : 2, k = some ? static_cast<int>(low[i]) : 0;
    set_lane(at[kX], i, lane(a[h][h], i));
    set_lane(at[kY], i, lane(a[h - 1][h - 1], i));
    set_lane(at[kBelow], i, lane(a[h][h - 1], i));
    set_lane(at[kBeside], i, lane(a[h - 1][h], i));
    set_lane(at[kNext], i, lane(a[h - 1][h - 2], i));
    set_lane(at[kTop], i, lane(a[k][k], i));
    set_lane(at[kUnder], i, lane(a[k + 1][k], i));
    set_lane(at[kOver], i, lane(a[k][k + 1], i));
    set_lane(at[kSecond], i, lane(a[k + 1][k + 1], i));
    set_lane(at[kThird], i, lane(a[k + 2][k + 1], i));
  }
  F x = at[kX], y = at[kY], product = at[kBelow] * at[kBeside];
  // an exceptional pair of shifts breaks a cycle
  const auto cycling = (w.trial == 9.0) | (w.trial == 19.0) | (w.trial == 29.0) | (w.trial == 39.0) |
                       (w.trial == 49.0) | (w.trial == 59.0);
  if (__builtin_expect(any(cycling), 0)) {
    const F s = abs(at[kBelow]) + abs(at[kNext]), shift = x + 0.75 * s;
    x = select(cycling, shift, x);
    y = select(cycling, shift, y);
    product = select(cycling, -0.4375 * s * s, product);
  }
  w.trial += 1.0;
  // differences first: they are all that is left in a cluster
  const F z = at[kTop], dx = x - z, dy = y - z;
  column[0] = (dx * dy - product) / at[kUnder] + at[kOver];
  column[1] = at[kSecond] - z - dx - dy;
  column[2] = at[kThird];
  const F size = 1.0 / (abs(column[0]) + abs(column[1]) + abs(column[2]));
  const auto some = w.high >= 0.0;
  for (F& c : column) c = select(some, c * size, F(0.0));
}

// The reflection that begins or goes on with the sweeps at row k; what it takes is written as it leaves it. With Begin no window
// began before.
template <bool Begin, class F, int N, int Room>
PIEPER_INLINE Reflection<F> reflection(F (&a)[N][Room], const Windows<F>& w, const F (&column)[3], int k) {
  const double at = k;
  const auto first = w.low == at;
  const bool third = k + 2 < N;
  F p = select(first, column[0], F(0.0)), q = select(first, column[1], F(0.0)), r = select(first, column[2], F(0.0));
  auto inside = first, has_third = first;
  if constexpr (!Begin) {
    inside = (w.low < at) & (w.high > at);
    has_third = inside & (w.high > at + 1.5);
    p = select(inside, a[k][k - 1], p);
    q = select(inside, a[k + 1][k - 1], q);
    if (third) r = select(has_third, a[k + 2][k - 1], r);
  }
  const F norm = sqrt(p * p + q * q + r * r);
  const F s = select(p < 0.0, 0.0 - norm, norm);
  const F head = p + s, size = s * head;
  const F scale = select(size > 0.0, 1.0 / select(size > 0.0, size, F(1.0)), F(0.0));
  if constexpr (!Begin) {
    inside = inside & (norm > 0.0);
    a[k][k - 1] = select(inside, 0.0 - s, a[k][k - 1]);
    a[k + 1][k - 1] = select(inside, F(0.0), a[k + 1][k - 1]);
    if (third) a[k + 2][k - 1] = select(inside & has_third, F(0.0), a[k + 2][k - 1]);
  }
  return {head, q, r, head * scale, q * scale, r * scale};
}

// The rows from k on turned, in the columns from `begin` up to `end`.
template <int Rows, class F, int N, int Room>
PIEPER_INLINE void turn_rows(F (&a)[N][Room], const Reflection<F>& v, int k, int begin, int end) {
  for (int j = begin; j <= end; ++j) {
    F t = v.head * a[k][j] + v.q * a[k + 1][j];
    if constexpr (Rows == 3) t += v.r * a[k + 2][j];
    a[k][j] -= t * v.v0;
    a[k + 1][j] -= t * v.v1;
    if constexpr (Rows == 3) a[k + 2][j] -= t * v.v2;
  }
}
template <int Columns, class F, int N, int Room>
PIEPER_INLINE void turn_columns(F (&a)[N][Room], const Reflection<F>& v, int k, int begin, int end) {
  for (int i = begin; i <= end; ++i) {
    F t = v.v0 * a[i][k] + v.v1 * a[i][k + 1];
    if constexpr (Columns == 3) t += v.v2 * a[i][k + 2];
    a[i][k] -= t * v.head;
    a[i][k + 1] -= t * v.q;
    if constexpr (Columns == 3) a[i][k + 2] -= t * v.r;
  }
}

// Eigenvalues of upper Hessenberg matrices (destroyed), one a lane. found[i] < N only when lane i met its bound.
template <class F, int N, int Room>
void hessenberg_eigenvalues(F (&a)[N][Room], double (*re)[N], double (*im)[N], int* found) {
  constexpr int W = width_of<F>;
  Windows<F> w;
  w.norm = 0.0;
  for (int r = 0; r < N; ++r)
    for (int c = r ? r - 1 : 0; c < N; ++c) w.norm += abs(a[r][c]);
  w.low = w.trial = 0.0;
  w.high = select(w.norm < kEigenvalueOverflow, F(N - 1.0), F(-1.0));
  for (int i = 0; i < W; ++i) found[i] = 0;
  for (;;) {
    int to = deflate(a, w, re, im, found);
    if (to < 0) break;
    const auto given_up = w.trial == 60.0;
    if (__builtin_expect(any(given_up), 0)) {
      w.high = select(given_up, F(-1.0), w.high);
      to = deflate(a, w, re, im, found);
      if (to < 0) break;
    }
    F column[3];
    first_column(a, w, column);
    // a window that is empty neither begins nor ends
    w.low = select(w.high >= 0.0, w.low, F(double(N)));
    double low[W];
    store(low, w.low);
    int from = N;
    for (int i = 0; i < W; ++i) from = low[i] < from ? static_cast<int>(low[i]) : from;
    Reflection<F> next = reflection<true>(a, w, column, from);
    for (int k = from; k < to; ++k) {
      const Reflection<F> v = next;
      if (k + 2 < N) {
        const int near = W > 1 && k + 2 < to ? k + 2 : to, last = k + 3 < to ? k + 3 : to;
        turn_rows<3>(a, v, k, k, near);
        turn_columns<3>(a, v, k, W > 1 ? k + 1 : from, last);
        if (k + 1 < to) next = reflection<false>(a, w, column, k + 1);
        turn_rows<3>(a, v, k, near + 1, to);
        if (W > 1) turn_columns<3>(a, v, k, from, k);
      } else {
        turn_rows<2>(a, v, k, k, to);
        turn_columns<2>(a, v, k, from, to);
      }
    }
  }
}

}  // namespace pieper::PIEPER_ISA::general
