// Newton's method onto a pose by shortest steps. Any number of joints; plain types, scalar.
#pragma once

#include "chain/plain.hpp"

namespace pieper {

struct Steps {
  int most;
  double cutoff;   // directions weaker than this part of the strongest are left alone
  double longest;  // longest step, rad or lengths
};

// Moves joint vectors q (count x n; rad, m) towards poses T (16, or count x 16); the one that misses least on the way is kept. What is
// written to a row depends on nothing but that row. left (count): what each misses then (lengths; rad).
void onto(const PlainChain& chain, const Steps& how, long count, const double* T, bool one_pose, double* q,
          double* left);

// Of joint vectors q (count x n; rad, m) a bound from below of what part of the strongest direction's effect on the pose (lengths; rad)
// the weakest has, no more than six times too low; a tenth of what singular values cost.
void parts_of_weakest(const PlainChain& chain, long count, const double* q, double* out);

}  // namespace pieper
