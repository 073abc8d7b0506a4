// The loop around a closed-form family: poses from memory into lanes, one call, solutions back to memory.
//
// A family is a struct with `joints`, `slots` and a template `solve` over the number type; it never sees memory.
#pragma once

#include "lanes.hpp"

namespace pieper::PIEPER_ISA {

template <class F> struct Pose {
  F r[3][3];  // rotation, row by row
  F p[3];     // position, m
};

// What a family fills for every pose. Slots of one meaning keep one index, so labels follow from the slot.
template <class F, int Slots, int Joints> struct Branches {
  F q[Slots][Joints];        // rad or m; any value where not valid
  Mask<F> valid[Slots];      // verified by forward kinematics inside the family
  Mask<F> degenerate;        // so near a singular pose that families or merged roots are possible
  Mask<F> uncertain;         // the family cannot vouch that nothing is missing
  Mask<F> out_of_reach;      // no solution, for reasons of reach
};

enum FlagBit : std::uint8_t { kDegenerate = 1, kUncertain = 2, kOutOfReach = 4, kRounded = 8 };

// Poses [0, W) of T (row-major 4x4, 16 doubles each) into lanes.
template <class F> PIEPER_INLINE Pose<F> load_poses(const double* T) {
  constexpr int W = width_of<F>;
  Pose<F> pose;
  if constexpr (W == 1) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) pose.r[i][j] = T[4 * i + j];
      pose.p[i] = T[4 * i + 3];
    }
  } else {
    F column[16];
    for (int block = 0; block < 12; block += W) {
      for (int i = 0; i < W; ++i) column[block + i] = load<F>(T + 16 * i + block);
      transpose(column + block);
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) pose.r[i][j] = column[4 * i + j];
      pose.p[i] = column[4 * i + 3];
    }
  }
  return pose;
}

// `values[k]` lane i -> out[i * K + k], for the first `lanes` lanes.
template <class F, int K> PIEPER_INLINE void store_records(double* out, F* values, int lanes) {
  constexpr int W = width_of<F>;
  if constexpr (W == 1) {
    for (int k = 0; k < K; ++k) out[k] = values[k];
  } else {
    constexpr int whole = K - K % W;
    if (__builtin_expect(lanes == W, 1)) {
      for (int block = 0; block < whole; block += W) {
        transpose(values + block);
        for (int i = 0; i < W; ++i) store(out + i * K + block, values[block + i]);
      }
      for (int k = whole; k < K; ++k)
        for (int i = 0; i < W; ++i) out[i * K + k] = lane(values[k], i);
    } else {
      for (int k = 0; k < K; ++k)
        for (int i = 0; i < lanes; ++i) out[i * K + k] = lane(values[k], i);
    }
  }
}

template <class F, class Family>
PIEPER_INLINE void solve_group(const double* params, const int* iparams, const double* T, int lanes, double* q,
                               std::uint8_t* valid, std::uint8_t* flag) {
  constexpr int M = Family::slots, N = Family::joints;
  Branches<F, M, N> out;
  Family::template solve<F>(params, iparams, load_poses<F>(T), out);
  F values[M * N];
  unsigned bits[M];
  for (int m = 0; m < M; ++m) {
    for (int j = 0; j < N; ++j) values[m * N + j] = select(out.valid[m], out.q[m][j], F(0.0));
    bits[m] = bits_of(out.valid[m]);
  }
  store_records<F, M * N>(q, values, lanes);
  unsigned degenerate = bits_of(out.degenerate), uncertain = bits_of(out.uncertain), reach = bits_of(out.out_of_reach);
  for (int i = 0; i < lanes; ++i) {
    for (int m = 0; m < M; ++m) valid[i * M + m] = (bits[m] >> i) & 1u;
    flag[i] = static_cast<std::uint8_t>(((degenerate >> i) & 1u) * kDegenerate | ((uncertain >> i) & 1u) * kUncertain |
                                        ((reach >> i) & 1u) * kOutOfReach);
  }
}

// The entry of a closed-form family: any number of poses; a single one runs on plain doubles.
template <class Family>
void solve_batch(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid,
                 std::uint8_t* flag) {
  constexpr int M = Family::slots, N = Family::joints, W = PIEPER_LANES;
  if (count == 1) {
    solve_group<double, Family>(params, iparams, T, 1, q, valid, flag);
    return;
  }
  long done = 0;
  for (; done + W <= count; done += W)
    solve_group<Lanes<W>, Family>(params, iparams, T + 16 * done, W, q + M * N * done, valid + M * done, flag + done);
  if (done < count) {
    const int rest = static_cast<int>(count - done);
    double padded[16 * W];
    for (int i = 0; i < W; ++i)  // idle lanes repeat the last pose
      for (int k = 0; k < 16; ++k) padded[16 * i + k] = T[16 * (done + (i < rest ? i : rest - 1)) + k];
    solve_group<Lanes<W>, Family>(params, iparams, padded, rest, q + M * N * done, valid + M * done, flag + done);
  }
}

}  // namespace pieper::PIEPER_ISA
