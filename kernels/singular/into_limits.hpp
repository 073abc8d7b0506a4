// A merged root next to a limit: rounding blurs it along what is free there to first order, and a stop may lie within the blur. Scalar.
#pragma once

#include <vector>

#include "singular/merged.hpp"
#include "singular/motions.hpp"

namespace pieper::PIEPER_ISA {

// Puts a singular row at the limits it lies outside of, where a posture there takes the pose to rounding as well; or, with
// `turns`, at limits that it lies just outside of while it is inside a turn on: there the posture is at the stop, a turn nearer to it.
inline void into_limits(const SixJoints& arm, const Rigid& T, const Limits& limits, bool turns, double* q) {
  constexpr int kSteps = 6;
  double at[6];
  bool held[6] = {}, any = false;
  std::copy(q, q + kSix, at);
  for (int i = 0; i < kSix; ++i) {
    double value = q[i];
    const bool within = turned_inside(value, arm.slides[i], limits.lower[i], limits.upper[i]);
    if (within != turns || (within && arm.slides[i])) continue;
    const double lower = arm.slides[i] ? limits.lower[i] - q[i] : short_way(limits.lower[i] - q[i]),
                 upper = arm.slides[i] ? limits.upper[i] - q[i] : short_way(limits.upper[i] - q[i]),
                 way = std::fabs(lower) < std::fabs(upper) ? lower : upper;
    const bool out = (way == lower && way > 0) || (way == upper && way < 0) || std::fabs(lower - upper) < kLimitSlack;
    if (within && !(std::fabs(way) < kMergedBlur && out)) continue;
    if (!(std::fabs(way) < kMergedBlur)) return;
    at[i] += way, held[i] = any = true;
  }
  if (!any) return;
  for (int step = 0; step < kSteps; ++step) {
    Standing now(arm, at);
    double e[6];
    now.missing(T, e);
    for (int i = 0; i < kSix; ++i)
      if (held[i]) std::fill(now.J[i], now.J[i] + 6, 0.0);
    step_along(SingularSix(now.J), e, kHeldFirmly, -1, kMergedBlur, at);
  }
  const double rounding = kMergedRounding * (1 + std::sqrt(dot(T.t, T.t)));
  bool inside = missed_at(arm, at, T) <= std::fmax(rounding, missed_at(arm, q, T)) && arm.apart(at, q) < kMergedBlur;
  for (int i = 0; i < kSix && inside; ++i) {
    double value = at[i];
    inside = turned_inside(value, arm.slides[i], limits.lower[i], limits.upper[i]);
  }
  if (inside) std::copy(at, at + kSix, q);
}

// The same of all merged roots of a pose, but for two that would come to one posture: both roots of a fold beside a limit are rows.
inline void all_into_limits(const SixJoints& arm, const Rigid& T, const Limits& limits, std::vector<Root>& roots) {
  std::vector<Root> placed = roots;
  for (Root& root : placed)
    for (bool turns : {false, true}) into_limits(arm, T, limits, turns, root.q);
  for (std::size_t a = 0; a < roots.size(); ++a) {
    bool alone = true;
    for (std::size_t b = 0; b < roots.size(); ++b)
      alone = alone && (a == b || !(arm.apart(placed[a].q, placed[b].q) < arm.apart(roots[a].q, roots[b].q) / 4));
    if (alone) std::copy(placed[a].q, placed[a].q + kSix, roots[a].q);
  }
}

}  // namespace pieper::PIEPER_ISA
