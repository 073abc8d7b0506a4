// Three revolute axes of which the orientation alone counts; the chain may stand anywhere. Scalar.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

struct Orientation3 : Geometry {
  static constexpr const char* name = "orientation3";
  static constexpr const char* doc = "Three revolute joints of which the orientation alone counts.";
  static constexpr int joints = 3, slots = 2;
  double links[4][4][4];

  template <class Self, class Visit> static void fields(Self& self, Visit visit) { visit("links", self.links); }
};

}  // namespace pieper

#ifdef PIEPER_ISA
#include "closed_form/careful/orientation.hpp"

namespace pieper::PIEPER_ISA {

class Orientation3Kernel {
 public:
  static constexpr bool in_order = false;
  explicit Orientation3Kernel(const Orientation3& arm) {
    read_links(arm.links, 1, links_);
    for (auto& link : links_) link.t = {0, 0, 0};
    wrist_ = closed_form::read_wrist(links_[1], links_[2]);
  }

  void solve(const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) const {
    using namespace closed_form;
    static constexpr bool turning[3] = {};
    const TrueChain chain{3, 1.0, links_, turning, false};
    for (long i = 0; i < count; ++i) {
      Rigid pose = read_rigid(T + 16 * i, 1);
      pose.t = {0, 0, 0};
      double angles[2][3], room[6];
      bool lined_up;
      const int candidates = solve_wrist(wrist_, inverse(links_[0]) * pose * inverse(links_[3]), angles, lined_up);
      Found found{3, 2, 0, room};
      found.degenerate = lined_up;
      for (int k = 0; k < candidates; ++k) offer(chain, pose, angles[k], found);
      write_out(chain, pose, found, q + i * 6, valid + i * 2, flag + i);
    }
  }

 private:
  Rigid links_[4];
  closed_form::Wrist wrist_;
};

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
