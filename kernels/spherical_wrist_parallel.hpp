// stub
#pragma once
#include "batch.hpp"
namespace pieper::PIEPER_ISA {
struct SphericalWristParallel {
  static constexpr int joints = 6, slots = 8;
  template <class F> PIEPER_INLINE static void solve(const double*, const int*, const Pose<F>&, Branches<F, 8, 6>& out) {
    for (int m = 0; m < 8; ++m) { out.valid[m] = mask_of<F>(false); for (int j = 0; j < 6; ++j) out.q[m][j] = F(0.0); }
    out.degenerate = out.uncertain = out.out_of_reach = mask_of<F>(false);
  }
};
}
