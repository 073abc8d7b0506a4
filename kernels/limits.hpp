// Joint limits: is a solution inside, if need be by a whole turn more or less?
#pragma once

#include "math.hpp"

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

inline void apply_limits(double* q, const std::uint8_t* valid, long rows, int n, const double* lower,
                         const double* upper, const std::uint8_t* prismatic, std::uint8_t* in_limits) {
  constexpr int W = PIEPER_LANES;
  // angles come in (-pi, pi]: a turn can only help a joint whose limits reach beyond that on one side
  std::uint64_t turning = 0;
  for (int j = 0; j < n && j < 64; ++j) turning |= static_cast<std::uint64_t>(!prismatic[j] && (upper[j] > kPi || lower[j] < -kPi)) << j;
  long r = 0;
  if (n * W <= kLimitPattern) {
    // W rows of n are n vectors; the limits repeat with the same period
    double low[kLimitPattern], high[kLimitPattern];
    for (int k = 0; k < n * W; ++k) low[k] = lower[k % n], high[k] = upper[k % n];
    const std::uint64_t full = n == 64 ? ~0ull : (1ull << n) - 1;
    for (; r + W <= rows; r += W) {
      std::uint64_t bits = 0;
      for (int k = 0; k < n; ++k) {
        Lanes<W> v = load<Lanes<W>>(q + r * n + k * W);
        bits |= static_cast<std::uint64_t>(
                    bits_of((v >= load<Lanes<W>>(low + k * W)) & (v <= load<Lanes<W>>(high + k * W)))) << (k * W);
      }
      for (int i = 0; i < W; ++i) {
        const std::uint64_t outside = ~(bits >> (i * n)) & full;
        const bool good = valid[r + i];
        in_limits[r + i] = good & !outside;
        if (good && (outside & turning)) in_limits[r + i] = turned_inside(q + (r + i) * n, n, lower, upper, prismatic);
      }
    }
  }
  for (; r < rows; ++r) in_limits[r] = valid[r] && turned_inside(q + r * n, n, lower, upper, prismatic);
}

}  // namespace pieper::PIEPER_ISA
