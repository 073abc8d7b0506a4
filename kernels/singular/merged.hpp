// Merged roots: how many branches meet in a solution, and which solutions are one. Scalar.
#pragma once

#include <complex>
#include <vector>

#include "singular/six.hpp"

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
inline double bend_of(const double (*J)[6], const SingularSix& d) { return std::fabs(second_order(J, d)); }

// How many branches merge where that much is missed to second order; 0 where that is too little.
inline int branches_of_fold(double bend, const SingularSix& d) {
  if (bend < kClearFold) return 0;
  const double sigma = d.s[5],
               blur = std::fmin(std::sqrt(kMergedRounding / bend), kMergedRounding / std::fmax(sigma, kTiny));
  return sigma / bend < std::fmax(kMergedSame, 3 * blur) ? 2 : 1;
}

// How many roots of c[0] + c[1] t + ... + c[4] t^4 lie nearer to zero than `within`; vanishing leading coefficients are left out.
inline int roots_within(const double* c, double within) {
  int degree = 4;
  while (degree > 0 && c[degree] == 0) --degree;
  if (degree == 0) return 0;
  std::complex<double> t[4];
  for (int k = 0; k < degree; ++k) t[k] = std::pow(std::complex<double>(0.4, 0.9), k);
  // all roots at once (Durand 1960, Kerner 1966), in units of a root's largest size
  double size = 0;
  for (int k = 0; k < degree; ++k) size = std::fmax(size, std::pow(std::fabs(c[k] / c[degree]), 1.0 / (degree - k)));
  if (size == 0) return degree;
  double a[5];
  for (int k = 0; k <= degree; ++k) a[k] = c[k] / c[degree] * std::pow(size, k - degree);
  for (int i = 0; i < 200; ++i) {
    double most = 0;
    for (int k = 0; k < degree; ++k) {
      std::complex<double> value = a[degree], others = 1;
      for (int j = degree - 1; j >= 0; --j) value = value * t[k] + a[j];
      for (int j = 0; j < degree; ++j)
        if (j != k) others *= t[k] - t[j];
      if (std::abs(others) == 0) others = kRootsCoincide;
      const std::complex<double> step = value / others;
      t[k] -= step;
      most = std::fmax(most, std::abs(step));
    }
    if (most < kRootsFound) break;
  }
  int count = 0;
  for (int k = 0; k < degree; ++k) count += std::abs(t[k]) * size < within;
  return count;
}

// How many branches merge at a solution: 1 where its Jacobian is merely poor.
//
// Along the curve on which only the weakest direction misses the pose, what is missed is c0 + c1 t + ... + c4 t^4: its roots that
// lie within what rounding lets one tell of each other are one solution.
inline int branches_at(const SixJoints& arm, const Rigid& T, const double* q) {
  const OnCurve here(arm, T, q, 0);
  const double sigma = SingularSix(Standing(arm, q).J).s[5];
  double at[4];
  for (int k = 0; k < 4; ++k) {
    const double t = kMergedStep * (k < 2 ? k - 2 : k - 1);
    double start[6], lean = 0;
    for (int i = 0; i < kSix; ++i) start[i] = q[i] + t * here.null[i];
    const OnCurve beside(arm, T, start, 5);
    for (int r = 0; r < 6; ++r) lean += beside.left[r] * here.left[r];
    at[k] = lean < 0 ? -beside.miss : lean > 0 ? beside.miss : 0;
  }
  const double h = kMergedStep, far = at[0], near = at[1], near2 = at[2], far2 = at[3];
  double c[5] = {0, -sigma, 0, ((far2 - far) - 2 * (near2 - near)) / (12 * h * h * h),
                 ((far + far2) - 4 * (near + near2)) / (24 * h * h * h * h)};
  c[2] = (near + near2) / (2 * h * h) - c[4] * h * h;
  double blur = INFINITY;
  bool any = false;
  for (int k = 1; k < 5; ++k) {
    if (k > 1 && std::fabs(c[k]) < kRootsFound / std::pow(h, k)) c[k] = 0;
    if (c[k] != 0) any = true, blur = std::fmin(blur, std::pow(kMergedRounding / std::fabs(c[k]), 1.0 / k));
  }
  return any ? std::max(1, roots_within(c, std::fmax(kMergedSame, 3 * blur))) : 1;
}

inline double determinant(const double (*J)[6]) {
  double A[6][6], det = 1;
  std::copy(&J[0][0], &J[0][0] + 36, &A[0][0]);
  for (int k = 0; k < kSix; ++k) {
    int best = k;
    for (int i = k + 1; i < kSix; ++i)
      if (std::fabs(A[i][k]) > std::fabs(A[best][k])) best = i;
    if (A[best][k] == 0) return 0;
    if (best != k) std::swap_ranges(A[best], A[best] + 6, A[k]), det = -det;
    det *= A[k][k];
    for (int i = k + 1; i < kSix; ++i)
      for (int j = kSix - 1; j >= k; --j) A[i][j] -= A[i][k] / A[k][k] * A[k][j];
  }
  return det;
}

// One of each cluster of singular solutions that forward kinematics cannot tell apart, the most exact first.
//
// Two are one when everything between them holds the pose to rounding as well: the blur of a double root is about 1e-8 wide, that
// of a triple root 1e-5. Neighbouring roots on a curve lie on two sides of a singularity: such are kept apart even where rounding
// hides what is between them.
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
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.miss < b.miss; });
  const double size = 1 + std::sqrt(dot(T.t, T.t));
  std::vector<Row> kept;
  for (const Row& row : rows) {
    bool same = false;
    for (const Row& other : kept) {
      const double apart = arm.apart(row.root.q, other.root.q);
      same = apart < kMergedSame;
      if (!same && apart < (row.side == other.side ? kMergedBlur : kMergedTwins)) {
        // a chord leaves a bent curve: what lies between is moved onto it
        double strayed = 0, missed = 0, rest = 0;
        for (int m = 1; m < 4; ++m) {
          double chord[6];
          for (int i = 0; i < kSix; ++i) chord[i] = other.root.q[i] + 0.25 * m * arm.way(row.root.q, other.root.q, i);
          const OnCurve between(arm, T, chord, 3);
          for (int i = 0; i < kSix; ++i) strayed = std::fmax(strayed, std::fabs(between.q[i] - chord[i]));
          missed = std::fmax(missed, std::fabs(between.miss)), rest = std::fmax(rest, between.rest);
        }
        same = strayed < apart / 4 && missed <= kMergedAlong && rest <= kMergedRounding * size;
      }
      if (same) break;
    }
    if (!same) kept.push_back(row);
  }
  roots.clear();
  for (const Row& row : kept) roots.push_back(row.root);
}

// Makes one of roots that rounding cannot tell apart.
inline void one_of_each(const SixJoints& arm, const Rigid& T, std::vector<Root>& roots) {
  double least = INFINITY;
  for (std::size_t a = 0; a < roots.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) least = std::fmin(least, arm.apart(roots[a].q, roots[b].q));
  if (least >= kMergedBlur) return;
  distinct_roots(arm, T, roots);
  for (Root& root : roots) root.branches = branches_at(arm, T, root.q);
}

}  // namespace pieper::PIEPER_ISA
