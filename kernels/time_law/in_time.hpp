// A cubic joint curve under a profile of its parameter: samples in time, and the largest speeds and accelerations a piece.
#pragma once

#include <algorithm>
#include <cmath>

namespace pieper {

// q(s) in pieces of third degree, derivatives at each piece's beginning: s (cells + 1), the others cells x joints.
struct CubicPieces {
  long cells;
  int joints;
  const double *s, *q, *d1, *d2, *d3;
};

// The largest part of each joint's limits that each piece uses, x = (ds/dt)^2 (cells + 1) linear on it: of the speed
// (row 2 j) and of the acceleration (row 2 j + 1), rows of `cells`. The acceleration is a quadratic of s and the speed has
// it, over sqrt(x), as its derivative: both are looked at in the ends and wherever they peak between. share (cells): the
// part of the speeds that is meant.
inline void peak_ratios(const CubicPieces& p, const double* x, const double* speed, const double* acceleration,
                        const double* share, double* out) {
  const int n = p.joints;
  for (int j = 0; j < n; ++j) {
    double *rates = out + 2 * j * p.cells, *bends = rates + p.cells;
    const double per_bend = 1 / acceleration[j];
    for (long i = 0; i < p.cells; ++i) {
      const double h = p.s[i + 1] - p.s[i], x0 = x[i], u = (x[i + 1] - x0) / (2 * h);
      const double a = p.d1[i * n + j], b = p.d2[i * n + j], c = p.d3[i * n + j];
      // acceleration A + B r + C r^2 at r behind the beginning
      const double A = a * u + b * x0, B = 3 * b * u + c * x0, C = 2.5 * c * u;
      auto bend = [&](double r) { return A + r * (B + r * C); };
      auto square = [&](double r) {
        const double v = a + r * (b + r * c / 2);
        return v * v * std::max(x0 + 2 * u * r, 0.0);
      };
      const double last = bend(h);
      double most = std::max(std::fabs(A), std::fabs(last)), fastest = std::max(square(0), square(h));
      if (B * C < 0 && std::fabs(B) < 2 * std::fabs(C) * h) most = std::max(most, std::fabs(bend(-B / (2 * C))));
      // Bernstein coefficients of one sign: no root, and the speed does not peak between
      const double middle = A + h / 2 * B;
      if (!((A > 0 && middle > 0 && last > 0) || (A < 0 && middle < 0 && last < 0))) {
        auto inside = [&](double r) { return r > 0 ? (r < h ? r : h) : 0.0; };  // of NaN: 0
        const double half = -(B + std::copysign(std::sqrt(std::max(B * B - 4 * A * C, 0.0)), B)) / 2;
        fastest = std::max(fastest, std::max(square(inside(half / C)), square(inside(A / half))));
      }
      rates[i] = std::sqrt(fastest) / (speed[j] * share[i]);
      bends[i] = most * per_bend;
    }
  }
}

// s(t) in `pieces` pieces of third degree: t (pieces + 1), c (pieces x 4) s, its rate, second and third derivative.
// times: count, not falling. out: count x joints each; s: count.
inline void in_time(const CubicPieces& p, long pieces, const double* t, const double* c, const double* times,
                    long count, double* s, double* q, double* dq, double* ddq, double* dddq) {
  long piece = 0, cell = 0;
  for (long k = 0; k < count; ++k) {
    while (piece + 1 < pieces && times[k] >= t[piece + 1]) ++piece;
    const double *at = c + 4 * piece, tau = times[k] - t[piece];
    const double v = at[1] + tau * (at[2] + tau * at[3] / 2), a = at[2] + tau * at[3], jerk = at[3];
    s[k] = at[0] + tau * (at[1] + tau * (at[2] / 2 + tau * at[3] / 6));
    if (k == count - 1) s[k] = p.s[p.cells];
    while (cell + 1 < p.cells && s[k] >= p.s[cell + 1]) ++cell;
    while (cell > 0 && s[k] < p.s[cell]) --cell;
    const double h = s[k] - p.s[cell];
    for (int j = 0; j < p.joints; ++j) {
      const long i = cell * p.joints + j, o = k * p.joints + j;
      const double d3 = p.d3[i], d2 = p.d2[i] + h * d3, d1 = p.d1[i] + h * (p.d2[i] + h * d3 / 2);
      q[o] = p.q[i] + h * (p.d1[i] + h * (p.d2[i] / 2 + h * d3 / 6));
      dq[o] = d1 * v;
      ddq[o] = d2 * v * v + d1 * a;
      dddq[o] = d3 * v * v * v + 3 * d2 * v * a + d1 * jerk;
    }
  }
}

}  // namespace pieper
