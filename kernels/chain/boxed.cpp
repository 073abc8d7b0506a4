// The work of `descend`. Compiled once, for the plainest processor.
#include "chain/boxed.hpp"

#include <algorithm>
#include <cmath>

#include "chain/posture.hpp"

namespace pieper {
namespace {

using namespace PIEPER_ISA;

// Solves A y = e (6x6, symmetric, hardly positive where directions are lost) by elimination with the largest pivot.
void solved(double (*A)[6], double* y) {
  for (int j = 0; j < 6; ++j) {
    int best = j;
    for (int i = j + 1; i < 6; ++i)
      if (std::fabs(A[i][j]) > std::fabs(A[best][j])) best = i;
    if (best != j) std::swap(y[j], y[best]), std::swap_ranges(A[j], A[j] + 6, A[best]);
    const double pivot = A[j][j] == 0 ? kTiny : A[j][j];
    for (int i = j + 1; i < 6; ++i) {
      const double part = A[i][j] / pivot;
      for (int k = j + 1; k < 6; ++k) A[i][k] -= part * A[j][k];
      y[i] -= part * y[j];
    }
    A[j][j] = pivot;
  }
  for (int j = 5; j >= 0; --j) {
    for (int k = j + 1; k < 6; ++k) y[j] -= A[j][k] * y[k];
    y[j] /= A[j][j];
  }
}

struct Boxed : Posture {
  const Descent& how;
  std::vector<double> J, at, tried, step, low, high;  // J: n x 6, a column of the Jacobian a row
  std::vector<char> free;

  Boxed(const PlainChain& chain, const Descent& as)
      : Posture(chain), how(as), J(6 * n), at(n), tried(n), step(n), low(n), high(n), free(n) {}

  // The damped step towards e of the joints that are free.
  void towards(const double* e, double rate) {
    double A[6][6] = {}, y[6];
    for (int k = 0; k < n; ++k) {
      if (!free[k]) continue;
      const double* c = &J[6 * k];
      for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) A[i][j] += c[i] * c[j];
    }
    for (int i = 0; i < 6; ++i) {
      A[i][i] += rate, y[i] = e[i];
      for (int j = 0; j < i; ++j) A[i][j] = A[j][i];
    }
    solved(A, y);
    double size = 0;
    for (int k = 0; k < n; ++k) {
      const double* c = &J[6 * k];
      step[k] = 0;
      if (!free[k]) continue;
      for (int i = 0; i < 6; ++i) step[k] += c[i] * y[i];
      size += step[k] * step[k];
    }
    const double shrink = std::fmin(1.0, how.longest / std::fmax(std::sqrt(size), kTiny));
    for (double& s : step) s *= shrink;
  }

  // From `tried` on; the best is left in `at`.
  double run(const Rigid& goal) {
    double square = INFINITY, damping = how.first, e[6] = {};
    int idle = 0;
    for (int taken = 0; taken < how.steps; ++taken) {
      double missing_now[6];
      stand(tried.data());
      const double size = missing(goal, missing_now), now = size * size;
      const bool better = now < square;
      idle = better && now < how.left * square ? 0 : idle + 1;
      if (better) {
        at = tried, square = now;
        std::copy(missing_now, missing_now + 6, e);
        for (int k = 0; k < n; ++k) column(k, &J[6 * k]);
      }
      damping = std::fmin(std::fmax(damping * (better ? how.shrink : how.grow), how.least), how.most);
      if (!(square > how.done * how.done && damping < how.most && idle < how.idle)) break;
      const double rate = damping * std::fmin(square, 1.0) + how.weakest;
      std::fill(free.begin(), free.end(), 1);
      for (int again = 0; again < how.again; ++again) {
        towards(e, rate);
        bool stopped = false;
        for (int k = 0; k < n; ++k)
          if (free[k] && ((at[k] <= low[k] && step[k] < 0) || (at[k] >= high[k] && step[k] > 0)))
            free[k] = 0, stopped = true;
        if (!stopped) break;
      }
      for (int k = 0; k < n; ++k) tried[k] = std::fmin(std::fmax(free[k] ? at[k] + step[k] : at[k], low[k]), high[k]);
    }
    return std::sqrt(square);
  }
};

}  // namespace

void descend(const PlainChain& chain, const Descent& how, long count, const double* T, const double* low,
             const double* high, double* q, double* missed) {
  Boxed box(chain, how);
  const int n = chain.n;
  for (long i = 0; i < count; ++i, q += n, low += n, high += n, T += 16) {
    for (int k = 0; k < n; ++k) {
      const double unit = chain.unit(k);
      box.tried[k] = q[k] / unit, box.low[k] = low[k] / unit, box.high[k] = high[k] / unit;
    }
    missed[i] = box.run(read_rigid(T, chain.length));
    // back in its units a joint at a stop is at the stop
    for (int k = 0; k < n; ++k) q[k] = std::fmin(std::fmax(box.at[k] * chain.unit(k), low[k]), high[k]);
  }
}

}  // namespace pieper
