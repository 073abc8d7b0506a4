// The road of the families that leave one joint's angle to a trigonometric polynomial: its values at a few angles, its real roots
// (trigonometric_roots.hpp), the other joints from each root, all of it in lanes, and every solution put back through the chain
// as described. A pose where anything is delicate is handed to the general solver.
//
// A family is a struct with
//   degree, samples (more than 2 degree + 1), both (whether a root has a solution on either side), slots;
//   Arm: its constants, doubles only; Target<F>: a pose as the arm sees it, numbers of type F only;
//   see(arm, pose), polynomial(arm, target, c, s), wanting(arm, target): whether the polynomial may not know all solutions,
//   Settled<F> settle(arm, target, root, slope, unclear): a root, the polynomial's slope there, made exact on the arm's own condition; says
//   what is not clear,
//   posture(arm, target, settled, side, q): the joints, on its own side, 1, or where `both` on the other, -1.
// Templates over the number type, used for lanes only; the general solver is the careful road.
#pragma once

#include "chain/outcomes.hpp"
#include "chain/row_order.hpp"
#include "elimination/entry.hpp"
#include "hidden_angle/refined_roots.hpp"
#include "lanes/unit_angle.hpp"

namespace pieper::PIEPER_ISA::hidden_angle {

// x + y r with r^2 known: what is even and what is odd in a square root, also where that is not real.
template <class F> struct Surd {
  F x, y, square;
};
template <class F> PIEPER_INLINE Surd<F> operator+(Surd<F> a, Surd<F> b) { return {a.x + b.x, a.y + b.y, a.square}; }
template <class F> PIEPER_INLINE Surd<F> operator-(Surd<F> a, Surd<F> b) { return {a.x - b.x, a.y - b.y, a.square}; }
template <class F> PIEPER_INLINE Surd<F> operator*(Surd<F> a, Surd<F> b) {
  return {a.x * b.x + a.square * (a.y * b.y), a.x * b.y + a.y * b.x, a.square};
}
template <class F> PIEPER_INLINE Surd<F> operator+(Surd<F> a, double b) { return {a.x + b, a.y, a.square}; }
template <class F> PIEPER_INLINE Surd<F> operator+(Surd<F> a, F b) { return {a.x + b, a.y, a.square}; }
template <class F> PIEPER_INLINE Surd<F> operator*(double k, Surd<F> a) { return {k * a.x, k * a.y, a.square}; }
template <class F> PIEPER_INLINE Surd<F> operator*(F k, Surd<F> a) { return {k * a.x, k * a.y, a.square}; }

// A value and its derivative by the hidden angle.
template <class F> struct Dual {
  F x, d;
};
template <class F> PIEPER_INLINE Dual<F> operator+(Dual<F> a, Dual<F> b) { return {a.x + b.x, a.d + b.d}; }
template <class F> PIEPER_INLINE Dual<F> operator-(Dual<F> a, Dual<F> b) { return {a.x - b.x, a.d - b.d}; }
template <class F> PIEPER_INLINE Dual<F> operator*(Dual<F> a, Dual<F> b) { return {a.x * b.x, a.x * b.d + a.d * b.x}; }
template <class F> PIEPER_INLINE Dual<F> operator+(Dual<F> a, double b) { return {a.x + b, a.d}; }
template <class F> PIEPER_INLINE Dual<F> operator*(double k, Dual<F> a) { return {k * a.x, k * a.d}; }
template <class F> PIEPER_INLINE Dual<F> operator*(F k, Dual<F> a) { return {k * a.x, k * a.d}; }
template <class F> PIEPER_INLINE Dual<F> over(Dual<F> a, Dual<F> b) {
  const F inv = 1.0 / select(b.x == 0.0, F(kTiny), b.x), x = a.x * inv;
  return {x, (a.d - x * b.d) * inv};
}
template <class F> PIEPER_INLINE Dual<F> root(Dual<F> a) {
  const F x = sqrt(max(a.x, F(0.0)));
  return {x, 0.5 * a.d / select(x == 0.0, F(kTiny), x)};
}

// A small turn, kept of length one.
template <class F> PIEPER_INLINE Motion<F> advanced(Motion<F> angle, F change) {
  return unit_again(angle.c - change * angle.s, angle.s + change * angle.c);
}

template <int Slots> struct Found {
  int count;
  bool edge;        // without solutions it is not said that poses beside it have none
  bool turns;       // limits are still to be looked at: a row may have to make a whole turn
  unsigned inside;  // bits of the rows inside the limits
  double q[Slots][6];
};

// W candidates of any poses of the group.
template <class F, class Family> struct Candidates {
  typename Family::template Target<F> target;
  RigidT<F> tool;
};

// By how much the chain as described misses the tool's place and two columns of its rotation, which fix the third: read from its end.
template <class F>
PIEPER_INLINE F missed_by(const HiddenAngle& head, const RigidT<F>* truth, const Motion<F>* q, const RigidT<F>& tool) {
  Vec3T<F> x = truth[6].x, y = truth[6].y, t = truth[6].t;
  for (int j = 5; j >= 0; --j) {
    const Motion<F> m = q[j];
    const RigidT<F>& link = truth[j];
    if (head.slides[j]) t.z += m.c;
    else {
      const auto turned = [&](Vec3T<F> v) -> Vec3T<F> { return {m.c * v.x - m.s * v.y, m.s * v.x + m.c * v.y, v.z}; };
      x = turned(x), y = turned(y), t = turned(t);
    }
    x = turn(link, x), y = turn(link, y), t = move(link, t);
  }
  return max(max(largest(x - tool.x), largest(y - tool.y)), largest(t - tool.t));
}

// Candidates checked and entered; the poses of those that are not clear are marked. limits: null where nobody asks.
template <class F, class Family> void enter(const HiddenAngle& head, const RigidT<F>* truth, const JointLimits* limits,
                                            const Motion<F>* q, const RigidT<F>& tool, Mask<F> unclear, const int* pose,
                                            int used, Found<Family::slots>* found, unsigned& unclear_poses) {
  constexpr int W = width_of<F>;
  const F miss = missed_by(head, truth, q, tool);
  F row[1][8];  // as many as a record holds whose vectors are whole
  for (int j = 0; j < 6; ++j) {
    const Motion<F> m = q[head.backward ? 5 - j : j];
    row[0][j] = head.slides[head.backward ? 5 - j : j] ? m.c * head.length : unit_angle_wrapped(m.s, m.c);
  }
  row[0][6] = row[0][7] = F(0.0);
  const Mask<F> good[1] = {!unclear & (miss <= 0.5 * kClosedVerified)};
  unsigned inside = 0, turns = 0;
  if (limits) {
    F moved[1][6];
    for (int j = 0; j < 6; ++j) moved[0][j] = row[0][j];
    Mask<F> within[1];
    turn_inside<F, 1, 6>(moved, good, *limits, within);
    auto other = mask_of<F>(false);
    for (int j = 0; j < 6; ++j) other = other | (moved[0][j] != row[0][j]);
    inside = bits_of(within[0]), turns = bits_of(other);
  }
  const unsigned bits = bits_of(good[0]);
  double rows[8 * W];
  store_records<F, 8>(rows, row[0], W);
  for (int i = 0; i < used; ++i) {
    Found<Family::slots>& to = found[pose[i]];
    if (!((bits >> i) & 1u) || to.count == Family::slots) {
      unclear_poses |= 1u << pose[i];
      continue;
    }
    to.inside |= ((inside >> i) & 1u) << to.count;
    to.turns |= (turns >> i) & 1u;
    __builtin_memcpy(to.q[to.count++], rows + 8 * i, sizeof(double[6]));
  }
}

// A group of W poses, `used` of them asked for. Returns the bits of the poses that are not clear.
template <class F, class Family> unsigned solve_group(const HiddenAngle& head, const typename Family::Arm& arm,
                                                      const RigidT<F>* truth, const JointLimits* limits,
                                                      const RigidT<F>& pose, int used, Found<Family::slots>* found) {
  constexpr int W = width_of<F>, D = Family::degree, M = Family::samples;
  const auto target = Family::see(arm, pose);
  const RigidT<F> tool = in_lengths(pose, head.length);
  const trigonometric::Circle<M>& angle = trigonometric::circle<M>();
  F value[M], size;
  for (int i = 0; i < M; ++i) value[i] = Family::polynomial(arm, target, Motion<F>{F(angle.c[i]), F(angle.s[i])});
  trigonometric::Series<F, D> series;
  const F above = trigonometric::series_of<F, D, M>(value, series, size);
  const F noise = max(kHiddenNoise * size, 100.0 * above);
  unsigned unclear = bits_of(!(above < kHiddenDegree * size) | Family::wanting(arm, target));
  trigonometric::Sectors<F, D> sectors;
  sectors_of(series, sectors);
  const trigonometric::Isolation<F, D> roots(sectors, noise, ~unclear, used);
  unclear |= roots.unclear;
  for (int i = 0; i < used; ++i) {
    found[i].count = 0, found[i].inside = 0, found[i].turns = false;
    found[i].edge = !(roots.away[i] > kHiddenEdge * lane(size, i));
  }
  const auto& list = roots.list;
  for (int first = 0; first < roots.count; first += W) {
    const int lanes = roots.count - first < W ? roots.count - first : W;
    Candidates<F, Family> x;
    trigonometric::Series<F, D> own;
    const int* const of = list.lane + first;
    const LanePicker<W> pick(of);
    pick_lanes<F, F>(own, series, pick);
    pick_lanes<F, F>(x.target, target, pick);
    pick_lanes<F, F>(x.tool, tool, pick);
    Motion<F> root, q[6];
    F slope;
    trigonometric::refine(own, list, first, root.c, root.s, slope);
    Mask<F> unsettled;
    const auto settled = Family::settle(arm, x.target, root, slope, unsettled);
    for (int side = 1; side >= (Family::both ? -1 : 1); side -= 2) {
      Family::posture(arm, x.target, settled, side, q);
      enter<F, Family>(head, truth, limits, q, x.tool, unsettled, of, lanes, found, unclear);
    }
  }
  return unclear & ((1u << used) - 1u);
}

// Largest joint difference of two solutions, lengths in units of the arm.
inline double apart(const HiddenAngle& head, const double* a, const double* b) {
  double worst = 0;
  for (int j = 0; j < 6; ++j) {
    double d = __builtin_fabs(a[j] - b[j]);
    if (head.slides[j]) d = d / head.length;
    else if (d > kPi) d = __builtin_fabs(kTwoPi - d);
    worst = d > worst ? d : worst;
  }
  return worst;
}

// Adds to n rows those of `more` that are none of them; returns how many there are then.
template <int Slots> int joined(const HiddenAngle& head, double* rows, int n, const Found<Slots>& more) {
  const int known = n;
  for (int k = 0; k < more.count && n < Slots; ++k) {
    bool again = false;
    for (int m = 0; m < known && !again; ++m) again = apart(head, rows + 6 * m, more.q[k]) < kHiddenSame;
    if (!again) __builtin_memcpy(rows + 6 * n++, more.q[k], 6 * sizeof(double));
  }
  return n;
}

// Writes the rows of a pose in order (chain/row_order.hpp), zeros after them, and which are inside the limits. Returns what is known then,
// as in Answers.
template <int Slots> PIEPER_INLINE std::uint8_t put_rows(const Found<Slots>& found, const std::uint8_t* slides,
                                                         const JointLimits* limits, double* q, std::uint8_t* valid,
                                                         std::uint8_t* in_limits) {
  constexpr int W = PIEPER_LANES, parts = Slots / W;
  static_assert(Slots % W == 0);
  using F = Lanes<W>;
  const int n = found.count;
  for (int m = 0; m < Slots; ++m) valid[m] = m < n;
  for (int k = 0; k < 6 * Slots; k += W) store(q + k, F(0.0));
  double key[Slots];
  for (int m = 0; m < Slots; ++m) key[m] = m < n ? place(found.q[m][0], slides[0]) : kEndless;
  F all[parts];
  for (int k = 0; k < parts; ++k) all[k] = load<F>(key + k * W);
  bool tie = false;
  unsigned inside = 0;
  for (int m = 0; m < n; ++m) {
    const F low(key[m] - kKernelRowOrder), high(key[m] + kKernelRowOrder);
    int before = 0, with = 0;  // rows that come before this one, and those that are not clearly after it
    for (int k = 0; k < parts; ++k) {
      before += __builtin_popcount(bits_of(all[k] < low));
      with += __builtin_popcount(bits_of(all[k] <= high));
    }
    tie |= with != before + 1;
    inside |= ((found.inside >> m) & 1u) << before;
    __builtin_memcpy(q + 6 * before, found.q[m], sizeof(double[6]));
  }
  if (tie) {
    __builtin_memcpy(q, found.q[0], sizeof(double[6]) * n);
    put_in_order(q, valid, Slots, 6, slides);
  }
  if (!limits) return n ? 1 : 0;
  for (int m = 0; m < Slots; ++m) in_limits[m] = (inside >> m) & 1u;
  if (tie || found.turns) {
    apply_limits(q, valid, Slots, 6, limits->lower, limits->upper, limits->prismatic, in_limits);
    inside = 0;
    for (int m = 0; m < Slots; ++m) inside |= in_limits[m];
  }
  return static_cast<std::uint8_t>((n != 0) + (inside != 0));
}

// Poses that are not clear wait for company: the general solver takes W at a time. What was found and verified here stays.
template <int Slots> struct Waiting {
  static constexpr int most = 64, general_slots = 16;
  int count = 0;
  long index[most];
  Found<Slots> own[most];
  double T[16 * most], q[6 * general_slots * most];
  std::uint8_t valid[general_slots * most], flag[most];

  void solve(const HiddenAngle& head, const std::uint8_t* slides, const JointLimits* limits, const Answers& to) {
    if (count == 0) return;
    solve_general(*head.general, T, count, q, valid, flag);
    for (int i = 0; i < count; ++i) {
      const long at = index[i];
      double* rows = to.q + 6 * Slots * at;
      std::uint8_t* good = to.valid + Slots * at;
      // valid rows come first
      __builtin_memcpy(rows, q + 6 * general_slots * i, 6 * Slots * sizeof(double));
      __builtin_memcpy(good, valid + general_slots * i, Slots);
      int n = 0;
      while (n < Slots && good[n]) ++n;
      n = joined(head, rows, n, own[i]);
      for (int m = 0; m < n; ++m) good[m] = 1;
      put_in_order(rows, good, Slots, 6, slides);
      to.flag[at] = static_cast<std::uint8_t>(n ? flag[i] & ~(kOutOfReach | kEdge) : flag[i]);
      if (!limits) continue;
      apply_limits(rows, good, Slots, 6, limits->lower, limits->upper, limits->prismatic, to.in_limits + Slots * at);
      outcomes(good, to.in_limits + Slots * at, 1, Slots, to.outcome + at);
    }
    count = 0;
  }
};

// `ways`: the same arm seen in several ways, best first. how: as FamilyEntry::solve_inside says, or null where poses are rigid motions
// and nobody asks for limits. Returns whether all poses were rigid motions.
template <class Family> bool solve(const HiddenAngle& head, const typename Family::Arm* arm, int ways, const double* T,
                                   long count, const Directly* how, const Answers& to) {
  constexpr int M = Family::slots;
  using F = Lanes<PIEPER_LANES>;
  const JointLimits* const limits = how ? &how->limits : nullptr;
  std::uint8_t slides[6];  // in the order of the rows
  for (int j = 0; j < 6; ++j) slides[j] = head.slides[head.backward ? 5 - j : j];
  RigidT<F> truth[7];
  for (int k = 0; k < 7; ++k) truth[k] = spread<F>(read_rigid(head.links[k][0], head.length));
  Waiting<M> waiting;
  bool rigid = true;
  in_lanes(T, count, [&](long done, int used, const double* poses) {
    RigidT<F> pose;
    if (how) {
      const Given<F> given = load_given<F>(poses);
      if (!(rigid = rigid && all(is_exact(given, how->exact)))) return;
      pose = given.pose;
    } else pose = load_poses<F>(poses);
    if (head.backward) pose = inverse(pose);
    Found<M> found[PIEPER_LANES];
    unsigned unclear = solve_group<F, Family>(head, arm[0], truth, limits, pose, used, found);
    for (int way = 1; way < ways && unclear; ++way) {
      Found<M> other[PIEPER_LANES];
      const unsigned still = solve_group<F, Family>(head, arm[way], truth, limits, pose, used, other);
      for (int i = 0; i < used; ++i) {
        if (!((unclear >> i) & 1u)) continue;
        if ((still >> i) & 1u) {
          found[i].count = joined(head, found[i].q[0], found[i].count, other[i]);
          found[i].turns = true;
        } else found[i] = other[i];
      }
      unclear &= still;
    }
    for (int i = 0; i < used; ++i) {
      const long at = done + i;
      const bool doubt = (unclear >> i) & 1u;
      if (doubt && head.general) {
        __builtin_memcpy(waiting.T + 16 * waiting.count, T + 16 * at, 16 * sizeof(double));
        waiting.own[waiting.count] = found[i];
        waiting.index[waiting.count++] = at;
        if (waiting.count == Waiting<M>::most) waiting.solve(head, slides, limits, to);
        continue;
      }
      alignas(64) double rows[6 * M];
      double* const q = to.q + 6 * M * at;
      const bool past_cache = how && how->past_cache;
      const std::uint8_t outcome = put_rows(found[i], slides, limits, past_cache ? rows : q, to.valid + M * at,
                                            to.in_limits ? to.in_limits + M * at : nullptr);
      if (past_cache) put_past_cache(q, rows, 6 * M);
      if (limits) to.outcome[at] = outcome;
      const int none = found[i].edge ? kOutOfReach | kEdge : kOutOfReach;
      to.flag[at] = static_cast<std::uint8_t>(doubt ? kDegenerate | kUncertain : found[i].count ? 0 : none);
    }
  });
  if (how && how->past_cache) past_cache_done();
  if (rigid) waiting.solve(head, slides, limits, to);
  return rigid;
}

}  // namespace pieper::PIEPER_ISA::hidden_angle
