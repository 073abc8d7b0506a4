// The nearest pair of bodies of many postures, W at a time: its distance, nearest points and normal; or all distances.
#pragma once

#include "collision/posture.hpp"

namespace pieper::PIEPER_ISA {

// room: bodies x sizeof(Placed<Lanes>) + one vector, in bytes, from the caller. distance (count), pair (count); points
// (count x 2 x 3) and normal (count x 3), or null; each (count x pairs), or null.
inline void collision_nearest(const CollisionModel& m, const double* q, long count, void* room, double* distance,
                              int* pair, double* points, double* normal, double* each) {
  using Wide = Lanes<PIEPER_LANES>;
  const std::uintptr_t align = sizeof(Wide);
  void* aligned = reinterpret_cast<void*>((reinterpret_cast<std::uintptr_t>(room) + align - 1) & ~(align - 1));
  Placed<Wide>* wide = static_cast<Placed<Wide>*>(aligned);
  place_still(m, wide);
  for (long first = 0; first < count; first += PIEPER_LANES) {
    const int lanes = count - first < PIEPER_LANES ? static_cast<int>(count - first) : PIEPER_LANES;
    place_moving(m, q + first * m.n, lanes, wide, [](int, const RigidT<Wide>&) {});
    Wide best(kEndless), which(0.0);
    for (int k = 0; k < m.pairs; ++k) {
      const Wide d = pair_distance(m, k, wide);
      const auto nearer = d < best;
      best = select(nearer, d, best);
      which = select(nearer, Wide(static_cast<double>(k)), which);
      if (each)
        for (int i = 0; i < lanes; ++i) each[(first + i) * m.pairs + k] = lane(d, i);
    }
    for (int i = 0; i < lanes; ++i) {
      distance[first + i] = lane(best, i);
      pair[first + i] = static_cast<int>(lane(which, i));
    }
  }
  if (!points) return;
  Placed<double>* alone = static_cast<Placed<double>*>(aligned);
  place_still(m, alone);
  for (long k = 0; k < count; ++k) {
    place_moving(m, q + k * m.n, 1, alone, [](int, const RigidT<double>&) {});
    const Apart<double> gap = pair_apart(m, pair[k], alone);
    const Vec3 at[3] = {gap.a, gap.b, gap.normal};
    for (int v = 0; v < 2; ++v)
      for (int c = 0; c < 3; ++c) points[6 * k + 3 * v + c] = (&at[v].x)[c];
    for (int c = 0; c < 3; ++c) normal[3 * k + c] = (&at[2].x)[c];
  }
}

}  // namespace pieper::PIEPER_ISA
