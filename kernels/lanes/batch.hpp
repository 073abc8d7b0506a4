// Poses from memory into lanes, and solutions back to memory; a closed form between the two never sees memory.
// Templates over the number type.
#pragma once

#include "dispatch/geometry.hpp"
#include "chain/limits.hpp"
#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA {

// What a family fills for every pose. Slots of one meaning keep one index, so labels follow from the slot.
template <class F, int Slots, int Joints> struct Branches {
  F q[Slots][Joints];      // rad or m; any value where not valid
  Mask<F> valid[Slots];    // verified by forward kinematics inside the family
  Mask<F> reached[Slots];  // in reach, verified or not
  Mask<F> missed;          // a row in reach is not verified: rounding took too much, and the row may be missing
  Mask<F> degenerate;      // so near a singular pose that families or merged roots are possible
  Mask<F> uncertain;       // the family cannot vouch that nothing is missing
  Mask<F> out_of_reach;    // no solution, for reasons of reach
  Mask<F> edge;            // nor is it clear that poses beside it have none
};

// Poses [0, W) of T (row-major 4x4, 16 doubles each) into lanes.
template <class F> PIEPER_INLINE RigidT<F> load_poses(const double* T) {
  constexpr int W = width_of<F>;
  if constexpr (W == 1) return read_rigid(T, 1);
  else {
    F column[16];
    for (int block = 0; block < 12; block += W) {
      for (int i = 0; i < W; ++i) column[block + i] = load<F>(T + 16 * i + block);
      transpose(column + block);
    }
    RigidT<F> pose;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) pose.r(i, j) = column[4 * i + j];
      pose.p(i) = column[4 * i + 3];
    }
    return pose;
  }
}

// Lane from[i] of `in` becomes lane i of `to`; both are made of nothing but numbers of type F and G. The lanes of a narrower F are all
// the same.
template <class G, class F, class To, class From>
PIEPER_INLINE void pick_lanes(To& to, const From& in, const LanePicker<width_of<G>>& pick) {
  constexpr unsigned all = sizeof(To), one = sizeof(G), given = sizeof(From), each = sizeof(F);
  static_assert(all / one == given / each);
  G* into = reinterpret_cast<G*>(&to);
  const F* of = reinterpret_cast<const F*>(&in);
#pragma GCC unroll 4
  for (unsigned k = 0; k < all / one; ++k) {
    if constexpr (width_of<F> < width_of<G>) into[k] = G(lane(of[k], 0));
    else into[k] = pick(of[k]);
  }
}

// Lane j of `from` becomes lane i of `to`; both are made of nothing but numbers of type F and G.
template <class G, class F, class To, class From>
PIEPER_INLINE void copy_lanes(To& to, int i, const From& from, int j) {
  G* into = reinterpret_cast<G*>(&to);
  const F* of = reinterpret_cast<const F*>(&from);
  constexpr unsigned all = sizeof(To), one = sizeof(G);
  for (unsigned k = 0; k < all / one; ++k) set_lane(into[k], i, lane(of[k], j));
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

// Masks of M slots -> bytes, M for each of the first `lanes` lanes.
template <class F, int M> PIEPER_INLINE void store_masks(std::uint8_t* out, const Mask<F>* slot, int lanes) {
  // eight slots are the eight bytes of one word per lane
  for (int first = 0; first < M; first += 8) {
    const int slots = M - first < 8 ? M - first : 8;
    Bits<F> word = word_where(slot[first], 1);
    for (int m = 1; m < slots; ++m) word |= word_where(slot[first + m], 1ll << (8 * m));
    if (M == 8 && lanes == width_of<F>) __builtin_memcpy(out, &word, sizeof word);
    else
      for (int i = 0; i < lanes; ++i) {
        const std::int64_t bytes = word_of_lane(word, i);
        for (int m = 0; m < slots; ++m) out[i * M + first + m] = (bytes >> (8 * m)) & 1;
      }
  }
}

// limits: null where they are left to others.
template <class F, class Kernel, class Arm>
PIEPER_INLINE void solve_group(const Arm& arm, const double* T, int lanes, const JointLimits* limits, double* q,
                               std::uint8_t* valid, std::uint8_t* flag, std::uint8_t* in_limits) {
  constexpr int M = Arm::slots, N = Arm::joints;
  Branches<F, M, N> out;
  Kernel::template branches<F>(arm, load_poses<F>(T), out);
  F values[M][N];
  for (int m = 0; m < M; ++m)
    for (int j = 0; j < N; ++j) values[m][j] = select(out.valid[m], out.q[m][j], F(0.0));
  if (limits) {
    Mask<F> inside[M];
    turn_inside<F, M, N>(values, out.valid, *limits, inside);
    store_masks<F, M>(in_limits, inside, lanes);
  }
  store_records<F, M * N>(q, values[0], lanes);
  store_masks<F, M>(valid, out.valid, lanes);
  Bits<F> flags = word_where(out.degenerate, kDegenerate) | word_where(out.uncertain, kUncertain) |
                  word_where(out.out_of_reach, kOutOfReach) | word_where(out.edge, kEdge);
  for (int i = 0; i < lanes; ++i) flag[i] = static_cast<std::uint8_t>(word_of_lane(flags, i));
}

// Calls group(first, lanes, poses) for all poses, W at a time; idle lanes of the last group repeat the last pose.
template <class Group> PIEPER_INLINE void in_lanes(const double* T, long count, Group group) {
  constexpr int W = PIEPER_LANES;
  long done = 0;
  for (; done + W <= count; done += W) group(done, W, T + 16 * done);
  if (done == count) return;
  const int rest = static_cast<int>(count - done);
  double padded[16 * W];
  for (int i = 0; i < W; ++i)
    __builtin_memcpy(padded + 16 * i, T + 16 * (done + (i < rest ? i : rest - 1)), sizeof(double[16]));
  group(done, rest, padded);
}

// Any number of poses through a closed form that never branches.
template <class Kernel, class Arm> void solve_batch(const Arm& arm, const double* T, long count,
                                                    const JointLimits* limits, double* q, std::uint8_t* valid,
                                                    std::uint8_t* flag, std::uint8_t* in_limits) {
  constexpr int M = Arm::slots, N = Arm::joints;
  in_lanes(T, count, [&](long first, int lanes, const double* poses) {
    solve_group<Lanes<PIEPER_LANES>, Kernel>(arm, poses, lanes, limits, q + M * N * first, valid + M * first,
                                             flag + first, limits ? in_limits + M * first : nullptr);
  });
}

}  // namespace pieper::PIEPER_ISA
