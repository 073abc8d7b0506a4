// Whether the self-motion of two turns about one line is crossed by another.
#pragma once

#include <algorithm>
#include <cmath>

#include "singular/motions.hpp"
#include "singular/six.hpp"

namespace pieper::PIEPER_ISA {

// A column this near to the span of the others (without units) may lie in it: golden sections end within the root of
// rounding.
constexpr double kCrossed = 1e-5;

// Whether another self-motion may cross a line at one of its points: whether the rank drops there once more.
//
// Along the line the pose stays, and of the columns of the Jacobian only those of joints between its two turn, about their
// axis: c(u) = c0 + a cos u + b sin u for the one that a wrist has. It lies in the span of the others where the part across
// them vanishes, which is looked for from sixteen places. Lines over more joints are left to the slower look.
inline bool crossed(const SixJoints& arm, const LineSelfMotion& line) {
  if (line.j != line.i + 2) return true;
  const int m = line.i + 1;
  double basis[4][6];
  int rank = 0;
  auto across = [&](double* c) {
    for (int k = 0; k < rank; ++k) {
      double along = 0;
      for (int r = 0; r < 6; ++r) along += basis[k][r] * c[r];
      for (int r = 0; r < 6; ++r) c[r] -= along * basis[k][r];
    }
  };
  auto size = [](const double* c) {
    double sum = 0;
    for (int r = 0; r < 6; ++r) sum += c[r] * c[r];
    return std::sqrt(sum);
  };
  double place[3][6];
  for (int s = 0; s < 3; ++s) {
    double at[6];
    std::copy(line.through, line.through + kSix, at);
    at[line.i] += s * kTwoPi / 3;
    at[line.j] -= line.sense * s * kTwoPi / 3;
    const Standing there(arm, at);
    auto column = [&](int k, double* c) {
      for (int r = 0; r < 6; ++r) c[r] = there.J[k][r];
    };
    for (int k = 0; s == 0 && k < kSix; ++k) {
      if (k == m || k == line.j) continue;
      double c[6];
      column(k, c);
      across(c);
      across(c);
      const double left = size(c);
      if (left < kOneWayFree) return true;
      for (int r = 0; r < 6; ++r) basis[rank][r] = c[r] / left;
      ++rank;
    }
    column(m, place[s]);
    across(place[s]);
  }
  auto left = [&](double u) {
    double c[6];
    for (int r = 0; r < 6; ++r) {
      const double mean = (place[0][r] + place[1][r] + place[2][r]) / 3;
      const double a = (2 * place[0][r] - place[1][r] - place[2][r]) / 3,
                   b = (place[1][r] - place[2][r]) / std::sqrt(3.0);
      c[r] = mean + a * std::cos(u) + b * std::sin(u);
    }
    return size(c);
  };
  constexpr int kPlaces = 16;
  for (int k = 0; k < kPlaces; ++k) {
    double low = (k - 1) * kTwoPi / kPlaces, high = (k + 1) * kTwoPi / kPlaces;
    const double here = left(k * kTwoPi / kPlaces);
    if (here > left(low) || here > left(high)) continue;
    for (int step = 0; step < 40; ++step) {
      const double one = low + 0.382 * (high - low), other = low + 0.618 * (high - low);
      (left(one) < left(other) ? high : low) = left(one) < left(other) ? other : one;
    }
    if (left((low + high) / 2) < kCrossed) return true;
  }
  return false;
}

}  // namespace pieper::PIEPER_ISA
