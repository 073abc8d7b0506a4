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
  double missing(const Rigid& goal, double* e) const { return missing_to(end, goal, e); }

  // What joint k does to the end, linear rows first.
  void column(int k, double* out) const { moved_end(axis[k], point[k], slides[k], end.t, out); }
};

}  // namespace pieper::PIEPER_ISA
