// Three joints of a plane anywhere in the chain (closed_form/careful/three_parallel.hpp), many poses at once.
// A template over the number type; its careful twin is scalar.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

struct ThreeParallel : Group {
  static constexpr const char* name = "three_parallel";
  static constexpr const char* doc =
      "Three neighbouring joints of a plane; in `loop` their frames lie in it, z along its normal.";
  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    Group::fields(self, visit);
    visit("sense", self.sense);
  }
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "closed_form/careful/three_parallel.hpp"
#include "closed_form/lanes/group.hpp"
#include "closed_form/lanes/planar.hpp"

namespace pieper::PIEPER_ISA {
namespace closed_form {

struct ThreeParallelLanes {
  PlanarLanes plane;
  bool straight;

  PlanarLink l1, l2;

  explicit ThreeParallelLanes(const GroupArm& arm)
      : plane(read_planar(arm.links[arm.first + 1]), read_planar(arm.links[arm.first + 2]), arm.slides + arm.first,
              arm.sense),
        straight(plane.usable),
        l1(read_planar(arm.links[arm.first + 1])),
        l2(read_planar(arm.links[arm.first + 2])) {}

  void careful(const GroupArm& arm, const double* T, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    solve_three_parallel(arm, l1, l2, T, q, valid, flag);
  }

  template <class F>
  __attribute__((noinline)) void solve(const GroupArm& arm, const LoopRestT<F>& rest, LaneSolutions<F>& out) const {
    const bool slides[3] = {arm.slides[arm.order[0]], arm.slides[arm.order[1]], arm.slides[arm.order[2]]};
    const PlaneProblem<F> P(rest, slides);
    PairLanes<F> s;
    start_pair(arm, s);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) s.M[i][j] = P.M[i][j], s.N[i][j] = P.N[i][j];
      s.e[i] = P.e[i];
    }
    solve_pair(s);
    out.unclear = s.unclear;
    Around<F> loop{arm, rest, s, {}, {}};
#pragma GCC unroll 1
    for (int i = 0; i < 4; ++i) {
      Vec3T<F> to = slides[0] ? P.w.at : P.w.at + s.a[i].c * P.w.first + s.a[i].s * P.w.second;
      Vec3T<F> from = slides[2] ? P.u.at : P.u.at + s.c[i].c * P.u.first + s.c[i].s * P.u.second;
      Motion<F> b;
      if (!slides[1]) {
        b = turn_between(from, to, out.unclear, s.found[i]);
      } else {
        Vec3T<F> turned_a = slides[0] ? P.ha.at : P.ha.at + s.a[i].c * P.ha.first + s.a[i].s * P.ha.second;
        F rise = P.climb + dot(turned_a, P.At) + dot(from, P.Bt);
        if (slides[0]) rise = rise + s.a[i].c * P.h.z;
        if (slides[2]) rise = rise + s.c[i].c * P.k.z;
        out.unclear = out.unclear | (s.found[i] & !(abs(to.z) > kPlaneUnclear));
        b = {-rise / to.z, F(0.0)};
      }
      // the plane's motion is the inverse of `around`
      const RigidT<F> around = loop.at(i, b);
      const F whole_c = 0.5 * (around.x.x + around.y.y), whole_s = 0.5 * (around.y.x - around.x.y);
      const F tx = -dot(around.x, around.t), ty = -dot(around.y, around.t), tz = dot(around.z, around.t);
      const F lean = max(max(abs(around.z.x), abs(around.z.y)), abs(tz));
      Mask<F> wanted = s.found[i];
      // beside a sliding middle joint each of the two equations holds one joint alone: two of the four pairs take the normal to its mirror
      // image, and are no solutions
      if (slides[1]) wanted = wanted & !(max(max(abs(around.z.x), abs(around.z.y)), 1.0 - around.z.z) > kPlaneMirrored);
      out.unclear = out.unclear | (wanted & !((lean <= 0.5 * kClosedVerified) & (around.z.z > 0.0)));
      F bent[2][3];
      const Mask<F> exists = plane.solve(whole_c, whole_s, tx, ty, wanted, bent, out.unclear);
      const F angle_b = joint_value(b, slides[1]);
      for (int n = 0; n < 2; ++n) {
        F* q = out.q[2 * i + n];
        put_pair(arm, s, i, angle_b, q);
        for (int j = 0; j < 3; ++j) q[arm.first + j] = bent[n][j];
        out.valid[2 * i + n] = n && plane.one_solution ? mask_of<F>(false) : exists;
      }
    }
  }
};

}  // namespace closed_form

using ThreeParallelKernel = closed_form::GroupKernel<ThreeParallel, closed_form::ThreeParallelLanes>;

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
