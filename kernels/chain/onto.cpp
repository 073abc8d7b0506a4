// The work of `onto`. Compiled once, for the plainest processor.
#include "chain/onto.hpp"

#include "chain/singular_rows.hpp"

namespace pieper {

using namespace PIEPER_ISA;
namespace {

// The Jacobian of an arm, or its transpose where joints are to spare, made a triangle by reflections (Householder).
class Triangle {
 public:
  explicit Triangle(int n) : n_(n), long_(n > 6 ? n : 6), few_(n > 6 ? 6 : n), columns_(long_ * few_), rest_(long_) {}

  // The shortest step that misses least; a tenth of what singular values cost. False where some direction may be weaker
  // than `weakest` of the strongest.
  bool step(const Posture& arm, const double* e, double weakest, double* out) {
    const bool spare = n_ > 6;
    if (!spare) std::copy(e, e + 6, rest_.begin());
    if (!(part_of_weakest(arm) > weakest)) return false;
    if (!spare) {
      for (int c = 0; c < few_; ++c) reflect(c, rest_.data());
      for (int i = few_ - 1; i >= 0; --i) {
        double left = rest_[i];
        for (int k = i + 1; k < few_; ++k) left -= column(k)[i] * out[k];
        out[i] = left / diagonal_[i];
      }
      return true;
    }
    std::fill(rest_.begin(), rest_.end(), 0.0);
    for (int i = 0; i < few_; ++i) {
      double left = e[i];
      for (int k = 0; k < i; ++k) left -= column(i)[k] * rest_[k];
      rest_[i] = left / diagonal_[i];
    }
    for (int c = few_ - 1; c >= 0; --c) reflect(c, rest_.data());
    std::copy(rest_.begin(), rest_.end(), out);
    return true;
  }

  // The weakest direction is at least this part of the strongest: by the sizes of the triangle and of its inverse.
  double part_of_weakest(const Posture& arm) {
    for (int k = 0; k < n_; ++k) {
      double moved[6];
      arm.column(k, moved);
      for (int i = 0; i < 6; ++i) columns_[n_ > 6 ? long_ * i + k : long_ * k + i] = moved[i];
    }
    double all = 0, inverse = 0;
    for (int c = 0; c < few_; ++c) {
      double* v = column(c);
      const double norm = size_of(v + c, long_ - c);
      if (!(norm > 0)) return 0;
      diagonal_[c] = v[c] > 0 ? -norm : norm;
      v[c] -= diagonal_[c], half_[c] = -diagonal_[c] * v[c];
      for (int d = c + 1; d < few_; ++d) reflect(c, column(d));
      all += norm * norm + dot_of(v, v, c);
      double y[6];
      for (int i = c; i >= 0; --i) {
        double left = i == c;
        for (int k = i + 1; k <= c; ++k) left -= column(k)[i] * y[k];
        y[i] = left / diagonal_[i], inverse += y[i] * y[i];
      }
    }
    return 1 / std::sqrt(all * inverse);
  }

 private:
  double* column(int c) { return &columns_[long_ * c]; }
  void reflect(int c, double* x) {
    const double* v = column(c);
    const double part = dot_of(v + c, x + c, long_ - c) / half_[c];
    for (int k = c; k < long_; ++k) x[k] -= part * v[k];
  }

  int n_, long_, few_;
  // of each column what lies above the diagonal of the triangle, then its reflector, of which half the square is kept
  std::vector<double> columns_, rest_;
  double diagonal_[6], half_[6];
};

}  // namespace

void onto(const PlainChain& chain, const Steps& how, long count, const double* T, bool one_pose, double* q,
          double* left) {
  Posture arm(chain);
  SingularRows rows;
  const int n = chain.n;
  std::vector<double> at(n), best(n), step(n);
  Triangle triangle(n);
  const double weakest = std::fmax(kNewtonRegular, how.cutoff);
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
      if (!triangle.step(arm, e, weakest, step.data())) {
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

void parts_of_weakest(const PlainChain& chain, long count, const double* q, double* out) {
  Posture arm(chain);
  Triangle triangle(chain.n);
  std::vector<double> at(chain.n);
  for (long i = 0; i < count; ++i, q += chain.n) {
    for (int k = 0; k < chain.n; ++k) at[k] = q[k] / chain.unit(k);
    arm.stand(at.data());
    out[i] = triangle.part_of_weakest(arm);
  }
}

}  // namespace pieper
