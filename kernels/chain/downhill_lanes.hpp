// What `Downhill::down` does (downhill.hpp), of many postures at once, one a lane: a lane that has come down takes the next posture.
// A template over the number type, used for lanes; no coupled joints, and not more than kDescendingJoints.
#pragma once

#include "chain/closest.hpp"
#include "chain/rigid.hpp"
#include "dispatch/isa.hpp"

namespace pieper::PIEPER_ISA {

// The distance at a posture, with slope and second derivatives without units (on and above the diagonal).
template <class F> struct Slope {
  F value, way, lean;
  F first[kDescendingJoints], second[kDescendingJoints][kDescendingJoints];
};

template <class F> PIEPER_INLINE void keep_where(Mask<F> better, int n, const Slope<F>& from, Slope<F>& to) {
  to.value = select(better, from.value, to.value);
  to.way = select(better, from.way, to.way);
  to.lean = select(better, from.lean, to.lean);
  for (int i = 0; i < n; ++i) {
    to.first[i] = select(better, from.first[i], to.first[i]);
    for (int j = i; j < n; ++j) to.second[i][j] = select(better, from.second[i][j], to.second[i][j]);
  }
}

// x solves (|A| + damping largest) x = b of the joints that are not held, by Cholesky's factors; where A has eigenvalues below zero, by
// `indefinite`. x is nought of those that are held.
template <class F> void step_down(int n, const Slope<F>& at, const Mask<F>* held, F damping, Mask<F> active,
                                  IndefiniteStep indefinite, F* x) {
  constexpr int M = kDescendingJoints;
  F A[M][M], L[M][M], b[M], most(0.0);
  for (int i = 0; i < n; ++i) {
    b[i] = select(held[i], F(0.0), at.first[i]);
    for (int j = i; j < n; ++j) A[j][i] = A[i][j] = select(held[i] | held[j], F(0.0), at.second[i][j]);
  }
  for (int i = 0; i < n; ++i) {
    F sum(0.0);
    for (int j = 0; j < n; ++j) sum += abs(A[i][j]);
    most = max(most, sum);
  }
  const F more = (damping + kDescentFlat) * most, nothing = kDescentFlat * most;
  Mask<F> below = mask_of<F>(false);
  for (int j = 0; j < n; ++j) {
    F d = A[j][j];
    for (int k = 0; k < j; ++k) d -= L[j][k] * L[j][k];
    const auto flat = !(d > nothing) & !held[j];  // of A itself
    below = below | (flat & !(d > 0.0 - nothing));
    d = select(held[j], F(1.0), sqrt(max(d, F(0.0)) + more));
    const F inv = 1.0 / d;
    L[j][j] = inv;
    for (int i = j + 1; i < n; ++i) {
      F s = A[i][j];
      for (int k = 0; k < j; ++k) s -= L[i][k] * L[j][k];
      below = below | (flat & (abs(s) > nothing));
      L[i][j] = s * inv;
    }
  }
  for (int i = 0; i < n; ++i) {
    F t = b[i];
    for (int k = 0; k < i; ++k) t -= L[i][k] * x[k];
    x[i] = t * L[i][i];
  }
  for (int i = n - 1; i >= 0; --i) {
    F t = x[i];
    for (int k = i + 1; k < n; ++k) t -= L[k][i] * x[k];
    x[i] = t * L[i][i];
  }
  for (unsigned rest = bits_of(below & active); rest; rest &= rest - 1) {
    const int lane_of = __builtin_ctz(rest);
    double matrix[M * M], right[M], found[M];
    int free[M], m = 0;
    for (int i = 0; i < n; ++i) {
      if (!((bits_of(held[i]) >> lane_of) & 1u)) free[m++] = i;
      set_lane(x[i], lane_of, 0.0);
    }
    for (int i = 0; i < m; ++i) {
      right[i] = lane(b[free[i]], lane_of);
      for (int j = 0; j < m; ++j) matrix[i * m + j] = lane(A[free[i]][free[j]], lane_of);
    }
    indefinite(m, matrix, lane(damping, lane_of), right, found);
    for (int i = 0; i < m; ++i) set_lane(x[free[i]], lane_of, found[i]);
  }
}

// Postures that wait and those at work, one a lane.
template <class F> struct Descending {
  static constexpr int W = width_of<F>, M = kDescendingJoints;
  const DownhillChain& chain;
  const int n;
  const long count;
  double* const rows;  // count x n
  Rigid links[M + 1];
  F q[M], tried[M];  // the best so far; what is looked at next
  F damping{0.0}, taken{0.0};
  long row[W], next = 0;
  unsigned fresh = 0, at_work = 0;  // lanes: just begun, and not done

  Descending(const DownhillChain& of, long how_many, double* q_rows)
      : chain(of), n(of.n), count(how_many), rows(q_rows) {
    for (int k = 0; k <= n; ++k) links[k] = read_rigid(chain.links + 16 * k, chain.length);
    for (int k = 0; k < n; ++k) q[k] = tried[k] = F(0.0);
    for (int i = 0; i < W; ++i) begin(i);
  }

  void begin(int i) {
    if (next == count) return;
    row[i] = next++;
    for (int k = 0; k < n; ++k) set_lane(tried[k], i, rows[row[i] * n + k]);
    fresh |= 1u << i, at_work |= 1u << i;
  }
  void clip() {
    for (int k = 0; k < n; ++k) tried[k] = min(max(tried[k], F(chain.lower[k])), F(chain.upper[k]));
  }
  // The tool at `tried`, the joints' axes, and what each does to the tool's position.
  RigidT<F> stand(Vec3T<F>* axis, Vec3T<F>* moves) const {
    Vec3T<F> point[M];
    const auto motion = [&](int k) {
      const F x = tried[k] * (1 / chain.unit(k));
      return chain.prismatic[k] ? Motion<F>{x, F(0.0)} : turned_by(x);
    };
    const RigidT<F> end = walk(
        n, spread<F>(links[0]), [&](int k) -> const Rigid& { return links[k + 1]; }, motion, chain.prismatic,
        [&](int k, const RigidT<F>& frame) { axis[k] = frame.z, point[k] = frame.t; });
    for (int k = 0; k < n; ++k) moves[k] = chain.prismatic[k] ? axis[k] : cross(axis[k], end.t - point[k]);
    return end;
  }
  // Whether what was tried is better, and the damping after it.
  Mask<F> judged(Mask<F> better, double damping_at_first, double shrink, double grow) {
    const auto first = mask_of_bits<F>(fresh);
    better = better | first;
    damping = select(first, F(damping_at_first),
                     select(better, max(damping * shrink, F(kDescentLeastDamping)), damping * grow));
    taken = select(first, F(0.0), taken + 1.0);
    fresh = 0;
    for (int k = 0; k < n; ++k) q[k] = select(better, tried[k], q[k]);
    return better;
  }
  Mask<F> going(int steps) const {
    return (taken < double(steps)) & (damping < kDescentMostDamping) & mask_of_bits<F>(at_work);
  }
  // Steps x (sign: towards or away) in the lanes that go on; the others are written, with what done(row, lane) adds, and their lanes
  // begin anew.
  template <class Done> void on(Mask<F> going, const F* x, double sign, Done done) {
    F size(0.0);
    for (int k = 0; k < n; ++k) size += x[k] * x[k];
    size = sqrt(size);
    going = going & (size >= kDescentSettled);
    const F shrink = sign * min(F(1.0), kDescentLongest / max(size, F(kTiny)));
    for (int k = 0; k < n; ++k) tried[k] = select(going, q[k] + shrink * x[k] * chain.unit(k), q[k]);
    for (unsigned ended = at_work & ~bits_of(going); ended; ended &= ended - 1) {
      const int i = __builtin_ctz(ended);
      for (int k = 0; k < n; ++k) rows[row[i] * n + k] = lane(q[k], i);
      done(row[i], i);
      at_work &= ~(1u << i);
      begin(i);
    }
  }
};

template <class F> void slope_at(const Descending<F>& work, const RigidT<F>& goal, double turning, Slope<F>& out) {
  const int n = work.n;
  Vec3T<F> axis[kDescendingJoints], moves[kDescendingJoints], turns[kDescendingJoints];
  const RigidT<F> end = work.stand(axis, moves);
  const Vec3T<F> zero = {F(0.0), F(0.0), F(0.0)}, gap = goal.t - end.t, skew = -2.0 * sine_between(end, goal);
  for (int k = 0; k < n; ++k) turns[k] = work.chain.prismatic[k] ? zero : axis[k];
  const F trace = dot(end.x, goal.x) + dot(end.y, goal.y) + dot(end.z, goal.z);
  const bool turns_alone = turning > kNearlyEndless;
  const double near = turns_alone ? 0 : 1, turned = turns_alone ? 1 : turning;
  out.way = 0.5 * dot(gap, gap);
  out.lean = 0.5 * (3.0 - trace);
  out.value = near * out.way + turned * out.lean;
  for (int i = 0; i < n; ++i) {
    out.first[i] = (0.5 * turned) * dot(turns[i], skew) - near * dot(moves[i], gap);
    const Vec3T<F> bent_gap = cross(gap, turns[i]);
    for (int j = i; j < n; ++j) out.second[i][j] = near * dot(moves[i] - bent_gap, moves[j]);
    if (turned == 0) continue;
    // M = R G^T applied from the left: turn_i . M turn_j = sum over columns (turn_i . end_c)(goal_c . turn_j)
    const Vec3T<F> image =
        dot(turns[i], end.x) * goal.x + dot(turns[i], end.y) * goal.y + dot(turns[i], end.z) * goal.z;
    const Vec3T<F> around = (0.5 * turned) * (trace * turns[i] - image);
    for (int j = i; j < n; ++j) out.second[i][j] += dot(around, turns[j]);
  }
}

inline void go_downhill(const DownhillChain& chain, const double* T, double turning, int steps,
                        IndefiniteStep indefinite, long count, double* rows, double* left) {
  using F = Lanes<PIEPER_LANES>;
  constexpr int M = kDescendingJoints;
  const int n = chain.n;
  const RigidT<F> goal = spread<F>(read_rigid(T, chain.length));
  Descending<F> work(chain, count, rows);
  F x[M];
  Slope<F> here, there;
  here.value = F(kEndless);
  Mask<F> held[M];
  while (work.at_work) {
    work.clip();
    slope_at(work, goal, turning, there);
    const auto better = work.judged(there.value < here.value, kDescentDamping, kDescentShrink, kDescentGrow);
    keep_where(better, n, there, here);
    auto all_held = mask_of<F>(true);
    for (int k = 0; k < n; ++k) {
      held[k] = ((work.q[k] <= chain.lower[k]) & (here.first[k] > 0.0)) |
                ((work.q[k] >= chain.upper[k]) & (here.first[k] < 0.0));
      all_held = all_held & held[k];
    }
    const auto going = work.going(steps) & !all_held;
    step_down(n, here, held, work.damping, going, indefinite, x);
    work.on(going, x, -1.0,
            [&](long row, int i) { left[2 * row] = lane(here.way, i), left[2 * row + 1] = lane(here.lean, i); });
  }
}

// What `Downhill::towards_place` does, of many postures at once. left: count, half the square of the way.
inline void crawl_to_place(const DownhillChain& chain, const double* T, const Crawl& how, long count, double* rows,
                           double* left) {
  using F = Lanes<PIEPER_LANES>;
  constexpr int M = kDescendingJoints;
  const int n = chain.n;
  const Vec3T<F> goal = spread<F>(read_rigid(T, chain.length).t);
  Descending<F> work(chain, count, rows);
  F value(kEndless), x[M];
  Vec3T<F> axis[M], moves[M], here[M], gap = {F(0.0), F(0.0), F(0.0)};
  for (int k = 0; k < n; ++k) here[k] = gap;
  const auto keep = [](Mask<F> better, const Vec3T<F>& from, Vec3T<F>& to) {
    to = {select(better, from.x, to.x), select(better, from.y, to.y), select(better, from.z, to.z)};
  };
  while (work.at_work) {
    work.clip();
    const Vec3T<F> missed = goal - work.stand(axis, moves).t;
    const F way = 0.5 * dot(missed, missed);
    const auto better = work.judged(way < value, how.damping, how.shrink, how.grow);
    value = select(better, way, value);
    keep(better, missed, gap);
    Mask<F> held[M];
    auto all_held = mask_of<F>(true);
    F A[6] = {work.damping, F(0.0), F(0.0), work.damping, F(0.0), work.damping};  // xx xy xz yy yz zz
    for (int k = 0; k < n; ++k) {
      keep(better, moves[k], here[k]);
      const Vec3T<F> c = here[k];
      const F pull = dot(c, gap);
      held[k] = ((work.q[k] <= chain.lower[k]) & (pull < 0.0)) | ((work.q[k] >= chain.upper[k]) & (pull > 0.0));
      all_held = all_held & held[k];
      const F free = select(held[k], F(0.0), F(1.0));
      A[0] += free * (c.x * c.x), A[1] += free * (c.x * c.y), A[2] += free * (c.x * c.z);
      A[3] += free * (c.y * c.y), A[4] += free * (c.y * c.z), A[5] += free * (c.z * c.z);
    }
    const Vec3T<F> r0 = {A[0], A[1], A[2]}, r1 = {A[1], A[3], A[4]}, r2 = {A[2], A[4], A[5]};
    const Vec3T<F> c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
    const Vec3T<F> y = (1.0 / max(dot(r0, c0), F(kTiny))) * (gap.x * c0 + gap.y * c1 + gap.z * c2);
    for (int k = 0; k < n; ++k) x[k] = select(held[k], F(0.0), dot(here[k], y));
    work.on(work.going(how.steps) & (value > how.reached) & !all_held, x, 1.0,
            [&](long row, int i) { left[row] = lane(value, i); });
  }
}

}  // namespace pieper::PIEPER_ISA
