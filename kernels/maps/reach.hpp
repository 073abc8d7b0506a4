// A reach map's inner loop: voxels times orientations, solved block by block; poses and answers never leave the cache, only bits,
// counts and the best of two measures do. No Python here.
#pragma once

#include <functional>

#include "dispatch/solver.hpp"

namespace pieper {

// What is asked.
struct Voxels {
  const double* centres;  // count x 3, m: of the voxels that are solved
  long count;
  const double* turns;  // orientations x 9, row-major, the rolls of a direction beside each other
  long orientations;
  // Where a roll of the tool is a turn of the last joint (sense 1 or -1), one of `rolls` neighbours is solved and answers for all;
  // sense 0: each is solved.
  int rolls;
  double sense;
  // Where a turn of the first joint (sense 1 or -1) takes voxels to each other, by `fold` equal parts of a whole turn, one is solved
  // and answers for all: number v takes its k-th image, images[v x fold + k], or is none (-1); orientation o there is
  // o + k x orientations / fold. fold 1: each is solved.
  int fold;
  double first_sense;
  const std::int64_t* images;
  const double* links;  // (joints + 1) x 16 of the chain, m; null: nothing is measured
  double length;        // that metres are divided by in singular values
};

// The columns of what is measured, of the solutions inside the limits: the best manipulability; the best share of half a range that
// the nearest limit is away; how many have a negative and a positive determinant of the Jacobian; the least and the greatest of
// their smallest singular values.
enum Measure { kManipulability, kMargin, kNegative, kPositive, kLeast, kMost, kMeasures };

// What comes out, by the numbers of the images. Bits as NumPy packs them, the first orientation in the highest bit.
struct Reached {
  std::uint8_t *bits, *look;  // voxels x ceil(orientations / 8): reached inside the limits; to be looked at one by one
  std::int64_t* solutions;    // voxels: inside the limits, all orientations together, without those to be looked at
  double* measures;           // voxels x kMeasures
};

// Returns false when stopped; `keep_going` is asked now and then, on the calling thread.
bool reach(const Solver& solver, const Voxels& asked, const Reached& to, int threads,
           const std::function<bool()>& keep_going);

}  // namespace pieper
