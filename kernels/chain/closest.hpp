// Postures inside limits that come nearest to a pose: descents from postures that were looked at before, the position first, then the
// orientation in stages. Plain types, scalar.
#pragma once

#include "chain/nearer.hpp"

namespace pieper {

// Postures spread evenly over the limits, and where the tool is at them.
struct Table {
  int count;
  const double *q, *poses;  // count x n, rad or m; count x 16 row-major, m
};

// What a turn counts beside a position (per length), how many steps, and how many postures are kept.
struct Stage {
  double turn;
  int steps, keep;
};

// Gauss's and Newton's damped steps: damping at first, its factors where a step helped and where not; a value that is reached.
struct Crawl {
  int steps;
  double damping, shrink, grow, reached;
};

struct Search {
  int starts, spread, turned;      // the best of the table for a place, others evenly beside, and the best for the pose
  int more, more_kept, few_steps;  // where few agree so many crawl, and of them so many go on
  int in_place, led_back, alike,
      last_steps;  // kept in place; led away and back; looked at for one kept; onto the position
  double reached, alike_place, agreed, same;
  Crawl crawl;
  std::vector<Stage> stages, back;
};

// Returns postures (k x n) of which one comes nearest, as far as is found; `seeds` are further ones to begin at.
std::vector<double> closest(const DownhillChain& chain, const double* T, const Table& table, long count,
                            const double* seeds, const Search& how, bool turning);

}  // namespace pieper
