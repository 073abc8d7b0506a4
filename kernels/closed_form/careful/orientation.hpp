// Three revolute axes through one point make a rotation: R = Z1 M1 Z2 M2 Z3 (an arm of three such axes, and every spherical wrist).
//
// With M = Rz(before) Rx(twist) Rz(after) the middle angle obeys the spherical law of cosines
//     R33 = cos(a1) cos(a2) - sin(a1) sin(a2) cos(t2),
// solved by the half-angle formula in products of sines, which keeps full accuracy at the wrist's singularity. Two solutions; none when the
// twists cannot reach the direction; where axes 1 and 3 line up only the sum of the outer angles is determined. Scalar.
#pragma once

#include "closed_form/careful/standing.hpp"

namespace pieper::PIEPER_ISA::closed_form {

struct Wrist {
  double before[2], twist[2], after[2];
};

// From the rotation parts of the two inner links.
inline Wrist read_wrist(const Rigid& M1, const Rigid& M2) {
  Wrist w;
  const Rigid* M[2] = {&M1, &M2};
  for (int k = 0; k < 2; ++k) {
    const Rigid& A = *M[k];
    double s = std::hypot(A.z.x, A.z.y);
    w.twist[k] = std::atan2(s, A.z.z);
    w.before[k] = std::atan2(A.z.x, -A.z.y);  // third column is (sin b sin t, -cos b sin t, cos t)
    w.after[k] = std::atan2(A.x.z, A.y.z);    // third row is (sin t sin a, sin t cos a, cos t)
  }
  return w;
}

// Rx by a twist applied to the columns: A * Rx.
inline Rigid twisted(const Rigid& A, double angle) {
  double c = std::cos(angle), s = std::sin(angle);
  return {A.x, c * A.y + s * A.z, c * A.z - s * A.y, A.t};
}

// At most two angle triples; `lined_up` says that axes 1 and 3 coincide within rounding.
inline int solve_wrist(const Wrist& w, const Rigid& R, double (*q)[3], bool& lined_up) {
  double side = std::sqrt(R.z.x * R.z.x + R.z.y * R.z.y), tilt = std::atan2(side, R.z.z);
  double sum = w.twist[0] + w.twist[1], difference = w.twist[0] - w.twist[1];
  double up = std::sin(0.5 * (sum + tilt)) * std::sin(0.5 * (sum - tilt));
  double down = std::sin(0.5 * (tilt + difference)) * std::sin(0.5 * (tilt - difference));
  lined_up = false;
  if (up < 0) {
    if (up < -kWristReach) return 0;
    up = 0;
  }
  if (down < 0) {
    if (down < -kWristReach) return 0;
    down = 0;
  }
  double middle = 2 * std::atan2(std::sqrt(up), std::sqrt(down));
  lined_up = side < kWristLinedUp;
  int count = lined_up || middle == 0 || middle >= 2 * kPi ? 1 : 2;
  double s1 = std::sin(w.twist[0]), c1 = std::cos(w.twist[0]), s2 = std::sin(w.twist[1]), c2 = std::cos(w.twist[1]);
  for (int k = 0; k < count; ++k) {
    double t2 = k ? -middle : middle;
    double vx = s2 * std::sin(t2), vy = -c1 * s2 * std::cos(t2) - s1 * c2;
    double t1 = lined_up ? w.before[0] : std::atan2(R.z.y * vx - R.z.x * vy, R.z.x * vx + R.z.y * vy);
    Rigid K = twisted(joint(twisted(joint(kNoMotion, t1, false), w.twist[0]), t2, false), w.twist[1]);
    // K^T R is a turn about z up to rounding
    double t3 = std::atan2(dot(K.y, R.x) - dot(K.x, R.y), dot(K.x, R.x) + dot(K.y, R.y));
    q[k][0] = t1 - w.before[0];
    q[k][1] = t2 - w.after[0] - w.before[1];
    q[k][2] = t3 - w.after[1];
  }
  return count;
}

}  // namespace pieper::PIEPER_ISA::closed_form
