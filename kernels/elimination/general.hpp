// The general solver's entry: every pose solved by the best variant, its certificate checked, and escalation where it fails.
//
// A pose is *settled* when the eigenvalues are all there and are the zeros of the determinant, every real one has a verified
// solution of its own, no solution moved far from its eigenvalue while being polished, and the solutions, double ones counted twice,
// are even in number. What is not settled is solved again by other variants (another hidden joint, another direction), then in turned
// charts, then from perturbed poses, until a settled attempt adds nothing. The work is bounded; what is still open then is flagged.
// Lanes first; what is not settled goes on one pose at a time.
#pragma once

#include "elimination/entry.hpp"

#ifdef PIEPER_ISA
#include <type_traits>

#include "elimination/counted.hpp"
#include "elimination/prepare.hpp"

namespace pieper::PIEPER_ISA {

namespace general {

inline constexpr int kSlots = 16;

inline bool even(const Found& found) {
  int n = found.count;
  for (int i = 0; i < found.count; ++i)
    if (found.merged[i] || found.sigma[i] < kGeneralUncounted)
      return true;  // multiplicities are beyond counting at a singular pose
  return n % 2 == 0;
}

// Whether an elimination has kept digits enough to be a witness: two eigenvalues that coincide part by the root of what it has lost.
inline bool trusted(const Variant& v, const Report& report) {
  return report.size > kGeneralTrusted * v.typical || report.proven;
}

inline bool settled(const Report& report, const Found& found) {
  return !report.doubtful && !report.strayed && report.unresolved == 0 && report.lost == 0 &&
         report.spread < kGeneralAccurate && even(found);
}

// A second opinion that added nothing. Special geometry gives some variants real eigenvalues without a solution, always; there
// only the agreement counts.
inline bool agreed(const Variant& v, const Report& report, const Found& found, int before) {
  if (found.count != before) return false;
  return settled(report, found) ||
         (v.open > 0 && !report.doubtful && !report.strayed && report.lost == 0 && even(found));
}

// The same of the pose itself. A nearby arm is no witness where two solutions may be about to merge: of it they may be complex. Where
// there are no other witnesses nothing is certain anyhow.
inline bool witnessed(const Model& model, const Variant& v, const Report& report, const Found& found, int before) {
  const bool keeps = report.size > kGeneralWitness * v.typical || report.proven;
  return keeps && (!report.blind || model.variant[0].arm) && agreed(v, report, found, before);
}

// Whether as many solutions are there as six joints can have, each regular and its root's only one: then nothing is missing
// whatever an elimination says, and no self-motion passes, whose points would be more.
inline bool all_there(const Model& model, const Found& found) {
  if (found.count != kSlots) return false;
  for (int i = 0; i < kSlots; ++i) {
    if (found.merged[i] || !(found.sigma[i] > kGeneralMerged) || !(found.residual[i] < kGeneralResolved)) return false;
    for (int j = 0; j < i; ++j)
      if (nearer_than(kGeneralSame, found.q[i], found.q[j], model.prismatic)) return false;
  }
  return true;
}

// Solutions of a neighbouring pose, polished onto this one.
inline void polish_onto(const Model& model, const Variant& v, const Rigid& pose, const Found& from, Found& into) {
  using G = Lanes<PIEPER_LANES>;
  constexpr int W = PIEPER_LANES;
  RigidT<G> wide[6];
  role_links(model, 0, v.roles, spread<G>(pose), wide);
  for (int first = 0; first < from.count; first += W) {
    const int used = from.count - first < W ? from.count - first : W;
    Motion<G> q[6];
    for (int k = 0; k < 6; ++k)
      for (int i = 0; i < W; ++i) {
        const double x = from.q[first + (i < used ? i : used - 1)][v.roles.joint[k]];
        const Motion<double> m = motion_of(x, v.roles.prismatic[k]);
        set_lane(q[k].c, i, m.c);
        set_lane(q[k].s, i, m.s);
      }
    const Closure<G> end = polish(wide, v.roles, q, 25);
    for (int i = 0; i < used; ++i) {
      if (!(lane(end.residual, i) < kGeneralVerified)) continue;
      double values[6];
      for (int k = 0; k < 6; ++k)
        values[v.roles.joint[k]] =
            v.roles.prismatic[k] ? lane(q[k].c, i) : __builtin_atan2(lane(q[k].s, i), lane(q[k].c, i));
      insert(into, values, lane(end.sigma, i), lane(end.residual, i), model.prismatic);
    }
  }
}

// Everything there is beyond the best variant. True when the pose is settled in the end; `healthy` when by an elimination that is
// far from singular there, `singular` when only by neighbouring poses.
inline bool escalate(const Model& model, const Rigid& pose, Found& found, bool* singular, bool* healthy) {
  *singular = *healthy = false;
  Report report;
  for (int n = 1; n < model.variants; ++n) {
    const int before = found.count;
    solve_variant(model, model.variant[n], pose, 1, &found, &report);
    if (all_there(model, found)) return true;
    // solutions fetched from nearby arms are believed when all of them agree
    const bool last = n + 1 == model.variants;
    if (witnessed(model, model.variant[n], report, found, before) && (last || model.variant[0].arm == 0)) {
      *healthy =
          model.variant[n].arm == 0 && (report.size > kGeneralMarked * model.variant[n].typical || report.proven);
      return true;
    }
  }
  Random random{7};
  for (int n = 0; n < 4; ++n) {  // the same elimination in turned charts
    Variant v = model.variant[n % model.variants];
    const double a = kTwoPi * random.uniform(), b = kTwoPi * random.uniform();
    v.chart = {__builtin_cos(a), __builtin_sin(a), __builtin_cos(b), __builtin_sin(b)};
    fill_constants(model, v);
    const int before = found.count;
    solve_variant(model, v, pose, 1, &found, &report);
    if (witnessed(model, v, report, found, before)) return true;
  }
  // The elimination is singular here for every variant: its neighbours need not be. Their solutions move by the size of the
  // perturbation, or its root where two merge, and Newton brings them back.
  int quiet = 0;
  *singular = true;
  for (int n = 0; n < 12 && quiet < 4; ++n) {
    const Variant& v = model.variant[n % (model.variants < 3 ? model.variants : 3)];
    Found near;
    near.count = 0;
    solve_variant(model, v, perturbed(pose, kGeneralBeside[n], model.scale, random), 1, &near, &report);
    const int before = found.count;
    polish_onto(model, v, pose, near, found);
    if (found.count != before) quiet = 0;
    else if (agreed(v, report, found, before)) ++quiet;  // an open report that adds nothing says neither yes nor no
  }
  return quiet >= 4;
}

// Ascending by joint 1, then 2, ...; joints that nearly agree count as equal, so that rounding does not change the order.
inline bool comes_before(const double* a, const double* b) {
  for (int k = 0; k < 6; ++k)
    if (__builtin_fabs(a[k] - b[k]) > kKernelRowOrder) return a[k] < b[k];
  return false;
}

// `edge`: without solutions it is not said that poses beside it have none.
inline void write_pose(const Model& model, const Found& found, bool certain, bool edge, double* q, std::uint8_t* valid,
                       std::uint8_t* flag) {
  int order[kMaxFound];
  for (int i = 0; i < found.count; ++i) order[i] = i;
  int count = found.count;
  *flag = 0;
  if (count > kSlots) {  // points of a self-motion crowd in: isolated solutions first
    for (int i = 1; i < count; ++i)
      for (int j = i; j > 0 && found.sigma[order[j]] > found.sigma[order[j - 1]]; --j) {
        const int t = order[j];
        order[j] = order[j - 1];
        order[j - 1] = t;
      }
    count = kSlots;
    *flag |= kDegenerate;
  }
  for (int i = 1; i < count; ++i)
    for (int j = i; j > 0 && comes_before(found.q[order[j]], found.q[order[j - 1]]); --j) {
      const int t = order[j];
      order[j] = order[j - 1];
      order[j - 1] = t;
    }
  for (int i = 0; i < kSlots; ++i) {
    valid[i] = i < count;
    for (int k = 0; k < 6; ++k)
      q[6 * i + k] = i < count ? found.q[order[i]][k] * (model.prismatic[k] ? model.scale : 1.0) : 0.0;
    if (i < count && (found.merged[order[i]] || found.sigma[order[i]] < kGeneralDegenerate)) *flag |= kDegenerate;
  }
  if (!certain) *flag |= kUncertain;
  else if (count == 0) *flag |= kOutOfReach;
  if (count == 0 && edge) *flag |= kEdge;
}

}  // namespace general

void make_model(General& arm) {
  general::Model* model = new general::Model;
  general::Trial record[general::kTried];
  general::make_model(arm, *model, record);
  for (int i = 0; i < general::kTried; ++i) {
    const general::Trial& t = record[i];
    const double row[4] = {double(t.rank), double(t.missed), double(t.open), t.noise};
    for (int k = 0; k < 4; ++k) arm.trials[i][k] = row[k];
  }
  arm.model = model;
  arm.usable = model->variants;
}

void drop_model(General& arm) { delete static_cast<const general::Model*>(arm.model); }

namespace general {

// Where the answers of a call go.
struct Answers {
  double* q;
  std::uint8_t *valid, *flag;

  void write(const Model& model, const Found& found, bool certain, bool edge, long at) const {
    write_pose(model, found, certain, edge, q + at * 6 * kSlots, valid + at * kSlots, flag + at);
  }
};

// W poses at T, of which `used` are asked for; at: their places in the call.
template <class F> void solve_group(const Model& model, const double* T, int used, const long* at, const Answers& to) {
  Found found[width_of<F>];
  Report report[width_of<F>];
  for (Found& f : found) f.count = 0;
  solve_variant(model, model.variant[0], load_poses<F>(T), used, found, report);
  for (int i = 0; i < used; ++i) {
    // an elimination that has lost digits for this arm is not believed on its own word, unless its real zeros tell how many
    const bool weak = !(report[i].size > kGeneralMarked * model.variant[0].typical) && !report[i].proven;
    const bool quiet = model.variant[0].noise < kGeneralQuiet || report[i].proven;
    bool certain = quiet && trusted(model.variant[0], report[i]) && settled(report[i], found[i]);
    // next to a pose where the elimination is singular, variants may agree on what all of them have lost
    bool fetched = false, healthy = false;
    const bool at_once = certain;
    certain = certain || all_there(model, found[i]);
    if (!certain) {
      const Rigid pose = load_poses<double>(T + 16 * i);
      healthy = certain = counted(model, pose, found[i]);
      if (!certain) certain = escalate(model, pose, found[i], &fetched, &healthy);
      if (!certain) healthy = certain = counted(model, pose, found[i]), fetched = fetched && !certain;
    }
    const bool whole = !at_once && all_there(model, found[i]), singular = !whole && ((weak && !healthy) || fetched);
    // no eigenvalue near the real line: a pose beside this one brings none onto it
    const bool edge = !at_once || report[i].nearly > 0;
    // what only nearby arms vouch for is not certain
    to.write(model, found[i], certain && (model.variant[0].arm == 0 || whole), edge, at[i]);
    if (singular) to.flag[at[i]] |= kDegenerate;
  }
}

// What one pose alone is solved in, twice at once where lanes are wider: of vectors of every width a compiler fuses the same products
// with sums, of plain numbers others, and a pose is to come to the same digits alone as among others.
using Alone = std::conditional_t<PIEPER_LANES == 2, double, Lanes<2>>;
// As many cost less one after the other than in one group.
inline constexpr int kAlone = PIEPER_LANES < 8 ? 1 : 2;

// Poses for the eigenvalues wait until all lanes are taken.
struct Waiting {
  static constexpr int W = PIEPER_LANES;
  int count = 0;
  long at[W];
  double T[16 * W];

  void add(const Model& model, const double* pose, long place, const Answers& to) {
    __builtin_memcpy(T + 16 * count, pose, sizeof(double[16]));
    at[count++] = place;
    if (count == W) solve(model, to);
  }
  void solve(const Model& model, const Answers& to) {
    if (count > kAlone) {
      for (int i = count; i < W; ++i) __builtin_memcpy(T + 16 * i, T, sizeof(double[16]));
      solve_group<Lanes<W>>(model, T, count, at, to);
    } else {
      for (int i = 0; i < count; ++i) {
        double same[16 * width_of<Alone>];
        for (int k = 0; k < width_of<Alone>; ++k) __builtin_memcpy(same + 16 * k, T + 16 * i, sizeof(double[16]));
        solve_group<Alone>(model, same, 1, at + i, to);
      }
    }
    count = 0;
  }
};

// The bits of poses that are farther away than the links laid end to end.
template <class F> unsigned beyond_reach(const Model& model, const RigidT<F>& pose) {
  const Vec3 base = model.link[0][0].t;
  const Vec3T<F> away = (1 / model.scale) * pose.t - Vec3T<F>{F(base.x), F(base.y), F(base.z)};
  return bits_of(dot(away, away) > model.farthest * model.farthest);
}

// What the signs settle of W poses at T, the first of which is `first` of the call; the others wait.
template <class F>
void settle_by_signs(const Model& model, const double* T, int used, long first, const Answers& to, Waiting& waiting) {
  Found found[width_of<F>];
  const RigidT<F> pose = load_poses<F>(T);
  const unsigned all = (1u << used) - 1u, none = beyond_reach(model, pose) & all;
  for (int i = 0; i < used; ++i) found[i].count = 0;
  const unsigned unclear = none == all ? 0 : solve_by_signs(model, pose, used, found) & ~none;
  for (int i = 0; i < used; ++i)
    if ((unclear >> i) & 1u) waiting.add(model, T + 16 * i, first + i, to);
    else to.write(model, found[i], true, false, first + i);
}

}  // namespace general

void solve_general(const General& arm, const double* T, long count, double* q, std::uint8_t* valid,
                   std::uint8_t* flag) {
  using namespace general;
  const Model& model = *static_cast<const Model*>(arm.model);
  const Answers to = {q, valid, flag};
  Waiting waiting;
  in_lanes(T, count, [&](long done, int used, const double* poses) {
    if (model.prismatic_count == 3) {
      for (int i = 0; i < used; ++i) {
        Found found;
        found.count = 0;
        const bool isolated = solve_slides(model, load_poses<double>(poses + 16 * i), found);
        to.write(model, found, true, true, done + i);
        if (!isolated) flag[done + i] = kDegenerate | (flag[done + i] & kEdge);
      }
    } else if (!model.by_signs) {
      for (int i = 0; i < used; ++i) waiting.add(model, poses + 16 * i, done + i, to);
    } else if (used > kAlone) {
      settle_by_signs<Lanes<PIEPER_LANES>>(model, poses, used, done, to, waiting);
    } else {
      for (int i = 0; i < used; ++i) {
        double same[16 * width_of<Alone>];
        for (int k = 0; k < width_of<Alone>; ++k) __builtin_memcpy(same + 16 * k, poses + 16 * i, sizeof(double[16]));
        settle_by_signs<Alone>(model, same, 1, done + i, to, waiting);
      }
    }
  });
  waiting.solve(model, to);
}

class GeneralKernel {
 public:
  static constexpr bool in_order = false;
  explicit GeneralKernel(const General& arm) : arm_(arm) {}
  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    solve_general(arm_, T, count, q, valid, flag);
  }

 private:
  const General& arm_;
};

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
