// Six joints, three neighbouring revolute axes through one point, wherever they stand in the chain.
//
// The loop L0 Z1 L1 ... Z6 L6 T^-1 = I may be entered anywhere: W Pre Za A Zb B Zc C = I with W the three wrist joints.
// W keeps the wrist's centre, so Za A Zb B Zc (C o) = Pre^-1 o is a positioning problem of three joints (at most four solutions), and W is
// then a known rotation (two): eight in all. One of Pre, A, B, C holds the pose.
// Scalar: the careful twin of closed_form/lanes/spherical_wrist.hpp.
#pragma once

#include "closed_form/careful/beside_group.hpp"
#include "closed_form/careful/orientation.hpp"

namespace pieper::PIEPER_ISA::closed_form {

// One pose.
inline void solve_spherical_wrist(const GroupArm& own, const Wrist& wrist, const double* T, double* q,
                                  std::uint8_t* valid, std::uint8_t* flag) {
  solve_beside_group(
      own, T, q, valid, flag,
      [&](const LoopRest& rest, const bool* slides, bool apart, PositionRoots& roots) {
        const Vec3 centre = turn_back(rest.pre, -1.0 * rest.pre.t);
        solve_position(rest.A, rest.B, rest.C.t, centre, slides, apart, own.first_c, roots);
      },
      [&](const double* arm, Free, const auto& around, const auto& put, Found& found) {
        double angles[2][3];
        bool lined_up;
        const int turns = solve_wrist(wrist, around(arm), angles, lined_up);
        for (int s = 0; s < turns; ++s) {
          const int before = found.count;
          put(arm, angles[s]);
          if (lined_up && found.count > before) found.degenerate = true;
        }
      });
}

}  // namespace pieper::PIEPER_ISA::closed_form
