// How far anything inside the limits can come along a path: the front of what is reached, carried on with proof.
#pragma once

#include <cstdint>
#include <vector>

namespace pieper {

// A path and what is free at each of its poses: one coordinate more than the pose decides, or none.
struct FrontAsked {
  int n;                          // coordinates, 6 or 7
  const double* links;            // (n + 1, 4, 4), m
  const std::uint8_t* prismatic;  // (n)
  double length;                  // of the arm: lengths and slides are counted in it
  const double* joints;           // (n, n) what is limited, as combinations of the coordinates, rad or m
  const double* lower;            // (n) limits of these, rad or m; infinite for none
  const double* upper;            // (n)
  std::int64_t stations;          // poses of the path
  const double* poses;            // (stations, 4, 4)
  const double* axis;             // (stations - 1, 3) about which the tool turns to the next pose, in its own frame
  const double* angle;            // (stations - 1) by how much, rad
  std::int64_t seeds;             // points of the first pose that are reached
  const double* seed;             // (seeds, n)
  double fine;                    // part of the largest steps that the bounds allow; above 1 nothing is proved
  std::int64_t most;              // points looked at in all
};

enum class FrontEnd : std::int32_t {
  DIED = 0,      // nothing inside the limits comes as far as `at`
  ARRIVED = 1,   // something may reach the last pose
  SINGULAR = 2,  // at `at` the coordinates lose their grip: the bounds there allow no step
  TIRED = 3      // more points than were allowed
};

struct FrontFound {
  FrontEnd end = FrontEnd::ARRIVED;
  double at = 0;            // stations and the part of one
  double rows_at = 0;       // where the front told is: behind `at` where it lost its grip or grew tired
  std::int64_t looked = 0;  // points looked at
  std::int64_t steps = 0;   // how many times a row was carried on
  double narrowest = 0;   // least distance in which the Jacobian could change by as much as itself, of what was reached
  std::vector<double> q;  // (k, n) the front
  std::vector<double> within;  // (k) how far each of its points stands for (rad; lengths)
  std::vector<std::int64_t>
      stretch;  // (rows) how many points each stretch of a curve has, below zero where it is closed
};

FrontFound front(const FrontAsked& asked);

}  // namespace pieper
