// The look at a singular pose of an arm that is solved by elimination, which may lose solutions where roots meet.
//
// Poses at small generic steps beside it have a solution near every one of its own, and their elimination is clear. Where each of
// their solutions follows from a row of the pose, by the row's Jacobian or, next to a fold, by what its weakest direction misses to second
// order, nothing was lost and no self-motion is near: of such a one the poses beside have solutions anywhere along it. A double root
// that was lost shows on one side of its fold alone: some steps are taken both ways. What does not follow is left to the slower look. Scalar.
#pragma once

#include "dispatch/geometry.hpp"
#include "singular/all_over.hpp"
#include "singular/into_limits.hpp"
#include "singular/known_row.hpp"
#include "singular/read.hpp"

namespace pieper::PIEPER_ISA {

// What a solver gave for a pose beside, for certain.
struct SolvedBeside {
  Rigid T;
  std::vector<double> rows;  // count x 6, rad; lengths
  int count;
};

class FromAside {
 public:
  static constexpr int kPoses = 6;               // beside, solved for certain,
  static constexpr int kBack = 2;                // of a bunch of as many steps so many are taken the other way too,
  static constexpr int kBunch = kPoses + kBack;  // and one of them is certain both ways;
  static constexpr int kBunches = 4;             // of so many bunches the certain ones count
  static constexpr std::size_t kMostCurves = 24;
  static constexpr double kMostWide = 100;
  static constexpr int kSlowSteps = 40;  // at merged roots each step only halves what is left

  // most: solutions a pose can have
  FromAside(const SixJoints& arm, const Limits& limits, int most) : arm_(arm), limits_(limits), most_(most) {}

  // The k-th pose of a bunch, at a generic small step beside T; the same ones every time. The last kBack lie opposite the first.
  static Rigid aside(const Rigid& T, int bunch, int k) {
    const bool back = k >= kPoses;
    const int step = kPoses * bunch + (back ? k - kPoses : k);
    // parts of a turn by the golden ratio: no two of the steps are alike, and none is along an axis
    double twist[6], size = 0;
    for (int r = 0; r < 6; ++r) {
      const double part = (6 * step + r + 1) * 0.6180339887498949;
      twist[r] = 2 * (part - std::floor(part)) - 1, size += twist[r] * twist[r];
    }
    for (double& x : twist) x *= (back ? -kAsideStep : kAsideStep) / std::sqrt(size);
    const Vec3 way = {twist[0], twist[1], twist[2]}, turn = {twist[3], twist[4], twist[5]};
    const double angle = std::sqrt(dot(turn, turn)), s = std::sin(angle) / angle,
                 c = 2 * std::pow(std::sin(angle / 2) / angle, 2);
    auto turned = [&](Vec3 v) {
      const Vec3 once = cross(turn, v);
      return v + s * once + c * cross(turn, once);
    };
    return {turned(T.x), turned(T.y), turned(T.z), T.t + way};
  }

  // What there is at T, of which a kernel gave rows (count x 6); false where that is not told by the poses beside.
  bool operator()(const Rigid& T, const double* rows, int count, const std::vector<SolvedBeside>& beside,
                  Read& out) const {
    out.clear();
    std::vector<Known> known;
    std::vector<NearCurve> curves;
    for (int k = 0; k < count; ++k) known.push_back(look_at(T, rows + 6 * k));
    for (int k = 0; k < count; ++k) {
      if (on_motion(known[k], out)) continue;
      if (!twin_is_known(T, known, k) && !along_any(curves, known[k]) && !through(T, known[k], known, curves, out))
        return false;
    }
    for (const SolvedBeside& one : beside) {
      double e[6];
      const double far = missing_to(T, one.T, e);
      for (int k = 0; k < one.count; ++k) {
        const double* row = one.rows.data() + 6 * k;
        if (follows(row, e, far, known, curves, out)) continue;
        if (!through(T, look_at(T, row, false), known, curves, out) || !follows(row, e, far, known, curves, out))
          return false;
      }
    }
    // a pose that is marked and has no row that explains it has something that poses beside do not lead to
    bool explained = out.curves.empty();
    if (explained)
      explained = std::any_of(known.begin(), known.end(), [](const Known& one) { return one.singular || one.weak; });
    if (!explained && !all_over(T, known, curves, out)) return false;
    for (const Known& one : known)
      if (one.several && !on_motion(one, out)) return false;
    const std::vector<bool> again = followed_again(out.curves);
    // there are no more solutions than slots: where rounding lets more be told, it blurs by more than was thought
    for (double wide = 1; wide < kMostWide; wide *= 2) {
      out.rows.clear();
      tell(T, known, curves, wide, again, out);
      if (static_cast<int>(out.rows.size()) > most_) continue;
      std::size_t k = 0;
      std::erase_if(out.curves, [&](const NearCurve&) { return again[k++]; });
      return true;
    }
    return false;
  }

 private:
  bool follows(const double* row, const double* e, double far, const std::vector<Known>& known,
               const std::vector<NearCurve>& curves, const Read& out) const {
    for (const Known& one : known)
      if (one.leads_to(arm_, row, e, far)) return true;
    for (const auto* all : {&curves, &out.curves})
      for (const NearCurve& curve : *all)
        if (curve.leads_to(arm_, row, e, far)) return true;
    return false;
  }
  bool on_motion(const Known& one, const Read& out) const {
    if (!one.singular) return false;
    for (const NearCurve& motion : out.curves)
      if (motion.holds(arm_, one.q, kDoublesFromCurve)) return true;
    return false;
  }

  // Which curves are earlier ones, followed again from a row at a bend: where two directions are nearly free a curve turns more sharply
  // than its pieces, and a row there is not seen to lie on it. Everywhere else it is.
  std::vector<bool> followed_again(const std::vector<NearCurve>& curves) const {
    constexpr int kAsked = 9;
    std::vector<bool> again(curves.size());
    for (std::size_t k = 1; k < curves.size(); ++k)
      for (std::size_t m = 0; m < k && !again[k]; ++m) {
        int held = 0;
        for (int i = 0; i < kAsked; ++i)
          held += curves[m].holds(arm_, curves[k].points[i * curves[k].pieces() / kAsked].q, kDoublesFromCurve);
        again[k] = !again[m] && 2 * held > kAsked;
      }
    return again;
  }

  // Whether a row lies on one of the curves, and another, if there is one, on the same.
  bool along_any(const std::vector<NearCurve>& curves, const Known& one, const Known* other = nullptr) const {
    for (const NearCurve& curve : curves)
      if (curve.holds(arm_, one.q, kDoublesFromCurve) && (!other || curve.holds(arm_, other->q, kDoublesFromCurve)))
        return true;
    return false;
  }

  // Whether a row is a point of a curve that only nearly holds the pose, where it is missed by more than rounding: kernels give such.
  bool nearly_holds(const Rigid& T, const Known& one, const std::vector<NearCurve>& curves) const {
    return one.singular && !one.fold && one.miss > 5 * rounding_of(T) && along_any(curves, one);
  }

  // Whether what a row misses beyond rounding is what a more exact one on its curve misses on the way; double roots' ways miss more.
  bool strays_from(const Rigid& T, const Known& one, const Known& other, const std::vector<NearCurve>& curves) const {
    if (!one.singular || !other.singular || one.fold || other.fold || one.miss <= kMergedRounding) return false;
    return other.miss < one.miss / 2 && arm_.apart(one.q, other.q) * other.sigma < 2 * one.miss &&
           along_any(curves, one, &other) && most_between(arm_, T, one.q, other.q).missed < 2 * one.miss;
  }

  // Follows the curve through a row that nearly holds the pose, and adds what hides on it, or the curve as a
  // self-motion; false where it is neither.
  bool through(const Rigid& T, const Known& row, std::vector<Known>& known, std::vector<NearCurve>& curves,
               Read& out) const {
    if (!row.weak || curves.size() == kMostCurves) return false;
    CurvePoint start{};
    std::copy(row.q, row.q + kSix, start.q);
    std::copy(row.null, row.null + 6, start.null), std::copy(row.left, row.left + 6, start.left);
    NearCurve curve;
    if (!curve.follow(arm_, T, start)) return false;
    const NearCurve::Held held = curve.held(arm_);
    if (held == NearCurve::Held::ALONG) out.curves.push_back(std::move(curve));
    if (held != NearCurve::Held::NOWHERE) return held == NearCurve::Held::ALONG;
    std::vector<double> places;
    for (int k = 0; k < curve.pieces(); ++k) {
      const CurvePiece piece = curve.piece(arm_, k);
      places.clear();
      piece.roots(kCurveTold * kAsideStep, places);
      for (double s : places) {
        CurvePoint at = s < 0.5 ? piece.a : piece.b;
        piece.point(arm_, s, at.q);
        if (!refine(T, piece.length, at) || is_known(known, at.q, kMergedTwins)) continue;
        const double rounding = rounding_of(T);
        // where Newton's method along the curve has not ended the root is merged
        if (std::fabs(at.miss) > kMergedAlong && !(settle(arm_, T, at.q, kSlowSteps, kPreciseRank) < rounding))
          continue;
        if (!is_known(known, at.q, kMergedSame)) known.push_back(look_at(T, at.q));
      }
    }
    curves.push_back(std::move(curve));
    return true;
  }
  // Adds what poses beside do not lead to, from joint vectors all over; false where that is neither a solution nor on a curve.
  bool all_over(const Rigid& T, std::vector<Known>& known, std::vector<NearCurve>& curves, Read& out) const {
    return from_all_over(arm_, T, [&](const double* q) {
      double at[6];
      std::copy(q, q + kSix, at);
      settle(arm_, T, at, 6, kHeldFirmly);
      const Known one = look_at(T, at);
      if (on_motion(one, out) || nearly_holds(T, one, curves) || is_alone(known, one.q, out)) return true;
      if (one.singular && one.miss > rounding_of(T)) return true;
      if (one.singular && !through(T, one, known, curves, out)) return false;
      if (!on_motion(one, out) && !is_alone(known, one.q, out)) known.push_back(one);
      return true;
    });
  }
  // Whether a point is one of the known rows that lie on no self-motion.
  bool is_alone(const std::vector<Known>& known, const double* q, const Read& out) const {
    for (const Known& one : known)
      if (arm_.apart(one.q, q) < std::fmax(kMergedTwins, one.blur()) && !on_motion(one, out)) return true;
    return false;
  }
  bool is_known(const std::vector<Known>& known, const double* q, double within) const {
    for (const Known& one : known)
      if (arm_.apart(one.q, q) < std::fmax(within, one.blur())) return true;
    return false;
  }
  // Newton's method along a curve; false where it leads away.
  bool refine(const Rigid& T, double length, CurvePoint& at) const {
    double least = INFINITY;
    for (int step = 0; step < 10; ++step) {
      CurvePoint next = at;
      if (step > 0) {
        const double way = -at.miss / at.slope;
        if (!(std::fabs(way) < length)) return least < kCurveTold * kAsideStep;
        for (int i = 0; i < kSix; ++i) next.q[i] += way * at.null[i];
      }
      if (!next.settle(arm_, T)) return false;
      if (step > 0 && !(std::fabs(next.miss) < 0.5 * least)) break;
      at = next, least = std::fabs(at.miss);
      if (least < kMergedAlong) break;
    }
    return true;
  }

  // A row as it stands; one of the pose itself is brought to its last digits where it is singular.
  Known look_at(const Rigid& T, const double* row, bool own = true) const {
    Known out{};
    std::copy(row, row + kSix, out.q);
    out.branches = 1;
    Standing at(arm_, out.q);
    if (last_pivot(kSix, at.J) > kPlainlyRegular) {
      out.regular = invert(at.J, out.inverse);
      return out;
    }
    SingularSix d(at.J);
    out.singular = d.s[5] <= kSingularExamined * d.s[0];
    if (out.singular && own) {
      // kernels stop where Newton's method is slow: the last digits of a merged root are fetched here
      settle(arm_, T, out.q, kSlowSteps, kHeldFirmly);
      out.miss = settle(arm_, T, out.q, kSlowSteps, kPreciseRank);
      at = Standing(arm_, out.q);
      d = SingularSix(at.J);
    } else {
      out.regular = invert(at.J, out.inverse);
    }
    seen(at, d, out);
    if (!out.singular || !own) return out;
    out.branches = branches_of_fold(std::fabs(out.bend), d);
    if (out.branches == 2) {
      onto_root_of_fold(arm_, T, d, out.bend, out.q);
      out.spread = 3 * std::sqrt(kMergedRounding / std::fabs(out.bend));
    } else if (out.branches == 0) {
      const Unfolded root = unfolded(arm_, T, out.q);
      out.branches = root.branches, out.spread = root.blur;
      out.several = !(d.s[4] > kOneWayFree * d.s[0]) && !stands_alone(at, d);
      if (root.branches == 1) return out;
      std::copy(root.q, root.q + kSix, out.q);
      at = Standing(arm_, out.q), d = SingularSix(at.J);
      seen(at, d, out);
      out.miss = missed_at(arm_, out.q, T);  // at the root, not where Newton's method ended beside it
    }
    out.several = !(d.s[4] > kOneWayFree * d.s[0]) && !stands_alone(at, d);
    return out;
  }
  static void seen(const Standing& at, const SingularSix& d, Known& out) {
    out.sigma = d.s[5], out.second = d.s[4], out.bend = second_order(at.J, d);
    out.weak = out.second > kOneWayFree * d.s[0] && out.sigma < kNearlySingular * d.s[0];
    out.fold = std::fabs(out.bend) > kClearFold && out.second > kOneWayFree * d.s[0];
    std::copy(d.joint[5], d.joint[5] + kSix, out.null);
    std::copy(d.pose[5], d.pose[5] + 6, out.left);
  }

  // Whether the other root of a row next to a fold is among the known ones, or far; where a singular row's was lost it is added.
  bool twin_is_known(const Rigid& T, std::vector<Known>& known, std::size_t k) const {
    const Known one = known[k];
    if (!one.fold) return !one.singular;
    if (one.branches > 1) return true;
    const double t = one.twin();
    double twin[6], apart = 0;
    for (int i = 0; i < kSix; ++i)
      twin[i] = one.q[i] + t * one.null[i], apart = std::fmax(apart, std::fabs(t * one.null[i]));
    if (std::fabs(t) > one.reach()) return true;
    for (std::size_t m = 0; m < known.size(); ++m)
      if (m != k && arm_.apart(known[m].q, twin) < apart / 2) return true;
    if (apart <= kMergedSame) {
      known[k].branches = 2;
      return true;
    }
    if (!one.singular) return false;
    double there[6];
    std::copy(twin, twin + kSix, there);
    const double miss = settle(arm_, T, there, kSlowSteps, kPreciseRank);
    if (!(miss < rounding_of(T))) return false;
    if (arm_.apart(there, twin) > apart / 2) {
      // what rounding cannot tell from the row is the row, where two branches merge then
      if (!(arm_.apart(there, one.q) < apart / 2)) return false;
      known[k].branches = 2;
      return true;
    }
    Known more = look_at(T, there);
    known.push_back(more);
    return true;
  }

  void tell(const Rigid& T, const std::vector<Known>& known, const std::vector<NearCurve>& curves, double wide,
            const std::vector<bool>& again, Read& out) const {
    std::vector<Root> merged;
    std::vector<const Known*> isolated, left;
    for (const Known& one : known) {
      bool strays = on_motion(one, out) || nearly_holds(T, one, curves);
      for (const Known& other : known) strays = strays || strays_from(T, one, other, curves);
      if (!strays) left.push_back(&one);
    }
    for (const Known* which : left) {
      const Known& one = *which;
      if (one.singular) {
        if (is_counted(arm_, left, which, wide)) continue;
        merged.push_back({{}, branches_with(arm_, left, which, wide)});
        std::copy(one.q, one.q + kSix, merged.back().q);
        continue;
      }
      bool again = false;
      for (const Known* other : isolated) again |= arm_.apart(one.q, other->q) < kSameSolution;
      if (!again) isolated.push_back(&one);
    }
    one_of_each(arm_, T, merged);
    for (const Known* one : isolated) out.add(arm_, one->q, 1, -1, false);
    std::erase_if(merged, [&](const Root& root) {
      return std::any_of(isolated.begin(), isolated.end(),
                         [&](const Known* one) { return arm_.apart(one->q, root.q) < kSameSolution; });
    });
    all_into_limits(arm_, T, limits_, merged);
    for (const Root& root : merged) out.add(arm_, root.q, root.branches, -1, true);
    int motion = 0;
    for (std::size_t k = 0; k < out.curves.size(); ++k) {
      if (again[k]) continue;
      double q[6];
      out.curves[k].representative(arm_, T, limits_, q);
      out.add(arm_, q, 1, motion++, true);
    }
    out.in_order(arm_);
  }

  // Columns J to the inverse, [joint][pose]; false where a pivot vanishes.
  static bool invert(const double (*J)[6], double (*inverse)[6]) {
    double A[6][12] = {};
    for (int r = 0; r < kSix; ++r) {
      for (int i = 0; i < kSix; ++i) A[r][i] = J[i][r];
      A[r][6 + r] = 1;
    }
    for (int k = 0; k < kSix; ++k) {
      int best = k;
      for (int r = k + 1; r < kSix; ++r)
        if (std::fabs(A[r][k]) > std::fabs(A[best][k])) best = r;
      if (A[best][k] == 0) return false;
      if (best != k) std::swap_ranges(A[best], A[best] + 12, A[k]);
      const double pivot = 1 / A[k][k];
      for (int c = k; c < 12; ++c) A[k][c] *= pivot;
      for (int r = 0; r < kSix; ++r) {
        if (r == k) continue;
        const double part = A[r][k];
        for (int c = k; c < 12; ++c) A[r][c] -= part * A[k][c];
      }
    }
    for (int i = 0; i < kSix; ++i) std::copy(A[i] + 6, A[i] + 12, inverse[i]);
    return true;
  }

  SixJoints arm_;
  Limits limits_;
  int most_;
};

}  // namespace pieper::PIEPER_ISA
