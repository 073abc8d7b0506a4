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
constexpr double kGrow = 1.3;    // by how much a step grows after one that went well,
constexpr double kLeap = 3.0;    // and after one as good as straight:
                                 // the cosine between the tangents at its ends is above kFollowStraight,
constexpr double kTurned = 0.8;  // and below this one the step was too long for how the curve bends
constexpr double kHome = 0.75;   // of a step: so near to where it began a curve is home,
constexpr double kAlong = 0.9;   // if it comes home along itself and not across
constexpr double kBeside = 0.3;  // of a step: so far beside it a curve's beginning may be passed by that step,
constexpr double kPast = 1.1;    // and so far ahead

// On which side of others a curve of seven joints is: the signs of the pivots when the Jacobian with the curve's way
// beneath is eliminated from its largest entries on, and their order. One curve keeps them, and the determinant's sign
// with them. What goes straight on where curves cross changes the last; where two directions weaken at once, as with
// shoulder and wrist all but in line, it changes the last two, and the determinant's sign is the same.
struct Sides {
  int row[7], entry[7];
  bool negative[7];
  bool known = false;  // not where another direction is free
};

struct Follower : Posture {
  Rigid goal;
  SingularRows rows;
  int order[6];
  double strength[6];

  Follower(const PlainChain& chain, const double* T) : Posture(chain), goal(read_rigid(T, length)) {}

  // One direction is free and no more, but where curves cross.
  bool one_free() const { return n == 7; }

  // Newton's method onto the pose within the plane across `direction`; false where it does not get there. Where the weakest
  // direction is weak what is missed to rounding is far off in the joints: there it goes on as long as that shrinks.
  bool onto(double* q, const double* direction) {
    double e[6], before = INFINITY;
    std::vector<double> step(n);
    for (int taken = 0;; ++taken) {
      stand(q);
      const double size = missing(goal, e);
      if (size < kOnCurve &&
          (!one_free() || size < kFollowExact || size > before / 2 || (taken > 0 && rows.weakest() > kFollowWeak)))
        return true;
      if (taken == kNewtonSteps) return size < kOnCurve;
      if (!(size < INFINITY)) return false;
      before = size;
      rows.take(*this, e, direction);
      rows.shortest(one_free() ? kFollowNone : kFollowWeakest, step.data());
      if (!(size_of(step.data(), n) <= kTooFar)) return false;
      for (int k = 0; k < n; ++k) q[k] += step[k];
    }
  }

  // The free direction at q nearest to the one of travel: where two curves cross straight on. Returns what part of the strongest
  // direction the weakest that is not free is.
  double tangent(const double* q, const double* travel, double* out) {
    stand(q);
    rows.take(*this, nullptr, nullptr);
    for (int i = 0; i < 6; ++i) order[i] = i, strength[i] = size_of(rows.row(i), n);
    std::sort(order, order + 6, [&](int a, int b) { return strength[a] > strength[b]; });
    // of six joints or fewer the weakest direction is the curve's, however strong
    const double most = strength[order[0]], weakest = strength[order[std::min(n, 6) - 1]];
    double free = (one_free() ? kFollowNone : kFollowFree) * most;
    if (n <= 6) free = std::fmax(free, weakest * (1 + kFollowAlike));
    left_free(free, travel, out);
    return weakest / most;
  }

  // The same where the weakest direction is free too, as it is where curves cross.
  void straight_on(const double* travel, double* out) { left_free(strength[order[5]], travel, out); }

  // What is left of the way of travel without the directions that are stronger than `free`.
  void left_free(double free, const double* travel, double* out) {
    std::copy(travel, travel + n, out);
    for (int i = 0; i < std::min(n, 6); ++i) {
      const double s = strength[order[i]];
      if (s <= free) break;
      const double* row = rows.row(order[i]);
      const double part = dot_of(row, out, n) / (s * s);
      for (int k = 0; k < n; ++k) out[k] -= part * row[k];
    }
    const double size = size_of(out, n);
    if (size > kFollowLost)
      for (int k = 0; k < n; ++k) out[k] /= size;
    else std::copy(travel, travel + n, out);
  }

  // The Jacobian with the way `along` beneath, a joint a row, where the arm stands.
  void with_beneath(const double* along, double A[7][7]) const {
    for (int k = 0; k < 7; ++k) {
      double moved[6];
      column(k, moved);
      for (int i = 0; i < 6; ++i) A[k][i] = moved[i];
      A[k][6] = along[k];
    }
  }

  // On which side of others the curve is that goes along `along` where the arm stands.
  Sides sides(const double* along) const {
    Sides out;
    if (!one_free()) return out;
    double A[7][7];
    with_beneath(along, A);
    double most = 0;
    for (int i = 0; i < 7; ++i) out.row[i] = out.entry[i] = i;
    for (int i = 0; i < 7; ++i) {
      int row = i, entry = i;
      for (int j = i; j < 7; ++j)
        for (int k = i; k < 7; ++k)
          if (std::fabs(A[j][k]) > std::fabs(A[row][entry])) row = j, entry = k;
      most = std::fmax(most, std::fabs(A[row][entry]));
      if (!(std::fabs(A[row][entry]) > kFollowNone * most)) return out;
      std::swap(A[row], A[i]), std::swap(out.row[row], out.row[i]), std::swap(out.entry[entry], out.entry[i]);
      for (int j = 0; j < 7; ++j) std::swap(A[j][entry], A[j][i]);
      out.negative[i] = A[i][i] < 0;
      eliminate(A, i);
    }
    out.known = true;
    return out;
  }

  // Whether the curve that goes along `along` where the arm stands is on the sides that one had a step before.
  bool keeps(const Sides& before, const double* along) const {
    double whole[7][7], A[7][7];
    with_beneath(along, whole);
    for (int j = 0; j < 7; ++j)
      for (int k = 0; k < 7; ++k) A[j][k] = whole[before.row[j]][before.entry[k]];
    for (int i = 0; i < 7; ++i) {
      if (!(before.negative[i] ? A[i][i] < 0 : A[i][i] > 0)) return false;
      eliminate(A, i);
    }
    return true;
  }

  static void eliminate(double A[7][7], int i) {
    for (int j = i + 1; j < 7; ++j) {
      const double part = A[j][i] / A[i][i];
      for (int k = i; k < 7; ++k) A[j][k] -= part * A[i][k];
    }
  }

  double way(double to, double from, int k) const {
    const double gap = to - from;
    return slides[k] ? gap : gap - kTwoPi * std::floor((gap + kPi) / kTwoPi);
  }

  // Whether the curve that goes along `along` from `here` to `ahead` passes its beginning `first` on the way. `sides` are
  // those on which it is here.
  bool passes(const double* here, const double* ahead, const double* along, const double* first, const Sides& sides) {
    std::vector<double> gap(n), on(here, here + n);
    double went = 0;
    for (int k = 0; k < n; ++k) gap[k] = way(first[k], here[k], k), went += (ahead[k] - here[k]) * along[k];
    const double forth = dot_of(gap.data(), along, n);
    if (!(forth > 0 && forth < kPast * went)) return false;
    double beside = 0;
    for (int k = 0; k < n; ++k) beside += (gap[k] - forth * along[k]) * (gap[k] - forth * along[k]);
    if (!(std::sqrt(beside) < kBeside * went)) return false;
    // another curve may pass as near: only this one meets the plane across it there in the beginning itself
    for (int k = 0; k < n; ++k) on[k] += gap[k];
    std::vector<double> there(on);
    const double part = std::fmin(forth / went, 1.0);
    for (int k = 0; k < n; ++k) on[k] = here[k] + part * (ahead[k] - here[k]);
    double off = 0;
    for (int k = 0; k < n; ++k) off += (there[k] - on[k]) * along[k];
    for (int k = 0; k < n; ++k) on[k] += off * along[k];
    if (!onto(on.data(), along) || (sides.known && !keeps(sides, along))) return false;
    double size = 0;
    for (int k = 0; k < n; ++k) size += (on[k] - there[k]) * (on[k] - there[k]);
    return std::sqrt(size) < kFollowSame;
  }
};

}  // namespace

bool follow_curve(const PlainChain& chain, const double* T, const double* q, const double* direction,
                  const Following& how, std::vector<double>& points) {
  Follower arm(chain, T);
  const int n = chain.n;
  const bool one_free = arm.one_free();
  std::vector<double> first(n), here(n), ahead(n), along(direction, direction + n), next(n), move(n);
  for (int k = 0; k < n; ++k) first[k] = here[k] = q[k] / chain.unit(k);
  points.assign(q, q + n);
  const auto keep = [&](const std::vector<double>& at) {
    for (int k = 0; k < n; ++k) points.push_back(at[k] * chain.unit(k));
  };
  // home: the first point once more, as many turns on as the curve went round
  const auto close = [&] {
    double* last = &points[points.size() - n];
    for (int k = 0; k < n; ++k)
      last[k] = chain.prismatic[k] ? q[k] : q[k] + kTwoPi * std::round((ahead[k] - first[k]) / kTwoPi);
    return true;
  };
  const double shortest = one_free ? kFollowFinest : kFollowShortest;
  double step = how.step / 2, gone = 0;
  double weakest = arm.tangent(first.data(), direction, next.data());
  Sides sides = arm.sides(direction);
  bool crossing = false;  // here so near to where curves cross that rounding hides which way this one goes
  for (int count = 1; count < how.most_steps;) {
    for (int k = 0; k < n; ++k) ahead[k] = here[k] + step * along[k];
    bool good = arm.onto(ahead.data(), along.data());
    for (int k = 0; k < n; ++k) move[k] = ahead[k] - here[k];
    const double went = size_of(move.data(), n);
    good = good && dot_of(move.data(), along.data(), n) > how.straight * went;
    double turned = 1, there = 0, bend = 0;
    Sides now;
    bool hidden = false, across = false;
    if (good) {
      there = arm.tangent(ahead.data(), along.data(), next.data());
      if (one_free) {
        turned = dot_of(next.data(), along.data(), n);
        now = arm.sides(next.data());
        across = !crossing && now.known && sides.known && !arm.keeps(sides, next.data());
        // the weakest direction fades and grows in proportion to the way to a crossing, and rounding blurs the points there
        bend = (across ? there + weakest : std::fabs(there - weakest)) / went;
        hidden = there * there < kFollowBlur * bend;
        if (hidden) arm.straight_on(along.data(), next.data());
        good = hidden || turned > kTurned;
      }
    }
    if (good && (across || hidden)) {
      // another curve passes, or crosses: only what does so within next to nothing is gone straight across
      good = step * step * bend < kFollowAcross * kFollowBlur;
    }
    if (!good) {
      step /= 2;
      if (step < shortest) return false;
      continue;
    }
    gone += went;
    keep(ahead), ++count;
    if (one_free) {
      const Sides on = crossing ? Sides() : sides;
      if (count > 3 && arm.passes(here.data(), ahead.data(), along.data(), first.data(), on)) return close();
    } else {
      for (int k = 0; k < n; ++k) move[k] = arm.way(ahead[k], first[k], k);
      const double size = size_of(move.data(), n);
      if (gone > 3 * step && size < kHome * step &&
          (size < kFollowHome || std::fabs(dot_of(move.data(), next.data(), n)) > kAlong * size))
        return close();
    }
    here = ahead, along = next, crossing = hidden;
    if (hidden) {
      step = std::fmin(how.step, std::fmax(step, kLeap * std::sqrt(kFollowBlur / bend)));
      continue;
    }
    weakest = there;
    if (now.known) sides = now;
    step = std::fmin(how.step, step * (one_free && turned > kFollowStraight ? kLeap : kGrow));
  }
  return false;
}

}  // namespace pieper
