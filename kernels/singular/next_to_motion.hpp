// The solutions next to a self-motion that is all but in place: kernels give one point for them. Scalar.
#pragma once

#include "singular/fibre.hpp"

namespace pieper::PIEPER_ISA {

struct NextToMotion {
  static constexpr int kSlowSteps = 40;
  SixJoints arm;

  // The solutions beside a self-motion all but in place: kernels give one point of such a line.
  //
  // What is missed along the line changes sign twice in a turn. Newton's method from four points of it ends at both; false where it does not.
  bool line(const Rigid& T, const double* q, const double* null, std::vector<Root>& alone) const {
    double starts[4][6];
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < kSix; ++i) starts[k][i] = q[i] + 0.5 * k * kPi * std::sqrt(2.0) * null[i];
    const std::vector<Root> ends = ends_of(T, starts, 4);
    if (ends.size() != 2) return false;
    join(ends, alone);
    return true;
  }

  // The same beside the self-motion of a linkage; how often the sign changes is not known beforehand, but it is even.
  bool linkage(const Rigid& T, const double* q, FourBar& bar, std::vector<Root>& alone) const {
    std::vector<SelfMotionRead> pieces;
    const LinkageSelfMotion* own = nullptr;
    if (!pieces_of(q, Standing(arm, q), bar, pieces)) return false;
    for (const SelfMotionRead& piece : pieces) {
      const auto* whole = std::get_if<LinkageSelfMotion>(&piece);
      if (!own && whole && whole->holds(arm, q, kNextToLinkage)) own = whole;
    }
    if (!own) return false;
    const LinkageSelfMotion& whole = *own;
    // what is missed along the curve on which all else holds, with one sign from place to place
    constexpr int kPlaces = 24;
    auto at = [&](double u) {
      double start[6];
      whole.point(u, start);
      return OnCurve(arm, T, start, 4);
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

  // Whether the pose can be held a little way along the null direction, all but exactly.
  bool held(const Rigid& T, const double* q, const double* null) const {
    for (double step : {0.05, -0.05}) {
      double at[6];
      for (int i = 0; i < kSix; ++i) at[i] = q[i] + step * null[i];
      if (std::fabs(OnCurve(arm, T, at, 5).miss) < 10 * kOnCurve) return true;
    }
    return false;
  }

 private:
  // Where Newton's method ends, each solution once.
  std::vector<Root> ends_of(const Rigid& T, double (*starts)[6], int count) const {
    std::vector<std::pair<double, int>> order;
    for (int k = 0; k < count; ++k) order.emplace_back(settle(arm, T, starts[k], kSlowSteps, kNewtonDone), k);
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Root> ends;
    for (const auto& [miss, k] : order) {
      bool again = !(miss < kHoldsToRounding);
      for (const Root& other : ends) again |= arm.apart(starts[k], other.q) < kSameAlong;
      if (again) continue;
      ends.push_back({{}, 1});
      std::copy(starts[k], starts[k] + kSix, ends.back().q);
    }
    return ends;
  }

  void join(const std::vector<Root>& ends, std::vector<Root>& alone) const {
    for (const Root& end : ends) {
      bool again = false;
      for (const Root& other : alone) again |= arm.apart(end.q, other.q) < kSameAlong;
      if (!again) alone.push_back(end);
    }
  }
};

}  // namespace pieper::PIEPER_ISA
