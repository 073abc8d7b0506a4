// What a family is told of an arm: plain structs with named fields, the same for Python and for every instruction set.
//
// A family's struct says its `name`, how many `joints` an arm of it has and how many `slots` a pose, its `doc`, and hands its fields
// to a visitor, each with its name: from that the binding makes keyword arguments, attributes and a state to be pickled.
#pragma once

#include <cstdint>

namespace pieper {

// What `many` and `one` say of a pose, one bit each. Kernels set the first three and the last, the solver the fourth; the
// others are Python's.
enum class Flag : std::uint8_t {
  DEGENERATE = 1,      // so near a singular pose that self-motions or merged roots are possible
  UNCERTAIN = 2,       // the family cannot vouch that nothing is missing
  OUT_OF_REACH = 4,    // no solution, for reasons of reach
  ROUNDED = 8,         // the rotation was replaced by the nearest exact one
  NO_ARM_ANGLE = 16,   // the arm angle is undefined here
  COUNT_CHANGES = 32,  // the arm as described has another number of solutions here than the one that was solved
  AT_ARM_ANGLE = 64,   // solved at a chosen arm angle
  EDGE = 128,  // no solution, and not far enough beyond the edge of reach to tell that poses beside it have none either
};
inline constexpr std::uint8_t kDegenerate = 1, kUncertain = 2, kOutOfReach = 4, kRounded = 8, kEdge = 128;

// A direction or a point.
struct Vector {
  double x, y, z;
};

// Up to six whole numbers.
struct Choice {
  int count = 0, at[6] = {};
};

// Limits of q (rad, m; infinite where there is none), slack included, and which joints slide.
struct JointLimits {
  const double *lower, *upper;
  const std::uint8_t* prismatic;
  bool
      once;  // no lower one above half a turn, no upper one below minus half a turn: one turn or none brings a value in (-pi, pi] inside
};

// Where answers go: q count x slots x joints, valid and in_limits count x slots, flag and outcome count (0 no rows, 1
// rows outside the limits alone, 2 a row inside).
struct Answers {
  double* q;
  std::uint8_t *valid, *in_limits, *flag, *outcome;
};

// How poses are checked, solved, limited and stored in one go.
struct Directly {
  JointLimits limits;
  double exact;     // poses that depart less from rigid motions are solved as they are
  bool past_cache;  // rows are written past the cache
};

struct Geometry {
  int family = -1;  // its place in the table of families
};

struct General;  // elimination/entry.hpp

// Three neighbouring joints that are solved together, a wrist or a plane, and the three beside them: of two families.
struct Group : Geometry {
  static constexpr int joints = 6, slots = 8;
  double length = 1;      // of the arm, m
  double links[7][4][4];  // as described, m
  double loop[7][4][4];   // the same, frames of the group moved along and about its axes as the family wants them, m
  bool slides[6];
  int first;                    // joint of the group, 0-based
  double sense[3] = {1, 1, 1};  // of the group's joints in `loop`
  bool hide_c, first_c,
      apart;  // how the pair of equations of the joints beside the group is solved (closed_form/lanes/pair.hpp)

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    visit("length", self.length), visit("links", self.links), visit("loop", self.loop), visit("slides", self.slides);
    visit("first", self.first), visit("hide_c", self.hide_c), visit("first_c", self.first_c),
        visit("apart", self.apart);
  }
};

// What every family that hides an angle is told.
struct HiddenAngle : Geometry {
  double length;          // m
  double links[7][4][4];  // of the arm that is solved, already reversed where `backward`, m
  bool slides[6] = {};
  bool backward = false;   // the arm was reversed, tool for base
  const General* general;  // solves what is not clear, of the arm as it stands; null: that is said to be uncertain

  template <class Self, class Visit> static void fields(Self& self, Visit visit) {
    visit("length", self.length), visit("links", self.links), visit("general", self.general);
  }
};

}  // namespace pieper
