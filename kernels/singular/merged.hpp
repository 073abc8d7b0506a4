// Merged roots: how many branches meet in a solution, and which solutions are one. Scalar.
#pragma once

#include "chain/determinant.hpp"
#include "singular/unfolding.hpp"

namespace pieper::PIEPER_ISA {

// A solution (rad; lengths) with how many branches merge in it.
struct Root {
  double q[6];
  int branches;
};

// What twists one after the other do to second order, twice, where they do nothing to first: the product of exponentials departs from
// one by their brackets, sum over i < j of [x_i, x_j] t^2 / 2.
class Bracket {
 public:
  double sum[6] = {};
  void then(const double* x) {
    const Vec3 v = {x[0], x[1], x[2]}, w = {x[3], x[4], x[5]}, bv = {before_[0], before_[1], before_[2]},
               bw = {before_[3], before_[4], before_[5]};
    const Vec3 linear = cross(bw, v) - cross(w, bv), turn = cross(bw, w);
    sum[0] += linear.x, sum[1] += linear.y, sum[2] += linear.z;
    sum[3] += turn.x, sum[4] += turn.y, sum[5] += turn.z;
    for (int r = 0; r < 6; ++r) before_[r] += x[r];
  }

 private:
  double before_[6] = {};
};

// What the null direction misses to second order along `pose[5]`, per square of its motion.
inline double second_order(const double (*J)[6], const SingularSix& d) {
  Bracket bracket;
  for (int i = 0; i < kSix; ++i) {
    double x[6];
    for (int r = 0; r < 6; ++r) x[r] = J[i][r] * d.joint[5][i];
    bracket.then(x);
  }
  double bend = 0;
  for (int r = 0; r < 6; ++r) bend += 0.5 * d.pose[5][r] * bracket.sum[r];
  return bend;
}

// How many branches merge where that much is missed to second order; 0 where that is too little.
inline int branches_of_fold(double bend, const SingularSix& d) {
  if (bend < kClearFold) return 0;
  const double sigma = d.s[5],
               blur = std::fmin(std::sqrt(kMergedRounding / bend), kMergedRounding / std::fmax(sigma, kTiny));
  return sigma / bend < std::fmax(kMergedSame, 2 * blur) ? 2 : 1;
}

// Puts a fold's double root where the fold is: rounding leaves it on one of its two sides, and half way to the other it is, on the
// bent curve that the weakest direction alone is missed on.
inline void onto_root_of_fold(const SixJoints& arm, const Rigid& T, const SingularSix& d, double bend, double* q) {
  constexpr int kBackOnto = 2;  // Newton steps: it is off by the square of a way of a millionth
  const double t = -0.5 * d.s[5] / bend;
  for (int i = 0; i < kSix; ++i) q[i] += t * d.joint[5][i];
  const OnCurve there(arm, T, q, kBackOnto);
  std::copy(there.q, there.q + kSix, q);
}

// What forward kinematics rounds of a pose.
inline double rounding_of(const Rigid& T) { return kMergedRounding * (1 + std::sqrt(dot(T.t, T.t))); }

// How many branches merge at a solution, which is put where they do: 1 where its Jacobian is merely poor.
inline int branches_at(const SixJoints& arm, const Rigid& T, double* q) {
  const Unfolded root = unfolded(arm, T, q);
  std::copy(root.q, root.q + kSix, q);
  return root.branches;
}

// What is missed most between two solutions on one curve, how far the curve leaves their chord, and by what it is no curve.
struct Between {
  double strayed, missed, rest;
};
inline Between most_between(const SixJoints& arm, const Rigid& T, const double* a, const double* b) {
  Between most{};
  for (int m = 1; m < 4; ++m) {
    double chord[6];
    for (int i = 0; i < kSix; ++i) chord[i] = b[i] + 0.25 * m * arm.way(a, b, i);
    const OnCurve between(arm, T, chord, 3);
    for (int i = 0; i < kSix; ++i) most.strayed = std::fmax(most.strayed, std::fabs(between.q[i] - chord[i]));
    most.missed = std::fmax(most.missed, std::fabs(between.miss)), most.rest = std::fmax(most.rest, between.rest);
  }
  return most;
}

// Whether two postures stand on two sides of a singularity.
inline bool on_two_sides(const SixJoints& arm, const double* a, const double* b) {
  return determinant(Standing(arm, a).J) * determinant(Standing(arm, b).J) < 0;
}

// One of each cluster of singular solutions that forward kinematics cannot tell apart, the most exact first.
//
// Two are one when everything between them holds the pose to rounding as well: the blur of a double root is about 1e-8 wide, that
// of a triple root 1e-5. Neighbouring roots on a curve lie on two sides of a singularity: such are kept apart even where rounding
// hides what is between them. Where several directions are free a root has no two sides, and one in which branches merge stands
// between its own: what is missed on the way to them is rounding; and on the way between two places that Newton's method has found such a
// root at. Of two that are one, each on its side, two branches merge.
inline void distinct_roots(const SixJoints& arm, const Rigid& T, std::vector<Root>& roots) {
  struct Row {
    Root root;
    double miss, side;
  };
  std::vector<Row> rows;
  for (const Root& root : roots) {
    const Standing now(arm, root.q);
    double e[6];
    const double miss = now.missing(T, e), det = determinant(now.J);
    rows.push_back({root, miss, det > 0 ? 1.0 : det < 0 ? -1.0 : 0.0});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    const bool one = a.root.branches == 1, other = b.root.branches == 1;
    return one != other ? other : a.miss < b.miss;
  });
  std::vector<Row> kept;
  for (const Row& row : rows) {
    bool same = false;
    for (Row& other : kept) {
      const double apart = arm.apart(row.root.q, other.root.q);
      const bool several = std::max(row.root.branches, other.root.branches) >= 4,
                 own = several || (row.root.branches == 1 && other.root.branches > 1),
                 sides = row.side != other.side && !own;
      same = apart < kMergedSame;
      if (!same && apart < (sides ? kMergedTwins : kMergedBlur)) {
        // a chord leaves a bent curve: what lies between is moved onto it
        const Between most = most_between(arm, T, row.root.q, other.root.q);
        same = most.strayed < apart / 4 && most.missed <= (own ? rounding_of(T) : kMergedAlong) &&
               most.rest <= rounding_of(T);
      }
      if (same && sides && apart >= kMergedSame && other.root.branches == 1) other.root.branches = 2;
      // what rounding parts from a root of several directions may look like a root of fewer
      if (same && other.root.branches > 1) other.root.branches = std::max(other.root.branches, row.root.branches);
      if (same) break;
    }
    if (!same) kept.push_back(row);
  }
  roots.clear();
  for (const Row& row : kept) roots.push_back(row.root);
}

// Makes one of roots that rounding cannot tell apart, once each is where it belongs. What stands by itself keeps its count: of a double
// root next to a line on which the pose all but stays no unfolding tells it.
inline void one_of_each(const SixJoints& arm, const Rigid& T, std::vector<Root>& roots) {
  std::vector<std::size_t> close;
  for (std::size_t a = 0; a < roots.size(); ++a) {
    double least = INFINITY;
    for (std::size_t b = 0; b < roots.size(); ++b)
      if (a != b) least = std::fmin(least, arm.apart(roots[a].q, roots[b].q));
    if (least < kMergedBlur) close.push_back(a);
  }
  if (close.empty()) return;
  for (std::size_t a : close) roots[a].branches = branches_at(arm, T, roots[a].q);
  distinct_roots(arm, T, roots);
}

}  // namespace pieper::PIEPER_ISA
