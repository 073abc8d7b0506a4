// The look at a singular pose in closed form: what is free at each of a kernel's rows is read off the row's axes.
//
// A row whose Jacobian has one null direction is a point of a self-motion where the joints of that direction are a linkage, and a
// merged root where the pose is left to second order. All that passes there, two directions at once, and courses that cross are read
// off the fibre of the closed form's group of three. Surfaces, and linkages of five and six joints, are not read. Scalar.
#pragma once

#include <utility>

#include "singular/crossed.hpp"
#include "singular/fibre.hpp"
#include "singular/into_limits.hpp"
#include "singular/into_place.hpp"
#include "singular/next_to_motion.hpp"
#include "singular/read.hpp"

namespace pieper::PIEPER_ISA {

class Look {
 public:
  Look(const SixJoints& arm, const Limits& limits)
      : arm_(arm),
        limits_(limits),
        groups_(groups_of(arm)),
        departs_(departs(arm)),
        held_(10 * std::fmax(kOnCurve, departs_)),
        unnoticed_(std::fmax(kUnnoticed, 4 * departs_)),
        next_to_{arm} {}

  // What there is at T, of which a closed-form kernel gave rows (count x 6); false where that cannot be read off.
  bool operator()(const Rigid& T, const double* rows, int count, Read& out) const {
    out.clear();
    if (count == 0) return false;
    std::vector<Root> alone;
    std::vector<Unsure> unsure;
    std::vector<int> regular;
    bool clear = count % 2 == 0;
    std::vector<double> own(rows, rows + 6 * count);
    rows = own.data();
    for (int k = 0; k < count; ++k) {
      double* q = own.data() + 6 * k;
      Standing at(arm_, q);
      if (well_posed(at.J)) {
        regular.push_back(k);
        continue;
      }
      if (known_motion(q, at, out.motions)) {
        clear = false;
        continue;
      }
      SingularSix d(at.J);
      clear = clear && d.s[5] > kClearlyRegular * d.s[0];
      if (d.s[5] > kSingularExamined * d.s[0]) {
        regular.push_back(k);
        continue;
      }
      if (stopped_early(T, at, d)) {
        settle(arm_, T, q, kSlowSteps, kHeldFirmly);
        at = Standing(arm_, q), d = SingularSix(at.J);
      }
      if (!singular_row(T, q, at, d, {rows, count}, unsure, alone, out.motions)) return false;
    }
    if (clear) {
      for (int k = 0; k < count; ++k) out.add(arm_, rows + 6 * k, 1, -1, false);
      return true;
    }
    if (out.motions.empty() && regular.size() + alone.size() < kMostSolutions &&
        !searched(T, regular.size(), unsure, alone))
      return false;
    one_of_each(arm_, T, alone);
    int branches = 0;
    for (const Root& root : alone) branches += root.branches;
    std::vector<int> isolated;
    for (int k : regular) {
      bool again = false;
      for (int m : isolated) again |= arm_.apart(rows + 6 * k, rows + 6 * m) < kSameSolution;
      if (!again) isolated.push_back(k);
    }
    // rows of a pose come in an even number, self-motions and double roots counted twice: another number is not believed
    if ((isolated.size() + branches) % 2) return false;
    for (int k : isolated) out.add(arm_, rows + 6 * k, 1, -1, false);
    all_into_limits(arm_, T, limits_, alone);
    for (const Root& root : alone) out.add(arm_, root.q, root.branches, -1, true);
    for (std::size_t k = 0; k < out.motions.size(); ++k) {
      double q[6];
      std::visit([&](const auto& motion) { motion.representative(arm_, limits_, q); }, out.motions[k]);
      out.add(arm_, q, 1, static_cast<int>(k), true);
    }
    out.in_order(arm_);
    return true;
  }

 private:
  static constexpr std::size_t kMostSolutions = 8;  // of a closed form

  // A row so near the self-motion of a linkage that a kernel may have given one point for two.
  struct Unsure {
    Root root;
    FourBar bar;
  };
  // Adds what hides beside such rows; false where that would be more than there can be.
  bool searched(const Rigid& T, std::size_t regular, std::vector<Unsure>& unsure, std::vector<Root>& alone) const {
    for (Unsure& one : unsure) next_to_.linkage(T, one.root.q, one.bar, alone);
    return regular + alone.size() <= kMostSolutions;
  }

  // All rows of a pose.
  struct Rows {
    const double* q;
    int count;
  };

  static constexpr int kLastDigits = 4;
  static constexpr int kSlowSteps = 40;  // near merged roots each step only halves what is left

  // Whether a row lies on a self-motion that is known, or on a new one of two axes in one line, which is added.
  bool known_motion(const double* q, const Standing& at, std::vector<SelfMotionRead>& motions) const {
    for (const SelfMotionRead& motion : motions)
      if (std::visit([&](const auto& m) { return m.holds(arm_, q, kOnSelfMotion); }, motion)) return true;
    const double rounding = rounding_at(at);
    for (int i = 0; i < kSix; ++i)
      for (int j = i + 1; j < kSix; ++j) {
        if (arm_.slides[i] || arm_.slides[j]) continue;
        const Vec3 tilt = cross(at.z[i], at.z[j]);
        if (dot(tilt, tilt) > rounding * rounding || line_gap(at, i, j) > rounding) continue;
        if (!lone_line(arm_, groups_, at, i, j, rounding)) return false;
        motions.emplace_back(line_of(q, at, i, j));
        return true;
      }
    return false;
  }

  // What axes may miss for rounding, and as the arm departs from what it is taken for: each of four by as much.
  double rounding_at(const Standing& at) const {
    double farthest = 0;
    for (const Vec3& o : at.o) farthest = std::fmax(farthest, largest(o));
    return std::fmax(kInOneLine, 4 * departs_) * (1 + farthest);
  }

  bool singular_row(const Rigid& T, const double* q, const Standing& at, const SingularSix& d, const Rows& rows,
                    std::vector<Unsure>& unsure, std::vector<Root>& alone, std::vector<SelfMotionRead>& motions) const {
    if (d.s[4] <= kOneWayFree * d.s[0]) return two_ways(T, q, alone, motions);
    Free free = Free::NO;
    FourBar bar;
    if (!what_is_free(T, q, at, d, motions, free, bar)) return false;
    if (free == Free::SELF_MOTION) return true;
    const double bend = second_order(at.J, d);
    Root root{{}, free == Free::BESIDE ? 1 : branches_of_fold(std::fabs(bend), d)};
    std::copy(q, q + kSix, root.q);
    if (root.branches == 2) onto_root_of_fold(arm_, T, d, bend, root.q);
    const bool flat = root.branches == 0;
    if (flat) {  // too flat to be told by its second order
      // next to a group's own line the pose is all but held, where the joints beside are at a fold
      if (next_to_.held(T, q, d.joint[5])) return at_fold(q, at) && two_ways(T, q, alone, motions);
      root.branches = branches_at(arm_, T, root.q);
    }
    if (root.branches == 1 && free == Free::NO && !twin_is_told(T, q, d, bend, rows, alone) && !flat &&
        twin_is_hidden(q, d.s[5], std::fabs(bend), rows))
      root.branches = 2;
    if (free == Free::BESIDE) {
      int moving = 0;
      for (double x : d.joint[5]) moving += std::fabs(x) > kLoopMoves;
      // beside a line both roots are found anew, which costs little
      if (moving <= 2 && d.s[5] < kLineRootsApart * d.s[0]) return next_to_.line(T, q, d.joint[5], alone);
      // a row is known along the self-motion to rounding over its singular value: the same twice is one
      const double blur = std::fmin(5 * kMergedRounding / std::fmax(d.s[5], kTiny), kSameAlong);
      for (const Root& other : alone)
        if (arm_.apart(q, other.q) < blur) return true;
      if (d.s[5] < kRootsApart * d.s[0]) unsure.push_back({root, bar});
    }
    alone.push_back(root);
    return true;
  }

  // Whether polishing has ended before a row holds the pose to rounding: near a fold each of its steps only halves what is left.
  bool stopped_early(const Rigid& T, const Standing& at, const SingularSix& d) const {
    double e[6];
    return d.s[4] > kOneWayFree * d.s[0] && at.missing(T, e) > kClosedStalled;
  }

  // Whether the other root of a fold is one of the rows, or is found and added, or is too far to be looked for: kernels take two for
  // one in a flat valley, and give one twice where polishing ends beside it.
  bool twin_is_told(const Rigid& T, const double* q, const SingularSix& d, double bend, const Rows& rows,
                    std::vector<Root>& alone) const {
    Root twin{{}, 1};
    const double t = -d.s[5] / bend;
    if (!(std::fabs(t) < kClosedValley)) return true;
    for (int i = 0; i < kSix; ++i) twin.q[i] = q[i] + t * d.joint[5][i];
    const double near = arm_.apart(q, twin.q) / 2;
    auto known = [&] {
      bool any = false;
      for (int k = 0; k < rows.count; ++k) any |= arm_.apart(rows.q + 6 * k, twin.q) < near;
      for (const Root& other : alone) any |= arm_.apart(other.q, twin.q) < near;
      return any;
    };
    if (known()) return true;
    if (!(settle(arm_, T, twin.q, kSlowSteps, kPreciseRank) < rounding_of(T))) return false;
    // back at the root itself
    if (arm_.apart(q, twin.q) < near) return false;
    if (!known()) alone.push_back(twin);
    return true;
  }

  // Whether the twin of a root, sigma / bend away, was taken for the root itself because half way to it the pose is held as well.
  bool twin_is_hidden(const double* q, double sigma, double bend, const Rows& rows) const {
    if (sigma * sigma > 4 * bend * 3 * kClosedPolished) return false;
    for (int k = 0; k < rows.count; ++k) {
      const double apart = arm_.apart(rows.q + 6 * k, q);
      if (apart > 0 && apart < 2 * sigma / bend) return false;
    }
    return true;
  }

  enum class Free { NO, BESIDE, SELF_MOTION };

  // What is free at a row: a self-motion, which is added; nothing, but one is near; or nothing. False where a linkage is met that
  // cannot be read off.
  bool what_is_free(const Rigid& T, const double* q, const Standing& at, const SingularSix& d,
                    std::vector<SelfMotionRead>& motions, Free& free, FourBar& bar) const {
    const double* null = d.joint[5];
    const double rounding = rounding_at(at);
    int order[6] = {0, 1, 2, 3, 4, 5};
    std::stable_sort(order, order + 6, [&](int a, int b) { return std::fabs(null[a]) > std::fabs(null[b]); });
    const int i = std::min(order[0], order[1]), j = std::max(order[0], order[1]);
    double gap;
    const bool line = std::fabs(null[order[2]]) < kLoopMoves && !arm_.slides[i] && !arm_.slides[j];
    if (line) gap = line_gap(at, i, j);
    else if (!four_bar(arm_, at, null, order, bar, gap)) return true;
    if (gap <= rounding) {
      free = Free::SELF_MOTION;
      if (line && lone_line(arm_, groups_, at, i, j, rounding)) {
        motions.emplace_back(line_of(q, at, i, j));
        return true;
      }
      if (all_over(T, q, motions)) return true;
      const LineSelfMotion own = line_of(q, at, i, j);
      if (!line || crossed(arm_, own)) return false;
      motions.emplace_back(own);
      return true;
    }
    if (gap > kNextToLinkage) return true;
    // joints outside the linkage may make up for what it misses, or move it by so much unnoticed: a second look tells
    const bool unnoticed = gap * d.s[4] <= unnoticed_ * d.s[0];
    if (unnoticed && (line ? in_line(T, q, i, j, motions) : in_a_linkage(T, q, bar, motions))) free = Free::SELF_MOTION;
    // beside a line of a group there are the wrist's two, whatever the singular value; beside others roots stand apart as far as it is
    // of the gap, and are known to rounding over it
    else if ((d.s[5] > kNearlyInLine * gap || d.s[5] * d.s[5] > kMergedAlong * gap ||
              (line && lone_line(arm_, groups_, at, i, j, rounding))))
      free = Free::BESIDE;
    return true;
  }

  // Whether two axes, or four, are in place but for what rounding of the pose leaves open; their self-motion is added then.
  bool in_line(const Rigid& T, const double* q, int i, int j, std::vector<SelfMotionRead>& motions) const {
    return brought(T, q, motions, [=](const Standing& at, double* g) {
      const Vec3 tilt = cross(at.z[i], at.z[j]), off = cross(at.o[j] - at.o[i], at.z[i]);
      g[0] = tilt.x, g[1] = tilt.y, g[2] = tilt.z, g[3] = off.x, g[4] = off.y, g[5] = off.z;
    });
  }
  bool in_a_linkage(const Rigid& T, const double* q, const FourBar& bar, std::vector<SelfMotionRead>& motions) const {
    for (const Group3& group : groups_) {
      int inside = 0, other = -1;
      for (int joint : bar.joint) {
        if (joint >= group.first && joint < group.first + 3) ++inside;
        else other = joint;
      }
      if (inside < 3) continue;
      return brought(T, q, motions, [&](const Standing& at, double* g) {
        const Vec3 v = Beside(arm_, at, group, 0).of(at.J[other]);
        g[0] = v.x, g[1] = v.y, g[2] = v.z, g[3] = g[4] = g[5] = 0;
      });
    }
    return false;
  }
  template <class Gap>
  bool brought(const Rigid& T, const double* q, std::vector<SelfMotionRead>& motions, Gap gap) const {
    double there[6];
    std::copy(q, q + kSix, there);
    if (!(into_place(arm_, T, gap, there) < unnoticed_)) return false;
    const Standing at(arm_, there);
    for (const Group3& group : groups_) {
      const Fibre fibre = fibre_over(arm_, group, there, at, rounding_at(at));
      if (fibre.over == Over::MOTIONS && added(T, fibre, motions)) return true;
    }
    return false;
  }

  // Adds all that passes through a row, and whatever crosses that; false where it is no self-motion, or cannot be read.
  bool all_over(const Rigid& T, const double* q, std::vector<SelfMotionRead>& motions) const {
    double p[6];
    const Standing at = settled(T, q, p);
    for (const Group3& group : groups_) {
      const Fibre fibre = fibre_over(arm_, group, p, at, rounding_at(at));
      if (fibre.over == Over::MOTIONS && added(T, fibre, motions)) return true;
    }
    return false;
  }

  // A row to the last digit in all that the pose fixes to first order: courses that cross are told by that digit.
  Standing settled(const Rigid& T, const double* q, double* p) const {
    std::copy(q, q + kSix, p);
    settle(arm_, T, p, kLastDigits, kHeldFirmly);
    return Standing(arm_, p);
  }

  bool at_fold(const double* q, const Standing& at) const {
    bool any = false;
    for (const Group3& group : groups_) any |= fibre_over(arm_, group, q, at, rounding_at(at)).over_fold();
    return any;
  }

  // A row with more than one weak direction.
  bool two_ways(const Rigid& T, const double* q, std::vector<Root>& alone, std::vector<SelfMotionRead>& motions) const {
    Root root{{}, 1};
    const Standing at = settled(T, q, root.q);
    const double rounding = rounding_at(at);
    for (const Group3& group : groups_) {
      Fibre fibre = fibre_over(arm_, group, root.q, at, rounding);
      if (fibre.over_fold()) fibre = at_double_root(arm_, T, group, rounding, fibre, root.q);
      if (fibre.over != Over::MOTIONS && moved_aside(T, root.q, at, group, fibre)) fibre.over = Over::MOTIONS;
      if (fibre.over == Over::UNKNOWN) continue;
      if (fibre.over == Over::MOTIONS) return added(T, fibre, motions);
      root.branches = fibre.branches;
      if (!is_told(arm_, group, fibre, root, alone)) alone.push_back(root);
      return true;
    }
    return false;
  }

  // Whether the pose can be held far along a joint that all but moves in the group: rows may stand where a self-motion meets a fold,
  // and there rounding hides that it is one.
  bool moved_aside(const Rigid& T, const double* q, const Standing& at, const Group3& group, Fibre& fibre) const {
    const Beside beside(arm_, at, group, 0);
    for (int k = 0; k < beside.moving; ++k) {
      if (beside.size[k] > kNextToLinkage || arm_.slides[beside.rest[k]]) continue;
      for (double step : {0.4, -0.4, 1.1}) {
        double aside[6];
        std::copy(q, q + kSix, aside);
        aside[beside.rest[k]] += step;
        if (!(settle(arm_, T, aside, NextToMotion::kSlowSteps, kHeldFirmly) < kHoldsToRounding) ||
            arm_.apart(aside, q) < 0.1)
          continue;
        const Standing there(arm_, aside);
        Fibre found = fibre_over(arm_, group, aside, there, rounding_at(there));
        if (found.over != Over::MOTIONS) continue;
        found.blur = std::fmax(found.blur, kMergedSame);
        fibre = found;
        return true;
      }
    }
    return false;
  }

  // Adds what is not known yet; false where something does not hold the pose.
  bool added(const Rigid& T, const Fibre& fibre, std::vector<SelfMotionRead>& motions) const {
    const double same = std::fmax(kOnSelfMotion, fibre.blur);
    std::vector<SelfMotionRead> fresh;
    for (const SelfMotionRead& one : fibre.motions) {
      double at[6];
      if (const auto* linkage = std::get_if<LinkageSelfMotion>(&one)) {
        for (int k = 0; k < 7; ++k) {
          linkage->point(k / 6.0, at);
          if (missed_at(arm_, at, T) > held_) return false;
        }
        linkage->point(0.377, at);
      } else {
        const LineSelfMotion& line = std::get<LineSelfMotion>(one);
        std::copy(line.through, line.through + kSix, at);
        at[line.i] += 0.377, at[line.j] -= 0.377 * line.sense;
        if (missed_at(arm_, at, T) > held_) return false;
      }
      bool known = false;
      for (const auto* some : {&std::as_const(motions), &std::as_const(fresh)})
        for (const SelfMotionRead& other : *some)
          known |=
              other.index() == one.index() && std::visit([&](const auto& m) { return m.holds(arm_, at, same); }, other);
      if (!known) fresh.push_back(one);
    }
    motions.insert(motions.end(), fresh.begin(), fresh.end());
    return true;
  }

  SixJoints arm_;
  Limits limits_;
  std::vector<Group3> groups_;
  double departs_;
  double held_;       // what points of its self-motions may miss the pose by,
  double unnoticed_;  // and what axes that are brought into place may cost it
  NextToMotion next_to_;
};

}  // namespace pieper::PIEPER_ISA
