// One pose of an arm whose joints are a group of three, a wrist or a plane, and the three beside it.
// Scalar: the road of closed_form/careful.
#pragma once

#include "closed_form/careful/group.hpp"
#include "closed_form/careful/position.hpp"

namespace pieper::PIEPER_ISA::closed_form {

// `position(rest, slides, apart, roots)` finds the joints beside the group, and `complete(arm, free, around, put, found)` the group's
// for each of them: `around(arm)` is what the loop leaves to the group, `put(arm, group)` offers both together as a row.
template <class Position, class Complete>
inline void solve_beside_group(const GroupArm& own, const double* T, double* q, std::uint8_t* valid, std::uint8_t* flag,
                               Position position, Complete complete) {
  constexpr int kSlots = 8;
  const TrueChain chain = own.chain();
  const Rigid pose = read_rigid(T, chain.length);
  const LoopRest rest(own.links, pose, own.first);
  bool slides[3];
  for (int k = 0; k < 3; ++k) slides[k] = own.slides[rest.joints[k]];
  double room[kSlots * 6];
  Found found{6, kSlots, 0, room};
  const auto around = [&](const double* arm) {
    Rigid frame = joint(rest.pre, arm[0], slides[0]) * rest.A;
    frame = joint(frame, arm[1], slides[1]) * rest.B;
    return inverse(joint(frame, arm[2], slides[2]) * rest.C);
  };
  const auto put = [&](const double* arm, const double* group) {
    double candidate[6];
    for (int j = 0; j < 3; ++j) candidate[rest.joints[j]] = arm[j], candidate[own.first + j] = group[j];
    offer(chain, pose, candidate, found);
  };
  // where rows cannot be told from curves the quartic has its say too
  for (bool apart = own.apart, again = true; again; again = apart && !settled(chain, pose, found), apart = false) {
    PositionRoots roots;
    position(rest, slides, apart, roots);
    found.degenerate |= roots.degenerate;
    for (int k = 0; k < roots.count; ++k) complete(roots.q[k], roots.free[k], around, put, found);
  }
  write_out(chain, pose, found, q, valid, flag);
}

}  // namespace pieper::PIEPER_ISA::closed_form
