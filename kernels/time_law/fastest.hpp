// The fastest way along a joint path within speeds and accelerations: controllable sets backward, then greedily forward
// (Pham and Pham 2018), with rows that hold on all of a cell and not at its ends alone.
//
// The path is cubic in s on each cell, x = (ds/dt)^2 is linear there and u = d2s/dt2 constant. A joint's acceleration
// q' u + q'' x is then a quadratic of s; its three Bernstein coefficients are linear in (u, x) at the cell's beginning,
// and keeping them inside the limit keeps the acceleration inside. A joint's squared speed q'^2 x is of degree five.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tolerances.hpp"

namespace pieper {

struct TimedPath {
  long cells;
  int joints, extra;                   // extra rows a cell: |a u + b x| <= c
  const double* s;                     // cells + 1
  const double *d1, *d2, *d3;          // cells x joints, derivatives of q at a cell's beginning
  const double *speed, *acceleration;  // cells x joints
  const double *a, *b, *c;             // cells x extra
  const double* most;                  // cells + 1, further bounds of x; may be infinite
  const double* wanted;                // cells + 1, x that must be had; NaN where free
};

struct Timing {
  bool done;
  long where;       // the cell or point where it is impossible
  double* x;        // cells + 1
  double* highest;  // cells + 1, the controllable sets' upper ends
};

class FastestPass {
 public:
  explicit FastestPass(const TimedPath& path)
      : p_(path), rows_(3 * path.joints + path.extra), slope_(rows_), room_(rows_), cap_(path.cells + 1) {
    caps();
  }

  Timing run(double start, double end, double* x, double* highest) {
    const long n = p_.cells;
    std::vector<double> lowest(n + 1);
    if (!std::isnan(p_.wanted[n])) end = p_.wanted[n];
    lowest[n] = highest[n] = end;
    for (long i = n - 1; i >= 0; --i) {
      const double most = set(i, lowest[i + 1], highest[i + 1]);
      if (!std::isnan(p_.wanted[i])) {
        const double w = p_.wanted[i];
        if (w > most * (1 + kSetRounding) || !holds(w)) return {false, i, x, highest};
        lowest[i] = highest[i] = w;
        continue;
      }
      if (!(largest(most, highest[i]) && smallest(highest[i], lowest[i]))) return {false, i, x, highest};
    }
    if (start < lowest[0] * (1 - kSetRounding) || start > highest[0] * (1 + kSetRounding))
      return {false, -1, x, highest};
    x[0] = start;
    for (long i = 0; i < n; ++i) {
      set(i, lowest[i + 1], highest[i + 1]);
      x[i + 1] = std::clamp(x[i] + 2 * width(i) * above(x[i]).value, lowest[i + 1], highest[i + 1]);
    }
    return {true, n, x, highest};
  }

 private:
  struct Line {
    double value, offset, slope;
  };

  double width(long i) const { return p_.s[i + 1] - p_.s[i]; }

  // x at the points of a cell such that all Bernstein coefficients of q'^2 x stay within the squared speed
  void caps() {
    const long n = p_.cells;
    const int m = p_.joints;
    std::fill(cap_.begin(), cap_.end(), std::numeric_limits<double>::infinity());
    for (long i = 0; i <= n; ++i) cap_[i] = std::min(p_.most[i], std::isnan(p_.wanted[i]) ? kFastest : p_.wanted[i]);
    for (long i = 0; i < n; ++i) {
      const double h = width(i);
      for (int j = 0; j < m; ++j) {
        const double a = p_.d1[i * m + j], b = p_.d2[i * m + j], v = p_.speed[i * m + j];
        const double e = a + h * (b + h / 2 * p_.d3[i * m + j]);
        if (a * a * cap_[i] > v * v) cap_[i] = v * v / (a * a);
        if (e * e * cap_[i + 1] > v * v) cap_[i + 1] = v * v / (e * e);
      }
    }
    std::vector<double> shrink(n + 1, 1.0);
    for (long i = 0; i < n; ++i) {
      const double h = width(i), x0 = cap_[i], x1 = cap_[i + 1];
      double worst = 1.0;
      for (int j = 0; j < m; ++j) {
        const double r0 = p_.d1[i * m + j], r1 = r0 + h / 2 * p_.d2[i * m + j];
        const double r2 = r0 + h * (p_.d2[i * m + j] + h / 2 * p_.d3[i * m + j]), v = p_.speed[i * m + j];
        const double sq[5] = {r0 * r0, std::max(r0 * r1, 0.0), std::max((r0 * r2 + 2 * r1 * r1) / 3, 0.0),
                              std::max(r1 * r2, 0.0), r2 * r2};
        for (int k = 1; k <= 4; ++k) worst = std::max(worst, ((5 - k) * sq[k] * x0 + k * sq[k - 1] * x1) / (5 * v * v));
      }
      shrink[i] = std::max(shrink[i], worst);
      shrink[i + 1] = std::max(shrink[i + 1], worst);
    }
    for (long i = 0; i <= n; ++i) cap_[i] /= shrink[i];
  }

  // Takes up the rows of cell i: u + slope x within +- room, and x + 2 h u within the next set. Returns the bound of x.
  double set(long i, double low, double high) {
    const double h = width(i);
    double most = cap_[i];
    const double reach = std::max(cap_[i], high) / (2 * h);  // no |u| is larger
    int k = 0;
    auto row = [&](double a, double b, double c) {
      // a joint that rests has rows of rounding alone: what cannot bind, whatever u and x are, is left out, and what u
      // cannot move by more than rounding bounds x alone
      const double push = std::fabs(a) * reach, pull = std::fabs(b) * cap_[i];
      if (push + pull <= c) return;
      if (push <= kRowFlat * c) {
        most = std::min(most, (c - push) / std::fabs(b));
        return;
      }
      slope_[k] = b / a;
      room_[k++] = c / std::fabs(a);
    };
    const int m = p_.joints;
    for (int j = 0; j < m; ++j) {
      const double d1 = p_.d1[i * m + j], d2 = p_.d2[i * m + j], d3 = p_.d3[i * m + j];
      const double c = p_.acceleration[i * m + j], e2 = d2 + h * d3;
      row(d1, d2, c);
      row(d1 + 1.5 * h * d2, d2 + h / 2 * d3, c);
      row(d1 + h * (d2 + h / 2 * d3) + 2 * h * e2, e2, c);
    }
    for (int j = 0; j < p_.extra; ++j) row(p_.a[i * p_.extra + j], p_.b[i * p_.extra + j], p_.c[i * p_.extra + j]);
    used_ = k;
    next_ = 1 / (2 * h);
    low_ = low * next_;
    high_ = high * next_;
    return most;
  }

  Line above(double x) const {
    Line best{high_ - next_ * x, high_, next_};
    for (int k = 0; k < used_; ++k) {
      const double u = room_[k] - slope_[k] * x;
      if (u < best.value) best = {u, room_[k], slope_[k]};
    }
    return best;
  }
  Line below(double x) const {
    Line best{low_ - next_ * x, low_, next_};
    for (int k = 0; k < used_; ++k) {
      const double u = -room_[k] - slope_[k] * x;
      if (u > best.value) best = {u, -room_[k], slope_[k]};
    }
    return best;
  }
  static bool open(const Line& hi, const Line& lo) {
    return hi.value >= lo.value - kSetRounding * (std::fabs(hi.value) + std::fabs(lo.value));
  }
  bool holds(double x) const { return open(above(x), below(x)); }

  // The room for u is a concave function of x, linear in pieces: Newton from outside ends after as many steps as pieces.
  bool largest(double most, double& x) const {
    x = most;
    for (int round = 0; round < 4 * rows_ + 8; ++round) {
      const Line hi = above(x), lo = below(x);
      if (open(hi, lo)) return true;
      const double narrowing = hi.slope - lo.slope;
      if (narrowing <= 0) return false;
      const double next = (hi.offset - lo.offset) / narrowing;
      if (next < 0) return false;
      if (next >= x) return true;
      x = next;
    }
    return true;
  }
  bool smallest(double most, double& x) const {
    x = 0.0;
    for (int round = 0; round < 4 * rows_ + 8; ++round) {
      const Line hi = above(x), lo = below(x);
      if (open(hi, lo)) return x <= most * (1 + kSetRounding);
      const double widening = lo.slope - hi.slope;
      if (widening <= 0) return false;
      const double next = (lo.offset - hi.offset) / widening;
      if (next > most * (1 + kSetRounding)) return false;
      if (next <= x) return true;
      x = next;
    }
    return true;
  }

  const TimedPath& p_;
  int rows_, used_ = 0;
  std::vector<double> slope_, room_, cap_;
  double next_ = 0, low_ = 0, high_ = 0;
};

}  // namespace pieper
