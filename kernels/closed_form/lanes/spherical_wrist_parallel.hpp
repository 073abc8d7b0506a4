// Six revolute joints: the first perpendicular to the second, the second and third parallel, a spherical wrist of
// three mutually perpendicular neighbours at the end. Eight solutions in closed form (Pieper, 1968).
//
// In the base frame B (origin on axis 1 at the height of axis 2; z along axis 1, y against axis 2) the arm is
//     B^-1 T C = Rz(th1) [x = a1 + L2 cos th2 + L3 cos(th2 + th3), y = b, z = L2 sin th2 + L3 sin(th2 + th3)]   wrist centre
//     rotation = Rz(th1) S(th2 + th3 + psi) X(tau) Rz(th4) Ry(th5) Rz(th6)
// where S turns x towards z and X(tau) tilts axis 4 out of the arm's plane (zero for every usual arm).
//
// Slot = 4 shoulder + 2 elbow + wrist:
//     shoulder 0: the wrist centre on the positive x side of the turned base frame, 1: on the negative side
//     elbow    0: sin th3 negative in front (positive behind): the elbow above the line from shoulder to wrist
//     wrist    0: sin th5 positive, 1: negative
// At a double root only the slot with the 0 is filled: wrist centre on axis 1 (th1 is free; q1 = 0 stands for it) or at
// the shoulder's inner reach, arm stretched or folded (th3 double; wrist centre on axis 2: q2 = 0), sin th5 = 0 (th4 and
// th6 count only as sum or difference; q4 = 0).
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

struct SphericalWristParallel : Geometry {
  static constexpr const char* name = "spherical_wrist_parallel";
  static constexpr const char* doc =
      "Parallel second and third axes, the first across them, a spherical wrist of right angles at the end.";
  static constexpr int joints = 6, slots = 8;
  double base[3][3];          // takes world directions to B
  double tool[3][3];          // C, the end frame of the wrist's angles seen from the tool
  Vector origin;              // minus B's origin, in B, m
  Vector centre;              // wrist centre seen from the tool point, in C's frame, m
  double a1, b, upper, fore;  // m; L2 and L3 above
  double cos_psi, sin_psi, cos_tau, sin_tau;
  double offset2, offset3, offset4, offset5;  // rad: th2 = q2 + offset2, th3 = sign3 q3 + offset3, ...
  double sign3, cos_offset4, sin_offset4;
  double scale;  // length that positions are compared with, m
  bool tilted;   // tau is not zero

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    visit("base", self.base), visit("tool", self.tool), visit("origin", self.origin), visit("centre", self.centre);
    visit("a1", self.a1), visit("b", self.b), visit("upper", self.upper), visit("fore", self.fore);
    visit("cos_psi", self.cos_psi), visit("sin_psi", self.sin_psi), visit("cos_tau", self.cos_tau),
        visit("sin_tau", self.sin_tau);
    visit("offset2", self.offset2), visit("offset3", self.offset3), visit("offset4", self.offset4),
        visit("offset5", self.offset5);
    visit("sign3", self.sign3), visit("cos_offset4", self.cos_offset4), visit("sin_offset4", self.sin_offset4);
    visit("scale", self.scale), visit("tilted", self.tilted);
  }
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "closed_form/lanes/parallel_wrist_steps.hpp"
#include "lanes/batch.hpp"

namespace pieper::PIEPER_ISA {

class SphericalWristParallelKernel : ParallelWristSteps {
 public:
  static constexpr bool in_order = true;
  explicit SphericalWristParallelKernel(const SphericalWristParallel& arm) : arm_(arm) {}

  // Each joint's angle less what it is measured from, in (-pi, pi].
  template <class F> struct AsTheyCome {
    double offset[6];

    explicit AsTheyCome(const SphericalWristParallel& P)
        : offset{0.0, P.offset2, P.sign3 * P.offset3, P.offset4, P.offset5, 0.0} {}
    PIEPER_INLINE F own(int, F s, F c) const { return atan2(s, c); }
    PIEPER_INLINE F operator()(int j, F angle) const { return wrapped(angle - offset[j]); }
    PIEPER_INLINE F other_way(int, F q) const { return half_a_turn_on(q); }
    PIEPER_INLINE void keep(const F (&from)[6], Mask<F>, F (&to)[6], Mask<F>&) const {
      for (int j = 0; j < 6; ++j) to[j] = from[j];
    }
  };

  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    in_lanes(T, count, [&](long first, int lanes, const double* poses) {
      using F = Lanes<PIEPER_LANES>;
      Branches<F, 8, 6> out;
      branches(arm_, load_poses<F>(poses), out, AsTheyCome<F>(arm_));
      for (int m = 0; m < 8; ++m)
        for (int j = 0; j < 6; ++j) out.q[m][j] = select(out.valid[m], out.q[m][j], F(0.0));
      store_records<F, 48>(q + 48 * first, out.q[0], lanes);
      store_masks<F, 8>(valid + 8 * first, out.valid, lanes);
      store_flags<F>(flag + first, out, lanes);
    });
  }
  bool solve_inside(const double* T, long count, const Directly& how, const Answers& to) const {
    using F = Lanes<PIEPER_LANES>;
    const Places places(arm_, how.limits);
    bool exact = true;
    in_lanes(T, count, [&](long first, int lanes, const double* poses) {
      Branches<F, 8, 6> out;
      const Given<F> given = load_given<F>(poses);
      exact = exact & all(is_exact(given, how.exact));
      branches(arm_, given.pose, out, Inside<F>{places});
      store_group<F>(out, first, lanes, how.past_cache, to);
    });
    if (how.past_cache) past_cache_done();
    return exact;
  }

  // All branches of W poses: lanes are poses, the branches follow one another.
  template <class F, class Place> PIEPER_INLINE static void branches(const SphericalWristParallel& P,
                                                                     const RigidT<F>& T, Branches<F, 8, 6>& out,
                                                                     const Place& place) {
    F M[3][3], w[3];
    into_base(P, T, M, w);
    Shoulder<F> shoulder = start_shoulder(P, w);
    Mask<F> none = mask_of<F>(true), beyond = mask_of<F>(true), missed = mask_of<F>(false);
    // step by step for all postures: a step is a chain of dependent operations, and one posture's hides the latencies of another's
    Arm<F> arm[2];
    Elbow<F> elbow[2];
    Forearm<F> forearm[4];
    Wrist<F> wrist[4];
#pragma GCC unroll 2
    for (int side = 0; side < 2; ++side) {
      arm[side] = turn_shoulder(P, M, w, shoulder, F(side ? -1.0 : 1.0));
      if (side) arm[side].ok = arm[side].ok & shoulder.two_sides;
    }
#pragma GCC unroll 2
    for (int side = 0; side < 2; ++side) elbow[side] = start_elbow(P, arm[side]);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) forearm[k] = bend(P, M, arm[k / 2], elbow[k / 2], F(k == 0 || k == 3 ? -1.0 : 1.0));
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) wrist[k] = turn_wrist(P, arm[k / 2], elbow[k / 2], forearm[k]);
    F q1[2], th3[2];
#pragma GCC unroll 2
    for (int side = 0; side < 2; ++side) {
      q1[side] = place.own(0, arm[side].s, arm[side].c);
      th3[side] = unit_angle(elbow[side].s3, elbow[side].c3);
      shoulder.degenerate = shoulder.degenerate | elbow[side].degenerate;
      beyond = beyond & elbow[side].beyond;
    }
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const Wrist<F>& of = wrist[k];
      const Mask<F> ok = k % 2 ? of.ok & elbow[k / 2].two : of.ok;
      const Angles<F> angle = angles(P, elbow[k / 2], forearm[k], of);
      const F at[6] = {
          q1[k / 2],           place(1, angle.th2), place(2, (k == 0 || k == 3 ? -P.sign3 : P.sign3) * th3[k / 2]),
          place(3, angle.th4), place(4, angle.th5), place.own(5, of.s6, of.c6)};
      // the other turn of the wrist: th4 + pi, -th5, th6 + pi, the same rotation exactly
      const F other[6] = {
          at[0], at[1], at[2], place.other_way(3, at[3]), place(4, -angle.th5), place.other_way(5, at[5])};
      out.valid[2 * k] = ok;
      out.valid[2 * k + 1] = ok & of.two;
      out.reached[2 * k] = k % 2 ? of.reached & elbow[k / 2].two : of.reached;
      out.reached[2 * k + 1] = out.reached[2 * k] & of.two;
      missed = missed | (out.reached[2 * k] & !ok);
      place.keep(at, ok, out.q[2 * k], out.inside[2 * k]);
      place.keep(other, out.valid[2 * k + 1], out.q[2 * k + 1], out.inside[2 * k + 1]);
      shoulder.degenerate = shoulder.degenerate | (of.degenerate & ok);
      none = none & !ok;
    }
    out.degenerate = shoulder.degenerate, out.missed = missed;
    out.uncertain = (none & shoulder.degenerate & shoulder.reached) | missed;
    out.out_of_reach = none;
    out.edge = none & !(shoulder.beyond | beyond);
  }

 private:
  // The turn that limits want of each joint.
  struct Places {
    TurnOfJoint of[6];

    Places(const SphericalWristParallel& P, const JointLimits& limits) {
      const AsTheyCome<double> from(P);
      for (int j = 0; j < 6; ++j) of[j] = turn_of_joint(limits.lower[j], limits.upper[j], from.offset[j]);
    }
  };
  template <class F> struct Inside {
    const Places& places;

    PIEPER_INLINE F own(int j, F s, F c) const { return (*this)(j, unit_angle(s, c)); }
    PIEPER_INLINE F operator()(int j, F angle) const { return turned_into(places.of[j], angle); }
    PIEPER_INLINE F other_way(int j, F q) const { return half_a_turn_on(places.of[j], q); }
    PIEPER_INLINE void keep(const F (&from)[6], Mask<F> ok, F (&to)[6], Mask<F>& inside) const {
      inside = ok;
      for (int j = 0; j < 6; ++j) {
        inside = inside & (from[j] >= places.of[j].low) & (from[j] <= places.of[j].high);
        to[j] = select(ok, from[j], F(0.0));
      }
    }
  };

  const SphericalWristParallel& arm_;
};

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
