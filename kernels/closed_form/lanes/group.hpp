// A group of three joints and the three beside it for many poses at once: the straight road. A lane in which anything is delicate
// (a root pair about to merge, a wrist about to line up, a residual above the verified one) is handed to the careful scalar road.
// A template over the number type: one pose in doubles, many in lanes; its careful twin is scalar.
#pragma once

#include "chain/outcomes.hpp"
#include "chain/row_order.hpp"
#include "closed_form/careful/group.hpp"
#include "closed_form/careful/position.hpp"
#include "closed_form/lanes/pair.hpp"
#include "lanes/batch.hpp"

namespace pieper::PIEPER_ISA::closed_form {

// What a family computes for a group of poses.
template <class F> struct LaneSolutions {
  F q[8][6];  // rad; a slide in lengths of the arm
  Mask<F> valid[8];
  Mask<F> unclear;
};

// The three joints beside a group, at each of the four pairs: the middle joint, and the motion of the loop around the group.
template <class F> struct Around {
  const GroupArm& arm;
  const LoopRestT<F>& rest;
  const PairLanes<F>& s;
  RigidT<F> left, right;  // Pre Za A and B Zc C, each kept while its joint stays the same

  PIEPER_INLINE RigidT<F> at(int i, Motion<F> b) {
    const bool *slides = arm.slides, second = s.apart && i % 2;
    if (!second || s.first_c) left = moved(rest.pre, s.a[i], slides[arm.order[0]]) * rest.A;
    if (!second || !s.first_c) right = moved(rest.B, s.c[i], slides[arm.order[2]]) * rest.C;
    return moved(left, b, slides[arm.order[1]]) * right;
  }
};

// The turn about z that takes `from` to `to`.
template <class F> PIEPER_INLINE Motion<F> turn_between(Vec3T<F> from, Vec3T<F> to, Mask<F>& unclear, Mask<F> found) {
  unclear = unclear | (found & !((from.x * from.x + from.y * from.y) > kRootsMerge));
  return unit(to.x * from.x + to.y * from.y, to.y * from.x - to.x * from.y);
}

template <class F> PIEPER_INLINE void start_pair(const GroupArm& arm, PairLanes<F>& s) {
  s.slides_a = arm.slides[arm.order[0]], s.slides_c = arm.slides[arm.order[2]];
  s.hide_c = arm.hide_c, s.first_c = arm.first_c, s.apart = arm.apart;
}

template <class F> PIEPER_INLINE void put_pair(const GroupArm& arm, const PairLanes<F>& s, int i, F b, F* q) {
  q[arm.order[0]] = s.angle_a[i], q[arm.order[1]] = b, q[arm.order[2]] = s.angle_c[i];
}

// Lanes of poses through a family, verified by closing the loop, rows in order; bits of the lanes that need the careful road. limits: null
// where they are left to others.
template <class F, class Family>
__attribute__((noinline)) unsigned solve_clear(const GroupArm& arm, const Family& family, const RigidT<F>& pose,
                                               int lanes, const JointLimits* limits, double* q, std::uint8_t* valid,
                                               std::uint8_t* flag, std::uint8_t* in_limits) {
  constexpr int W = width_of<F>;
  const LoopRestT<F> rest(arm.links, in_lengths(pose, arm.length), arm.first);
  LaneSolutions<F> out;
  family.template solve<F>(arm, rest, out);
  F values[8][6];
  for (int m = 0; m < 8; ++m)
    for (int j = 0; j < 6; ++j) values[m][j] = select(out.valid[m], out.q[m][j] * arm.unit[j], F(0.0));
  Bits<F> rank[8];
  rank_rows<F, 8, 6>(values, out.valid, arm.slides, rank);
  // as many different ranks as rows, or the lane's order is left to the careful road
  Bits<F> seen = {}, count = {};
  for (int m = 0; m < 8; ++m) {
    seen |= (Bits<F>{} + 1) << rank[m];
    count += word_where(out.valid[m], 1);
  }
  std::int64_t ranks[8][W], counts[W], all_seen[W];
  __builtin_memcpy(ranks, rank, sizeof ranks);
  __builtin_memcpy(counts, &count, sizeof counts);
  __builtin_memcpy(all_seen, &seen, sizeof all_seen);
  unsigned unclear = bits_of(out.unclear);
  std::uint8_t within[8 * W];
  if (limits) {
    Mask<F> inside[8];
    turn_inside<F, 8, 6>(values, out.valid, *limits, inside);
    store_masks<F, 8>(within, inside, W);
  }
  double rows[48 * W];
  store_records<F, 48>(rows, values[0], W);
  for (int i = 0; i < lanes; ++i) {
    for (int m = 0; m < 8; ++m) __builtin_memcpy(q + 48 * i + 6 * ranks[m][i], rows + 48 * i + 6 * m, 48);
    if (limits)
      for (int m = 0; m < 8; ++m) in_limits[8 * i + ranks[m][i]] = within[8 * i + m];
    if (all_seen[i] != 255) unclear |= 1u << i;
    const std::uint64_t ones = 0x0101010101010101u,
                        word = counts[i] == 8 ? ones : ones & ((1ull << (8 * counts[i])) - 1);
    __builtin_memcpy(valid + 8 * i, &word, 8);
    flag[i] = counts[i] ? 0 : kOutOfReach;
  }
  return unclear & ((1u << lanes) - 1u);
}

// A family of groups. `Lanes` is made from a GroupArm, solves poses in lanes, and has `careful`, which takes one pose.
template <class Geometry, class Lanes_> class GroupKernel {
 public:
  static constexpr bool in_order = true;
  explicit GroupKernel(const Geometry& arm) : arm_(arm), family_(arm_) {}

  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    const Answers to = {q, valid, nullptr, flag, nullptr};
    if (!arm_.straight || !family_.straight) {
      for (long i = 0; i < count; ++i) again(1, T + 16 * i, nullptr, part(to, i));
    } else {
      in_lanes(T, count, [&](long first, int lanes, const double* poses) {
        clear_or_again(load_poses<Wide>(poses), poses, lanes, nullptr, part(to, first));
      });
    }
  }
  bool solve_inside(const double* T, long count, const Directly& how, const Answers& to) const {
    bool exact =
        arm_.straight && family_.straight;  // the careful road alone: those who ask look at its poses themselves
    if (!exact) return false;
    double rows[48 * width_of<Wide>];
    in_lanes(T, count, [&](long first, int lanes, const double* poses) {
      const Given<Wide> given = load_given<Wide>(poses);
      if (!(exact = exact && all(is_exact(given, how.exact)))) return;
      Answers here = part(to, first);
      double* const q = here.q;
      if (how.past_cache) here.q = rows;
      clear_or_again(given.pose, poses, lanes, &how.limits, here);
      if (how.past_cache) put_past_cache(q, rows, 48l * lanes);
    });
    if (how.past_cache) past_cache_done();
    if (exact) outcomes(to.valid, to.in_limits, count, 8, to.outcome);
    return exact;
  }

 private:
  using Wide = Lanes<PIEPER_LANES>;

  static Answers part(const Answers& to, long first) {
    return {to.q + 48 * first, to.valid + 8 * first, to.in_limits ? to.in_limits + 8 * first : nullptr, to.flag + first,
            to.outcome ? to.outcome + first : nullptr};
  }
  void clear_or_again(const RigidT<Wide>& pose, const double* T, int lanes, const JointLimits* limits,
                      const Answers& to) const {
    again(solve_clear<Wide>(arm_, family_, pose, lanes, limits, to.q, to.valid, to.flag, to.in_limits), T, limits, to);
  }
  // The poses that bits of `unclear` name on the careful road.
  void again(unsigned unclear, const double* T, const JointLimits* limits, const Answers& to) const {
    for (; unclear; unclear &= unclear - 1) {
      const long i = __builtin_ctz(unclear);
      family_.careful(arm_, T + 16 * i, to.q + 48 * i, to.valid + 8 * i, to.flag + i);
      put_in_order(to.q + 48 * i, to.valid + 8 * i, 8, 6, reinterpret_cast<const std::uint8_t*>(arm_.slides));
      if (limits)
        apply_limits(to.q + 48 * i, to.valid + 8 * i, 8, 6, limits->lower, limits->upper, limits->prismatic,
                     to.in_limits + 8 * i);
    }
  }

  GroupArm arm_;
  Lanes_ family_;
};

}  // namespace pieper::PIEPER_ISA::closed_form
