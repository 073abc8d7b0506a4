// An arm as it is handed from one translation unit to another: plain types.
#pragma once

#include <cstdint>

namespace pieper {

struct PlainChain {
  int n;
  double length;                  // m
  const double* links;            // (n + 1) x 16 row-major, m
  const std::uint8_t* prismatic;  // n

  double unit(int k) const { return prismatic[k] ? length : 1.0; }
};

}  // namespace pieper
