// A cubic joint curve under a profile of its parameter: samples in time, and the largest parts of limits that each piece
// uses. Joints stand in lanes.
#pragma once

#include "lanes/lanes.hpp"
#include "time_law/timed_path.hpp"

namespace pieper::PIEPER_ISA {

// Calls body(number, j) for joints j, as many at once as a vector holds, the last ones one by one.
template <class Body> PIEPER_INLINE void over_joints(int n, Body body) {
  int j = 0;
  for (; j + PIEPER_LANES <= n; j += PIEPER_LANES) body(Lanes<PIEPER_LANES>(0.0), j);
  for (; j < n; ++j) body(0.0, j);
}

// The largest part of each joint's limits that each piece uses, x = (ds/dt)^2 (cells + 1) linear on it: of the speed
// (row 2 j) and of the acceleration (row 2 j + 1), rows of `cells`. The acceleration is a quadratic of s and the speed has
// it, over sqrt(x), as its derivative: both are looked at in the ends and wherever they peak between. share (cells): the
// part of the speeds that is meant.
inline void peak_ratios(const CubicPieces& p, const double* x, const double* speed, const double* acceleration,
                        const double* share, double* out) {
  const int n = p.joints;
  for (long i = 0; i < p.cells; ++i) {
    const double h = p.s[i + 1] - p.s[i], x0 = x[i], u = (x[i + 1] - x0) / (2 * h);
    over_joints(n, [&](auto number, int j) {
      using N = decltype(number);
      const long k = i * n + j;
      const N a = load<N>(p.d1 + k), b = load<N>(p.d2 + k), c = load<N>(p.d3 + k);
      // acceleration A + B r + C r^2 at r behind the beginning
      const N A = a * u + b * x0, B = 3 * u * b + c * x0, C = 2.5 * u * c;
      auto bend = [&](N r) { return A + r * (B + r * C); };
      auto square = [&](N r) {
        const N v = a + r * (b + r * c * 0.5);
        return v * v * max(x0 + 2 * u * r, N(0.0));
      };
      // of what is not a number, and of what lies outside, an end
      auto inside = [&](N r) { return min(max(r, N(0.0)), N(h)); };
      N most = max(abs(A), abs(bend(N(h)))), fastest = max(square(N(0.0)), square(N(h)));
      most = max(most, abs(bend(inside(-0.5 * B / C))));
      const N half = -0.5 * (B + with_sign_of(sqrt(max(B * B - 4.0 * A * C, N(0.0))), B));
      fastest = max(fastest, max(square(inside(half / C)), square(inside(A / half))));
      const N rate = sqrt(fastest) / (load<N>(speed + j) * share[i]), part = most / load<N>(acceleration + j);
      for (int w = 0; w < width_of<N>; ++w) {
        out[2 * (j + w) * p.cells + i] = lane(rate, w);
        out[(2 * (j + w) + 1) * p.cells + i] = lane(part, w);
      }
    });
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
    const double h = s[k] - p.s[cell], v2 = v * v, v3 = v2 * v, va = 3 * v * a;
    over_joints(p.joints, [&](auto number, int j) {
      using N = decltype(number);
      const long i = cell * p.joints + j, o = k * p.joints + j;
      const N f1 = load<N>(p.d1 + i), f2 = load<N>(p.d2 + i), d3 = load<N>(p.d3 + i);
      const N d2 = f2 + h * d3, d1 = f1 + h * (f2 + h / 2 * d3);
      store(q + o, load<N>(p.q + i) + h * (f1 + h * (0.5 * f2 + h / 6 * d3)));
      store(dq + o, d1 * v);
      store(ddq + o, d2 * v2 + d1 * a);
      store(dddq + o, d3 * v3 + d2 * va + d1 * jerk);
    });
  }
}

// Most places of a piece at which values are taken.
inline constexpr int kMostPlaces = 9;

// The largest parts of each joint's speed, acceleration and jerk (rows 3 j, 3 j + 1, 3 j + 2 of `pieces`) under a profile
// of which every piece lies on one piece of the curve, and the largest ds/dt of each piece. Proved where `coefficients`
// (places x places, from values at even places to Bernstein coefficients) are given, else the largest of the values.
inline void jerk_ratios(const CubicPieces& curve, long pieces, const double* t, const double* c,
                        const JerkBounds& bounds, const double* coefficients, int places, double* out,
                        double* fastest) {
  const int n = curve.joints;
  auto most = [&](const auto* v) {
    auto best = abs(v[0]);
    for (int k = 0; k < places; ++k) {
      auto sum = v[k];
      if (coefficients) {
        sum = coefficients[k * places] * v[0];
        for (int i = 1; i < places; ++i) sum += coefficients[k * places + i] * v[i];
      }
      best = coefficients && k == 0 ? abs(sum) : max(best, abs(sum));
    }
    return best;
  };
  double r[kMostPlaces], rate[kMostPlaces], bend[kMostPlaces];
  long at = 0, cell = 0;
  for (long k = 0; k < pieces; ++k, c += 4) {
    const double h = t[k + 1] - t[k];
    for (int i = 0; i < places; ++i) {
      const double tau = h * i / (places - 1);
      r[i] = c[0] + tau * (c[1] + tau * (c[2] / 2 + tau * c[3] / 6));
      rate[i] = c[1] + tau * (c[2] + tau * c[3] / 2);
      bend[i] = c[2] + tau * c[3];
    }
    // each piece has one piece of the curve, that of its middle, and is looked at beyond its ends if rounding wants it
    const double middle = r[places / 2], sharp = c[3];
    while (at + 1 < curve.cells && middle >= curve.s[at + 1]) ++at;
    while (cell + 1 < bounds.cells && middle >= bounds.s[cell + 1]) ++cell;
    for (int i = 0; i < places; ++i) r[i] -= curve.s[at];
    fastest[k] = most(rate);
    over_joints(n, [&](auto number, int j) {
      using N = decltype(number);
      const long from = at * n + j;
      const N d1 = load<N>(curve.d1 + from), d2 = load<N>(curve.d2 + from), d3 = load<N>(curve.d3 + from);
      N speeds[kMostPlaces], bends[kMostPlaces], jerks[kMostPlaces];
      for (int i = 0; i < places; ++i) {
        const N q2 = d2 + r[i] * d3, q1 = d1 + r[i] * (d2 + 0.5 * r[i] * d3);
        const double v = rate[i];
        speeds[i] = q1 * v;
        bends[i] = q2 * (v * v) + q1 * bend[i];
        jerks[i] = d3 * (v * v * v) + q2 * (3 * v * bend[i]) + q1 * sharp;
      }
      const N parts[] = {most(speeds) / (load<N>(bounds.speed + j) * bounds.share[cell]),
                         most(bends) / load<N>(bounds.acceleration + j), most(jerks) / load<N>(bounds.jerk + j)};
      for (int what = 0; what < 3; ++what)
        for (int w = 0; w < width_of<N>; ++w) out[(3 * (j + w) + what) * pieces + k] = lane(parts[what], w);
    });
  }
}

}  // namespace pieper::PIEPER_ISA
