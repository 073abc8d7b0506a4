// The path of a front: its poses, and the constant twists between them.
#pragma once

#include <cmath>
#include <cstdint>

#include "chain/rigid.hpp"
#include "route/front.hpp"

namespace pieper::PIEPER_ISA {

struct Way {
  const FrontAsked& a;

  Rigid pose(std::int64_t k, double part) const {
    Rigid T = read_rigid(a.poses + 16 * k, a.length);
    if (part == 0) return T;
    const Rigid next = read_rigid(a.poses + 16 * (k + 1), a.length);
    if (part == 1) return next;
    const double* u = a.axis + 3 * k;
    const double angle = part * a.angle[k], c = std::cos(angle), s = std::sin(angle), o = 1 - c;
    Rigid R = kNoMotion;
    R.x = {c + o * u[0] * u[0], o * u[0] * u[1] + s * u[2], o * u[0] * u[2] - s * u[1]};
    R.y = {o * u[0] * u[1] - s * u[2], c + o * u[1] * u[1], o * u[1] * u[2] + s * u[0]};
    R.z = {o * u[0] * u[2] + s * u[1], o * u[1] * u[2] - s * u[0], c + o * u[2] * u[2]};
    Rigid out = T * R;
    out.t = T.t + part * (next.t - T.t);
    return out;
  }

  // The twist t (6) to the next pose, base frame, and its size: between two poses it is constant.
  double twist(std::int64_t k, double* t) const {
    const Rigid T = read_rigid(a.poses + 16 * k, a.length);
    const Vec3 d = read_rigid(a.poses + 16 * (k + 1), a.length).t - T.t,
               u = {a.axis[3 * k], a.axis[3 * k + 1], a.axis[3 * k + 2]}, w = a.angle[k] * turn(T, u);
    t[0] = d.x, t[1] = d.y, t[2] = d.z, t[3] = w.x, t[4] = w.y, t[5] = w.z;
    return std::sqrt(dot(d, d) + dot(w, w));
  }
};

}  // namespace pieper::PIEPER_ISA
