// Where a merged root of a chain is and how many branches merge there; plain types.
#pragma once

#include "chain/plain.hpp"

namespace pieper {

// Puts a singular solution q (joints, at most six; lengths) of a pose (16, row-major, m) where the root is that it is a part of; returns
// how many branches merge there. mixed: what joints do to axes, axes x joints, or none.
int unfold(const PlainChain& chain, int joints, const double* mixed, const double* T, double* q);

}  // namespace pieper
