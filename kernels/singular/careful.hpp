// One arm's look at singular poses, from a raw pose to rows inside limits; plain types, no Python here.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "dispatch/solver.hpp"

namespace pieper {

// A self-motion as its own words: two joints in one line, a linkage, or points that were followed.
struct SelfMotionSaid {
  double through[6];  // rad; m
  bool line;
  int joints[4];  // two of a line, ascending
  double sense;   // of a line
  // of a linkage
  bool flat;
  double axes[4][3], spots[4][2], senses[4];  // spots per length
  int lead;
  double low, high;
  int course;
  // of one that was followed, else none
  std::vector<double> points;  // k x 6, rad; m
  bool closed;
};

// All there is at one pose, rows in order, limits applied.
struct CarefulPose {
  int count;
  std::vector<double> q;  // count x 6, rad; m
  std::vector<std::uint8_t> inside, singular;
  std::vector<int> branches, motion;
  std::vector<SelfMotionSaid> motions;
  std::uint8_t flag;
};

// What a linkage that was said can be asked.
class Linkage {
 public:
  Linkage(const SelfMotionSaid& said, const std::uint8_t* prismatic, double length);
  ~Linkage();
  // The joint vector (6, rad; m) at u, each angle the short way round from `through`.
  void point(double u, double* q) const;
  // u of a joint vector by its linkage's angles; NaN where they are not on this piece of the curve.
  double place(const double* q) const;
  // Intervals of u inside limits (6, rad; m, without slack), two numbers each.
  std::vector<double> inside(const double* lower, const double* upper) const;

 private:
  struct Own;
  std::unique_ptr<Own> own_;
};

class CarefulLook {
 public:
  // links: 7 x 16 row-major, m. lower, upper: 6, without slack. closed_form: whether the solver loses nothing where roots meet.
  CarefulLook(const Solver& solver, const double* links, const std::uint8_t* prismatic, double length,
              const double* lower, const double* upper, double exact, bool closed_form);
  ~CarefulLook();

  // Looks at a pose that is one, of which the solver has these rows (count x 6, rad, m) and this flag; false where what there is
  // cannot be read off.
  bool look(const double* T, const double* q, int count, std::uint8_t flag, CarefulPose& out) const;

 private:
  struct Own;
  std::unique_ptr<Own> own_;
};

}  // namespace pieper
