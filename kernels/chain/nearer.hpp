// How near a chain's tool comes to a pose inside limits: Newton on the distance itself, with its second derivatives. Any number of
// joints, coupled ones too; plain types, scalar.
#pragma once

#include <vector>

#include "chain/plain.hpp"

namespace pieper {

struct DownhillChain : PlainChain {
  const double* coupling;       // n x n: the chain is at coupling @ q; null where no joint is coupled
  const double *lower, *upper;  // n, of q, rad or m
};

// Goes downhill from each of `count` q (n; left at the best) in |p - p_T|^2 / 2 + turning (1 - cos angle), lengths in units of the arm; turning infinite
// for turns alone; `turning` one a row. The values that are left are written to `left`.
//
// The remainder is large where a pose is out of reach: Gauss's and Newton's step would crawl, so the second derivatives are taken as
// they are, with their eigenvalues' absolute values.
void nearer(const DownhillChain& chain, const double* T, long count, const double* turning, int steps, double* q,
            double* left);

}  // namespace pieper
