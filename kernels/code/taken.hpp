// One arm's solver where there is neither Python nor a choice of instruction sets: the family's kernel, pose checks, limits, and
// forward kinematics, for the C++ headers and the WebAssembly that `arm.code` writes. No exceptions.
#pragma once

#include <type_traits>

#include "chain/forward.hpp"
#include "chain/limits.hpp"
#include "chain/posecheck.hpp"
#include "chain/row_order.hpp"
#include "code/numbers.hpp"
#include "elimination/entry.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA {

// What an arm says of its chain: links (n + 1) x 16, limits with their slack, rad or m.
struct TakenChain {
  const double *links, *lower, *upper;
  const std::uint8_t* slides;
};

// Own: the family's geometry. Kernel: what solves it. Made once; solving changes nothing, so threads may share it.
template <class Own, class Kernel> class Taken {
 public:
  static constexpr int joints = Own::joints, slots = Own::slots;

  // general: the numbers of the general solver that helps the family out, or null.
  Taken(const double* numbers, const double* general, const TakenChain& chain)
      : help_(general), own_(numbers, help_.given(general)), kernel_(own_.own), chain_(chain) {}

  // T: count x 16. q: count x slots x joints; valid, in_limits: count x slots; flag: count. Returns the first pose that is no rigid
  // motion, whose block is not solved, or count.
  long solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* in_limits,
             std::uint8_t* flag) const {
    constexpr long block = 16;
    double deviation[block], straight[16 * block];
    for (long first = 0; first < count; first += block) {
      const long here = count - first < block ? count - first : block;
      const double* poses = T + 16 * first;
      double* rows = q + first * slots * joints;
      std::uint8_t *good = valid + first * slots, *say = flag + first;
      const double largest = pose_deviation(poses, here, deviation);
      if (!(largest <= kRotationAccepted))
        for (long i = 0; i < here; ++i)
          if (!(deviation[i] <= kRotationAccepted)) return first + i;
      if (largest > kRotationExact) {
        pose_straighten(poses, deviation, kRotationExact, here, straight);
        poses = straight;
      }
      kernel_.solve(poses, here, rows, good, say);
      for (long i = 0; i < here; ++i) {
        if (!Kernel::in_order) put_in_order(rows + i * slots * joints, good + i * slots, slots, joints, chain_.slides);
        if (deviation[i] > kRotationExact) say[i] |= kRounded;
      }
      apply_limits(rows, good, here * slots, joints, chain_.lower, chain_.upper, chain_.slides,
                   in_limits + first * slots);
    }
    return count;
  }

  void fk(const double* q, long count, double* T) const {
    forward_fk(chain_.links, chain_.slides, joints, q, count, T);
  }
  void jacobian(const double* q, long count, double* J) const {
    forward_jacobian(chain_.links, chain_.slides, joints, q, count, J);
  }

 private:
  template <class G> struct Held {
    G own{};
    Held(const double* numbers, const General* general = nullptr) {
      if (!numbers) return;
      read_numbers(own, numbers, general);
      if constexpr (requires { own.trials; }) make_model(own);
    }
    ~Held() {
      if constexpr (requires { own.trials; }) drop_model(own);
    }
    Held(const Held&) = delete;
    const General* given(const double* numbers) const { return numbers ? &own : nullptr; }
  };
  struct NoHelp {
    explicit NoHelp(const double*) {}
    static const General* given(const double*) { return nullptr; }
  };

  template <class G> static constexpr bool helped = requires(G own) { own.general; };
  std::conditional_t<helped<Own>, Held<General>, NoHelp> help_;
  Held<Own> own_;
  Kernel kernel_;
  TakenChain chain_;
};

}  // namespace pieper::PIEPER_ISA
