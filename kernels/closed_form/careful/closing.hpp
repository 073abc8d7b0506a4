// Closing the loop: forward kinematics of a chain, the last Newton steps on SE(3), the verdict on a candidate, and the
// list of distinct solutions. Shared by the families that find candidates in closed form.
#pragma once

#include <cmath>
#include <cstdint>

#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA::closed_form {

inline constexpr int kMaxJoints = 6;
// A candidate is a solution when forward kinematics misses the pose by no more (in lengths of the arm; rad).
inline constexpr double kVerified = 1e-12;
// Candidates that miss by more than this before polishing belong to a wrong branch.
inline constexpr double kHopeless = 2e-2;
// Solutions closer than this (rad; lengths of the arm) are one.
inline constexpr double kSame = 3e-8;
// Smallest over largest singular value of the scaled Jacobian under which a solution is looked at closely.
inline constexpr double kSingular = 2.5e-7;

template <class F> struct Vec3T { F x, y, z; };
using Vec3 = Vec3T<double>;
template <class F> PIEPER_INLINE Vec3T<F> operator+(Vec3T<F> a, Vec3T<F> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class F> PIEPER_INLINE Vec3T<F> operator-(Vec3T<F> a, Vec3T<F> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class F> PIEPER_INLINE Vec3T<F> operator*(F s, Vec3T<F> a) { return {s * a.x, s * a.y, s * a.z}; }
template <class F> PIEPER_INLINE F dot(Vec3T<F> a, Vec3T<F> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class F> PIEPER_INLINE Vec3T<F> cross(Vec3T<F> a, Vec3T<F> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A rigid motion: columns x, y, z of its rotation and its translation t.
template <class F> struct RigidT { Vec3T<F> x, y, z, t; };
using Rigid = RigidT<double>;
template <class F> PIEPER_INLINE Vec3T<F> turn(const RigidT<F>& A, Vec3T<F> v) {
  return v.x * A.x + v.y * A.y + v.z * A.z;
}
template <class F> PIEPER_INLINE Vec3T<F> turn_back(const RigidT<F>& A, Vec3T<F> v) {
  return {dot(A.x, v), dot(A.y, v), dot(A.z, v)};
}
template <class F> PIEPER_INLINE Vec3T<F> move(const RigidT<F>& A, Vec3T<F> p) { return turn(A, p) + A.t; }
template <class F> PIEPER_INLINE Vec3T<F> move_back(const RigidT<F>& A, Vec3T<F> p) { return turn_back(A, p - A.t); }
template <class F> PIEPER_INLINE RigidT<F> operator*(const RigidT<F>& A, const RigidT<F>& B) {
  return {turn(A, B.x), turn(A, B.y), turn(A, B.z), move(A, B.t)};
}
template <class F> PIEPER_INLINE RigidT<F> inverse(const RigidT<F>& A) {
  return {{A.x.x, A.y.x, A.z.x}, {A.x.y, A.y.y, A.z.y}, {A.x.z, A.y.z, A.z.z}, turn_back(A, F(-1.0) * A.t)};
}
// From the upper three rows of a row-major 4x4, lengths divided by `length`.
inline Rigid read_rigid(const double* m, double length) {
  double k = 1 / length;
  return {{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}, {k * m[3], k * m[7], k * m[11]}};
}
template <int N> void read_links(const double (&from)[N][4][4], double length, Rigid* to) {
  for (int k = 0; k < N; ++k) to[k] = read_rigid(from[k][0], length);
}
// A * Z, the joint's motion by `value` about or along the local z.
inline Rigid joint(const Rigid& A, double value, bool prismatic) {
  if (prismatic) return {A.x, A.y, A.z, A.t + value * A.z};
  double c = std::cos(value), s = std::sin(value);
  return {c * A.x + s * A.y, c * A.y - s * A.x, A.z, A.t};
}
inline double one_turn(double angle) {
  angle = std::remainder(angle, 2 * kPi);
  return angle <= -kPi ? kPi : angle;
}

// The part of the loop after a group of three joints, with the pose put where it belongs.
template <class F> struct LoopRestT {
  RigidT<F> pre, A, B, C;
  int joints[3];  // which joints a, b, c are

  LoopRestT() = default;
  LoopRestT(const RigidT<F>* links, const RigidT<F>& T, int first) {
    // link k leads from joint k - 1 to joint k; link 0 is where the loop closes, through the pose
    RigidT<F> closing = links[6] * inverse(T) * links[0];
    auto link = [&](int k) { return k % 6 == 0 ? closing : links[k % 6]; };
    pre = link(first + 3);
    A = link(first + 4);
    B = link(first + 5);
    C = link(first + 6);
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
  bool position_only;
};

// What forward kinematics of q misses T by, as a twist of the tool in base coordinates; and the Jacobian's columns.
inline double missed(const TrueChain& chain, const Rigid& T, const double* q, double* error, double (*columns)[6]) {
  Rigid frame = chain.links[0];
  Vec3 axis[kMaxJoints], point[kMaxJoints];
  for (int i = 0; i < chain.n; ++i) {
    axis[i] = frame.z;
    point[i] = frame.t;
    frame = joint(frame, q[i], chain.slides[i]) * chain.links[i + 1];
  }
  Vec3 dp = T.t - frame.t, dr = {0, 0, 0};
  if (!chain.position_only) dr = 0.5 * (cross(frame.x, T.x) + cross(frame.y, T.y) + cross(frame.z, T.z));
  double worst = std::sqrt(dot(dp, dp));
  if (!chain.position_only) {
    Vec3 ex = T.x - frame.x, ey = T.y - frame.y, ez = T.z - frame.z;  // sees a half turn, which the cross products miss
    worst = std::fmax(worst, std::sqrt(0.5 * (dot(ex, ex) + dot(ey, ey) + dot(ez, ez))));
  }
  error[0] = dp.x, error[1] = dp.y, error[2] = dp.z, error[3] = dr.x, error[4] = dr.y, error[5] = dr.z;
  for (int i = 0; i < chain.n; ++i) {
    Vec3 v = chain.slides[i] ? axis[i] : cross(axis[i], frame.t - point[i]);
    Vec3 w = chain.slides[i] || chain.position_only ? Vec3{0, 0, 0} : axis[i];
    columns[i][0] = v.x, columns[i][1] = v.y, columns[i][2] = v.z;
    columns[i][3] = w.x, columns[i][4] = w.y, columns[i][5] = w.z;
  }
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
    const double least = damping * trace + 1e-300;
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

// The step dq with (J^T J + damping) dq = J^T e.
inline void damped_step(int n, const double* error, const double (*J)[6], double damping, double* dq) {
  for (int i = 0; i < n; ++i) {
    dq[i] = 0;
    for (int k = 0; k < 6; ++k) dq[i] += J[i][k] * error[k];
  }
  Normal(n, J, damping).solve(dq);
}

// Whether the Jacobian (columns, lengths in units of the arm) is singular within kSingular.
inline bool is_singular(int n, const double (*J)[6]) {
  double largest = 0;
  for (int i = 0; i < n; ++i) {
    double s = 0;
    for (int k = 0; k < 6; ++k) s += J[i][k] * J[i][k];
    largest += s;
  }
  if (!(largest > 0)) return true;
  // pivoted QR by modified Gram-Schmidt: the last diagonal is within a small factor of the smallest singular value
  double Q[kMaxJoints][6];
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 6; ++k) Q[i][k] = J[i][k];
  bool used[kMaxJoints] = {};
  double last = 0;
  for (int step = 0; step < n; ++step) {
    int best = -1;
    double most = -1;
    for (int i = 0; i < n; ++i) {
      if (used[i]) continue;
      double s = 0;
      for (int k = 0; k < 6; ++k) s += Q[i][k] * Q[i][k];
      if (s > most) most = s, best = i;
    }
    used[best] = true;
    last = most;
    if (!(most > 0)) return true;
    double inv = 1 / most;
    for (int i = 0; i < n; ++i) {
      if (used[i]) continue;
      double s = 0;
      for (int k = 0; k < 6; ++k) s += Q[i][k] * Q[best][k];
      s *= inv;
      for (int k = 0; k < 6; ++k) Q[i][k] -= s * Q[best][k];
    }
  }
  return last <= (3 * kSingular) * (3 * kSingular) * largest;
}

// The distinct verified solutions of one pose.
struct Found {
  int n, most, count = 0;
  double* q;  // most x n
  bool degenerate = false, near_miss = false;
  bool suspect = false;  // a row is nearly singular
};

// Polish a candidate (values in rad and lengths of the arm), verify it, and append it unless it is there already.
inline void offer(const TrueChain& chain, const Rigid& T, const double* candidate, Found& found) {
  int n = chain.n;
  double q[kMaxJoints], error[6], J[kMaxJoints][6];
  for (int i = 0; i < n; ++i) {
    q[i] = candidate[i];
    if (!(std::fabs(q[i]) < 1e6)) return;
  }
  double miss = missed(chain, T, q, error, J);
  if (!(miss < kHopeless)) return;
  double damping = 1e-15;
  for (int i = 0; i < 12 && miss > 4e-15; ++i) {
    double dq[kMaxJoints], trial[kMaxJoints], e2[6], J2[kMaxJoints][6];
    damped_step(n, error, J, damping, dq);
    double largest = 0;
    for (int k = 0; k < n; ++k) largest = std::fmax(largest, std::fabs(dq[k]));
    double shrink = largest > 0.3 ? 0.3 / largest : 1;
    for (int k = 0; k < n; ++k) trial[k] = q[k] + shrink * dq[k];
    double next = missed(chain, T, trial, e2, J2);
    if (next < miss) {
      bool stalled = next > 0.5 * miss && next < 1e-14;
      miss = next;
      for (int k = 0; k < 6; ++k) error[k] = e2[k];
      for (int k = 0; k < n; ++k) {
        q[k] = trial[k];
        for (int r = 0; r < 6; ++r) J[k][r] = J2[k][r];
      }
      damping = std::fmax(damping * 1e-2, 1e-15);
      if (stalled) break;
    } else {
      if (miss < 5e-14 || damping > 1) break;
      damping = damping * 1e3;
    }
  }
  if (!(miss <= kVerified)) {
    if (miss < 1e-9) found.near_miss = true;
    return;
  }
  for (int i = 0; i < n; ++i)
    if (!chain.slides[i]) q[i] = one_turn(q[i]);
  const bool singular = is_singular(n, J);
  for (int s = 0; s < found.count; ++s) {
    double apart = 0, middle[kMaxJoints];
    for (int i = 0; i < n; ++i) {
      double d = q[i] - found.q[s * n + i];
      if (!chain.slides[i]) d = std::remainder(d, 2 * kPi);
      middle[i] = q[i] - 0.5 * d;
      apart = std::fmax(apart, std::fabs(d));
    }
    if (apart < kSame) return;
    // in a flat valley (a family, or a root too shallow for double precision) two candidates are one answer
    if (singular && apart < 0.05 && missed(chain, T, middle, error, J) <= 4e-15 + 2 * miss) {
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
