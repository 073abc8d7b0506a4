// Three joints of any kinds that place the tool's point. Scalar.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

struct Position3 : Geometry {
  static constexpr const char* name = "position3";
  static constexpr const char* doc = "Three joints of any kinds that place the tool's point.";
  static constexpr int joints = 3, slots = 4;
  double length;          // m
  double links[4][4][4];  // m
  bool slides[3];

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    visit("length", self.length), visit("links", self.links), visit("slides", self.slides);
  }
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "closed_form/careful/position.hpp"

namespace pieper::PIEPER_ISA {

class Position3Kernel {
 public:
  static constexpr bool in_order = false;
  explicit Position3Kernel(const Position3& arm) : arm_(arm) { read_links(arm.links, arm.length, links_); }

  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    using namespace closed_form;
    constexpr int M = Position3::slots;
    const TrueChain chain{3, arm_.length, links_, arm_.slides, true};
    for (long i = 0; i < count; ++i) {
      const Rigid pose = read_rigid(T + 16 * i, chain.length);
      PositionRoots roots;
      solve_position(links_[1], links_[2], links_[3].t, move_back(links_[0], pose.t), arm_.slides, false, false, roots);
      double room[M * 3];
      Found found{3, M, 0, room};
      found.degenerate = roots.degenerate;
      for (int k = 0; k < roots.count; ++k) offer(chain, pose, roots.q[k], found);
      write_out(chain, pose, found, q + i * M * 3, valid + i * M, flag + i);
    }
  }

 private:
  const Position3& arm_;
  Rigid links_[4];
};

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
