// The fastest way along a joint path within speeds and accelerations: controllable sets backward, then greedily forward
// (Pham and Pham 2018), with rows that hold on all of a cell and not at its ends alone.
//
// The path is cubic in s on each cell, x = (ds/dt)^2 is linear there and u = d2s/dt2 constant. A joint's acceleration
// q' u + q'' x is then a quadratic of s; its three Bernstein coefficients are linear in (u, x) at the cell's beginning,
// and keeping them inside the limit keeps the acceleration inside. A joint's squared speed q'^2 x is of degree five.
//
// Joints stand in lanes: a cell's rows are vectors, three for each vector of joints, then the further ones.
#pragma once

#include "lanes/lanes.hpp"
#include "time_law/timed_path.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA {

class FastestPass {
 public:
  using F = Lanes<PIEPER_LANES>;
  static constexpr int W = PIEPER_LANES;

  // room: as large as `doubles(path)`.
  FastestPass(const TimedPath& path, double* room)
      : p_(path), wide_(vectors(path.joints) * W), rows_(3 * vectors(path.joints) + vectors(path.extra)) {
    const long n = p_.cells;
    cap_ = room;
    low_ = cap_ + n + 1;
    shrink_ = low_ + n + 1;
    slope_ = shrink_ + n + 1;
    room_ = slope_ + rows_ * W;
    speed_ = room_ + rows_ * W;
    bend_ = speed_ + wide_;
    d_ = bend_ + wide_;
    for (int j = 0; j < wide_; ++j) {
      // joints that are none never bind
      speed_[j] = j < p_.joints ? 1 / (p_.speed[j] * p_.speed[j]) : 1.0;
      bend_[j] = j < p_.joints ? p_.acceleration[j] : 1.0;
    }
    const double* given[] = {p_.d1, p_.d2, p_.d3};
    for (int k = 0; k < 3; ++k)
      for (long i = 0; i < n; ++i)
        for (int j = 0; j < wide_; ++j) at(k, i)[j] = j < p_.joints ? given[k][i * p_.joints + j] : 0.0;
    caps();
  }

  static long doubles(const TimedPath& p) {
    const long wide = vectors(p.joints) * W, rows = 3 * vectors(p.joints) + vectors(p.extra);
    return 3 * (p.cells + 1) + 2 * rows * W + 2 * wide + 3 * p.cells * wide;
  }

  Timing run(double start, double end, double* x, double* highest) {
    const long n = p_.cells;
    low_[n] = highest[n] = end;
    // a motion ends as it is told to, whatever speed is wanted there
    if (wants(n) && abs(p_.wanted[n] - end) > kSetRounding * end) return {false, n, x, highest};
    for (long i = n - 1; i >= 0; --i) {
      const Cell c = set(i, low_[i + 1], highest[i + 1]);
      if (wants(i)) {
        const double w = p_.wanted[i];
        if (w > c.most * (1 + kSetRounding) || !room_at(c, w).open()) return {false, i, x, highest};
        low_[i] = highest[i] = w;
        continue;
      }
      if (!(largest(c, highest[i]) && smallest(c, highest[i], low_[i]))) return {false, i, x, highest};
    }
    if (start < low_[0] * (1 - kSetRounding) || start > highest[0] * (1 + kSetRounding)) return {false, -1, x, highest};
    x[0] = start;
    for (long i = 0; i < n; ++i) {
      const Cell c = set(i, low_[i + 1], highest[i + 1]);
      const double next = x[i] + 2 * width(i) * above_at(c, x[i]);
      x[i + 1] = next < low_[i + 1] ? low_[i + 1] : next > highest[i + 1] ? highest[i + 1] : next;
    }
    return {true, n, x, highest};
  }

 private:
  // The rows of a cell, u + slope x within +- room, and x + 2 h u within the next set: u + next x within low and high.
  struct Cell {
    double next, low, high, most, narrowest;  // most: the bound of x; narrowest: the least room
  };
  // What is left for u at some x: up to `above` and down to `below`, and the slopes of the rows that say so.
  struct Room {
    double above, above_slope, above_offset, below, below_slope, below_offset;
    bool open() const { return above >= below - kSetRounding * (abs(above) + abs(below)); }
  };

  static constexpr int vectors(int count) { return (count + W - 1) / W; }
  static constexpr double kNone = __builtin_inf();
  static double least(F x) {
    double out = lane(x, 0);
    for (int k = 1; k < W; ++k) out = min(out, lane(x, k));
    return out;
  }
  static double most(F x) {
    double out = lane(x, 0);
    for (int k = 1; k < W; ++k) out = max(out, lane(x, k));
    return out;
  }

  double* at(int order, long i) const { return d_ + (order * p_.cells + i) * wide_; }
  double width(long i) const { return p_.s[i + 1] - p_.s[i]; }
  bool wants(long i) const { return p_.wanted[i] == p_.wanted[i]; }

  // x at the points of a cell such that all Bernstein coefficients of q'^2 x stay within the squared speed
  void caps() {
    const long n = p_.cells;
    for (long i = 0; i <= n; ++i) {
      cap_[i] = min(p_.most[i], wants(i) ? p_.wanted[i] : kFastest);
      shrink_[i] = 1.0;
    }
    for (long i = 0; i < n; ++i) {
      const double h = width(i), part = p_.share[i] * p_.easing[i], square = part * part;
      F first(0.0), last(0.0);
      for (int v = 0; v < wide_; v += W) {
        const F a = load<F>(at(0, i) + v), b = load<F>(at(1, i) + v), d3 = load<F>(at(2, i) + v);
        const F e = a + h * (b + h / 2 * d3), per = load<F>(speed_ + v);
        first = max(first, a * a * per);
        last = max(last, e * e * per);
      }
      cap_[i] = min(cap_[i], square / most(first));
      cap_[i + 1] = min(cap_[i + 1], square / most(last));
    }
    for (long i = 0; i < n; ++i) {
      const double h = width(i), x0 = cap_[i], x1 = cap_[i + 1], part = p_.share[i] * p_.easing[i];
      F top(0.0);
      for (int v = 0; v < wide_; v += W) {
        const F r0 = load<F>(at(0, i) + v), d2 = load<F>(at(1, i) + v), r1 = r0 + h / 2 * d2;
        const F r2 = r0 + h * (d2 + h / 2 * load<F>(at(2, i) + v));
        const F sq[5] = {r0 * r0, max(r0 * r1, F(0.0)), max((r0 * r2 + 2.0 * r1 * r1) / 3.0, F(0.0)),
                         max(r1 * r2, F(0.0)), r2 * r2};
        F here(0.0);
        for (int k = 1; k <= 4; ++k) here = max(here, (5.0 - k) * sq[k] * x0 + double(k) * sq[k - 1] * x1);
        top = max(top, here * load<F>(speed_ + v));
      }
      const double worst = most(top) / (5 * part * part);
      shrink_[i] = max(shrink_[i], worst);
      shrink_[i + 1] = max(shrink_[i + 1], worst);
    }
    for (long i = 0; i <= n; ++i) cap_[i] /= shrink_[i];
  }

  // Takes up the rows of cell i, and x + 2 h u within the next set.
  Cell set(long i, double low, double high) {
    const double h = width(i), next = 1 / (2 * h), cap = cap_[i];
    const double reach = max(cap, high) * next;  // no |u| is larger
    F bound(cap), narrowest(kNone);
    double *slope = slope_, *room = room_;
    auto row = [&](F a, F b, F c) {
      // a joint that rests has rows of rounding alone: what cannot bind, whatever u and x are, is left out, and what u
      // cannot move by more than rounding bounds x alone
      const F push = abs(a) * reach;
      const auto binds = push + abs(b) * cap > c, flat = push <= kRowFlat * c, kept = binds & !flat;
      const F per = 1.0 / select(kept, a, F(1.0)), wide = select(kept, c * abs(per), F(kNone));
      bound = select(binds & flat, min(bound, (c - push) / abs(b)), bound);
      narrowest = min(narrowest, wide);
      store(slope, select(kept, b * per, F(0.0)));
      store(room, wide);
      slope += W, room += W;
    };
    const double eased = p_.easing[i] * p_.easing[i];
    for (int v = 0; v < wide_; v += W) {
      const F d1 = load<F>(at(0, i) + v), d2 = load<F>(at(1, i) + v), d3 = load<F>(at(2, i) + v);
      const F c = load<F>(bend_ + v) * eased, e2 = d2 + h * d3;
      row(d1, d2, c);
      row(d1 + 1.5 * h * d2, d2 + h / 2 * d3, c);
      row(d1 + h * (d2 + h / 2 * d3) + 2 * h * e2, e2, c);
    }
    for (int j = 0; j < p_.extra; j += W) {
      F a(0.0), b(0.0), c(1.0);
      for (int k = 0; k < W && j + k < p_.extra; ++k) {
        const long from = i * p_.extra + j + k;
        set_lane(a, k, p_.a[from]), set_lane(b, k, p_.b[from]), set_lane(c, k, p_.c[from]);
      }
      row(a, b, c);
    }
    return {next, low * next, high * next, least(bound), least(narrowest)};
  }

  Room room_at(const Cell& c, double x) const {
    F above(kNone), above_slope(0.0), above_offset(0.0), below(-kNone), below_slope(0.0), below_offset(0.0);
    for (int k = 0; k < rows_ * W; k += W) {
      const F slope = load<F>(slope_ + k), room = load<F>(room_ + k), t = slope * x, up = room - t, down = -room - t;
      const auto lower = up<above, higher = down> below;
      above = select(lower, up, above), above_slope = select(lower, slope, above_slope);
      above_offset = select(lower, room, above_offset);
      below = select(higher, down, below), below_slope = select(higher, slope, below_slope);
      below_offset = select(higher, -room, below_offset);
    }
    Room best{c.high - c.next * x, c.next, c.high, c.low - c.next * x, c.next, c.low};
    for (int k = 0; k < W; ++k) {
      if (lane(above, k) < best.above)
        best.above = lane(above, k), best.above_slope = lane(above_slope, k), best.above_offset = lane(above_offset, k);
      if (lane(below, k) > best.below)
        best.below = lane(below, k), best.below_slope = lane(below_slope, k), best.below_offset = lane(below_offset, k);
    }
    return best;
  }
  double above_at(const Cell& c, double x) const {
    F above(c.high - c.next * x);
    for (int k = 0; k < rows_ * W; k += W) above = min(above, load<F>(room_ + k) - load<F>(slope_ + k) * x);
    return least(above);
  }

  // The room for u is a concave function of x, linear in pieces: Newton from outside ends after as many steps as pieces.
  // A step is x - gap / narrowing with a gap above zero while the room is shut, so that `next >= x` is no tolerance: it can
  // be only where the step is under the last digit of x, and x then is the bound to that digit. What the last digit is worth
  // is in the margin, which is computed anew from the profile and slows it down where it is above one.
  bool largest(const Cell& c, double& x) const {
    x = c.most;
    for (long round = 0; round < 4 * rows_ * W + 8; ++round) {
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
    for (long round = 0; round < 4 * rows_ * W + 8; ++round) {
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
  const int wide_, rows_;
  double *cap_, *low_, *shrink_, *slope_, *room_, *speed_, *bend_, *d_;
};

inline long fastest_doubles(const TimedPath& path) { return FastestPass::doubles(path); }
inline Timing fastest(const TimedPath& path, double start, double end, double* room, double* x, double* highest) {
  return FastestPass(path, room).run(start, end, x, highest);
}

}  // namespace pieper::PIEPER_ISA
