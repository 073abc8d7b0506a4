// The general solver as the rest sees it: what it is told of an arm, and its call.
#pragma once

#include "dispatch/geometry.hpp"

namespace pieper {

// Making a model tries every way of elimination on test poses, so it is made once and shared by all solvers of the arm.
struct General : Geometry {
  static constexpr const char* name = "general";
  static constexpr const char* doc =
      "Any six joints; making it tries every way of elimination. `trials` and `usable` say how that went.";
  static constexpr int joints = 6, slots = 16;
  double links[7][4][4];  // frames slid along their axes towards each other, m
  bool slides[6];
  double scale;  // m per unit of length inside

  // What the trials left: the model, and for every hand-out of roles (shift, direction, swap) rank (1 the best way, 0 of no use),
  // solutions missed, eigenvalues left open, noise. `usable`: how many ways there are; 0 where the arm is beyond this solver.
  const void* model = nullptr;
  double trials[24][4];
  int usable = 0;

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    visit("links", self.links), visit("slides", self.slides), visit("scale", self.scale);
  }
};

}  // namespace pieper

#ifdef PIEPER_ISA
namespace pieper::PIEPER_ISA {

void make_model(General& arm);
void drop_model(General& arm);
void solve_general(const General& arm, const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag);

}  // namespace pieper::PIEPER_ISA
#endif  // PIEPER_ISA
