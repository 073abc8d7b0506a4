// Joint limits: is a solution inside, if need be by a whole turn more or less?
// Lanes for whole groups of rows, and a scalar twin for the rest.
#pragma once

#include "dispatch/geometry.hpp"
#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA {

inline constexpr int kLimitPattern = 64;  // most joints x lanes of the vector path: one bit each

// A revolute value outside its limits is moved by whole turns to the inside when that is possible, else left alone.
// Returns whether the whole row is inside then.
inline bool turned_inside(double* row, int n, const double* lower, const double* upper, const std::uint8_t* prismatic) {
  bool inside = true;
  for (int j = 0; j < n; ++j) {
    double v = row[j];
    if (!prismatic[j] && v < lower[j]) v += kTwoPi * __builtin_ceil((lower[j] - v) / kTwoPi);
    else if (!prismatic[j] && v > upper[j]) v -= kTwoPi * __builtin_ceil((v - upper[j]) / kTwoPi);
    if (v >= lower[j] && v <= upper[j]) row[j] = v;
    else inside = false;
  }
  return inside;
}

// The whole turns, as a number of radians, that bring values between low and high where one would do; 0 where they are inside.
template <class F> PIEPER_INLINE F turns_inside(F v, F low, F high) {
  constexpr double to_integer = 6755399441055744.0;  // 1.5 * 2^52: adding and subtracting it rounds to an integer
  F x = select(v < low, low - v, v - high) * (1 / kTwoPi), n = (x + to_integer) - to_integer;
  n = select(n < x, n + 1.0, n) * kTwoPi;
  return select(v < low, n, select(v > high, -n, F(0.0)));
}

// Which of the valid rows of F's lanes of poses lie inside; values are moved by a turn where only that is inside.
template <class F, int M, int N>
PIEPER_INLINE void turn_inside(F (*q)[N], const Mask<F>* valid, const JointLimits& limits, Mask<F>* inside) {
  for (int m = 0; m < M; ++m) inside[m] = valid[m];
#pragma GCC unroll 1
  for (int j = 0; j < N; ++j) {
    const double lower = limits.lower[j], upper = limits.upper[j];
    // angles come in (-pi, pi]: a whole turn of room holds them all, and a turn can only help a joint whose limits reach beyond
    // that on one side
    if (!limits.prismatic[j] && lower <= -kPi && upper >= kPi) continue;
    const F low(lower), high(upper);
    if (limits.prismatic[j] || (upper <= kPi && lower >= -kPi)) {
      for (int m = 0; m < M; ++m) inside[m] = inside[m] & (q[m][j] >= low) & (q[m][j] <= high);
      continue;
    }
    for (int m = 0; m < M; ++m) {
      const F v = q[m][j], moved = v + (select(v < low, kTwoPi, F(0.0)) - select(v > high, kTwoPi, F(0.0)));
      const Mask<F> there = valid[m] & (moved >= low) & (moved <= high);
      q[m][j] = select(there, moved, v);
      inside[m] = inside[m] & there;
    }
  }
}

// Where a joint's angle is measured from, and the turn that its limits want: values are put into (bottom, top], which is one turn.
struct TurnOfJoint {
  double shift;  // rad, added to an angle in [-pi, pi]
  double top, bottom, middle;
  double low, high;  // the limits, infinite where a turn of room holds every value
};

// Values in (-pi, pi] that do not lie inside go there by one turn up or down where that leads inside: (-pi, pi] is cut elsewhere.
// lower <= pi and upper >= -pi.
inline TurnOfJoint turn_of_joint(double lower, double upper, double offset) {
  TurnOfJoint turn{0.0 - offset, kPi, -kPi, 0.0, lower, upper};
  if (lower <= -kPi && upper >= kPi) {
    turn.low = -__builtin_inf(), turn.high = __builtin_inf();
  } else if (upper > kPi) {
    turn.bottom = min(__builtin_nextafter(lower, -9.0), upper - kTwoPi);
    turn.top = turn.bottom + kTwoPi;
  } else if (lower < -kPi) {
    turn.top = max(upper, lower + kTwoPi);
    turn.bottom = turn.top - kTwoPi;
  }
  turn.middle = 0.5 * (turn.top + turn.bottom);
  // one turn at most is left to be made
  const double far = turn.middle - turn.shift;
  if (far > kPi) turn.shift += kTwoPi;
  else if (far < -kPi) turn.shift -= kTwoPi;
  return turn;
}
template <class F> PIEPER_INLINE F turned_into(const TurnOfJoint& turn, F angle) {
  F v = angle + turn.shift;
  v = select(v > turn.top, v - kTwoPi, v);
  return select(v <= turn.bottom, v + kTwoPi, v);
}
// A value that stands there turned by half a turn.
template <class F> PIEPER_INLINE F half_a_turn_on(const TurnOfJoint& turn, F v) {
  v = select(v > turn.middle, v - kPi, v + kPi);
  return select(v <= turn.bottom, v + kTwoPi, v);
}

inline void apply_limits(double* q, const std::uint8_t* valid, long rows, int n, const double* lower,
                         const double* upper, const std::uint8_t* prismatic, std::uint8_t* in_limits) {
  constexpr int W = PIEPER_LANES;
  long r = 0;
  if (n * W <= kLimitPattern) {
    using V = Lanes<W>;
    // W rows of n are n vectors; the limits repeat with the same period
    double low[kLimitPattern], high[kLimitPattern];
    for (int k = 0; k < n * W; ++k) low[k] = lower[k % n], high[k] = upper[k % n];
    // angles come in (-pi, pi]: a turn can only help a joint whose limits reach beyond that on one side
    std::uint64_t turning = 0;
    for (int k = 0; k < n * W; ++k)
      turning |= static_cast<std::uint64_t>(!prismatic[k % n] && (high[k] > kPi || low[k] < -kPi)) << k;
    const std::uint64_t full = n == 64 ? ~0ull : (1ull << n) - 1;
    for (; r + W <= rows; r += W) {
      std::uint64_t bits = 0, rows_valid = 0;
      for (int k = 0; k < n; ++k) {
        V v = load<V>(q + r * n + k * W);
        bits |= static_cast<std::uint64_t>(bits_of((v >= load<V>(low + k * W)) & (v <= load<V>(high + k * W))))
                << (k * W);
      }
      for (int i = 0; i < W; ++i) rows_valid |= (valid[r + i] ? full : 0) << (i * n);
      const std::uint64_t wanted = ~bits & turning & rows_valid;
      for (int k = 0; k < n; ++k) {
        const unsigned here = (wanted >> (k * W)) & ((1u << W) - 1);
        if (!here) continue;
        const V v = load<V>(q + r * n + k * W), l = load<V>(low + k * W), h = load<V>(high + k * W);
        const V moved = v + turns_inside(v, l, h);
        const auto better = (moved >= l) & (moved <= h) & mask_of_bits<V>(here);
        bits |= static_cast<std::uint64_t>(bits_of(better)) << (k * W);
        store(q + r * n + k * W, select(better, moved, v));
      }
      for (int i = 0; i < W; ++i) in_limits[r + i] = ((bits & rows_valid) >> (i * n) & full) == full;
    }
  }
  for (; r < rows; ++r) in_limits[r] = valid[r] && turned_inside(q + r * n, n, lower, upper, prismatic);
}

}  // namespace pieper::PIEPER_ISA
