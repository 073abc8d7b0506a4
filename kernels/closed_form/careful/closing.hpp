// Closing the loop: forward kinematics of a chain, the last Newton steps on SE(3), the verdict on a candidate, and the
// list of distinct solutions. Shared by the families that find candidates in closed form.
// Scalar: the careful road takes one pose at a time.
#pragma once

#include <cmath>
#include <cstdint>

#include "chain/determinant.hpp"
#include "chain/newton_step.hpp"
#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA::closed_form {

inline constexpr int kMaxJoints = 6;

inline double one_turn(double angle) {
  angle = std::remainder(angle, 2 * kPi);
  return angle <= -kPi ? kPi : angle;
}

// The part of the loop after a group of three joints, with the pose put where it belongs.
template <class F> struct LoopRestT {
  RigidT<F> pre, A, B, C;
  int joints[3];  // which joints a, b, c are

  PIEPER_INLINE LoopRestT(const Rigid* links, const RigidT<F>& T, int first) {
    const RigidT<F> closing = closing_link(links, T);
    RigidT<F>* place[4] = {&pre, &A, &B, &C};
    for (int k = 0; k < 4; ++k) *place[k] = loop_link(links, closing, (first + 2 + k) % 6);
    for (int k = 0; k < 3; ++k) joints[k] = (first + 3 + k) % 6;
  }
};
using LoopRest = LoopRestT<double>;

// The chain as described, lengths in units of the arm, which every candidate has to satisfy.
struct TrueChain {
  int n;
  double length;       // m
  const Rigid* links;  // n + 1
  const bool* slides;
};

// What forward kinematics of q misses T by, as a twist of the tool in base coordinates; and the Jacobian's columns.
inline double missed(const TrueChain& chain, const Rigid& T, const double* q, double* error, double (*columns)[6]) {
  const Miss<double> miss = missed_by(
      chain.n, chain.links[0], [&](int k) -> const Rigid& { return chain.links[k + 1]; },
      [&](int k) { return motion_of(q[k], chain.slides[k]); }, chain.slides, T, columns);
  const Rigid& end = miss.end;
  const Vec3 w = miss.w;
  // sees a half turn, which the cross products miss
  const Vec3 ex = T.x - end.x, ey = T.y - end.y, ez = T.z - end.z;
  const double worst =
      std::fmax(std::sqrt(dot(miss.p, miss.p)), std::sqrt(0.5 * (dot(ex, ex) + dot(ey, ey) + dot(ez, ez))));
  error[0] = miss.p.x, error[1] = miss.p.y, error[2] = miss.p.z, error[3] = w.x, error[4] = w.y, error[5] = w.z;
  return worst;
}

// J^T J + damping trace(J^T J), factored by Cholesky. A damping a little above rounding keeps singular poses finite.
struct Normal {
  int n;
  double A[kMaxJoints][kMaxJoints], trace = 0;

  Normal(int joints, const double (*J)[6], double damping) : n(joints) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j) {
        A[i][j] = 0;
        for (int k = 0; k < 6; ++k) A[i][j] += J[i][k] * J[j][k];
      }
      trace += A[i][i];
    }
    const double least = damping * trace + kTiny;
    for (int j = 0; j < n; ++j) {
      double d = A[j][j] + least;
      for (int k = 0; k < j; ++k) d -= A[j][k] * A[j][k];
      A[j][j] = std::sqrt(std::fmax(d, least));
      for (int i = j + 1; i < n; ++i) {
        double s = A[i][j];
        for (int k = 0; k < j; ++k) s -= A[i][k] * A[j][k];
        A[i][j] = s / A[j][j];
      }
    }
  }
  void solve(double* b) const {
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < i; ++k) b[i] -= A[i][k] * b[k];
      b[i] /= A[i][i];
    }
    for (int i = n - 1; i >= 0; --i) {
      for (int k = i + 1; k < n; ++k) b[i] -= A[k][i] * b[k];
      b[i] /= A[i][i];
    }
  }
};

// Whether the Jacobian (columns, lengths in units of the arm) is singular within kClosedSingular.
inline bool is_singular(int n, const double (*J)[6]) {
  return last_pivot(n, J) <= (3 * kClosedSingular) * (3 * kClosedSingular);
}

// The distinct verified solutions of one pose.
struct Found {
  int n, most, count = 0;
  double* q;  // most x n
  bool degenerate = false, near_miss = false;
  bool suspect = false;  // a row is nearly singular
};

// Whether two postures (n) are one root: a posture halfway between them holds the pose to `rounding`. The line between them leaves a
// bent valley, and so it is put back first, as far as that is told to first order, which along the valley it is not. The two roots of a
// fold lie on either side of where the determinant vanishes: what is put back between them may come to hold though they are two.
inline bool held_between(const TrueChain& chain, const Rigid& T, const double (*J)[6], const double* other,
                         double* middle, double apart, double rounding) {
  double error[6], at[kMaxJoints][6], dq[kMaxJoints], gone = 0;
  if (missed(chain, T, middle, error, at) <= rounding) return true;
  if (chain.n == 6) {
    missed(chain, T, other, error, at);
    if (determinant(J) * determinant(at) < 0) return false;
    missed(chain, T, middle, error, at);
  }
  for (int i = 0; i < 2; ++i) {
    damped_step(chain.n, error, at, kClosedDamping, apart, dq);
    for (int k = 0; k < chain.n; ++k) middle[k] += dq[k], gone = std::fmax(gone, std::fabs(dq[k]));
    if (gone > apart / 4) return false;
    if (missed(chain, T, middle, error, at) <= rounding) return true;
  }
  return false;
}

// Polish a candidate (values in rad and lengths of the arm), verify it, and append it unless it is there already.
inline void offer(const TrueChain& chain, const Rigid& T, const double* candidate, Found& found) {
  int n = chain.n;
  double q[kMaxJoints], error[6], J[kMaxJoints][6];
  for (int i = 0; i < n; ++i) {
    q[i] = candidate[i];
    if (!(std::fabs(q[i]) < kClosedEndless)) return;
  }
  double miss = missed(chain, T, q, error, J);
  if (!(miss < kClosedHopeless)) return;
  double damping = kClosedDamping;
  for (int i = 0; i < 12 && miss > kClosedPolished; ++i) {
    double dq[kMaxJoints], trial[kMaxJoints], e2[6], J2[kMaxJoints][6];
    damped_step(n, error, J, damping, kClosedLongestStep, dq);
    for (int k = 0; k < n; ++k) trial[k] = q[k] + dq[k];
    double next = missed(chain, T, trial, e2, J2);
    if (next < miss) {
      bool stalled = next > 0.5 * miss && next < kClosedStalled;
      miss = next;
      for (int k = 0; k < 6; ++k) error[k] = e2[k];
      for (int k = 0; k < n; ++k) {
        q[k] = trial[k];
        for (int r = 0; r < 6; ++r) J[k][r] = J2[k][r];
      }
      damping = std::fmax(damping * kClosedDampingFalls, kClosedDamping);
      if (stalled) break;
    } else {
      if (miss < kClosedGoodEnough || damping > 1) break;
      damping = damping * kClosedDampingGrows;
    }
  }
  if (!(miss <= kClosedVerified)) {
    if (miss < kClosedNearMiss) found.near_miss = true;
    return;
  }
  for (int i = 0; i < n; ++i)
    if (!chain.slides[i]) q[i] = one_turn(q[i]);
  const bool singular = is_singular(n, J);
  static_assert(kClosedSame < kClosedValley);
  for (int s = 0; s < found.count; ++s) {
    double apart = 0, middle[kMaxJoints];
    for (int i = 0; i < n && apart < kClosedValley; ++i) {
      double d = q[i] - found.q[s * n + i];
      if (!chain.slides[i]) d -= kTwoPi * std::nearbyint(d / kTwoPi);
      middle[i] = q[i] - 0.5 * d;
      apart = std::fmax(apart, std::fabs(d));
    }
    if (apart < kClosedSame) return;
    // in a flat valley (a self-motion, or a root too shallow for double precision) two candidates are one answer
    if (singular && apart < kClosedValley &&
        held_between(chain, T, J, found.q + s * n, middle, apart, kClosedPolished + 2 * miss)) {
      found.suspect = true;
      return;
    }
  }
  found.suspect |= singular;
  if (found.count == found.most) {
    found.degenerate = true;
    return;
  }
  for (int i = 0; i < n; ++i) found.q[found.count * n + i] = q[i];
  ++found.count;
}

}  // namespace pieper::PIEPER_ISA::closed_form
