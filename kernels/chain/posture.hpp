// An arm of any number of joints at a joint vector: its axes, and what is missing to a pose. Lengths in units of the arm. Scalar.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "chain/plain.hpp"
#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA {

struct Posture {
  int n;
  double length;
  std::vector<Rigid> links;
  std::vector<std::uint8_t> slides;
  std::vector<Vec3> axis, point;
  Rigid end;

  explicit Posture(const PlainChain& chain)
      : n(chain.n),
        length(chain.length),
        links(n + 1),
        slides(chain.prismatic, chain.prismatic + n),
        axis(n),
        point(n),
        end(kNoMotion) {
    for (int k = 0; k <= n; ++k) links[k] = read_rigid(chain.links + 16 * k, length);
  }

  // Puts the arm to q (rad; lengths).
  void stand(const double* q) {
    end = walk(
        n, links[0], [&](int k) -> const Rigid& { return links[k + 1]; },
        [&](int k) { return motion_of(q[k], slides[k]); }, slides,
        [&](int k, const Rigid& frame) { axis[k] = frame.z, point[k] = frame.t; });
  }

  // What is missing to a pose: way, then rotation vector; returns its size.
  double missing(const Rigid& goal, double* e) const {
    const Vec3 p = goal.t - end.t;
    Vec3 w = 0.5 * (cross(end.x, goal.x) + cross(end.y, goal.y) + cross(end.z, goal.z));
    const double sine = std::sqrt(dot(w, w));
    const double cosine = 0.5 * (dot(end.x, goal.x) + dot(end.y, goal.y) + dot(end.z, goal.z) - 1);
    if (sine > kSineLeast) w = (std::atan2(sine, cosine) / sine) * w;
    else if (cosine < 0) w = {kPi, 0, 0};
    e[0] = p.x, e[1] = p.y, e[2] = p.z, e[3] = w.x, e[4] = w.y, e[5] = w.z;
    double sum = 0;
    for (int i = 0; i < 6; ++i) sum += e[i] * e[i];
    return std::sqrt(sum);
  }

  // What joint k does to the end, linear rows first.
  void column(int k, double* out) const {
    const Vec3 v = slides[k] ? axis[k] : cross(axis[k], end.t - point[k]), w = slides[k] ? Vec3{0, 0, 0} : axis[k];
    out[0] = v.x, out[1] = v.y, out[2] = v.z, out[3] = w.x, out[4] = w.y, out[5] = w.z;
  }
};

}  // namespace pieper::PIEPER_ISA
