// Six joints, three neighbouring ones of a plane (three parallel axes; or turns about a normal and slides across it),
// wherever they stand in the chain: the UR arms and their relatives.
//
// The loop entered after the plane's joints reads P Pre Za A Zb B Zc C = I. P keeps the plane's normal and its height, so the row
// (0 0 1 0) passes through it: h Za A Zb B Zc = k with h the third row of Pre and k that of C^-1. The middle joint b drops
// out of the normal's component along it and of the height, two equations linear in the terms of a and c: a PairSystem
// (four pairs). Then b, then P is a known motion of the plane (two solutions): eight in all.
// The equations are templates over the number type; the rest is scalar, the careful twin of closed_form/lanes/three_parallel.hpp.
#pragma once

#include "closed_form/careful/beside_group.hpp"
#include "closed_form/careful/planar.hpp"

namespace pieper::PIEPER_ISA::closed_form {

inline PlanarLink read_planar(const Rigid& link) { return {{link.t.x, link.t.y}, std::atan2(link.x.y, link.x.x)}; }

// A direction as a function of a joint: a sliding one leaves it alone.
inline Vec3 direction_at(const Swing& s, double x, bool slides) { return slides ? s.at : swing_at(s, x, false); }

// The normal's component along the middle axis (as the squared part across it, which stays accurate where the normal nearly lies along
// the axis) and the height, as a pair of separable equations.
struct PlaneEquations {
  const Swing &ha, &w, &kc, &u;
  Vec3 At, Bt;
  double rise_a, rise_c, climb;
  bool slides_a, slides_c;
  void operator()(double a, double c, Separable& flat, Separable& bent) const {
    Vec3 p = direction_at(w, a, slides_a), r = direction_at(u, c, slides_c), zero = {0, 0, 0};
    Vec3 dp = zero, ddp = zero, dr = zero, ddr = zero, ph = direction_at(ha, a, slides_a), dph = zero, ddph = zero;
    if (!slides_a) swing_slopes(w, a, false, dp, ddp), swing_slopes(ha, a, false, dph, ddph);
    if (!slides_c) swing_slopes(u, c, false, dr, ddr);
    flat = {climb + dot(ph, At) + dot(r, Bt) + rise_a * a + rise_c * c, dot(dph, At) + rise_a, dot(dr, Bt) + rise_c,
            dot(ddph, At), dot(ddr, Bt)};
    if (std::fabs(p.z) < 0.5) {
      bent = {p.z - r.z, dp.z, -dr.z, ddp.z, -ddr.z};
    } else {
      bent = aside_of_z(p, dp, ddp, r, dr, ddr);
    }
    flatter_first(flat, bent);
  }
};

// The four swings and the pair of equations of the joints around a plane: h in the frames of a and b, k in those of c and b.
template <class F> struct PlaneProblem {
  Vec3T<F> h, k, At, Bt;
  F climb;  // height the three joints have to make up for
  SwingT<F> ha, w, kc, u;
  F M[2][2], N[2][2], e[2];

  PIEPER_INLINE PlaneProblem(const LoopRestT<F>& rest, const bool* slides) {
    const RigidT<F>&A = rest.A, &B = rest.B;
    const F zero(0.0);
    const Vec3T<F> none = {zero, zero, zero};
    h = {rest.pre.x.z, rest.pre.y.z, rest.pre.z.z};
    k = rest.C.z;
    At = A.t, Bt = B.t;
    climb = rest.pre.t.z + dot(k, rest.C.t);
    // w(a) = A^T Za^T h, u(c) = B Zc k as swings of directions: a sliding joint does not turn them
    ha = slides[0] ? SwingT<F>{h, none, none} : SwingT<F>{{zero, zero, h.z}, {h.x, h.y, zero}, {h.y, -h.x, zero}};
    w = {turn_back(A, ha.at), turn_back(A, ha.first), turn_back(A, ha.second)};
    kc = slides[2] ? SwingT<F>{k, none, none} : SwingT<F>{{zero, zero, k.z}, {k.x, k.y, zero}, {-k.y, k.x, zero}};
    u = {turn(B, kc.at), turn(B, kc.first), turn(B, kc.second)};
    if (!slides[1]) {
      M[0][0] = w.first.z, M[0][1] = w.second.z;
      N[0][0] = -u.first.z, N[0][1] = -u.second.z;
      e[0] = u.at.z - w.at.z;
      M[1][0] = slides[0] ? h.z : dot(ha.first, At), M[1][1] = slides[0] ? zero : dot(ha.second, At);
      N[1][0] = slides[2] ? k.z : dot(u.first, Bt), N[1][1] = slides[2] ? zero : dot(u.second, Bt);
      e[1] = -climb - dot(ha.at, At) - dot(u.at, Bt);
    } else {  // the sliding middle joint leaves both directions alone: w(a) = u(c), one equation for each alone
      Vec3T<F> along_c = turn(A, B.z), along_a = turn_back(B, Vec3T<F>{A.x.z, A.y.z, A.z.z});
      M[0][0] = dot(ha.first, along_c), M[0][1] = dot(ha.second, along_c);
      N[0][0] = N[0][1] = zero;
      e[0] = k.z - dot(ha.at, along_c);
      M[1][0] = M[1][1] = zero;
      N[1][0] = dot(kc.first, along_a), N[1][1] = dot(kc.second, along_a);
      e[1] = h.z - dot(kc.at, along_a);
    }
  }
};

// The values of joints a, b, c that leave the rest to the plane.
// `apart`, `first_c`: of PairSystem.
inline void solve_around_plane(const LoopRest& rest, const bool* slides, bool apart, bool first_c, PositionRoots& out) {
  const PlaneProblem<double> P(rest, slides);
  const auto& [h, k, At, Bt, climb, ha, w, kc, u, M, N, e] = P;
  PairSystem s;
  s.slides_a = slides[0];
  s.slides_c = slides[2];
  s.apart = apart, s.first_c = first_c;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) s.M[i][j] = M[i][j], s.N[i][j] = N[i][j];
    s.e[i] = e[i];
  }
  PairRoots pairs;
  solve_pair(s, pairs);
  out.degenerate = pairs.degenerate;
  const PlaneEquations equations{ha,    w,         kc,       u, At, Bt, slides[0] ? h.z : 0, slides[2] ? k.z : 0,
                                 climb, slides[0], slides[2]};
  for (int i = 0; i < pairs.count; ++i) {
    double refined[2][2] = {{pairs.a[i], pairs.c[i]}, {}};
    int branches = slides[1] ? 1 : refine_pair(equations, pairs.a[i], pairs.c[i], refined);
    for (int n = 0; n < branches; ++n) {
      double a = refined[n][0], c = refined[n][1], middle;
      Vec3 from = direction_at(u, c, slides[2]), to = direction_at(w, a, slides[0]);
      bool free = false;
      if (!slides[1]) {
        middle = turn_between(from, to, free);
      } else if (std::fabs(to.z) > kPairLinear) {
        middle = -(climb + dot(direction_at(ha, a, slides[0]), At) + dot(from, Bt) + (slides[0] ? a * h.z : 0) +
                   (slides[2] ? c * k.z : 0)) /
                 to.z;
      } else {  // the slide runs along the plane, which makes up for any value of it; the height is there or is not
        middle = 0, free = true;
      }
      out.degenerate |= free;
      const bool nearly =
          !slides[1] && std::fmin(from.x * from.x + from.y * from.y, to.x * to.x + to.y * to.y) < kNearMiddleAxis;
      out.add(a, middle, c, free ? Free::YES : nearly ? Free::NEARLY : Free::NO);
    }
  }
}

// By how much joint b must turn for three turning joints of the plane to reach: the square of how far they must is a harmonic of it, and
// is brought as near as it can be to the middle of what they can. With its twin on the other side of the harmonic's phase.
template <class Far> void turn_to_reach(Far far, double a, double b, double* out) {
  const double r0 = far(0), r1 = far(2 * kPi / 3), r2 = far(-2 * kPi / 3);
  const double middle = (r0 + r1 + r2) / 3, cosine = r0 - middle, sine = (r1 - r2) / std::sqrt(3.0),
               size = std::hypot(cosine, sine), phase = std::atan2(sine, cosine);
  // what they can reach of [middle - size, middle + size]
  const double low = std::fmax((a - b) * (a - b), middle - size), high = std::fmin((a + b) * (a + b), middle + size);
  const double away =
      std::acos(std::fmin(std::fmax((0.5 * (low + high) - middle) / std::fmax(size, kTiny), -1.0), 1.0));
  out[0] = phase + away, out[1] = phase - away;
}

// The same for a slide along the plane: the square of how far they must reach goes with the square of its value.
template <class Far> void slide_to_reach(Far far, double a, double b, double* out) {
  const double here = far(0), ahead = far(1), back = far(-1);
  const double bent = std::fmax(0.5 * (ahead + back) - here, kTiny), nearest = 0.25 * (back - ahead) / bent;
  const double least = here - bent * nearest * nearest;
  const double low = std::fmax((a - b) * (a - b), least),
               away = std::sqrt(std::fmax(0.5 * (low + (a + b) * (a + b)) - least, 0.0) / bent);
  out[0] = nearest + away, out[1] = nearest - away;
}

// The same where the plane's own slide stands at an end of it and two turns beside: how far its line passes their circle's centre goes
// with the joint's value, and is brought to nothing. `past`: that distance.
template <class Past> double slide_to_line(Past past) {
  const double here = past(0), slope = past(1) - here;
  return std::fabs(slope) > kPairLinear ? -here / slope : 0;
}

// One pose.
inline void solve_three_parallel(const GroupArm& own, const PlanarLink& l1, const PlanarLink& l2, const double* T,
                                 double* q, std::uint8_t* valid, std::uint8_t* flag) {
  solve_beside_group(
      own, T, q, valid, flag,
      [&](const LoopRest& rest, const bool* slides, bool apart, PositionRoots& roots) {
        solve_around_plane(rest, slides, apart, own.first_c, roots);
      },
      [&](double* arm, Free free, const auto& around, const auto& put, Found& found) {
        // a free joint turns or slides to where the plane can reach: with slides in the plane that is searched
        const bool* slides = own.slides + own.first;
        const bool along = own.slides[own.order[1]];
        const bool turning = !(slides[0] || slides[1] || slides[2]);
        double values[16] = {arm[1]};
        int tries = 1;
        if (free != Free::NO && turning) {
          double* to_reach = values + (free == Free::NEARLY);
          const auto far = [&](double by) {
            double moved[3] = {arm[0], arm[1] + by, arm[2]};
            const Rigid left = around(moved);
            return left.t.x * left.t.x + left.t.y * left.t.y;
          };
          const double upper = std::hypot(l1.at.x, l1.at.y), lower = std::hypot(l2.at.x, l2.at.y);
          if (along) slide_to_reach(far, upper, lower, to_reach);
          else turn_to_reach(far, upper, lower, to_reach);
          to_reach[0] += arm[1], to_reach[1] += arm[1];
          tries = static_cast<int>(to_reach - values) + 2;
        } else if (free == Free::YES) {
          // a slide is tried ever farther away, both ways, in lengths of the arm
          for (tries = 0; tries < 16; ++tries)
            values[tries] = along ? (tries % 2 ? -0.25 : 0.25) * ((tries + 1) / 2) : arm[1] + tries * (2 * kPi / 16);
          if (along && slides[0] + slides[1] + slides[2] == 1 && !slides[1])
            values[0] = slide_to_line([&](double by) {
              double moved[3] = {arm[0], by, arm[2]};
              const Rigid left = around(moved);
              const Flat to = {left.t.x, left.t.y};
              if (slides[0]) return to.y - l1.at.y;
              return flat_turn(-std::atan2(left.x.y - left.y.x, left.x.x + left.y.y), to).y -
                     flat_turn(-l2.angle, l2.at).y;
            });
        }
        const bool all = turning && free == Free::YES;  // both sides of what is free; elsewhere the first that reaches
        const int before = found.count;
        for (int trial = 0; trial < tries && (all || found.count == before); ++trial) {
          arm[1] = values[trial];
          const Rigid left = around(arm);
          double plane[2][3];
          bool shared = false;
          const int bends =
              solve_planar(l1, l2, own.slides + own.first, std::atan2(left.x.y - left.y.x, left.x.x + left.y.y),
                           {left.t.x, left.t.y}, plane, shared);
          found.degenerate |= shared;
          for (int s = 0; s < bends; ++s) {
            for (int j = 0; j < 3; ++j) plane[s][j] *= own.sense[j];
            put(arm, plane[s]);
          }
        }
      });
}

}  // namespace pieper::PIEPER_ISA::closed_form
