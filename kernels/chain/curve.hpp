// Following a self-motion: along what the pose leaves free and back onto the pose, until the curve closes or ends. Any number of
// joints; plain types, scalar.
#pragma once

#include <cstdint>
#include <vector>

namespace pieper {

struct FollowedChain {
  int n;
  double length;                  // m
  const double* links;            // (n + 1) x 16 row-major, m
  const std::uint8_t* prismatic;  // n
};

struct Following {
  double step;      // longest step, rad or lengths
  double straight;  // cosine by which a step may depart from the tangent that it sets out along
  int most_steps;   // points at most
};

// Points (k x n) along the curve through q (n, rad or m, on the pose), which is the first, setting out along `direction` (n, unit,
// slides per length). Returns whether the curve closed: then the last point is q again, whole turns added.
bool follow_curve(const FollowedChain& chain, const double* T, const double* q, const double* direction,
                  const Following& how, std::vector<double>& points);

}  // namespace pieper
