// Solutions of a pose from joint vectors all over, and whether what is free at one of them in two directions leads away. Scalar.
//
// A self-motion that pushes every pose beside to one and the same side has no solution of theirs near it: only Newton's method on the pose
// itself, from anywhere, leads to its points.
#pragma once

#include "singular/merged.hpp"

namespace pieper::PIEPER_ISA {

// Calls visit with what holds T, from the same joint vectors every time; false when visit says so.
template <class Visit> bool from_all_over(const SixJoints& arm, const Rigid& T, Visit visit) {
  constexpr int kStarts = 48, kSteps = 30;
  // Weyl's sequence: multiples of square roots of primes spread evenly
  constexpr double kRoots[6] = {1.4142135623730951, 1.7320508075688772, 2.2360679774997896,
                                2.6457513110645907, 3.3166247903553998, 3.6055512754639891};
  for (int k = 1; k <= kStarts; ++k) {
    double q[6], step[6], size = INFINITY;
    for (int i = 0; i < kSix; ++i) {
      const double part = k * kRoots[i];
      q[i] = (2 * (part - std::floor(part)) - 1) * (arm.slides[i] ? 1 : kPi);
    }
    for (int taken = 0; taken < kSteps && size > kHoldsToRounding; ++taken) {
      const Standing at(arm, q);
      double e[6];
      size = at.missing(T, e);
      // far away a damped step comes down where Newton's would leap about
      damped_step(kSix, e, at.J, std::fmax(kAllOverDamping * std::fmin(1.0, size * size), kAllOverLeast), 0.5, step);
      for (int i = 0; i < kSix; ++i) q[i] += step[i];
    }
    if (size < kAllOverHolds && !visit(q)) return false;
  }
  return true;
}

// Whether the pose can be left along none of the directions that are free at a row with two of them: what both miss to second
// order vanishes together for no mixture, and the row is isolated.
inline bool stands_alone(const Standing& at, const SingularSix& d) {
  constexpr int kMixtures = 24;
  if (!(d.s[3] > kOneWayFree * d.s[0])) return false;
  double least = INFINITY, most = 0;
  for (int k = 0; k < kMixtures; ++k) {
    const double c = std::cos(k * kPi / kMixtures), s = std::sin(k * kPi / kMixtures);
    Bracket bracket;
    for (int i = 0; i < kSix; ++i) {
      double x[6];
      for (int r = 0; r < 6; ++r) x[r] = at.J[i][r] * (c * d.joint[4][i] + s * d.joint[5][i]);
      bracket.then(x);
    }
    double size = 0;
    for (int open = 4; open < 6; ++open) {
      double part = 0;
      for (int r = 0; r < 6; ++r) part += d.pose[open][r] * bracket.sum[r];
      size += part * part;
    }
    least = std::fmin(least, std::sqrt(size)), most = std::fmax(most, std::sqrt(size));
  }
  return most > kClearFold && least > kMixtureMisses * most;
}

}  // namespace pieper::PIEPER_ISA
