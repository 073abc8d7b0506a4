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
  explicit FastestPass(const TimedPath& path) : p_(path), cap_(path.cells + 1), cells_(path.cells) {
    rows_.reserve(path.cells * 6);
    caps();
  }

  Timing run(double start, double end, double* x, double* highest) {
    const long n = p_.cells;
    std::vector<double> lowest(n + 1);
    if (!std::isnan(p_.wanted[n])) end = p_.wanted[n];
    lowest[n] = highest[n] = end;
    for (long i = n - 1; i >= 0; --i) {
      const Cell& c = set(i, lowest[i + 1], highest[i + 1]);
      if (!std::isnan(p_.wanted[i])) {
        const double w = p_.wanted[i];
        if (w > c.most * (1 + kSetRounding) || !room_at(c, w).open()) return {false, i, x, highest};
        lowest[i] = highest[i] = w;
        continue;
      }
      if (!(largest(c, highest[i]) && smallest(c, highest[i], lowest[i]))) return {false, i, x, highest};
    }
    if (start < lowest[0] * (1 - kSetRounding) || start > highest[0] * (1 + kSetRounding))
      return {false, -1, x, highest};
    x[0] = start;
    for (long i = 0; i < n; ++i) {
      const double u = room_at(cells_[i], x[i]).above;
      x[i + 1] = std::clamp(x[i] + 2 * width(i) * u, lowest[i + 1], highest[i + 1]);
    }
    return {true, n, x, highest};
  }

 private:
  // u + slope x within +- room
  struct Row {
    double slope, room;
  };
  // The rows of a cell, and x + 2 h u within the next set: u + next x within low and high.
  struct Cell {
    long first, rows;
    double next, low, high, most, narrowest;  // most: the bound of x; narrowest: the least room
  };
  // What is left for u at some x: up to `above` and down to `below`, and the slopes of the rows that say so.
  struct Room {
    double above, above_slope, above_offset, below, below_slope, below_offset;
    bool open() const { return above >= below - kSetRounding * (std::fabs(above) + std::fabs(below)); }
  };

  double width(long i) const { return p_.s[i + 1] - p_.s[i]; }

  // x at the points of a cell such that all Bernstein coefficients of q'^2 x stay within the squared speed
  void caps() {
    const long n = p_.cells;
    const int m = p_.joints;
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
        double top = 0;
        for (int k = 1; k <= 4; ++k) top = std::max(top, (5 - k) * sq[k] * x0 + k * sq[k - 1] * x1);
        if (top > worst * 5 * v * v) worst = top / (5 * v * v);
      }
      shrink[i] = std::max(shrink[i], worst);
      shrink[i + 1] = std::max(shrink[i + 1], worst);
    }
    for (long i = 0; i <= n; ++i) cap_[i] /= shrink[i];
  }

  // Takes up the rows of cell i, kept for the way back, and x + 2 h u within the next set.
  const Cell& set(long i, double low, double high) {
    const double h = width(i), next = 1 / (2 * h);
    double most = cap_[i], narrowest = std::numeric_limits<double>::infinity();
    const double reach = std::max(cap_[i], high) * next;  // no |u| is larger
    const long first = static_cast<long>(rows_.size());
    auto row = [&](double a, double b, double c) {
      // a joint that rests has rows of rounding alone: what cannot bind, whatever u and x are, is left out, and what u
      // cannot move by more than rounding bounds x alone
      const double size = std::fabs(a), push = size * reach, pull = std::fabs(b) * cap_[i];
      if (push + pull <= c) return;
      if (push <= kRowFlat * c) {
        most = std::min(most, (c - push) / std::fabs(b));
        return;
      }
      const double per = 1 / a, room = c * std::fabs(per);
      rows_.push_back({b * per, room});
      narrowest = std::min(narrowest, room);
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
    return cells_[i] = {first, static_cast<long>(rows_.size()) - first, next, low * next, high * next, most, narrowest};
  }

  Room room_at(const Cell& c, double x) const {
    Room best{c.high - c.next * x, c.next, c.high, c.low - c.next * x, c.next, c.low};
    const Row* row = rows_.data() + c.first;
    for (long k = 0; k < c.rows; ++k) {
      const double t = row[k].slope * x, above = row[k].room - t, below = -row[k].room - t;
      if (above < best.above) best.above = above, best.above_slope = row[k].slope, best.above_offset = row[k].room;
      if (below > best.below) best.below = below, best.below_slope = row[k].slope, best.below_offset = -row[k].room;
    }
    return best;
  }

  // The room for u is a concave function of x, linear in pieces: Newton from outside ends after as many steps as pieces.
  bool largest(const Cell& c, double& x) const {
    x = c.most;
    for (long round = 0; round < 4 * c.rows + 8; ++round) {
      const Room room = room_at(c, x);
      if (room.open()) return true;
      const double narrowing = room.above_slope - room.below_slope;
      if (narrowing <= 0) return false;
      const double next = (room.above_offset - room.below_offset) / narrowing;
      if (next < 0) return false;
      if (next >= x) return true;
      x = next;
    }
    return true;
  }
  bool smallest(const Cell& c, double most, double& x) const {
    x = 0.0;
    if (c.low <= c.narrowest) return true;  // at rest
    for (long round = 0; round < 4 * c.rows + 8; ++round) {
      const Room room = room_at(c, x);
      if (room.open()) return x <= most * (1 + kSetRounding);
      const double widening = room.below_slope - room.above_slope;
      if (widening <= 0) return false;
      const double next = (room.below_offset - room.above_offset) / widening;
      if (next > most * (1 + kSetRounding)) return false;
      if (next <= x) return true;
      x = next;
    }
    return true;
  }

  const TimedPath& p_;
  std::vector<double> cap_;
  std::vector<Row> rows_;
  std::vector<Cell> cells_;
};

}  // namespace pieper
