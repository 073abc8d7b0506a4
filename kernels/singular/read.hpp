// All there is at a singular pose, as a look tells it: rows in order, and the self-motions some of them stand for. Scalar.
#pragma once

#include "singular/near_curve.hpp"
#include "singular/pieces.hpp"

namespace pieper::PIEPER_ISA {

struct Read {
  struct Row {
    double q[6];   // rad; lengths
    int branches;  // that merge in it
    int motion;    // the self-motion it stands for, of `motions` or behind them of `curves`, or -1
    bool singular;
  };
  std::vector<Row> rows;
  std::vector<SelfMotionRead> motions;
  std::vector<NearCurve> curves;  // self-motions that were followed

  void clear() { rows.clear(), motions.clear(), curves.clear(); }

  void add(const SixJoints& arm, const double* q, int branches, int motion, bool singular) {
    Row row{{}, branches, motion, singular};
    for (int i = 0; i < kSix; ++i) row.q[i] = arm.slides[i] ? q[i] : in_one_turn(q[i]);
    rows.push_back(row);
  }

  // Ascending by joint 1, then 2, ...; what differs by rounding alone counts as equal.
  void in_order(const SixJoints& arm) {
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
      for (int i = 0; i < kSix; ++i) {
        const double grid = arm.slides[i] ? kRowOrderGrid / arm.length : kRowOrderGrid,
                     x = std::nearbyint(a.q[i] / grid), y = std::nearbyint(b.q[i] / grid);
        if (x != y) return x < y;
      }
      return false;
    });
  }

 private:
  // An angle in (-pi, pi]; a rounding away from -pi it is pi, so that it does not change places with its twin.
  static double in_one_turn(double q) {
    if (!(q > -kPi && q <= kPi)) q = kPi - (kPi - q - kTwoPi * std::floor((kPi - q) / kTwoPi));
    return q < kOrthogonal - kPi ? kPi : q;
  }
};

}  // namespace pieper::PIEPER_ISA
