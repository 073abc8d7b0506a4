// One arm's inverse kinematics over one pose or many: pose checks, the family's kernel, limits, threads. No Python here.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dispatch/isa.hpp"

namespace pieper {

// A pose that is not a rigid motion.
struct BadPose {
  long index;  // which of the poses given
  double
      deviation;  // max abs of R^T R - 1 and of the last row against 0 0 0 1; 2 when left handed; NaN when not finite
};

class Solver {
 public:
  // geometry: kept by the caller as long as this lives. lower, upper: limits of q (rad, m; infinite where there is none), slack
  // included.
  Solver(const Geometry& geometry, std::vector<double> lower, std::vector<double> upper,
         std::vector<std::uint8_t> prismatic, double accepted, double exact);
  ~Solver() { family_.drop(kernel_); }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  int joints() const { return family_.joints; }
  int slots() const { return family_.slots; }

  // Whether all poses are rigid motions; if not, `bad` is the first that is none. Nothing is solved yet. `exact` tells
  // whether none of them needs straightening.
  bool check(const double* T, long count, BadPose& bad, bool& exact) const;

  // Solves count poses (16 doubles each). q: count x slots x n, valid and in_limits: count x slots, flag: count.
  // `exact`: no pose needs straightening, as `check` found out.

  // `keep_going` is asked between blocks on the calling thread; false stops the work and is returned.
  bool solve(const double* T, long count, bool exact, int threads, double* q, std::uint8_t* valid,
             std::uint8_t* in_limits, std::uint8_t* flag, const std::function<bool()>& keep_going) const;

  // One pose, checked here; returns false and fills `bad` when it is not a rigid motion.
  bool solve_one(const double* T, double* q, std::uint8_t* valid, std::uint8_t* in_limits, std::uint8_t* flag,
                 BadPose& bad) const;

 private:
  void solve_block(const double* T, long count, bool exact, double* q, std::uint8_t* valid, std::uint8_t* in_limits,
                   std::uint8_t* flag) const;

  const IsaTable& isa_;
  const FamilyEntry& family_;
  const void* kernel_;
  std::vector<double> lower_, upper_;
  std::vector<std::uint8_t> prismatic_;
  double accepted_, exact_;
};

}  // namespace pieper
