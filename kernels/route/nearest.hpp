// How far each row of a ladder is from the nearest row of the cells beside it, and of its own. Scalar.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace pieper {

struct Beside {
  std::int64_t rungs, cells;
  int rows, joints, width;     // width: joints a row is stored with
  const double* q;             // (rungs, cells, rows, width)
  const std::uint8_t* valid;   // (rungs, cells, rows)
  const double* unit;          // (joints)
  const std::uint8_t* circle;  // (joints)
  bool cyclic;                 // whether the last cell is beside the first
};

// out: (rungs, cells, rows, 5): own cell, cell below, cell above, rung before, rung after. Infinite where there is no row,
// negative where there is no such cell.
inline void nearest_beside(const Beside& b, double* out) {
  const double none = std::numeric_limits<double>::infinity();
  auto row = [&](std::int64_t r, std::int64_t c, int k) { return b.q + ((r * b.cells + c) * b.rows + k) * b.width; };
  for (std::int64_t r = 0; r < b.rungs; ++r)
    for (std::int64_t c = 0; c < b.cells; ++c) {
      std::int64_t rung[5] = {r, r, r, r - 1, r + 1}, cell[5] = {c, c - 1, c + 1, c, c};
      if (b.cyclic) cell[1] = (c + b.cells - 1) % b.cells, cell[2] = (c + 1) % b.cells;
      for (int k = 0; k < b.rows; ++k) {
        double* to = out + ((r * b.cells + c) * b.rows + k) * 5;
        if (!b.valid[(r * b.cells + c) * b.rows + k]) {
          for (int w = 0; w < 5; ++w) to[w] = -1.0;
          continue;
        }
        const double* x = row(r, c, k);
        for (int w = 0; w < 5; ++w) {
          if (rung[w] < 0 || rung[w] >= b.rungs || cell[w] < 0 || cell[w] >= b.cells || (b.cells == 1 && w && w < 3)) {
            to[w] = -1.0;
            continue;
          }
          double least = none;
          for (int o = 0; o < b.rows; ++o) {
            if ((w == 0 && o == k) || !b.valid[(rung[w] * b.cells + cell[w]) * b.rows + o]) continue;
            const double* y = row(rung[w], cell[w], o);
            double most = 0.0;
            for (int j = 0; j < b.joints && most < least; ++j) {
              double e = y[j] - x[j];
              if (b.circle[j]) e -= 6.283185307179586476925286766559 * std::nearbyint(e * 0.15915494309189533576888);
              e = std::fabs(e) / b.unit[j];
              if (e > most) most = e;
            }
            if (most < least) least = most;
          }
          to[w] = least;
        }
      }
    }
}

}  // namespace pieper
