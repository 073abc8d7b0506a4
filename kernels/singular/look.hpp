// The look at a singular pose in closed form: what is free at each of a kernel's rows is read off the row's axes.
//
// A row whose Jacobian has one null direction is a point of a self-motion where the joints of that direction are a linkage, and a
// merged root where the pose is left to second order. Everything else (two directions at once, linkages of five and six joints,
// curves that cross) is not read. Scalar.
#pragma once

#include <cstdint>
#include <variant>

#include "singular/merged.hpp"
#include "singular/crossed.hpp"
#include "singular/motions.hpp"

namespace pieper::PIEPER_ISA {

using SelfMotionRead = std::variant<LineSelfMotion, LinkageSelfMotion>;

// All there is at a pose.
struct Read {
  struct Row {
    double q[6];   // rad; lengths
    int branches;  // that merge in it
    int motion;    // the self-motion it stands for, or -1
    bool singular;
  };
  std::vector<Row> rows;
  std::vector<SelfMotionRead> motions;
};

class Look {
 public:
  Look(const SixJoints& arm, const Limits& limits) : arm_(arm), limits_(limits) {}

  // What there is at T, of which a closed-form kernel gave rows (count x 6); false where that cannot be read off.
  bool operator()(const Rigid& T, const double* rows, int count, Read& out) const {
    out.rows.clear(), out.motions.clear();
    if (count == 0) return false;
    std::vector<Root> alone;
    std::vector<int> regular;
    bool clear = count % 2 == 0;
    for (int k = 0; k < count; ++k) {
      const double* q = rows + 6 * k;
      const Standing at(arm_, q);
      if (well_posed(at.J)) {
        regular.push_back(k);
        continue;
      }
      if (known_motion(q, at, out.motions)) {
        clear = false;
        continue;
      }
      const SingularSix d(at.J);
      clear = clear && d.s[5] > kClearlyRegular * d.s[0];
      if (d.s[5] > kSingularExamined * d.s[0]) {
        regular.push_back(k);
        continue;
      }
      if (!singular_row(T, q, at, d, alone, out.motions)) return false;
    }
    if (clear) {
      for (int k = 0; k < count; ++k) add(rows + 6 * k, 1, -1, false, out);
      return true;
    }
    if (!apart(T, alone)) return false;
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
    for (int k : isolated) add(rows + 6 * k, 1, -1, false, out);
    for (const Root& root : alone) add(root.q, root.branches, -1, true, out);
    for (std::size_t k = 0; k < out.motions.size(); ++k) {
      double q[6];
      std::visit([&](const auto& motion) { motion.representative(arm_, limits_, q); }, out.motions[k]);
      add(q, 1, static_cast<int>(k), true, out);
    }
    std::stable_sort(out.rows.begin(), out.rows.end(), [&](const Read::Row& a, const Read::Row& b) {
      for (int i = 0; i < kSix; ++i) {
        const double scale = arm_.slides[i] ? arm_.length * 1e6 : 1e6, x = std::nearbyint(a.q[i] * scale),
                     y = std::nearbyint(b.q[i] * scale);
        if (x != y) return x < y;
      }
      return false;
    });
    return true;
  }

 private:
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
        if (!well_posed(at.J, j)) return false;  // nothing else is free
        LineSelfMotion line{{}, i, j, dot(at.z[i], at.z[j]) > 0 ? 1.0 : -1.0};
        std::copy(q, q + kSix, line.through);
        if (crossed(arm_, line)) return false;
        motions.emplace_back(line);
        return true;
      }
    return false;
  }

  // What axes may miss for rounding.
  static double rounding_at(const Standing& at) {
    double farthest = 0;
    for (const Vec3& o : at.o) farthest = std::fmax(farthest, largest(o));
    return kInOneLine * (1 + farthest);
  }

  // Whether the smallest singular value is far above what is looked at, one joint left out or none: the last pivot of an
  // elimination with full choice of columns.
  static bool well_posed(const double (*J)[6], int without = -1) {
    double Q[6][6], total = 0, last = 0;
    std::copy(&J[0][0], &J[0][0] + 36, &Q[0][0]);
    bool used[6] = {};
    if (without >= 0) used[without] = true;
    for (int step = 0; step < kSix - (without >= 0); ++step) {
      int best = -1;
      double most = -1;
      for (int i = 0; i < kSix; ++i) {
        if (used[i]) continue;
        double s = 0;
        for (int r = 0; r < 6; ++r) s += Q[i][r] * Q[i][r];
        if (step == 0) total += s;
        if (s > most) most = s, best = i;
      }
      if (!(most > 0)) return false;
      used[best] = true, last = most;
      for (int i = 0; i < kSix; ++i) {
        if (used[i]) continue;
        double s = 0;
        for (int r = 0; r < 6; ++r) s += Q[i][r] * Q[best][r];
        s /= most;
        for (int r = 0; r < 6; ++r) Q[i][r] -= s * Q[best][r];
      }
    }
    return last > 1e-8 * total;  // a hundred times what is looked at, squared
  }

  void add(const double* q, int branches, int motion, bool singular, Read& out) const {
    Read::Row row{{}, branches, motion, singular};
    for (int i = 0; i < kSix; ++i) row.q[i] = arm_.slides[i] ? q[i] : in_one_turn(q[i]);
    out.rows.push_back(row);
  }

  // An angle in (-pi, pi]; a rounding away from -pi it is pi, so that it does not change places with its twin.
  static double in_one_turn(double q) {
    if (!(q > -kPi && q <= kPi)) q = kPi - (kPi - q - kTwoPi * std::floor((kPi - q) / kTwoPi));
    return q < kOrthogonal - kPi ? kPi : q;
  }

  bool singular_row(const Rigid& T, const double* q, const Standing& at, const SingularSix& d, std::vector<Root>& alone,
                    std::vector<SelfMotionRead>& motions) const {
    if (d.s[4] <= kOneWayFree * d.s[0]) return false;
    Free free = Free::NO;
    FourBar bar;
    if (!what_is_free(T, q, at, d, motions, free, bar)) return false;
    if (free == Free::SELF_MOTION) return true;
    int count = free == Free::BESIDE ? 1 : branches_of_fold(at.J, d);
    if (count == 0) {  // too flat to be told by its second order: what a step along it misses tells
      count = branches_at(arm_, T, q);
      if (held_aside(T, q, d.joint[5])) return false;
    }
    if (free == Free::BESIDE && d.s[5] < kRootsApart * d.s[0]) {
      int moving = 0;
      for (double x : d.joint[5]) moving += std::fabs(x) > kLoopMoves;
      return moving <= 2 ? along_the_line(T, q, d.joint[5], alone) : along_the_linkage(T, q, bar, alone);
    }
    Root root{{}, count};
    std::copy(q, q + kSix, root.q);
    alone.push_back(root);
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
    if (std::fabs(null[order[2]]) < kLoopMoves && !arm_.slides[i] && !arm_.slides[j]) {
      gap = line_gap(at, i, j);
      if (gap <= rounding) {
        LineSelfMotion line{{}, i, j, dot(at.z[i], at.z[j]) > 0 ? 1.0 : -1.0};
        std::copy(q, q + kSix, line.through);
        if (crossed(arm_, line)) return false;
        motions.emplace_back(line);
        free = Free::SELF_MOTION;
        return true;
      }
    } else {
      if (!four_bar(arm_, at, null, order, bar, gap)) return true;
      if (gap <= rounding) {
        free = Free::SELF_MOTION;
        return linkage(T, q, bar, motions);
      }
    }
    if (gap > kNextToLinkage) return true;
    // joints outside the linkage may make up for what it misses, or move it by so much unnoticed: a second look tells
    if (d.s[5] > kNearlyInLine * gap && gap * d.s[4] > kUnnoticed * d.s[0]) free = Free::BESIDE;
    return true;
  }

  // The whole curve of a linkage that stands at q; false where its pieces touch.
  static bool whole_of(const double* q, FourBar& bar, LinkageSelfMotion& whole) {
    bar.prepare();
    bool any = false;
    for (int lead = 0; lead < 4; ++lead) {
      double low, high;
      if (!bar.range(lead, low, high)) return false;
      const bool round = high - low >= kTwoPi - 1e-12;
      const double across = std::sin(-bar.opposite(lead).phase);
      if (round && std::fabs(across) < 1e-9) return false;
      if (any && !(round && whole.side == 0)) continue;
      any = true;
      whole = {{}, bar, lead, low, high, round ? (across > 0 ? 1.0 : -1.0) : 0.0};
      std::copy(q, q + kSix, whole.through);
    }
    return true;
  }

  bool linkage(const Rigid& T, const double* q, FourBar& bar, std::vector<SelfMotionRead>& motions) const {
    LinkageSelfMotion whole{};
    if (!whole_of(q, bar, whole)) return false;
    for (int k = 0; k < 7; ++k) {
      double at[6];
      whole.point(k / 6.0, at);
      if (missed_at(arm_, at, T) > 10 * kOnCurve) return false;
    }
    motions.emplace_back(whole);
    return true;
  }

  // The solutions beside a self-motion all but in place: kernels give one point of such a line.
  //
  // What is missed along the line changes sign twice in a turn. Newton's method from four points of it ends at both.
  bool along_the_line(const Rigid& T, const double* q, const double* null, std::vector<Root>& alone) const {
    double starts[4][6];
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < kSix; ++i) starts[k][i] = q[i] + 0.5 * k * kPi * std::sqrt(2.0) * null[i];
    std::vector<Root> ends = ends_of(T, starts, 4);
    if (ends.size() != 2) {
      ends.resize(1);
      std::copy(q, q + kSix, ends[0].q);
    }
    join(ends, alone);
    return true;
  }

  // The same beside the self-motion of a linkage; how often the sign changes is not known beforehand, but it is even.
  bool along_the_linkage(const Rigid& T, const double* q, FourBar& bar, std::vector<Root>& alone) const {
    LinkageSelfMotion whole{};
    if (!whole_of(q, bar, whole)) return false;
    // what is missed along the curve on which all else holds, with one sign from place to place
    constexpr int kPlaces = 24;
    auto at = [&](double u) {
      double start[6];
      whole.point(u, start);
      return OnCurve(arm_, T, start, 4);
    };
    auto side = [](const OnCurve& a, const OnCurve& by) {
      double lean = 0;
      for (int r = 0; r < 6; ++r) lean += a.left[r] * by.left[r];
      return lean < 0 ? -a.miss : a.miss;
    };
    std::vector<OnCurve> places;
    for (int k = 0; k < kPlaces; ++k) {
      places.push_back(at(k / double(kPlaces)));
      if (!(places.back().rest < kHoldsToRounding)) return false;
    }
    std::vector<Root> ends;
    for (int k = 0; k < kPlaces; ++k) {
      const OnCurve& by = places[k];
      double low = k / double(kPlaces), high = (k + 1) / double(kPlaces), left = by.miss,
             right = side(places[(k + 1) % kPlaces], by);
      if ((left < 0) == (right < 0)) continue;
      Root root{{}, 1};
      for (int step = 0; step < 60; ++step) {
        const double u = step % 3 == 2 ? (low + high) / 2 : low + (high - low) * left / (left - right);
        const OnCurve here = at(u);
        const double miss = side(here, by);
        std::copy(here.q, here.q + kSix, root.q);
        if (std::fabs(miss) < kMergedAlong / 2 || high - low < kOnSelfMotion) break;
        if ((miss < 0) == (left < 0)) low = u, left = miss;
        else high = u, right = miss;
      }
      ends.push_back(root);
    }
    if (ends.empty() || ends.size() % 2) return false;
    join(ends, alone);
    return true;
  }

  // Where Newton's method ends, each solution once.
  std::vector<Root> ends_of(const Rigid& T, double (*starts)[6], int count) const {
    std::vector<std::pair<double, int>> order;
    for (int k = 0; k < count; ++k) order.emplace_back(settle(arm_, T, starts[k], kSlowSteps, 1e-15), k);
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Root> ends;
    for (const auto& [miss, k] : order) {
      bool again = !(miss < kHoldsToRounding);
      for (const Root& other : ends) again |= arm_.apart(starts[k], other.q) < kSameAlong;
      if (again) continue;
      ends.push_back({{}, 1});
      std::copy(starts[k], starts[k] + kSix, ends.back().q);
    }
    return ends;
  }

  void join(const std::vector<Root>& ends, std::vector<Root>& alone) const {
    for (const Root& end : ends) {
      bool again = false;
      for (const Root& other : alone) again |= arm_.apart(end.q, other.q) < kSameAlong;
      if (!again) alone.push_back(end);
    }
  }

  // Whether the pose can be held a little way along the null direction, all but exactly.
  bool held_aside(const Rigid& T, const double* q, const double* null) const {
    for (double step : {0.05, -0.05}) {
      double at[6];
      for (int i = 0; i < kSix; ++i) at[i] = q[i] + step * null[i];
      if (std::fabs(OnCurve(arm_, T, at, 5).miss) < 10 * kOnCurve) return true;
    }
    return false;
  }

  // Makes one of roots that rounding cannot tell apart.
  bool apart(const Rigid& T, std::vector<Root>& alone) const {
    double least = INFINITY;
    for (std::size_t a = 0; a < alone.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) least = std::fmin(least, arm_.apart(alone[a].q, alone[b].q));
    if (least >= kMergedBlur) return true;
    distinct_roots(arm_, T, alone);
    for (Root& root : alone) root.branches = branches_at(arm_, T, root.q);
    return true;
  }

  static constexpr int kSlowSteps = 40;
  SixJoints arm_;
  Limits limits_;
};

}  // namespace pieper::PIEPER_ISA
