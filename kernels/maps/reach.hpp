// A reach map's inner loop: voxels times orientations, solved block by block; poses and answers never leave the cache, only bits,
// counts and the best of two measures do. No Python here.
#pragma once

#include <functional>

#include "dispatch/solver.hpp"

namespace pieper {

// What is asked.
struct Voxels {
  const double* centres;  // count x 3, m
  long count;
  const double* turns;  // orientations x 9, row-major, the rolls of a direction beside each other
  long orientations;
  // Where a roll of the tool is a turn of the last joint (sense 1 or -1), one of `rolls` neighbours is solved and answers for all;
  // sense 0: each is solved.
  int rolls;
  double sense;
  const double* links;  // (joints + 1) x 16 of the chain, m, for manipulability; null: nothing is measured
};

// What comes out, a voxel each. Bits as NumPy packs them, the first orientation in the highest bit.
struct Reached {
  std::uint8_t *bits, *look;  // count x ceil(orientations / 8): reached inside the limits; to be looked at one by one
  std::int64_t* solutions;    // count: inside the limits, all orientations together, without those to be looked at
  double *manipulability, *margin;  // count: the best; margin: share of half the range that the nearest limit is away
};

// Returns false when stopped; `keep_going` is asked now and then, on the calling thread.
bool reach(const Solver& solver, const Voxels& asked, const Reached& to, int threads,
           const std::function<bool()>& keep_going);

}  // namespace pieper
