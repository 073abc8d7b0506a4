// The work of `follow_curve`. Compiled once, for the plainest processor.
#include "chain/curve.hpp"

#include <algorithm>
#include <cmath>

#include "chain/singular_rows.hpp"

namespace pieper {
namespace {

using namespace PIEPER_ISA;

constexpr int kNewtonSteps = 12;
constexpr double kTooFar = 1.0;  // a Newton step that is longer leads elsewhere, rad or lengths
constexpr double kGrow = 1.3;    // by how much a step grows after one that went well
constexpr double kHome = 0.75;   // of a step: so near to where it began a curve is home,
constexpr double kAlong = 0.9;   // if it comes home along itself and not across

struct Follower : Posture {
  Rigid goal;
  SingularRows rows;

  Follower(const PlainChain& chain, const double* T) : Posture(chain), goal(read_rigid(T, length)) {}

  // Newton's method onto the pose within the plane across `direction`; false where it does not get there.
  bool onto(double* q, const double* direction) {
    double e[6];
    std::vector<double> step(n);
    for (int taken = 0;; ++taken) {
      stand(q);
      const double size = missing(goal, e);
      if (size < kOnCurve) return true;
      if (taken == kNewtonSteps || !(size < INFINITY)) return false;
      rows.take(*this, e, direction);
      rows.shortest(kFollowWeakest, step.data());
      if (!(size_of(step.data(), n) <= kTooFar)) return false;
      for (int k = 0; k < n; ++k) q[k] += step[k];
    }
  }

  // The free direction at q nearest to the one of travel: where two curves cross straight on.
  void tangent(const double* q, const double* travel, double* out) {
    stand(q);
    rows.take(*this, nullptr, nullptr);
    int order[6] = {0, 1, 2, 3, 4, 5};
    double s[6];
    for (int i = 0; i < 6; ++i) s[i] = size_of(rows.row(i), n);
    std::sort(order, order + 6, [&](int a, int b) { return s[a] > s[b]; });
    // of six joints or fewer the weakest direction is the curve's, however strong
    const int ways = std::min(n, 6);
    double free = kFollowFree * s[order[0]];
    if (n <= 6) free = std::fmax(free, s[order[ways - 1]] * (1 + kFollowAlike));
    std::copy(travel, travel + n, out);
    for (int i = 0; i < ways; ++i) {
      if (s[order[i]] <= free) break;
      const double* row = rows.row(order[i]);
      const double part = dot_of(row, out, n) / (s[order[i]] * s[order[i]]);
      for (int k = 0; k < n; ++k) out[k] -= part * row[k];
    }
    const double size = size_of(out, n);
    if (size > kFollowLost)
      for (int k = 0; k < n; ++k) out[k] /= size;
    else std::copy(travel, travel + n, out);
  }

  // On which side of a crossing the curve is that goes along `along` where the arm stands: of seven joints the sign of the
  // determinant of the Jacobian with it beneath, which one curve keeps and what goes straight on at a crossing changes. Zero
  // where another direction is free.
  int side(const double* along) {
    if (n != 7) return 0;
    double A[7][7];
    for (int k = 0; k < 7; ++k) {
      double moved[6];
      column(k, moved);
      for (int i = 0; i < 6; ++i) A[k][i] = moved[i];
      A[k][6] = along[k];
    }
    int sign = 1;
    double most = 0, least = INFINITY;
    for (int i = 0; i < 7; ++i) {
      int pivot = i;
      for (int j = i + 1; j < 7; ++j)
        if (std::fabs(A[j][i]) > std::fabs(A[pivot][i])) pivot = j;
      const double size = std::fabs(A[pivot][i]);
      most = std::fmax(most, size), least = std::fmin(least, size);
      if (!(least > kFollowFree * most)) return 0;
      if (pivot != i) std::swap(A[pivot], A[i]), sign = -sign;
      if (A[i][i] < 0) sign = -sign;
      for (int j = i + 1; j < 7; ++j) {
        const double part = A[j][i] / A[i][i];
        for (int k = i; k < 7; ++k) A[j][k] -= part * A[i][k];
      }
    }
    return sign;
  }

  double way(double to, double from, int k) const {
    const double gap = to - from;
    return slides[k] ? gap : gap - kTwoPi * std::floor((gap + kPi) / kTwoPi);
  }
};

}  // namespace

bool follow_curve(const PlainChain& chain, const double* T, const double* q, const double* direction,
                  const Following& how, std::vector<double>& points) {
  Follower arm(chain, T);
  const int n = chain.n;
  std::vector<double> first(n), here(n), ahead(n), along(direction, direction + n), next(n), move(n);
  for (int k = 0; k < n; ++k) first[k] = here[k] = q[k] / chain.unit(k);
  points.assign(q, q + n);
  const auto keep = [&](const std::vector<double>& at) {
    for (int k = 0; k < n; ++k) points.push_back(at[k] * chain.unit(k));
  };
  double step = how.step / 2, gone = 0;
  arm.stand(first.data());
  int side = arm.side(direction);
  for (int count = 1; count < how.most_steps;) {
    for (int k = 0; k < n; ++k) ahead[k] = here[k] + step * along[k];
    bool good = arm.onto(ahead.data(), along.data());
    for (int k = 0; k < n; ++k) move[k] = ahead[k] - here[k];
    const double went = size_of(move.data(), n);
    good = good && dot_of(move.data(), along.data(), n) > how.straight * went;
    if (!good) {
      step /= 2;
      if (step < kFollowShortest) return false;
      continue;
    }
    arm.tangent(ahead.data(), along.data(), next.data());
    const int there = arm.side(next.data());
    if (there * side < 0 && step > kFollowCrossing) {
      // another curve passes, or crosses: only what does so within next to nothing is gone straight across
      step /= 2;
      continue;
    }
    if (there) side = there;
    gone += went;
    keep(ahead), ++count;
    for (int k = 0; k < n; ++k) move[k] = arm.way(ahead[k], first[k], k);
    const double size = size_of(move.data(), n);
    if (gone > 3 * step && size < kHome * step &&
        (size < kFollowHome || std::fabs(dot_of(move.data(), next.data(), n)) > kAlong * size)) {
      // home: the first point once more, as many turns on as the curve went round
      double* last = &points[points.size() - n];
      for (int k = 0; k < n; ++k)
        last[k] = chain.prismatic[k] ? q[k] : q[k] + kTwoPi * std::round((ahead[k] - first[k]) / kTwoPi);
      return true;
    }
    here = ahead, along = next;
    step = std::fmin(how.step, step * kGrow);
  }
  return false;
}

}  // namespace pieper
