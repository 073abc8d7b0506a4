// A spherical wrist anywhere in the chain (closed_form/careful/spherical_wrist.hpp), many poses at once.
// A template over the number type; its careful twin is scalar.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

struct SphericalWrist : Group {
  static constexpr const char* name = "spherical_wrist";
  static constexpr const char* doc =
      "Three neighbouring revolute axes through one point; in `loop` their frames stand there.";
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "closed_form/careful/spherical_wrist.hpp"
#include "closed_form/lanes/group.hpp"

namespace pieper::PIEPER_ISA {
namespace closed_form {

struct SphericalWristLanes {
  Wrist wrist;
  double c0, s0, c1, s1, cos_sum, cos_difference, shift[3];
  bool square;  // right angles between neighbours: the other turn of the wrist is half a turn of its outer joints
  bool straight = true;

  SphericalWristLanes(const GroupArm& arm) {
    const Wrist& w = wrist = read_wrist(arm.links[arm.first + 1], arm.links[arm.first + 2]);
    c0 = std::cos(w.twist[0]), s0 = std::sin(w.twist[0]), c1 = std::cos(w.twist[1]), s1 = std::sin(w.twist[1]);
    shift[0] = one_turn(-w.before[0]), shift[1] = one_turn(-w.after[0] - w.before[1]), shift[2] = one_turn(-w.after[1]);
    cos_sum = std::cos(w.twist[0] + w.twist[1]);
    cos_difference = std::cos(w.twist[0] - w.twist[1]);
    square = std::fabs(c0) < kWristSquare && std::fabs(c1) < kWristSquare;
  }

  void careful(const GroupArm& arm, const double* T, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    solve_spherical_wrist(arm, wrist, T, q, valid, flag);
  }

  template <class F>
  __attribute__((noinline)) void solve(const GroupArm& arm, const LoopRestT<F>& rest, LaneSolutions<F>& out) const {
    const bool slides[3] = {arm.slides[arm.order[0]], arm.slides[arm.order[1]], arm.slides[arm.order[2]]};
    Vec3T<F> g = turn_back(rest.pre, F(-1.0) * rest.pre.t);
    SwingT<F> w = swing_back(rest.A, g, slides[0]), u = swing_of(rest.B, rest.C.t, slides[2]);
    PairLanes<F> s;
    start_pair(arm, s);
    position_pair(w, u, slides, s.M, s.N, s.e);
    solve_pair(s);
    out.unclear = s.unclear;
    Around<F> loop{arm, rest, s, {}, {}};
    const double scale = 1 / (s0 * s1);
#pragma GCC unroll 1
    for (int i = 0; i < 4; ++i) {
      Vec3T<F> to = w.at + s.a[i].c * w.first, from = u.at + s.c[i].c * u.first;
      if (!slides[0]) to = to + s.a[i].s * w.second;
      if (!slides[2]) from = from + s.c[i].s * u.second;
      Motion<F> b = slides[1] ? Motion<F>{to.z - from.z, F(0.0)} : turn_between(from, to, out.unclear, s.found[i]);
      const RigidT<F> around = loop.at(i, b);
      const F angle_b = joint_value(b, slides[1]), off = largest(around.t);
      // the wrist's rotation R is the transpose of `around`
      const Vec3T<F> rx = {around.x.x, around.y.x, around.z.x}, ry = {around.x.y, around.y.y, around.z.y},
                     rz = {around.x.z, around.y.z, around.z.z};
      F up = rz.z - cos_sum, down = cos_difference - rz.z, side = rz.x * rz.x + rz.y * rz.y;
      Mask<F> exists = s.found[i] & (up > 0.0) & (down > 0.0);
      out.unclear = out.unclear | (s.found[i] & (about_zero(up, F(1.0)) | about_zero(down, F(1.0))));
      out.unclear = out.unclear | (exists & !(side > kRootsMerge));
      F ct = (c0 * c1 - rz.z) * scale, st = sqrt(max(up * down, F(0.0))) * scale;
      F vy = -c0 * s1 * ct - s0 * c1, vx = s1 * st, middle = joint_value(Motion<F>{ct, st}, false);
      const F over = 1.0 / sqrt(max(side * (vx * vx + vy * vy), F(kTiny)));
#pragma GCC unroll 1
      for (int n = 0; n < 2; ++n) {
        F* q = out.q[2 * i + n];
        put_pair(arm, s, i, angle_b, q);
        out.valid[2 * i + n] = exists;
        q[arm.first + 1] = wrapped((n ? -middle : middle) + shift[1]);
        if (n && square) {
          for (int j = 0; j < 3; j += 2) {
            q[arm.first + j] = half_a_turn_on(out.q[2 * i][arm.first + j]);
          }
          continue;
        }
        if (n) st = -st, vx = -vx;
        Motion<F> t1 = {(rz.x * vx + rz.y * vy) * over, (rz.y * vx - rz.x * vy) * over};
        // columns x, y of Rz(t1) Rx Rz(t2) Rx and from them the last turn
        Vec3T<F> x1 = {t1.c, t1.s, F(0.0)}, y1 = {-c0 * t1.s, c0 * t1.c, F(s0)}, z1 = {s0 * t1.s, -s0 * t1.c, F(c0)};
        Vec3T<F> x2 = ct * x1 + st * y1, y2 = ct * y1 - st * x1;
        Vec3T<F> y3 = F(c1) * y2 + F(s1) * z1;
        Motion<F> t3 = {0.5 * (dot(x2, rx) + dot(y3, ry)), 0.5 * (dot(y3, rx) - dot(x2, ry))};
        F miss = max(largest(t3.c * x2 + t3.s * y3 - rx), largest(t3.c * y3 - t3.s * x2 - ry));
        out.unclear = out.unclear | (exists & !(max(miss, off) <= 0.5 * kClosedVerified));
        q[arm.first] = wrapped(unit_angle(t1.s, t1.c) + shift[0]);
        q[arm.first + 2] = wrapped(unit_angle(t3.s, t3.c) + shift[2]);
      }
    }
  }
};

}  // namespace closed_form

using SphericalWristKernel = closed_form::GroupKernel<SphericalWrist, closed_form::SphericalWristLanes>;

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
