// Real roots of a binary quartic form for many poses at once, by the same bracketing as closed_form/careful/quartic.hpp. It answers only where all is clear:
// a lane whose curve comes near to touching zero between two roots is handed back as `unclear`.
// A template over the number type; the careful scalar twin is closed_form/careful/quartic.hpp.
#pragma once

#include "lanes/math.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA::closed_form {

template <class F, int Degree> PIEPER_INLINE void value_and_slope(const F* c, F t, F& value, F& slope) {
  value = c[Degree];
  slope = F(0.0);
  for (int k = Degree - 1; k >= 0; --k) {
    slope = slope * t + value;
    value = value * t + c[k];
  }
}
template <class F, int Degree> PIEPER_INLINE F value_of(const F* c, F t) {
  F value = c[Degree];
  for (int k = Degree - 1; k >= 0; --k) value = value * t + c[k];
  return value;
}

// Roots inside Count neighbouring brackets at once: edge[i]..edge[i + 1] holds one where signs differ (`inside`). Newton's step,
// or bisection where it would leave; at most `steps` of them. A root that moves no more keeps its digits, whatever other lanes need.
template <class F, int Degree, int Count> __attribute__((noinline)) void bracketed_roots(const F* c, const F* edge,
                                                                                         int steps, double precision,
                                                                                         F* root, Mask<F>* inside) {
  F between[3 * Count], at_low[Count];
  F *const at = between, *const low = at + Count, *const high = low + Count;
  F left = value_of<F, Degree>(c, edge[0]);
  for (int i = 0; i < Count; ++i) {
    F right = value_of<F, Degree>(c, edge[i + 1]);
    inside[i] = (left < 0.0) & !(right < 0.0);
    inside[i] = inside[i] | ((!(left < 0.0)) & (right < 0.0));
    low[i] = edge[i], high[i] = edge[i + 1], at_low[i] = left;
    // the chord's root is a good start where the bracket is short, the middle where it is long
    F chord = low[i] + (high[i] - low[i]) * (left / select(right == left, F(1.0), left - right));
    F middle = 0.5 * (low[i] + high[i]);
    at[i] = select(inside[i], 0.5 * (chord + middle), middle);
    left = right;
  }
  Mask<F> going[Count];
  for (int i = 0; i < Count; ++i) going[i] = inside[i];
  repeat(steps, between, [&] {
    Mask<F> moving = mask_of<F>(false);
    for (int i = 0; i < Count; ++i) {
      F value, slope;
      value_and_slope<F, Degree>(c, at[i], value, slope);
      // same sign as the lower end: the root lies above
      Mask<F> above = (value * at_low[i]) > 0.0;
      low[i] = select(above, at[i], low[i]);
      high[i] = select(above, high[i], at[i]);
      F next = at[i] - value / select(slope == 0.0, F(kTiny), slope);
      Mask<F> fine = (next >= low[i]) & (next <= high[i]);
      next = select(fine, next, 0.5 * (low[i] + high[i]));
      const Mask<F> still = going[i] & (abs(next - at[i]) > precision);
      at[i] = select(going[i], next, at[i]);
      going[i] = still;
      moving = moving | still;
    }
    return moving;
  });
  for (int i = 0; i < Count; ++i) root[i] = at[i];
}

// Directions (p, q), p^2 + q^2 = 1, in which the form f0 q^4 + .. + f4 p^4 vanishes: at most four, `found` says which hold.
template <class F>
__attribute__((noinline)) void form_directions(const F* f, F floor, F* p, F* q, Mask<F>* found, Mask<F>& unclear) {
  static const double C[4] = {1, 0.70710678118654752, 0, -0.70710678118654752};
  static const double S[4] = {0, 0.70710678118654752, 1, 0.70710678118654752};
  static const double C2[4] = {0.92387953251128674, 0.38268343236508977, -0.38268343236508977, -0.92387953251128674};
  static const double S2[4] = {0.38268343236508977, 0.92387953251128674, 0.92387953251128674, 0.38268343236508977};
  F most(-1.0), c(1.0), s(0.0), lead(1.0);
  for (int k = 0; k < 8; ++k) {
    double x = k < 4 ? C[k] : C2[k - 4], y = k < 4 ? S[k] : S2[k - 4];
    double x2 = x * x, y2 = y * y;
    F value = (f[4] * (x2 * x2) + f[3] * (x2 * x * y)) + (f[2] * (x2 * y2) + (f[1] * (x * y2 * y) + f[0] * (y2 * y2)));
    Mask<F> better = abs(value) > most * (1.0 + kRootTie);  // ties, common by symmetry, go to the first
    most = select(better, abs(value), most);
    lead = select(better, value, lead);
    c = select(better, F(x), c);
    s = select(better, F(y), s);
  }
  unclear = unclear | !(most > floor);
  lead = select(most > 0.0, lead, F(1.0));
  // p <- c p - s q, q <- s p + c q
  F acc[5] = {f[4], F(0.0), F(0.0), F(0.0), F(0.0)}, power[5] = {F(1.0), F(0.0), F(0.0), F(0.0), F(0.0)};
  for (int m = 1; m <= 4; ++m) {
    F next[5], np[5];
    for (int j = 0; j <= m; ++j) {
      F up = j > 0 ? c * acc[j - 1] : F(0.0), pu = j > 0 ? s * power[j - 1] : F(0.0);
      next[j] = j < m ? up - s * acc[j] : up;
      np[j] = j < m ? pu + c * power[j] : pu;
    }
    for (int j = 0; j <= m; ++j) {
      power[j] = np[j];
      acc[j] = next[j] + f[4 - m] * np[j];
    }
  }
  F g[5], slope[4];
  F inverse_lead = 1.0 / lead, size(1.0);
  for (int k = 0; k < 4; ++k) g[k] = acc[k] * inverse_lead, size = size + abs(g[k]);
  g[4] = F(1.0);
  slope[0] = g[1], slope[1] = 2.0 * g[2], slope[2] = 3.0 * g[3], slope[3] = F(4.0);
  // |F| is largest at infinity within a factor 1.5, so by Bernstein's inequality no root lies beyond 6
  F inner = -0.25 * g[3], disc = inner * inner - g[2] * (1.0 / 6.0), root = sqrt(max(disc, F(0.0)));
  F edges[4] = {F(-8.0), inner - root, inner + root, F(8.0)}, critical[3];
  Mask<F> turning[3];
  bracketed_roots<F, 3, 3>(slope, edges, 12, kRootCriticalPrecision, critical, turning);
  F splits[5] = {F(-8.0), critical[0], critical[1], critical[2], F(8.0)}, t[4];
  for (int i = 0; i < 3; ++i) {
    F value, lean;
    value_and_slope<F, 4>(g, critical[i], value, lean);
    unclear = unclear | (turning[i] & ((abs(value) < kRootUnclear * size) | (abs(lean) > kRootSlopeUnclear * size)));
  }
  for (int i = 1; i < 3; ++i)  // the derivative may touch zero where its own extremum lies
    unclear = unclear | ((abs(value_of<F, 3>(slope, edges[i])) < kRootInflectionUnclear * size) &
                         (abs(value_of<F, 4>(g, edges[i])) < kRootInflectionUnclear * size));
  bracketed_roots<F, 4, 4>(g, splits, 40, kRootPrecision, t, found);
  for (int i = 0; i < 4; ++i) {
    F n = 1.0 / sqrt(1.0 + t[i] * t[i]);
    p[i] = (c * t[i] - s) * n;
    q[i] = (s * t[i] + c) * n;
  }
}

}  // namespace pieper::PIEPER_ISA::closed_form
