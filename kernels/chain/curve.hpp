// Following a self-motion: along what the pose leaves free and back onto the pose, until the curve closes or ends. Any number of
// joints; plain types, scalar.
#pragma once

#include <vector>

#include "chain/plain.hpp"

namespace pieper {

struct Following {
  double step;      // longest step, rad or lengths
  double straight;  // cosine by which a step may depart from the tangent that it sets out along
  int most_steps;   // points at most
};

// Points (k x n) along the curve through q (n, rad or m, on the pose), which is the first, setting out along `direction` (n, unit,
// slides per length). Returns whether the curve closed: then the last point is q again, whole turns added.
bool follow_curve(const PlainChain& chain, const double* T, const double* q, const double* direction,
                  const Following& how, std::vector<double>& points);

}  // namespace pieper
