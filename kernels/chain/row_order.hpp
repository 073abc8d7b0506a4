// The order of a pose's rows where slots have no meaning of their own: valid rows first, by the first joint, then the
// second ... Lanes, the single-pose road and the careful road must agree on it.
// Ranking is a template over the number type; sorting one pose is its scalar twin.
#pragma once

#include "lanes/lanes.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA {

// A value for ordering: an angle a rounding away from -pi counts as pi, so that it does not change places with its twin.
template <class F> PIEPER_INLINE F place(F value, bool sliding) {
  return sliding ? value : select(value < -3.14159265, value + 6.283185307179586, value);
}

// Whether row a comes before row b.
inline bool before(const double* a, const double* b, const std::uint8_t* prismatic, int n) {
  for (int j = 0; j < n; ++j) {
    const double x = place(a[j], prismatic[j]), y = place(b[j], prismatic[j]);
    if (abs(x - y) > kKernelRowOrder) return x < y;
  }
  return false;
}

// Moves the valid rows of one pose to the front, in order; the others become zeros.
inline void put_in_order(double* q, std::uint8_t* valid, int slots, int n, const std::uint8_t* prismatic) {
  double sorted[256 * 8];
  int m = 0;
  bool moved = false;
  int order[256];
  for (int i = 0; i < slots; ++i) {
    if (!valid[i]) continue;
    int at = m++;
    while (at > 0 && before(q + i * n, q + order[at - 1] * n, prismatic, n)) {
      order[at] = order[at - 1];
      --at;
    }
    order[at] = i;
  }
  for (int i = 0; i < m; ++i) moved |= order[i] != i;
  if (!moved || m * n > 256 * 8) return;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) sorted[i * n + j] = q[order[i] * n + j];
  for (int k = 0; k < slots * n; ++k) q[k] = k < m * n ? sorted[k] : 0.0;
  for (int i = 0; i < slots; ++i) valid[i] = i < m;
}

// The rank of each of M rows by counting who comes before it; invalid rows come last. Where differences near kKernelRowOrder
// make a circle two rows get one rank: the caller must look.
template <class F, int M, int N>
PIEPER_INLINE void rank_rows(const F (*q)[N], const Mask<F>* valid, const bool* slides, Bits<F>* rank) {
  F first[M];
  for (int m = 0; m < M; ++m)
    first[m] = select(valid[m], place(q[m][0], slides[0]), F(kEndless * (m + 1)));  // no ties among invalid ones
  for (int m = 0; m < M; ++m) rank[m] = Bits<F>{} + m;  // before it: those of a lower slot, until shown otherwise
#pragma GCC unroll 1
  for (int b = 1; b < M; ++b)
#pragma GCC unroll 1
    for (int a = 0; a < b; ++a) {
      F ahead = first[b] - first[a];
      Mask<F> tie = abs(ahead) <= kKernelRowOrder;
      for (int j = 1; j < N && any(tie); ++j) {
        ahead = select(tie, place(q[b][j], slides[j]) - place(q[a][j], slides[j]), ahead);
        tie = abs(ahead) <= kKernelRowOrder;
      }
      const Bits<F> swap = word_where(ahead < -kKernelRowOrder, 1);
      rank[a] += swap;
      rank[b] -= swap;
    }
}

}  // namespace pieper::PIEPER_ISA
