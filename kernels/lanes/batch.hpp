// The loop around a closed-form family: poses from memory into lanes, one call, solutions back to memory.
//
// A family is a struct with `joints`, `slots` and a template `solve` over the number type; it never sees memory.
#pragma once

#include "lanes/lanes.hpp"

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
  for (int m = 0; m < M; ++m)
    for (int j = 0; j < N; ++j) values[m * N + j] = select(out.valid[m], out.q[m][j], F(0.0));
  store_records<F, M * N>(q, values, lanes);
  // eight slots are the eight bytes of one word per lane
  for (int first = 0; first < M; first += 8) {
    const int slots = M - first < 8 ? M - first : 8;
    Bits<F> word = word_where(out.valid[first], 1);
    for (int m = 1; m < slots; ++m) word |= word_where(out.valid[first + m], 1ll << (8 * m));
    if (M == 8 && lanes == width_of<F>) __builtin_memcpy(valid, &word, sizeof word);
    else
      for (int i = 0; i < lanes; ++i) {
        const std::int64_t bytes = word_of_lane(word, i);
        for (int m = 0; m < slots; ++m) valid[i * M + first + m] = (bytes >> (8 * m)) & 1;
      }
  }
  Bits<F> flags = word_where(out.degenerate, kDegenerate) | word_where(out.uncertain, kUncertain) |
                  word_where(out.out_of_reach, kOutOfReach);
  for (int i = 0; i < lanes; ++i) flag[i] = static_cast<std::uint8_t>(word_of_lane(flags, i));
}

// The entry of a closed-form family: any number of poses. A single one runs on plain doubles, or through the family's
// own `solve_alone` where it has one.
template <class Family>
void solve_batch(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid,
                 std::uint8_t* flag) {
  constexpr int M = Family::slots, N = Family::joints, W = PIEPER_LANES;
  if (count == 1) {
    if constexpr (requires { &Family::solve_alone; })
      Family::solve_alone(params, iparams, load_poses<double>(T), q, valid, flag);
    else
      solve_group<double, Family>(params, iparams, T, 1, q, valid, flag);
    return;
  }
  for (long done = 0; done < count; done += W) {
    const int lanes = count - done < W ? static_cast<int>(count - done) : W;
    const double* poses = T + 16 * done;
    double padded[16 * W];
    if (lanes < W) {  // idle lanes repeat the last pose
      for (int i = 0; i < W; ++i)
        for (int k = 0; k < 16; ++k) padded[16 * i + k] = poses[16 * (i < lanes ? i : lanes - 1) + k];
      poses = padded;
    }
    solve_group<Lanes<W>, Family>(params, iparams, poses, lanes, q + M * N * done, valid + M * done, flag + done);
  }
}

}  // namespace pieper::PIEPER_ISA
