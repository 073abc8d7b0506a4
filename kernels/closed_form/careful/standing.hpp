// Nearly singular rows of a pose: which stand alone for certain, and which need the careful look at families and merged roots.
// Scalar.
#pragma once

#include "closed_form/careful/closing.hpp"
#include "dispatch/geometry.hpp"

namespace pieper::PIEPER_ISA::closed_form {

// The null direction of a nearly singular row: how the pose is missed when moving along it.
struct NullDirection {
  double v[kMaxJoints], u[6];   // unit vectors: J v = sigma u
  double sigma, second, scale;  // the two smallest singular values; the Frobenius norm of J

  NullDirection(int n, const double (*J)[6]) {
    const Normal normal(n, J, kClosedDamping);
    scale = std::sqrt(normal.trace);
    double w[kMaxJoints];
    for (int i = 0; i < n; ++i) v[i] = 1 + 0.3 * i, w[i] = 1 - 0.37 * i;
    for (int i = 0; i < 4; ++i) normal.solve(v), make_unit(n, v);
    for (int i = 0; i < 3; ++i) {
      double along = 0;
      for (int k = 0; k < n; ++k) along += v[k] * w[k];
      for (int k = 0; k < n; ++k) w[k] -= along * v[k];
      make_unit(n, w);
      second = times(n, J, w, u);
      normal.solve(w);
    }
    sigma = times(n, J, v, u);
    for (double& x : u) x /= std::fmax(sigma, kTiny);
  }
  static void make_unit(int n, double* x) {
    double s = 0;
    for (int i = 0; i < n; ++i) s += x[i] * x[i];
    s = 1 / std::sqrt(std::fmax(s, kTiny));
    for (int i = 0; i < n; ++i) x[i] *= s;
  }
  static double times(int n, const double (*J)[6], const double* x, double* out) {
    double s = 0;
    for (int k = 0; k < 6; ++k) {
      out[k] = 0;
      for (int i = 0; i < n; ++i) out[k] += J[i][k] * x[i];
      s += out[k] * out[k];
    }
    return std::sqrt(s);
  }
};

// By how much the pose is missed, along u, at t on the curve through q that leaves in the null direction and is otherwise
// corrected as well as can be. False where the correction does not settle.
inline bool missed_along(const TrueChain& chain, const Rigid& T, const double* q, const NullDirection& d, double t,
                         double& miss) {
  const int n = chain.n;
  double p[kMaxJoints], error[6], J[kMaxJoints][6];
  for (int i = 0; i < n; ++i) p[i] = q[i] + t * d.v[i];
  for (int step = 0; step < 8; ++step) {
    missed(chain, T, p, error, J);
    double dq[kMaxJoints], largest = 0, along_u = 0;
    for (int k = 0; k < 6; ++k) along_u += error[k] * d.u[k];
    for (int k = 0; k < 6; ++k) error[k] -= along_u * d.u[k];
    for (int i = 0; i < n; ++i) {  // neither along v nor against u: what is left is well conditioned
      double lean = 0;
      for (int k = 0; k < 6; ++k) lean += J[i][k] * d.u[k];
      for (int k = 0; k < 6; ++k) J[i][k] += (d.v[i] - lean) * d.u[k];
    }
    damped_step(n, error, J, kAloneDamping, INFINITY, dq);
    for (int i = 0; i < n; ++i) p[i] += dq[i], largest = std::fmax(largest, std::fabs(dq[i]));
    miss = -along_u;
    if (largest < kAloneSettled) return true;
    if (largest > 1) return false;
  }
  return false;
}

// Whether a nearly singular row is a solution by itself for certain: no self-motion passes it, and its twin, if it has one, is
// another of the rows.
inline bool stands_alone(const TrueChain& chain, const Rigid& T, const Found& found, int row, const double (*J)[6]) {
  const int n = found.n;
  const double* q = found.q + row * n;
  const NullDirection d(n, J);
  if (!(d.sigma > kAloneSigma * d.scale) || d.second < 30 * d.sigma || d.second < kAloneSecond * d.scale) return false;
  // g(t) = sigma t + ... : while it keeps that slope nothing else is near
  double ahead, behind;
  if (!missed_along(chain, T, q, d, kAloneStep, ahead) || !missed_along(chain, T, q, d, -kAloneStep, behind))
    return false;
  const double least = 0.25 * kAloneStep * d.sigma;
  if (ahead >= least && -behind >= least && least > kAloneSigma) {
    if (std::fmax(ahead, -behind) > kAloneHeld) return true;
    double farther;
    return (missed_along(chain, T, q, d, kAloneFarther, farther) && std::fabs(farther) > kAloneHeld) ||
           (missed_along(chain, T, q, d, -kAloneFarther, farther) && std::fabs(farther) > kAloneHeld);
  }
  // a fold: g(t) = sigma t + kappa t^2 / 2 has its other root at -2 sigma / kappa
  const double kappa = (ahead + behind) / (kAloneStep * kAloneStep);
  if (!(std::fabs(kappa) > kAloneBent * d.scale)) return false;
  const double twin = 2 * d.sigma / std::fabs(kappa);
  // apart for a reader, and with a ridge between them that rounding cannot hide
  if (!(twin > 2 * kAloneTwins && d.sigma * twin > kAloneRidge)) return false;
  for (int s = 0; s < found.count; ++s) {
    if (s == row) continue;
    double apart = 0;
    for (int i = 0; i < n; ++i) {
      double gap = q[i] - found.q[s * n + i];
      if (!chain.slides[i]) gap = std::remainder(gap, 2 * kPi);
      apart += gap * gap;
    }
    apart = std::sqrt(apart);
    if (apart > 0.5 * twin && apart < 2 * twin) return true;
  }
  return false;
}

// Whether the rows of a pose need no look at families and merged roots.
inline bool all_stand_alone(const TrueChain& chain, const Rigid& T, const Found& found) {
  for (int s = 0; s < found.count; ++s) {
    double error[6], J[kMaxJoints][6];
    missed(chain, T, found.q + s * found.n, error, J);
    if (is_singular(found.n, J) && !stands_alone(chain, T, found, s, J)) return false;
  }
  return true;
}

// Whether the rows of a pose are all there and all clear.
inline bool settled(const TrueChain& chain, const Rigid& T, const Found& found) {
  return found.count > 0 && found.count % 2 == 0 && !found.degenerate &&
         (!found.suspect || all_stand_alone(chain, T, found));
}

// Write one pose's solutions into the caller's slots, zeros where there is none.
inline void write_out(const TrueChain& chain, const Rigid& T, const Found& found, double* q, std::uint8_t* valid,
                      std::uint8_t* flag) {
  int n = chain.n;
  for (int s = 0; s < found.most; ++s) {
    bool ok = s < found.count;
    valid[s] = ok;
    for (int i = 0; i < n; ++i) q[s * n + i] = ok ? found.q[s * n + i] * (chain.slides[i] ? chain.length : 1.0) : 0.0;
  }
  const bool look = found.count ? !settled(chain, T, found) : found.degenerate || found.suspect;
  *flag = (look ? kDegenerate : 0) | (found.near_miss && found.count == 0 ? kUncertain : 0) |
          (found.count == 0 ? kOutOfReach | kEdge : 0);
}

}  // namespace pieper::PIEPER_ISA::closed_form
