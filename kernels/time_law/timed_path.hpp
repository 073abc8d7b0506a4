// What a time law is asked for and what it gives: plain data, the same for every instruction set.
#pragma once

namespace pieper {

// q(s) in pieces of third degree, derivatives at each piece's beginning: s (cells + 1), the others cells x joints.
struct CubicPieces {
  long cells;
  int joints;
  const double *s, *q, *d1, *d2, *d3;
};

// A path on its cells with every bound on the way.
struct TimedPath {
  long cells;
  int joints, extra;                   // extra rows a cell: |a u + b x| <= c
  const double* s;                     // cells + 1
  const double *d1, *d2, *d3;          // cells x joints, derivatives of q at a cell's beginning
  const double *speed, *acceleration;  // joints
  const double *share, *easing;        // cells: parts of the speeds; of speeds too, squared of the accelerations
  const double *a, *b, *c;             // cells x extra
  const double* most;                  // cells + 1, further bounds of x; may be infinite
  const double* wanted;                // cells + 1, x that must be had; NaN where free
};

// What is kept: limits of the joints; on piece k of the grid (cells + 1 places s) the part share[k] of the speeds.
struct JerkBounds {
  const double *speed, *acceleration, *jerk;
  long cells;
  const double *s, *share;
};

struct Timing {
  bool done;
  long where;       // the cell or point where it is impossible
  double* x;        // cells + 1
  double* highest;  // cells + 1, the controllable sets' upper ends
};

}  // namespace pieper
