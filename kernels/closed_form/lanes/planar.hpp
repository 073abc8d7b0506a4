// Three joints of a plane for many poses at once (see closed_form/careful/planar.hpp): Z1 l1 Z2 l2 Z3 = (turn, x, y).
// A template over the number type; the careful scalar twin is closed_form/careful/planar.hpp.
#pragma once

#include "closed_form/lanes/pair.hpp"
#include "closed_form/careful/planar.hpp"

namespace pieper::PIEPER_ISA::closed_form {

struct PlanarLanes {
  int kind;           // which joints slide: bit 0 the first, bit 1 the second, bit 2 the third
  bool one_solution;  // two slides: everything is linear
  bool usable;
  double sense[3];
  double a, b;                                       // lengths of the links
  double heading_1, heading_2, angle_2, sum, shift;  // shift, sum: constants of the second joint and of all three
  Flat l1, l2, bent, along_1,
      along_12;  // bent: l2 turned by angle_1; along: unit vectors at angle_1 and angle_1 + angle_2
  double det;    // of the two slides' directions where that is a constant

  PlanarLanes(const PlanarLink& first, const PlanarLink& second, const bool* slides, const double* senses) {
    kind = slides[0] | slides[1] << 1 | slides[2] << 2;
    one_solution = kind == 3 || kind == 5 || kind == 6;
    l1 = first.at, l2 = second.at;
    const double angle_1 = first.angle;
    angle_2 = second.angle, sum = one_turn(angle_1 + angle_2);
    a = std::hypot(l1.x, l1.y), b = std::hypot(l2.x, l2.y);
    heading_1 = heading(l1), heading_2 = heading(l2);
    shift = one_turn((kind == 0 ? heading_1 : 0.0) - heading_2 - angle_1);
    bent = flat_turn(angle_1, l2);
    along_1 = {std::cos(angle_1), std::sin(angle_1)};
    along_12 = {std::cos(sum), std::sin(sum)};
    det = kind == 6 ? along_1.x * along_12.y - along_1.y * along_12.x : along_1.y;
    usable = kind != 7 && (kind != 0 || (a > kPlaneShort && b > kPlaneShort)) &&
             ((kind != 6 && kind != 3) || std::fabs(det) > kPlaneLanesParallel);
    for (int j = 0; j < 3; ++j) sense[j] = senses[j];
  }

  // q: two triples (rad; lengths of the arm) for a turn (c, s) and a place; returns where they exist among the `wanted`.
  template <class F>
  PIEPER_INLINE Mask<F> solve(F c, F s, F x, F y, Mask<F> wanted, F (*q)[3], Mask<F>& unclear) const {
    const F turn_by = unit_angle(s, c), rest = wrapped(turn_by - sum);  // what the turning joints add up to
    Mask<F> exists = wanted;
    // half of the two roots' difference from its square, `size` being what that is compared with
    auto root_of = [&](F room, F size) {
      exists = wanted & (room > 0.0);
      unclear = unclear | (wanted & about_zero(room, size));
      return sqrt(max(room, F(0.0)));
    };
    auto clear_heading = [&](F vx, F vy) {
      unclear = unclear | (exists & !((vx * vx + vy * vy) > kRootsMerge));
      return atan2_closed(vy, vx);
    };
    switch (kind) {
      case 0: {
        const F r2 = x * x + y * y, cosine = (r2 - (a * a + b * b)) * (0.5 / (a * b));
        const F sine = root_of((1.0 - cosine) * (1.0 + cosine), F(1.0));
        const F bend = unit_angle(sine, cosine), ahead = clear_heading(x, y) - heading_1;
        const F inner = atan2_closed(b * sine, a + b * cosine);  // between the first link and the line to the place
        for (int n = 0; n < 2; ++n) {
          q[n][1] = wrapped((n ? -bend : bend) + shift);
          q[n][0] = wrapped(n ? ahead + inner : ahead - inner);
          q[n][2] = wrapped(wrapped(rest - q[n][0]) - q[n][1]);
        }
        break;
      }
      case 1: {  // slide, turn, turn
        const F vx = x - l1.x, vy = y - l1.y, half = root_of(b * b - vy * vy, F(b * b));
        for (int n = 0; n < 2; ++n) {
          const F way = n ? -half : half;
          q[n][0] = vx - way;
          q[n][1] = wrapped(atan2_closed(vy, way) + shift);
          q[n][2] = wrapped(rest - q[n][1]);
        }
        break;
      }
      case 2: {  // turn, slide, turn
        const double vx = bent.x + l1.x, vy = bent.y + l1.y, along = vx * along_1.x + vy * along_1.y,
                     off = vx * along_1.y - vy * along_1.x;
        const F r2 = x * x + y * y, half = root_of(r2 - off * off, r2), ahead = clear_heading(x, y);
        for (int n = 0; n < 2; ++n) {
          q[n][1] = (n ? -half : half) - along;
          q[n][0] = wrapped(ahead - atan2_closed(vy + q[n][1] * along_1.y, vx + q[n][1] * along_1.x));
          q[n][2] = wrapped(rest - q[n][0]);
        }
        break;
      }
      case 4: {  // turn, turn, slide
        const Flat arm = flat_turn(-angle_2, l2);
        const F vx = x - (c * arm.x - s * arm.y), vy = y - (s * arm.x + c * arm.y);
        const F along = vx * c + vy * s, off = vx * s - vy * c, half = root_of(a * a - off * off, F(a * a));
        for (int n = 0; n < 2; ++n) {
          q[n][2] = along + (n ? -half : half);
          q[n][0] = wrapped(atan2_closed(vy - q[n][2] * s, vx - q[n][2] * c) - heading_1);
          q[n][1] = wrapped(rest - q[n][0]);
        }
        break;
      }
      case 6: {  // turn, slide, slide
        F rc, rs;
        sincos_of_turns(rest, rs, rc);
        const F vx = rc * x + rs * y - (l1.x + bent.x), vy = rc * y - rs * x - (l1.y + bent.y);
        q[0][0] = rest;
        q[0][1] = (vx * along_12.y - vy * along_12.x) * (1 / det);
        q[0][2] = (along_1.x * vy - along_1.y * vx) * (1 / det);
        break;
      }
      case 5: {  // slide, turn, slide
        const Flat arm = flat_turn(-angle_2, l2);
        const F vx = x - l1.x - (c * arm.x - s * arm.y), vy = y - l1.y - (s * arm.x + c * arm.y);
        unclear = unclear | (wanted & !(abs(s) > kPlaneUnclear));
        q[0][2] = vy / s;
        q[0][0] = vx - q[0][2] * c;
        q[0][1] = rest;
        break;
      }
      default: {  // slide, slide, turn
        const F vx = x - (l1.x + bent.x), vy = y - (l1.y + bent.y);
        q[0][1] = vy * (1 / det);
        q[0][0] = vx - q[0][1] * along_1.x;
        q[0][2] = rest;
        break;
      }
    }
    for (int n = 0; n < (one_solution ? 1 : 2); ++n)
      for (int j = 0; j < 3; ++j)
        if (sense[j] < 0) q[n][j] = select(q[n][j] >= kPi, q[n][j], -q[n][j]);  // pi stays pi
    if (one_solution)
      for (int j = 0; j < 3; ++j) q[1][j] = q[0][j];
    return exists;
  }
};

}  // namespace pieper::PIEPER_ISA::closed_form
