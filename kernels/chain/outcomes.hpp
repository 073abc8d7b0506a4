// What is known of each pose of a batch from its rows.
#pragma once

#include <cstdint>

#include "lanes/lanes.hpp"

namespace pieper::PIEPER_ISA {

// What is known of each pose: 0 no rows, 1 rows outside the limits alone, 2 a row inside.
inline void outcomes(const std::uint8_t* valid, const std::uint8_t* inside, long count, int slots, std::uint8_t* out) {
  if (slots == 8) {
    for (long i = 0; i < count; ++i) {
      std::uint64_t v, in;
      __builtin_memcpy(&v, valid + 8 * i, 8);
      __builtin_memcpy(&in, inside + 8 * i, 8);
      out[i] = static_cast<std::uint8_t>((v != 0) + (in != 0));
    }
    return;
  }
  for (long i = 0; i < count; ++i) {
    unsigned v = 0, in = 0;
    for (int m = 0; m < slots; ++m) v |= valid[i * slots + m], in |= inside[i * slots + m];
    out[i] = static_cast<std::uint8_t>((v != 0) + (in != 0));
  }
}

}  // namespace pieper::PIEPER_ISA
