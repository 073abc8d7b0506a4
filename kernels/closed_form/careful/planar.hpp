// Three joints of a plane, each a turn or a slide: Z1 l1 Z2 l2 Z3 = (turn, x, y). Used by every arm with three parallel axes.
//
// A turn is about the plane's normal, a slide along the local x. With three turns the place gives the law of
// cosines (two solutions), with one slide a circle meets a line (two), with two slides everything is linear (one).
// Scalar: the careful twin of closed_form/lanes/planar.hpp.
#pragma once

#include "closed_form/careful/closing.hpp"

namespace pieper::PIEPER_ISA::closed_form {

struct Flat {
  double x, y;
};
inline Flat flat_turn(double angle, Flat v) {
  double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}
inline double heading(Flat v) { return std::atan2(v.y, v.x); }

// A planar link: first go to `at`, then turn by `angle`.
struct PlanarLink {
  Flat at;
  double angle;
};

// Half the angle opposite `r` seen from outside: r^2 = a^2 + b^2 + 2 a b cos(angle). False when no triangle closes.
inline bool triangle(double a, double b, double r, double& angle) {
  double up = (a + b - r) * (a + b + r), down = (r - a + b) * (r + a - b);
  double slack = kPlaneReach * (a + b) * (a + b);
  if (up < -slack || down < -slack) return false;
  angle = 2 * std::atan2(std::sqrt(std::fmax(up, 0)), std::sqrt(std::fmax(down, 0)));
  return true;
}

// d with |v + d e| = r, e a unit vector.
inline int slide_to_circle(Flat v, Flat e, double r, double* d) {
  double along = v.x * e.x + v.y * e.y, off = v.x * e.y - v.y * e.x;
  double room = (r - std::fabs(off)) * (r + std::fabs(off));
  if (room < -kPlaneReach * r * r - kPlaneZero) return 0;
  double s = std::sqrt(std::fmax(room, 0));
  d[0] = -along + s;
  d[1] = -along - s;
  return s > 0 ? 2 : 1;
}

// At most two triples; `free` says that two slides are along one line and share what is missing.
inline int solve_planar(const PlanarLink& l1, const PlanarLink& l2, const bool* slides, double turn_by, Flat t,
                        double (*q)[3], bool& free) {
  const double sum = turn_by - l1.angle - l2.angle;  // of the turning joints
  const int kind = slides[0] | slides[1] << 1 | slides[2] << 2;
  auto ahead = [](double angle) { return Flat{std::cos(angle), std::sin(angle)}; };
  int count = 0;
  double d[2];
  switch (kind) {
    case 0: {
      double a = std::hypot(l1.at.x, l1.at.y), b = std::hypot(l2.at.x, l2.at.y), r = std::hypot(t.x, t.y), bend;
      if (!triangle(a, b, r, bend)) return 0;
      for (count = 0; count < (bend > 0 ? 2 : 1); ++count) {
        double q2 = (count ? -bend : bend) + heading(l1.at) - heading(l2.at) - l1.angle;
        Flat arm = flat_turn(l1.angle + q2, l2.at);
        double q1 = heading(t) - heading({l1.at.x + arm.x, l1.at.y + arm.y});
        q[count][0] = q1, q[count][1] = q2, q[count][2] = sum - q1 - q2;
      }
      return count;
    }
    case 1: {  // slide, turn, turn
      Flat v = {t.x - l1.at.x, t.y - l1.at.y};
      int n = slide_to_circle(v, {-1, 0}, std::hypot(l2.at.x, l2.at.y), d);
      for (; count < n; ++count) {
        double q2 = heading({v.x - d[count], v.y}) - heading(l2.at) - l1.angle;
        q[count][0] = d[count], q[count][1] = q2, q[count][2] = sum - q2;
      }
      return count;
    }
    case 2: {  // turn, slide, turn
      Flat v = flat_turn(l1.angle, l2.at), e = ahead(l1.angle);
      v = {v.x + l1.at.x, v.y + l1.at.y};
      int n = slide_to_circle(v, e, std::hypot(t.x, t.y), d);
      for (; count < n; ++count) {
        double q1 = heading(t) - heading({v.x + d[count] * e.x, v.y + d[count] * e.y});
        q[count][0] = q1, q[count][1] = d[count], q[count][2] = sum - q1;
      }
      return count;
    }
    case 4: {  // turn, turn, slide
      Flat v = flat_turn(turn_by - l2.angle, l2.at), e = ahead(turn_by);
      v = {t.x - v.x, t.y - v.y};
      int n = slide_to_circle(v, {-e.x, -e.y}, std::hypot(l1.at.x, l1.at.y), d);
      for (; count < n; ++count) {
        double q1 = heading({v.x - d[count] * e.x, v.y - d[count] * e.y}) - heading(l1.at);
        q[count][0] = q1, q[count][1] = sum - q1, q[count][2] = d[count];
      }
      return count;
    }
    default:
      break;
  }
  // two slides: v = d1 e1 + d2 e2 with known directions
  Flat v, e1, e2;
  if (kind == 6) {  // turn, slide, slide
    Flat a = flat_turn(l1.angle, l2.at), back = flat_turn(-sum, t);
    v = {back.x - l1.at.x - a.x, back.y - l1.at.y - a.y};
    e1 = ahead(l1.angle), e2 = ahead(l1.angle + l2.angle);
  } else if (kind == 5) {  // slide, turn, slide
    Flat a = flat_turn(l1.angle + sum, l2.at);
    v = {t.x - l1.at.x - a.x, t.y - l1.at.y - a.y};
    e1 = {1, 0}, e2 = ahead(turn_by);
  } else {  // slide, slide, turn
    Flat a = flat_turn(l1.angle, l2.at);
    v = {t.x - l1.at.x - a.x, t.y - l1.at.y - a.y};
    e1 = {1, 0}, e2 = ahead(l1.angle);
  }
  double det = e1.x * e2.y - e1.y * e2.x;
  double first, second;
  if (std::fabs(det) > kPlaneParallel) {
    first = (v.x * e2.y - v.y * e2.x) / det, second = (e1.x * v.y - e1.y * v.x) / det;
  } else {
    if (!(std::fabs(v.x * e1.y - v.y * e1.x) <= kPlaneMissed)) return 0;
    free = true;
    first = 0.5 * (v.x * e1.x + v.y * e1.y), second = 0.5 * (v.x * e2.x + v.y * e2.y);
  }
  if (kind == 6) q[0][0] = sum, q[0][1] = first, q[0][2] = second;
  else if (kind == 5) q[0][0] = first, q[0][1] = sum, q[0][2] = second;
  else q[0][0] = first, q[0][1] = second, q[0][2] = sum;
  return 1;
}

}  // namespace pieper::PIEPER_ISA::closed_form
