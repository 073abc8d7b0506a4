// Real roots of a binary quartic form, none lost: the polynomial behind every closed form that is not quadratic.
//
// A root is a direction (p : q) of F(p, q) = f0 q^4 + f1 p q^3 + f2 p^2 q^2 + f3 p^3 q + f4 p^4, so a half-angle
// tan(theta/2) = p/q at infinity (theta = pi) is as good as any other. The form is first turned so that |F| is large
// in the direction of infinity; every root is then of size about one and the leading coefficient never vanishes.
// Roots are bracketed by the roots of the derivative (Rolle), so two close ones are never confused with none. An extremum that
// touches zero within rounding is reported too: it is a double root, or a pair that rounding has pulled apart.
// Scalar: the careful twin of closed_form/lanes/quartic.hpp.
#pragma once

#include <cmath>

#include "lanes/lanes.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA::closed_form {

struct Direction {
  double p, q;
};

// Value and slope of a polynomial c[0] + c[1] t + ... + c[degree] t^degree.
inline void evaluate(const double* c, int degree, double t, double& value, double& slope) {
  value = c[degree];
  slope = 0;
  for (int k = degree - 1; k >= 0; --k) {
    slope = slope * t + value;
    value = value * t + c[k];
  }
}

// The root between a and b, where the polynomial has different signs: Newton's step, or bisection when it leaves.
inline double root_between(const double* c, int degree, double a, double b, double at_a) {
  double t = 0.5 * (a + b);
  for (int i = 0; i < 80; ++i) {
    double value, slope;
    evaluate(c, degree, t, value, slope);
    if (value == 0) return t;
    if ((value < 0) == (at_a < 0)) a = t;
    else b = t;
    double next = t - value / slope;
    if (!(next > a && next < b)) next = 0.5 * (a + b);
    if (std::fabs(next - t) <= kRootStep * (1 + std::fabs(t))) return next;
    t = next;
  }
  return t;
}

// Real roots of a polynomial inside (-bound, bound), given the ascending (near-)critical points: sign changes first, then the
// critical points themselves where the curve touches zero. Returns how many; they are written in ascending order.
inline int roots_from_critical(const double* c, int degree, double bound, const double* critical, int count,
                               double touching, double* roots) {
  int found = 0;
  double left = -bound, at_left, slope;
  evaluate(c, degree, left, at_left, slope);
  for (int k = 0; k <= count; ++k) {
    double right = k < count ? critical[k] : bound, at_right;
    evaluate(c, degree, right, at_right, slope);
    bool crosses = (at_left < 0) != (at_right < 0);
    if (crosses) roots[found++] = root_between(c, degree, left, right, at_left);
    if (k < count && std::fabs(at_right) <= touching) {
      // unless it is the crossing just found
      double near = found ? roots[found - 1] : -2 * bound;
      if (!(std::fabs(near - right) <= kRootTwice)) roots[found++] = right;
    }
    left = right;
    at_left = at_right;
  }
  return found;
}

// Real roots (with touches) of a quartic with |c[4]| not small against the others; at most 9 are written.
inline int quartic_roots(const double* c, double* roots) {
  double bound = 0;
  for (int k = 0; k < 4; ++k) bound = std::fmax(bound, std::fabs(c[k] / c[4]));
  bound += 1;
  const double first[4] = {c[1], 2 * c[2], 3 * c[3], 4 * c[4]};
  const double second[3] = {first[1], 2 * first[2], 3 * first[3]};
  double inflection[2];
  int inflections = 0;
  double h = -0.5 * second[1], disc = h * h - second[0] * second[2];
  double size = std::fabs(c[0]) + std::fabs(c[1]) + std::fabs(c[2]) + std::fabs(c[3]) + std::fabs(c[4]);
  if (disc > 0) {
    double s = std::sqrt(disc), big = h >= 0 ? h + s : h - s;
    double r1 = big / second[2], r2 = big != 0 ? second[0] / big : r1;
    inflection[0] = std::fmin(r1, r2);
    inflection[1] = std::fmax(r1, r2);
    inflections = 2;
  } else if (disc > -kRootFlat * size * size) {
    inflection[0] = h / second[2];
    inflections = 1;
  }
  double critical[8];
  int criticals = roots_from_critical(first, 3, bound, inflection, inflections, kRootTouchingSlope * size, critical);
  return roots_from_critical(c, 4, bound, critical, criticals, kRootTouching * size, roots);
}

// Substitute p <- c p - s q, q <- s p + c q in a quartic form.
inline void turn_form(const double* f, double c, double s, double* out) {
  double acc[5] = {f[4], 0, 0, 0, 0};
  // (p', q') -> p = c p' - s q', q = s p' + c q'. Build sum f_k p^k q^(4-k) by Horner in p with q multiplied in step by step.
  double qpow[5] = {1, 0, 0, 0, 0};  // q^m, coefficient j belongs to p'^j
  for (int m = 1; m <= 4; ++m) {
    double next[5] = {}, nq[5] = {};
    for (int j = 0; j < m; ++j) {  // acc has degree m - 1 and becomes acc * p + f[4 - m] * q^m
      next[j + 1] += c * acc[j];
      next[j] -= s * acc[j];
      nq[j + 1] += s * qpow[j];
      nq[j] += c * qpow[j];
    }
    for (int j = 0; j <= m; ++j) {
      qpow[j] = nq[j];
      acc[j] = next[j] + f[4 - m] * nq[j];
    }
  }
  for (int j = 0; j <= 4; ++j) out[j] = acc[j];
}

// Every real direction in which a quartic form vanishes (touches included); at most 7 are written, p*p + q*q = 1.
// Returns -1 when the form vanishes identically within `floor`.
inline int form_directions(const double* f, double floor, Direction* out) {
  static const double C[8] = {1, 0.92387953251128674,  0.70710678118654752,  0.38268343236508977,
                              0, -0.38268343236508977, -0.70710678118654752, -0.92387953251128674};
  static const double S[8] = {0, 0.38268343236508977, 0.70710678118654752, 0.92387953251128674,
                              1, 0.92387953251128674, 0.70710678118654752, 0.38268343236508977};
  int best = 0;
  double most = -1;
  for (int k = 0; k < 8; ++k) {
    double p = C[k], q = S[k];
    double value =
        std::fabs((((f[4] * p + f[3] * q) * p + f[2] * q * q) * p + f[1] * q * q * q) * p + f[0] * q * q * q * q);
    if (value > most) most = value, best = k;
  }
  if (!(most > floor)) return -1;
  double g[5], t[12];
  turn_form(f, C[best], S[best], g);
  for (int k = 0; k < 5; ++k) g[k] /= most;
  int count = quartic_roots(g, t);
  for (int i = 0; i < count; ++i) {
    double n = 1 / std::sqrt(1 + t[i] * t[i]);
    out[i] = {(C[best] * t[i] - S[best]) * n, (S[best] * t[i] + C[best]) * n};
  }
  return count;
}

}  // namespace pieper::PIEPER_ISA::closed_form
