// A row of a pose that is looked at from poses beside it, and what of it is counted in others. Scalar.
#pragma once

#include <vector>

#include "singular/merged.hpp"

namespace pieper::PIEPER_ISA {

struct Known {
  double q[6];
  int branches;
  bool singular, regular, fold, weak;
  bool several;                                        // more than one direction is free, and may lead away
  double inverse[6][6];                                // of the Jacobian of a regular row: [joint][pose]
  double miss;                                         // of a singular row
  double spread;                                       // of one in which branches merge: how far rounding parts them
  double sigma, second, bend, size, null[6], left[6];  // of a row with a weak direction

  // Whether a solution of a pose that is missed by e, of size `miss`, is this one that has moved.
  bool leads_to(const SixJoints& arm, const double* a, const double* e, double miss) const {
    double gap[6], length = 0;
    for (int i = 0; i < kSix; ++i) gap[i] = arm.way(a, q, i), length += gap[i] * gap[i];
    if (regular) {
      double moved = 0, astray = 0;
      for (int i = 0; i < kSix; ++i) {
        double step = 0;
        for (int r = 0; r < 6; ++r) step += inverse[i][r] * e[r];
        moved += step * step, astray += (gap[i] - step) * (gap[i] - step);
      }
      if (astray <= kAsideAstray * kAsideAstray * moved) return true;
    }
    if (!fold) return false;
    double t = 0, along = 0;
    for (int i = 0; i < kSix; ++i) t += null[i] * gap[i];
    for (int r = 0; r < 6; ++r) along += left[r] * e[r];
    if (std::fabs(t) > reach() || std::sqrt(std::fmax(length - t * t, 0.0)) * second > kAsideAcross * (t * t + miss))
      return false;
    return std::fabs(along - sigma * t - bend * t * t) <=
           kAsideAstray * (sigma * std::fabs(t) + std::fabs(bend) * t * t);
  }
  // How far from it rounding lets a solution be that is counted in it.
  double blur(double wide = 1) const {
    if (!singular) return 0;
    if (branches < 2) return fold ? 0 : std::fmin(2 * wide * kMergedRounding / std::fmax(sigma, kTiny), kSameAlong);
    return spread;
  }
  // How far along the weakest direction its second order says what is missed.
  double reach() const { return kFoldReaches * std::fabs(bend); }
  // Where the other root of the fold lies, along the weakest direction.
  double twin() const { return -sigma / bend; }
};

// Whether a singular row is counted in another of the rows, which rounding lets it be and which is known better.
inline bool is_counted(const SixJoints& arm, const std::vector<const Known*>& rows, const Known* one, double wide) {
  for (const Known* other : rows) {
    const bool better = other->blur(wide) < one->blur(wide) || (other->blur(wide) == one->blur(wide) && other < one),
               simple = one->branches == 1 && other->branches == 1;
    // two simple rows, each on its side, are the roots of a fold, however flat
    if (better && arm.apart(one->q, other->q) < one->blur(wide) && !(simple && on_two_sides(arm, one->q, other->q)))
      return true;
  }
  return false;
}

// How many branches merge in a row that stays, what is counted in it with it: a double root of which it is the only one known.
inline int branches_with(const SixJoints& arm, const std::vector<const Known*>& rows, const Known* one, double wide) {
  int branches = one->branches;
  for (const Known* other : rows) {
    if (branches > 1 || other->branches < 2 || !(arm.apart(one->q, other->q) < other->blur(wide))) continue;
    bool both = false;
    for (const Known* twin : rows)
      both |= twin->singular && twin->branches == 1 && arm.apart(twin->q, other->q) < other->blur(wide) &&
              on_two_sides(arm, twin->q, one->q);
    if (!both) branches = other->branches;
  }
  return branches;
}

}  // namespace pieper::PIEPER_ISA
