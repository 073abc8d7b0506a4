// An arm whose joints are solved as a group of three (a wrist, a plane) and the three beside it, made ready once.
// Scalar; read by the lanes as well.
#pragma once

#include "closed_form/careful/standing.hpp"

namespace pieper::PIEPER_ISA::closed_form {

struct GroupArm {
  Rigid truth[7], links[7];  // as described, and of the loop
  double length, unit[6];    // unit: what a joint's value is multiplied with at the end, 1 rad or the length
  int first;
  int order[3];  // joints a, b, c
  double sense[3];
  bool slides[6], hide_c, first_c, apart;
  bool straight;  // the loop's links are the arm's own within rounding: what closes the one closes the other

  explicit GroupArm(const Group& arm)
      : length(arm.length), first(arm.first), hide_c(arm.hide_c), first_c(arm.first_c), apart(arm.apart) {
    read_links(arm.links, length, truth);
    read_links(arm.loop, length, links);
    for (int k = 0; k < 6; ++k) slides[k] = arm.slides[k], unit[k] = slides[k] ? length : 1.0;
    for (int k = 0; k < 3; ++k) order[k] = (first + 3 + k) % 6, sense[k] = arm.sense[k];
    straight = true;
    for (int sample = 0; sample < 4; ++sample) {
      Rigid described = truth[0], loop = links[0];
      for (int k = 0; k < 6; ++k) {
        const double value = 2.3 * std::sin(1.7 * sample + 2.1 * k + 0.4);
        const bool inside = k >= first && k < first + 3;
        described = joint(described, value, slides[k]) * truth[k + 1];
        if (inside && slides[k]) loop.t = loop.t + value * loop.x;  // a plane's frames have x along a slide
        else loop = joint(loop, inside ? sense[k - first] * value : value, slides[k]);
        loop = loop * links[k + 1];
      }
      straight = straight && apart_by(described, loop) <= 0.2 * kClosedVerified;
    }
  }
  static double apart_by(const Rigid& A, const Rigid& B) {
    const Vec3 d[4] = {A.x - B.x, A.y - B.y, A.z - B.z, A.t - B.t};
    double most = 0;
    for (const Vec3& v : d) most = std::fmax(most, std::sqrt(dot(v, v)));
    return most;
  }
  TrueChain chain() const { return {6, length, truth, slides}; }
};

}  // namespace pieper::PIEPER_ISA::closed_form
