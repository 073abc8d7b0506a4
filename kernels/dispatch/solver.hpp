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

// A row chosen for each pose while it is at hand: near + i * stride is what pose i is to be near to; chosen count x n, has count.
// `by` null: none is.
struct Chosen {
  const Selection* by = nullptr;
  const double* near = nullptr;
  int stride = 0;
  double* chosen = nullptr;
  std::uint8_t* has = nullptr;
};

enum class Outcome { FINISHED, STOPPED, BAD_POSE };

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
  const IsaTable& isa_table() const { return isa_; }
  // Limits of q with their slack, and which joints slide.
  const std::vector<double>& lower() const { return lower_; }
  const std::vector<double>& upper() const { return upper_; }
  const std::vector<std::uint8_t>& prismatic() const { return prismatic_; }

  // Solves count poses (16 doubles each), each block checked, solved, limited and chosen from while it is in the cache. At a pose
  // that is no rigid motion the work ends, and `bad` is the first such; what has been written then is of no meaning.
  // `keep_going` is told now and then how many poses are done, on the calling thread; false stops the work.
  Outcome solve(const double* T, long count, int threads, const Answers& to, const Chosen& chosen, BadPose& bad,
                const std::function<bool(long)>& keep_going) const;

  // One pose by the road of many, so that it comes to the same digits alone as among others: where an angle is half a turn a last
  // digit decides its sign. Returns false and fills `bad` when it is no rigid motion.
  bool solve_one(const double* T, double* q, std::uint8_t* valid, std::uint8_t* in_limits, std::uint8_t* flag,
                 BadPose& bad) const;

 private:
  // Returns the block's first pose that is no rigid motion, or count.
  long solve_block(const double* T, long count, double* deviation, double* straight, bool past_cache,
                   const Answers& to) const;
  JointLimits limits() const { return {lower_.data(), upper_.data(), prismatic_.data(), once_}; }

  const IsaTable& isa_;
  const FamilyEntry& family_;
  const void* kernel_;
  std::vector<double> lower_, upper_;
  std::vector<std::uint8_t> prismatic_;
  double accepted_, exact_;
  bool once_ = true;  // JointLimits::once
};

}  // namespace pieper
