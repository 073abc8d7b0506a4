// Poses from memory into lanes, and solutions back to memory; a closed form between the two never sees memory.
// Templates over the number type.
#pragma once

#include "dispatch/geometry.hpp"
#include "chain/limits.hpp"
#include "chain/rigid.hpp"
#include "lanes/stream.hpp"

namespace pieper::PIEPER_ISA {

// What a family fills for every pose. Slots of one meaning keep one index, so labels follow from the slot.
template <class F, int Slots, int Joints> struct Branches {
  F q[Slots][Joints];      // rad or m; any value where not valid
  Mask<F> valid[Slots];    // verified by forward kinematics inside the family
  Mask<F> inside[Slots];   // inside the limits, where the family was told of them
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

// The same past the cache: at once where a vector is a line of it and stands on one. `past_cache_done` is left to the caller.
template <class F, int K> PIEPER_INLINE void store_records_past_cache(double* out, F* values, int lanes) {
  constexpr int W = width_of<F>;
  if constexpr (W == 8 && K % W == 0) {
    if (__builtin_expect(lanes == W && reinterpret_cast<std::uintptr_t>(out) % sizeof(F) == 0, 1)) {
      for (int block = 0; block < K; block += W) {
        transpose(values + block);
        for (int i = 0; i < W; ++i) store_past_cache(out + i * K + block, values[block + i]);
      }
      return;
    }
  }
  double near[K * W];
  store_records<F, K>(near, values, lanes);
  put_past_cache(out, near, static_cast<long>(K) * lanes);
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

// A pose as it was given: the rigid motion, and the last row.
template <class F> struct Given {
  RigidT<F> pose;
  F last[4];
};
template <class F> PIEPER_INLINE Given<F> load_given(const double* T) {
  constexpr int W = width_of<F>;
  F column[16];
  for (int block = 0; block < 16; block += W) {
    for (int i = 0; i < W; ++i) column[block + i] = load<F>(T + 16 * i + block);
    transpose(column + block);
  }
  Given<F> given;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) given.pose.r(i, j) = column[4 * i + j];
    given.pose.p(i) = column[4 * i + 3];
  }
  for (int j = 0; j < 4; ++j) given.last[j] = column[12 + j];
  return given;
}

// Where a pose is finite and departs from a rigid motion by no more than that: what `rotation_deviation` measures.
template <class F> PIEPER_INLINE Mask<F> is_exact(const Given<F>& given, double exact) {
  const RigidT<F>& T = given.pose;
  const F most(exact);
  Mask<F> good = abs(given.last[0]) + abs(given.last[1]) + abs(given.last[2]) + abs(given.last[3] - 1.0) <= most;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const F off = T.r(0, a) * T.r(0, b) + T.r(1, a) * T.r(1, b) + T.r(2, a) * T.r(2, b);
      good = good & (abs(a == b ? off - 1.0 : off) <= most);
    }
  good = good & (dot(cross(T.x, T.y), T.z) > 0.0);
  return good & (T.p(0) * 0.0 + T.p(1) * 0.0 + T.p(2) * 0.0 == 0.0);
}

template <class F, class Found> PIEPER_INLINE void store_flags(std::uint8_t* flag, const Found& out, int lanes) {
  Bits<F> flags = word_where(out.degenerate, kDegenerate) | word_where(out.uncertain, kUncertain) |
                  word_where(out.out_of_reach, kOutOfReach) | word_where(out.edge, kEdge);
  for (int i = 0; i < lanes; ++i) flag[i] = static_cast<std::uint8_t>(word_of_lane(flags, i));
}

// Rows, masks, flags and outcomes of a group of poses, the first of which has a number.
template <class F, int M, int N>
PIEPER_INLINE void store_group(Branches<F, M, N>& out, long first, int lanes, bool past_cache, const Answers& to) {
  double* const q = to.q + M * N * first;
  if (past_cache) store_records_past_cache<F, M * N>(q, out.q[0], lanes);
  else store_records<F, M * N>(q, out.q[0], lanes);
  store_masks<F, M>(to.valid + M * first, out.valid, lanes);
  store_masks<F, M>(to.in_limits + M * first, out.inside, lanes);
  store_flags<F>(to.flag + first, out, lanes);
  Mask<F> any_valid = out.valid[0], any_inside = out.inside[0];
  for (int m = 1; m < M; ++m) any_valid = any_valid | out.valid[m], any_inside = any_inside | out.inside[m];
  const Bits<F> outcome = word_where(any_valid, 1) | word_where(any_inside, 2);
  for (int i = 0; i < lanes; ++i)
    to.outcome[first + i] = static_cast<std::uint8_t>((word_of_lane(outcome, i) + 1) >> 1);
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

}  // namespace pieper::PIEPER_ISA
