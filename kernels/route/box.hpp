// Limits of what joints make of a chain's coordinates: a coordinate each, or combinations where joints are coupled.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "route/self_motion.hpp"

namespace pieper::PIEPER_ISA {

class Box {
 public:
  // joints: (n, n) what is limited, as combinations of the coordinates; units: of each coordinate.
  Box(int n, const double* joints, const double* lower, const double* upper, const double* units) : n_(n) {
    for (int i = 0; i < n; ++i) {
      double square = 0;
      for (int j = 0; j < n; ++j) {
        of_[i][j] = joints[i * n + j] * units[j] / units[i];
        square += of_[i][j] * of_[i][j];
      }
      // a limit of a combination is told by how far the coordinates are from it
      const double size = std::sqrt(square);
      for (int j = 0; j < n; ++j) of_[i][j] /= size;
      low[i] = lower[i] / units[i] / size, high[i] = upper[i] / units[i] / size;
      alone_[i] = of_[i][i] == 1.0;
    }
  }

  double low[kMostCoordinates], high[kMostCoordinates];

  // Whether a coordinate is bounded by nothing.
  bool free(int j) const {
    bool out = true;
    for (int i = 0; i < n_; ++i) out = out && (of_[i][j] == 0.0 || !(std::isfinite(low[i]) || std::isfinite(high[i])));
    return out;
  }

  // By how much coordinates y are outside, at least.
  double outside(const double* y) const {
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < n_; ++i) {
      const double value = limited(i, y);
      most = std::fmax(most, std::fmax(low[i] - value, value - high[i]));
    }
    return most;
  }

  // Whether the straight line from y along a tangent (of length one) comes, at most so far to either side, to where
  // nothing is outside by more than a slack.
  bool meets(const double* y, const double* tangent, double far, double slack) const {
    double first = -far, last = far;
    for (int i = 0; i < n_; ++i) {
      const double value = limited(i, y), slope = limited(i, tangent);
      const double below = low[i] - slack - value, above = high[i] + slack - value;
      if (slope == 0.0) {
        if (below > 0 || above < 0) return false;
        continue;
      }
      const double a = below / slope, b = above / slope;
      first = std::fmax(first, std::fmin(a, b)), last = std::fmin(last, std::fmax(a, b));
    }
    return first <= last;
  }

 private:
  double limited(int i, const double* y) const {
    if (alone_[i]) return y[i];
    double value = 0;
    for (int j = 0; j < n_; ++j) value += of_[i][j] * y[j];
    return value;
  }

  int n_;
  double of_[kMostCoordinates][kMostCoordinates];  // what is limited, each row of length one
  bool alone_[kMostCoordinates];                   // whether that is one coordinate
};

}  // namespace pieper::PIEPER_ISA
