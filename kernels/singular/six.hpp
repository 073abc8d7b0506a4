// Six joints at a joint vector, as the look at singular poses needs them: axes, Jacobian, what is missed, singular values and
// directions, Newton's step along some of them. Lengths in units of the arm. Scalar.
#pragma once

#include <algorithm>
#include <cmath>

#include "chain/newton_step.hpp"
#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA {

inline constexpr int kSix = 6;

// Differences the short way round, in [-pi, pi).
inline double short_way(double angle) { return angle - kTwoPi * std::floor((angle + kPi) / kTwoPi); }

struct SixJoints {
  double length;  // m
  Rigid links[7];
  bool slides[6];

  // Largest joint difference without units, angles the short way round.
  double apart(const double* a, const double* b) const {
    double most = 0;
    for (int i = 0; i < kSix; ++i) most = std::fmax(most, std::fabs(way(a, b, i)));
    return most;
  }
  double way(const double* a, const double* b, int i) const { return slides[i] ? a[i] - b[i] : short_way(a[i] - b[i]); }
};

// Singular values of a 6x6 with their joint and pose directions, the largest first: one-sided Jacobi, which is exact to rounding
// in small ones too. J is columns: J[i] is what joint i does.
struct SingularSix {
  double s[6], joint[6][6], pose[6][6];  // joint[k], pose[k]: unit directions of s[k]

  explicit SingularSix(const double (*J)[6]) {
    double A[6][6], V[6][6] = {};
    std::copy(&J[0][0], &J[0][0] + 36, &A[0][0]);
    for (int i = 0; i < kSix; ++i) V[i][i] = 1;
    bool turned = true;
    for (int sweep = 0; sweep < 30 && turned; ++sweep) {
      turned = false;
      for (int i = 0; i < kSix; ++i)
        for (int j = i + 1; j < kSix; ++j) turned |= turn(A, V, i, j);
    }
    double size[6];
    int order[6];
    for (int i = 0; i < kSix; ++i) size[i] = norm(A[i]), order[i] = i;
    std::sort(order, order + kSix, [&](int a, int b) { return size[a] > size[b] || (size[a] == size[b] && a < b); });
    for (int k = 0; k < kSix; ++k) {
      const int i = order[k];
      s[k] = size[i];
      for (int r = 0; r < kSix; ++r) joint[k][r] = V[i][r], pose[k][r] = A[i][r];
      across(k);
    }
  }

 private:
  static double norm(const double* v) {
    double sum = 0;
    for (int r = 0; r < kSix; ++r) sum += v[r] * v[r];
    return std::sqrt(sum);
  }
  static double along(const double* a, const double* b) {
    double sum = 0;
    for (int r = 0; r < kSix; ++r) sum += a[r] * b[r];
    return sum;
  }
  static bool turn(double (*A)[6], double (*V)[6], int i, int j) {
    const double a = along(A[i], A[i]), b = along(A[j], A[j]), c = along(A[i], A[j]);
    if (c * c <= kOrthogonal * kOrthogonal * a * b || c == 0) return false;
    const double zeta = (b - a) / (2 * c), t = (zeta >= 0 ? 1 : -1) / (std::fabs(zeta) + std::sqrt(1 + zeta * zeta));
    const double cos = 1 / std::sqrt(1 + t * t), sin = cos * t;
    for (int r = 0; r < kSix; ++r) {
      const double x = A[i][r], y = A[j][r], v = V[i][r], w = V[j][r];
      A[i][r] = cos * x - sin * y, A[j][r] = sin * x + cos * y;
      V[i][r] = cos * v - sin * w, V[j][r] = sin * v + cos * w;
    }
    return true;
  }
  // What is left of pose[k] when it is made orthogonal to the ones before it, of length one; any such where nothing is left.
  void across(int k) {
    double* v = pose[k];
    const double size = norm(v);
    if (size > kAcrossRounding * s[0]) {
      for (int r = 0; r < kSix; ++r) v[r] /= size;
      return;
    }
    double best[6] = {}, most = -1;
    for (int axis = 0; axis < kSix; ++axis) {
      double e[6] = {};
      e[axis] = 1;
      for (int again = 0; again < 2; ++again)
        for (int m = 0; m < k; ++m) {
          const double part = along(e, pose[m]);
          for (int r = 0; r < kSix; ++r) e[r] -= part * pose[m][r];
        }
      const double left = norm(e);
      if (left > most + kAcrossMore) most = left, std::copy(e, e + kSix, best);
    }
    const double sign = along(best, v) < 0 ? -1 : 1;
    for (int r = 0; r < kSix; ++r) v[r] = sign * best[r] / std::fmax(most, kTiny);
  }
};

// An arm at a joint vector (rad; lengths).
struct Standing {
  Rigid end;
  Vec3 z[6], o[6];
  double J[6][6];  // column of joint i, linear rows first

  Standing(const SixJoints& arm, const double* q) {
    end = walk(
        kSix, arm.links[0], [&](int k) -> const Rigid& { return arm.links[k + 1]; },
        [&](int k) { return motion_of(q[k], arm.slides[k]); }, arm.slides,
        [&](int k, const Rigid& frame) { z[k] = frame.z, o[k] = frame.t; });
    for (int k = 0; k < kSix; ++k) moved_end(z[k], o[k], arm.slides[k], end.t, J[k]);
  }
  // What is missing to T: way, then rotation vector; returns its size.
  double missing(const Rigid& T, double* e) const { return missing_to(end, T, e); }
};

inline double missed_at(const SixJoints& arm, const double* q, const Rigid& T) {
  double e[6];
  return Standing(arm, q).missing(T, e);
}

// Adds the shortest step that makes up for e along the directions stronger than `cutoff` (relative), `but` left out, no longer
// than `longest`.
inline void step_along(const SingularSix& d, const double* e, double cutoff, int but, double longest, double* q) {
  double step[6] = {}, size = 0;
  for (int k = 0; k < kSix; ++k) {
    if (k == but || !(d.s[k] > cutoff * d.s[0])) continue;
    double part = 0;
    for (int r = 0; r < kSix; ++r) part += d.pose[k][r] * e[r];
    for (int i = 0; i < kSix; ++i) step[i] += part / d.s[k] * d.joint[k][i];
  }
  for (double x : step) size += x * x;
  const double shrink = std::fmin(1.0, longest / std::fmax(std::sqrt(size), kTiny));
  for (int i = 0; i < kSix; ++i) q[i] += shrink * step[i];
}

// Newton's method to T from q; the best point met is left in q, what it misses is returned.
inline double settle(const SixJoints& arm, const Rigid& T, double* q, int steps, double cutoff) {
  double at[6], least = INFINITY;
  std::copy(q, q + kSix, at);
  for (int taken = 0, stalled = 0; taken <= steps; ++taken) {
    const Standing now(arm, at);
    double e[6];
    const double size = now.missing(T, e);
    stalled = size > 0.5 * least ? stalled + 1 : 0;
    if (size < least) least = size, std::copy(at, at + kSix, q);
    if (!(size > kNewtonDone) || (least <= kNewtonStalls && stalled >= 3)) break;
    step_along(SingularSix(now.J), e, cutoff, -1, 0.5, at);
  }
  return least;
}

// A point on the curve on which only the weakest direction misses the pose: Newton in all but that one.
struct OnCurve {
  double q[6], miss, rest;  // missed along the weakest pose direction, and otherwise
  double left[6], null[6];  // that direction, and the joints'

  OnCurve(const SixJoints& arm, const Rigid& T, const double* start, int steps) {
    std::copy(start, start + kSix, q);
    for (int k = 0;; ++k) {
      const Standing now(arm, q);
      const SingularSix d(now.J);
      double e[6];
      now.missing(T, e);
      if (k < steps) {
        step_along(d, e, kCurveWeak, 5, 0.3, q);
        continue;
      }
      std::copy(d.pose[5], d.pose[5] + 6, left);
      std::copy(d.joint[5], d.joint[5] + 6, null);
      miss = rest = 0;
      for (int r = 0; r < 6; ++r) miss += left[r] * e[r];
      for (int r = 0; r < 6; ++r) rest += (e[r] - miss * left[r]) * (e[r] - miss * left[r]);
      rest = std::sqrt(rest);
      return;
    }
  }
};

// Whether the smallest singular value is far above what is looked at, one joint left out or none: the last pivot of an
// elimination with full choice of columns.
inline bool well_posed(const double (*J)[6], int without = -1) { return last_pivot(kSix, J, without) > kSecondFree; }

}  // namespace pieper::PIEPER_ISA
