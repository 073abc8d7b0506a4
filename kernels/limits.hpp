// Joint limits: is a solution inside, if need be by a whole turn more or less?
#pragma once

#include "math.hpp"

namespace pieper::PIEPER_ISA {

// A revolute value outside its limits is moved by whole turns to the inside when that is possible, else left alone.
inline void apply_limits(double* q, const std::uint8_t* valid, long rows, int n, const double* lower,
                         const double* upper, const std::uint8_t* prismatic, std::uint8_t* in_limits) {
  for (long r = 0; r < rows; ++r) {
    double* row = q + r * n;
    bool inside = true;
    for (int j = 0; j < n; ++j) inside &= (row[j] >= lower[j]) & (row[j] <= upper[j]);
    if (__builtin_expect(!inside & (valid[r] != 0), 0)) {
      inside = true;
      for (int j = 0; j < n; ++j) {
        double v = row[j];
        if (!prismatic[j] && v < lower[j]) v += kTwoPi * __builtin_ceil((lower[j] - v) / kTwoPi);
        else if (!prismatic[j] && v > upper[j]) v -= kTwoPi * __builtin_ceil((v - upper[j]) / kTwoPi);
        if (v >= lower[j] && v <= upper[j]) row[j] = v;
        else inside = false;
      }
    }
    in_limits[r] = inside & (valid[r] != 0);
  }
}

}  // namespace pieper::PIEPER_ISA
