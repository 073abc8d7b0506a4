// Whether the self-motion of two turns about one line is crossed by another.
#pragma once

#include <algorithm>
#include <cmath>

#include "singular/motions.hpp"
#include "singular/six.hpp"

namespace pieper::PIEPER_ISA {

// Whether another self-motion may cross a line at one of its points: whether the rank drops there once more. For lines that belong to
// no group of three; of those of a group see fibre.hpp.
//
// Along the line the pose stays, and of the columns of the Jacobian only those of joints between its two turn, about their
// axis: c(u) = c0 + a cos u + b sin u for the one that a line over one joint has. Across the span of the other four two equations
// are left, of which cosine and sine are the solution. Lines over more joints are left to the slower look.
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
  // two directions across the four: the columns' largest part there, and what is left of another
  double p[3][2], first[6] = {}, second[6] = {};
  double c0[3][6];
  for (int r = 0; r < 6; ++r) {
    c0[0][r] = (place[0][r] + place[1][r] + place[2][r]) / 3;
    c0[1][r] = (2 * place[0][r] - place[1][r] - place[2][r]) / 3,
    c0[2][r] = (place[1][r] - place[2][r]) / std::sqrt(3.0);
  }
  for (double* way : {first, second}) {
    double best[6] = {}, most = 0;
    for (const auto& c : c0) {
      double left[6], along = 0;
      for (int r = 0; r < 6; ++r) along += c[r] * first[r];
      for (int r = 0; r < 6; ++r) left[r] = way == second ? c[r] - along * first[r] : c[r];
      if (size(left) > most) most = size(left), std::copy(left, left + 6, best);
    }
    if (most < kOneWayFree) return true;
    for (int r = 0; r < 6; ++r) way[r] = best[r] / most;
  }
  for (int k = 0; k < 3; ++k)
    for (int w = 0; w < 2; ++w) {
      p[k][w] = 0;
      for (int r = 0; r < 6; ++r) p[k][w] += c0[k][r] * (w ? second : first)[r];
    }
  const double det = p[1][0] * p[2][1] - p[1][1] * p[2][0];
  if (std::fabs(det) < kOneWayFree * kOneWayFree) return true;
  const double cosine = (p[2][0] * p[0][1] - p[2][1] * p[0][0]) / det,
               sine = (p[0][0] * p[1][1] - p[0][1] * p[1][0]) / det;
  return std::fabs(std::hypot(cosine, sine) - 1) < kOneWayFree;
}

}  // namespace pieper::PIEPER_ISA
