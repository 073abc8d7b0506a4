// Self-motions that are read off axes: two in one line, and four that are a linkage. Where they are inside limits, and the point
// that stands for each. Scalar; rad and lengths.
#pragma once

#include <algorithm>
#include <vector>

#include "singular/four_bar.hpp"

namespace pieper::PIEPER_ISA {

struct Limits {
  double lower[6], upper[6];  // rad; lengths; infinite where there are none
};
inline Limits no_limits() {
  Limits none;
  for (int i = 0; i < kSix; ++i) none.lower[i] = -INFINITY, none.upper[i] = INFINITY;
  return none;
}

// A value with its angle moved by whole turns as near to `near` as its limits allow.
inline double unwound(double q, double near, double lower, double upper) {
  double turns = std::nearbyint((near - q) / kTwoPi);
  const double least = std::ceil((lower - kLimitSlack - q) / kTwoPi),
               most = std::floor((upper + kLimitSlack - q) / kTwoPi);
  if (least <= most) turns = std::fmin(std::fmax(turns, least), most);
  return q + kTwoPi * turns;
}
// Moves whole turns where only there a value is inside, and says whether it is.
inline bool turned_inside(double& q, bool slides, double lower, double upper) {
  const double moved = slides ? q : unwound(q, q, lower, upper);
  const bool inside = moved >= lower - kLimitSlack && moved <= upper + kLimitSlack;
  if (inside) q = moved;
  return inside;
}

// Joints i and j turn against each other: q_i + sense q_j stays what it is.
struct LineSelfMotion {
  double through[6];
  int i, j;
  double sense;

  double total() const {
    const double sum = short_way(through[i] + sense * through[j]);
    return sum > kEdgeOfTurn - kPi ? sum : sum + kTwoPi;
  }

  bool holds(const SixJoints& arm, const double* q, double tolerance) const {
    const double off = short_way(q[i] + sense * q[j] - total());
    double square = off * off / 2;
    for (int k = 0; k < kSix; ++k)
      if (k != i && k != j) square += arm.way(q, through, k) * arm.way(q, through, k);
    return std::sqrt(square) < tolerance;
  }

  // Whether some of it is inside.
  bool reaches_inside(const SixJoints& arm, const Limits& limits) const {
    for (int k = 0; k < kSix; ++k) {
      double q = through[k];
      if (k != i && k != j && !turned_inside(q, arm.slides[k], limits.lower[k], limits.upper[k])) return false;
    }
    double spans[16][2] = {{-kPi, kPi}};
    int count = 1;
    const int joints[2] = {i, j};
    const double scale[2] = {1, -sense}, shift[2] = {0, sense * total()};
    for (int k = 0; k < 2; ++k) {
      const double lower = limits.lower[joints[k]] - kLimitSlack, upper = limits.upper[joints[k]] + kLimitSlack;
      if (upper - lower >= kTwoPi) continue;
      const double x = (lower - shift[k]) / scale[k], y = (upper - shift[k]) / scale[k], a = std::fmin(x, y),
                   b = std::fmax(x, y);
      double cut[16][2];
      int left = 0;
      const int last = static_cast<int>(std::floor((kPi - a) / kTwoPi));
      for (int n = 0; n < count; ++n)
        for (int turns = static_cast<int>(std::ceil((-kPi - b) / kTwoPi)); turns <= last && left < 16; ++turns) {
          const double low = std::fmax(spans[n][0], a + kTwoPi * turns),
                       high = std::fmin(spans[n][1], b + kTwoPi * turns);
          if (low <= high) cut[left][0] = low, cut[left++][1] = high;
        }
      count = left;
      std::copy(&cut[0][0], &cut[0][0] + 2 * left, &spans[0][0]);
    }
    return count > 0;
  }

  // The point inside limits nearest to zero: for every whole turn of joint j a clipped parabola. False where there is none.
  bool smallest(const SixJoints& arm, const Limits& limits, double* q) const {
    for (int k = 0; k < kSix; ++k)
      q[k] = arm.slides[k] ? through[k] : unwound(through[k], 0, limits.lower[k], limits.upper[k]);
    const double whole = total(), low_i = limits.lower[i], high_i = limits.upper[i], low_j = limits.lower[j],
                 high_j = limits.upper[j], e0 = sense * (whole - low_i), e1 = sense * (whole - high_i);
    const double wish = -sense * whole / kTwoPi, least = (low_j - std::fmax(e0, e1)) / kTwoPi,
                 most = (high_j - std::fmin(e0, e1)) / kTwoPi;
    const double middle = std::nearbyint(std::fmin(std::fmax(wish, least), most));
    double best = INFINITY, x_best = 0, turns_best = 0;
    for (int k = 0; k < 5; ++k) {
      const double turns = middle + (k % 2 ? (k + 1) / 2 : -k / 2), a = whole - sense * (low_j - kTwoPi * turns),
                   b = whole - sense * (high_j - kTwoPi * turns);
      const double low = std::fmax(std::fmin(a, b), low_i), high = std::fmin(std::fmax(a, b), high_i);
      if (low > high + 2 * kLimitSlack) continue;
      const double wanted = whole + sense * kTwoPi * turns;
      const double x = std::fmin(std::fmax(wanted / 2, low), std::fmax(low, high));
      const double away = x * x + (x - wanted) * (x - wanted);
      if (away < best - kNearerRow) best = away, x_best = x, turns_best = turns;
    }
    if (best == INFINITY) return false;
    q[i] = x_best, q[j] = sense * (whole - x_best) + kTwoPi * turns_best;
    return true;
  }

  void representative(const SixJoints& arm, const Limits& limits, double* q) const {
    if (reaches_inside(arm, limits) && smallest(arm, limits, q)) return;
    if (!smallest(arm, no_limits(), q)) std::copy(through, through + kSix, q);
  }
};

inline constexpr int kLinkageSamples = 241;  // even steps once round: at most 0.12 rad or so of every joint
inline constexpr int kLinkageStride = 6;     // of these every so many is tried first

// How a linkage goes through its curve.
enum class Course {
  BACK,     // the leading joint turns back at both ends: u counts once there and back
  ABOVE,    // it goes all the way round, and the joint opposite stays above its phase (u is the leading angle)
  BELOW,    // or below it
  ALIKE,    // both go all the way round, alike
  AGAINST,  // or against each other: two courses that cross where both are at their phase
  ROUND_TWICE  // it goes round twice until the curve, which crosses itself once, closes: the joint opposite passes its phase
};

// Four joints move by themselves, one of them leads.
struct LinkageSelfMotion {
  double through[6];
  FourBar bar;
  int lead;
  double low,
      high;  // from where to where the leading joint can go, rad from `through`; of ROUND_TWICE, low is where it crosses
  Course course;

  double start() const { return -kPi - through[bar.joint[lead]]; }
  double sense() const { return course == Course::AGAINST ? -1 : 1; }

  void point(double u, double* q) const {
    double turned[4], angle = start() + kTwoPi * u;
    switch (course) {
      case Course::BACK:
        bar.back(lead, low, high, u, turned);
        break;
      case Course::ABOVE:
        bar.turned(lead, angle, 1, turned);
        break;
      case Course::BELOW:
        bar.turned(lead, angle, -1, turned);
        break;
      case Course::ALIKE:
      case Course::AGAINST:
        bar.closed(lead, angle, bar.opposite(lead).phase + sense() * (angle - bar.side[lead][0].phase), turned);
        break;
      case Course::ROUND_TWICE:
        bar.twice(lead, low, start() + 2 * kTwoPi * u, turned);
        break;
    }
    std::copy(through, through + kSix, q);
    for (int k = 0; k < 4; ++k) q[bar.joint[k]] += short_way(turned[k]);
  }

  // The place u of angles of the linkage; false where they are not on this piece of the curve.
  bool place(const double* turned, double& u) const {
    const double angle = turned[lead], across = turned[(lead + 2) % 4] - bar.opposite(lead).phase,
                 opposite = short_way(across);
    u = (angle - start()) / kTwoPi;
    u -= std::floor(u);
    switch (course) {
      case Course::ABOVE:
        return opposite >= 0;
      case Course::BELOW:
        return opposite < 0;
      case Course::ALIKE:
      case Course::AGAINST:
        return std::fabs(short_way(across - sense() * (angle - bar.side[lead][0].phase))) < kLinkageTogether;
      case Course::ROUND_TWICE:
        u = (bar.place_twice(lead, low, angle, turned[(lead + 2) % 4]) - start()) / (2 * kTwoPi);
        u -= std::floor(u);
        return true;
      case Course::BACK:
        break;
    }
    u = bar.place_back(lead, low, high, angle, turned[(lead + 2) % 4]);
    u -= std::floor(u);
    const double off = short_way(angle - (low + high) / 2), half = (high - low) / 2;
    return std::fabs(off) <= half * (1 + kOnCourse) + kOnCourseTurn;
  }

  bool holds(const SixJoints& arm, const double* q, double tolerance) const {
    double turned[4], u, at[6];
    for (int i = 0, k = 0; i < kSix; ++i) {
      if (k < 4 && bar.joint[k] == i) turned[k++] = arm.way(q, through, i);
      else if (std::fabs(arm.way(q, through, i)) > tolerance) return false;
    }
    if (!place(turned, u)) return false;
    point(u, at);
    return arm.apart(at, q) < std::sqrt(tolerance);
  }

  // Values of u where a joint meets a limit that lies `beyond` further out, the ends of [0, 1] included, ascending; any joint of a
  // linkage may lead.
  std::vector<double> crossings(const Limits& limits, double beyond) const {
    std::vector<double> ends = {0, 1};
    if (course == Course::ROUND_TWICE) ends.push_back(0.5);  // where it may cross itself, as it is at its start
    for (int k = 0; k < 4; ++k) {
      const int joint = bar.joint[k];
      if (limits.upper[joint] - limits.lower[joint] >= kTwoPi) continue;
      for (double value : {limits.lower[joint] - beyond, limits.upper[joint] + beyond}) {
        if (!std::isfinite(value)) continue;
        for (double way : {1.0, -1.0}) {
          double turned[4], u;
          if (!bar.turned(k, short_way(value - through[joint]), way, turned) || !place(turned, u)) continue;
          ends.push_back(u);
          // where the curve crosses itself, rounding decides which round it is: an end too many only halves a stretch
          if (course == Course::ROUND_TWICE) ends.push_back(u < 0.5 ? u + 0.5 : u - 0.5);
        }
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  struct Stretch {
    double from, to;
  };

  // Where it is inside limits, ascending. What limits with their slack leave is sought, so that a posture with several joints at their
  // limits has a stretch however short; its ends are then where the limits themselves are met.
  std::vector<Stretch> inside(const SixJoints& arm, const Limits& limits) const {
    const std::vector<double> ends = crossings(limits, kLimitSlack);
    std::vector<double> exact;
    std::vector<Stretch> out;
    bool open = false;
    for (std::size_t n = 0; n + 1 < ends.size(); ++n) {
      double q[6];
      point((ends[n] + ends[n + 1]) / 2, q);
      bool ok = true;
      for (int i = 0; i < kSix; ++i) ok &= turned_inside(q[i], arm.slides[i], limits.lower[i], limits.upper[i]);
      if (ok && open) out.back().to = ends[n + 1];
      else if (ok) out.push_back({ends[n], ends[n + 1]});
      open = ok;
    }
    if (!out.empty()) exact = crossings(limits, 0);
    for (Stretch& stretch : out) {
      std::vector<double> at = {stretch.from};
      for (double u : exact)
        if (u > stretch.from && u < stretch.to) at.push_back(u);
      at.push_back(stretch.to);
      std::size_t first = at.size(), last = 0, best = 0;
      double least = INFINITY;
      for (std::size_t n = 0; n < at.size(); ++n) {
        if (n + 1 < at.size() && outside(limits, (at[n] + at[n + 1]) / 2) <= 0)
          first = std::min(first, n), last = n + 1;
        const double out_by = outside(limits, at[n]);
        if (out_by < least) least = out_by, best = n;
      }
      stretch = first < last ? Stretch{at[first], at[last]} : Stretch{at[best], at[best]};
    }
    return out;
  }

  // The point with the smallest joint values of those inside the limits, or of all, among even steps of u: every few at first, then
  // all those about the best.
  void representative(const SixJoints& arm, const Limits& limits, double* q) const {
    double cost = INFINITY;
    struct Steps {
      double from, to;
      int steps, best;
      double u(int k) const { return k + 1 == steps ? to : from + k * ((to - from) / (steps - 1)); }
    } best{0, 1, kLinkageSamples, 0};
    double at[6], still = 0;
    bool moves[6] = {};
    for (int joint : bar.joint) moves[joint] = true;
    for (int i = 0; i < kSix; ++i) {
      if (moves[i]) continue;
      q[i] = arm.slides[i] ? through[i] : unwound(through[i], 0, limits.lower[i], limits.upper[i]);
      still += q[i] * q[i];
    }
    auto offer = [&](const Steps& along, int k) {
      point(along.u(k), at);
      double square = still;
      for (int joint : bar.joint) {
        at[joint] = unwound(at[joint], 0, limits.lower[joint], limits.upper[joint]);
        square += at[joint] * at[joint];
      }
      const double now = std::nearbyint(std::sqrt(square) * 1e6);  // rounding makes equal costs unequal: a coarse key
      if (!(now < cost)) return;
      cost = now, best = along, best.best = k;
      for (int joint : bar.joint) q[joint] = at[joint];
    };
    auto spread = [&](const Steps& along) {
      const int stride = along.steps > 2 * kLinkageStride ? kLinkageStride : 1;
      for (int k = 0; k < along.steps; k += stride) offer(along, k);
      if (stride > 1) offer(along, along.steps - 1);
    };
    const std::vector<Stretch> stretches = inside(arm, limits);
    for (const Stretch& one : stretches)
      spread({one.from, one.to,
              std::max(3, 1 + static_cast<int>(std::ceil((one.to - one.from) * (kLinkageSamples - 1)))), 0});
    if (stretches.empty()) spread(best);
    const Steps about = best;
    if (about.steps <= 2 * kLinkageStride) return;
    for (int k = std::max(0, about.best - kLinkageStride + 1); k < std::min(about.steps, about.best + kLinkageStride);
         ++k)
      offer(about, k);
  }

 private:
  // How far (rad) the linkage's own joints are outside their limits at most, whole turns counted.
  double outside(const Limits& limits, double u) const {
    double q[6], most = 0;
    point(u, q);
    for (int joint : bar.joint) {
      const double value = unwound(q[joint], q[joint], limits.lower[joint], limits.upper[joint]);
      most = std::fmax(most, std::fmax(limits.lower[joint] - value, value - limits.upper[joint]));
    }
    return most;
  }
};

}  // namespace pieper::PIEPER_ISA
