// The work of `onto`. Compiled once, for the plainest processor.
#include "chain/onto.hpp"

#include "chain/singular_rows.hpp"

namespace pieper {

using namespace PIEPER_ISA;

void onto(const PlainChain& chain, const Steps& how, long count, const double* T, bool one_pose, double* q) {
  Posture arm(chain);
  SingularRows rows;
  const int n = chain.n;
  std::vector<double> at(n), best(n), step(n);
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
      rows.take(arm, e, nullptr);
      rows.shortest(how.cutoff, step.data());
      const double length = size_of(step.data(), n), shrink = std::fmin(1.0, how.longest / std::fmax(length, kTiny));
      if (length < kNewtonStill) break;
      for (int k = 0; k < n; ++k) at[k] += shrink * step[k];
    }
    if (!better) continue;  // as it was given, to the last digit
    for (int k = 0; k < n; ++k) q[k] = best[k] * chain.unit(k);
  }
}

}  // namespace pieper
