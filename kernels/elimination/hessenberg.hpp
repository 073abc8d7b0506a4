// Hessenberg form by Householder's reflections, in lanes: the first half of the eigenvalue problem.
//
// LAPACK is not linked: for 16 x 16 its call overhead and blocking cost more than the arithmetic.
// A template over the number type.
#pragma once

#include "lanes/lanes.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA::general {

// N columns of each row count; the rest is room.
template <class F, int N, int Room> void hessenberg(F (&a)[N][Room]) {
  for (int k = 0; k + 2 < N; ++k) {
    F tail = 0.0;
    for (int i = k + 2; i < N; ++i) tail += a[i][k] * a[i][k];
    const F x0 = a[k + 1][k];
    F norm = sqrt(tail + x0 * x0);
    norm = select(x0 > 0.0, norm, 0.0 - norm);
    const F head = x0 + norm, size = norm * head;
    const F scale = select(size > kHouseholderZero, 1.0 / select(size > kHouseholderZero, size, F(1.0)), F(0.0));
    F v[N];
    v[k + 1] = head;
    for (int i = k + 2; i < N; ++i) v[i] = a[i][k];
    for (int j = k + 1; j < N; ++j) {
      F w = 0.0;
      for (int i = k + 1; i < N; ++i) w += v[i] * a[i][j];
      w = w * scale;
      for (int i = k + 1; i < N; ++i) a[i][j] -= w * v[i];
    }
    for (int i = 0; i < N; ++i) {
      F w = 0.0;
      for (int j = k + 1; j < N; ++j) w += a[i][j] * v[j];
      w = w * scale;
      for (int j = k + 1; j < N; ++j) a[i][j] -= w * v[j];
    }
    a[k + 1][k] = 0.0 - norm;
    for (int i = k + 2; i < N; ++i) a[i][k] = 0.0;
  }
}

}  // namespace pieper::PIEPER_ISA::general
