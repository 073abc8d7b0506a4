// The work of `onto`. Compiled once, for the plainest processor.
#include "chain/onto.hpp"

#include "chain/singular_rows.hpp"

namespace pieper {

using namespace PIEPER_ISA;
namespace {

// The shortest step J^T (J J^T)^-1 e. False where a row of J is nearly a sum of others.
bool regular_step(const Posture& arm, const double* e, double regular, std::vector<double>& J, double* step) {
  const int n = arm.n;
  double A[6][6], y[6];
  for (int k = 0; k < n; ++k) arm.column(k, &J[6 * k]);
  for (int i = 0; i < 6; ++i) {
    y[i] = e[i];
    for (int j = 0; j <= i; ++j) {
      A[i][j] = 0;
      for (int k = 0; k < n; ++k) A[i][j] += J[6 * k + i] * J[6 * k + j];
    }
  }
  for (int i = 0; i < 6; ++i) {
    const double whole = A[i][i];
    for (int j = 0; j <= i; ++j) {
      for (int c = 0; c < j; ++c) A[i][j] -= A[i][c] * A[j][c];
      if (j < i) A[i][j] /= A[j][j];
    }
    if (!(A[i][i] > regular * whole)) return false;
    A[i][i] = std::sqrt(A[i][i]);
    for (int c = 0; c < i; ++c) y[i] -= A[i][c] * y[c];
    y[i] /= A[i][i];
  }
  for (int i = 5; i >= 0; --i) {
    for (int c = i + 1; c < 6; ++c) y[i] -= A[c][i] * y[c];
    y[i] /= A[i][i];
  }
  for (int k = 0; k < n; ++k) step[k] = dot_of(&J[6 * k], y, 6);
  return true;
}

}  // namespace

void onto(const PlainChain& chain, const Steps& how, long count, const double* T, bool one_pose, double* q,
          double* left) {
  Posture arm(chain);
  SingularRows rows;
  const int n = chain.n;
  std::vector<double> at(n), best(n), step(n), J(6 * n);
  for (long i = 0; i < count; ++i, q += n) {
    const Rigid goal = read_rigid(one_pose ? T : T + 16 * i, chain.length);
    for (int k = 0; k < n; ++k) at[k] = best[k] = q[k] / chain.unit(k);
    double least = INFINITY;
    bool better = false;
    for (int taken = 0, stalled = 0;; ++taken) {
      double e[6];
      arm.stand(at.data());
      const double size = arm.missing(goal, e);
      stalled = size > 0.5 * least ? stalled + 1 : 0;
      if (size < least) least = size, best = at, better = taken > 0;
      // rounding is reached, or what is missed has stopped shrinking: at a double root it shrinks by four a step
      if (!(size > kNewtonDone && size < INFINITY) || (least <= kNewtonStalls && stalled >= 3) || taken == how.most)
        break;
      if (!(how.regular < 1) || !regular_step(arm, e, how.regular, J, step.data())) {
        rows.take(arm, e, nullptr);
        rows.shortest(how.cutoff, step.data());
      }
      const double length = size_of(step.data(), n), shrink = std::fmin(1.0, how.longest / std::fmax(length, kTiny));
      if (length < kNewtonStill) break;
      for (int k = 0; k < n; ++k) at[k] += shrink * step[k];
    }
    left[i] = least;
    if (!better) continue;  // as it was given, to the last digit
    for (int k = 0; k < n; ++k) q[k] = best[k] * chain.unit(k);
  }
}

}  // namespace pieper
