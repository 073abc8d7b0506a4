// Six joints, three neighbouring revolute axes through one point, wherever they stand in the chain.
//
// The loop L0 Z1 L1 ... Z6 L6 T^-1 = I may be entered anywhere: W Pre Za A Zb B Zc C = I with W the three wrist joints.
// W keeps the wrist's centre, so Za A Zb B Zc (C o) = Pre^-1 o is a positioning problem of three joints (at most four solutions), and W is
// then a known rotation (two): eight in all. One of Pre, A, B, C holds the pose.
// Scalar: the careful twin of closed_form/lanes/spherical_wrist.hpp.
#pragma once

#include "closed_form/careful/group.hpp"
#include "closed_form/careful/orientation.hpp"
#include "closed_form/careful/position.hpp"

namespace pieper::PIEPER_ISA::closed_form {

// One pose.
inline void solve_spherical_wrist(const GroupArm& own, const Wrist& wrist, const double* T, double* q,
                                  std::uint8_t* valid, std::uint8_t* flag) {
  constexpr int kSlots = 8;
  const TrueChain chain = own.chain();
  const int first = own.first;
  Rigid pose = read_rigid(T, chain.length);
  LoopRest rest(own.links, pose, first);
  bool slides[3];
  for (int k = 0; k < 3; ++k) slides[k] = own.slides[rest.joints[k]];
  double room[kSlots * 6];
  Found found{6, kSlots, 0, room};
  // where rows cannot be told from curves the quartic has its say too
  for (bool apart = own.apart, again = true; again; again = apart && !settled(chain, pose, found), apart = false) {
    PositionRoots roots;
    solve_position(rest.A, rest.B, rest.C.t, turn_back(rest.pre, -1.0 * rest.pre.t), slides, apart, own.first_c, roots);
    found.degenerate |= roots.degenerate;
    for (int k = 0; k < roots.count; ++k) {
      const double* arm = roots.q[k];
      Rigid around = joint(rest.pre, arm[0], slides[0]) * rest.A;
      around = joint(around, arm[1], slides[1]) * rest.B;
      around = joint(around, arm[2], slides[2]) * rest.C;
      double angles[2][3], candidate[6];
      bool lined_up;
      int turns = solve_wrist(wrist, inverse(around), angles, lined_up);
      for (int s = 0; s < turns; ++s) {
        for (int j = 0; j < 3; ++j) candidate[rest.joints[j]] = arm[j], candidate[first + j] = angles[s][j];
        int before = found.count;
        offer(chain, pose, candidate, found);
        if (lined_up && found.count > before) found.degenerate = true;
      }
    }
  }
  write_out(chain, pose, found, q, valid, flag);
}

}  // namespace pieper::PIEPER_ISA::closed_form
