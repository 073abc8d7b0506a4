// Down to a pose inside a box of joint limits: steps that stop at a limit and go on along it. Any number of joints; plain types,
// scalar.
#pragma once

#include "chain/plain.hpp"

namespace pieper {

struct Descent {
  int steps, again;  // steps at most; how often one is made again, without joints that it would carry out of the box
  double longest;    // longest step, rad or lengths
  double first, shrink, grow;   // damping at first, and its factors where a step helped and where not
  double most, least, weakest;  // damping at which it rests, least damping, and what is always added to it
  double done;                  // what is missed below which it goes on no longer (per length; rad)
  int idle;                     // it rests after so many steps in turn that left more than
  double left;                  // this of the square that is missed
};

// Moves joint vectors q (count x n, inside their boxes; rad, m) towards poses T (count x 16), never out of boxes low, high (count x n);
// missed (count) is what is left (per length; rad).
void descend(const PlainChain& chain, const Descent& how, long count, const double* T, const double* low,
             const double* high, double* q, double* missed);

}  // namespace pieper
