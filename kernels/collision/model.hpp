// Bodies on a chain and around it, and the pairs of them that are looked at; plain numbers for every instruction set.
#pragma once

#include <cstdint>

namespace pieper {

enum class Solid : std::uint8_t { SEGMENT = 0, BOX = 1, CYLINDER = 2 };

struct CollisionModel {
  int n;                          // joints
  const double* links;            // (n + 1) x 16
  const std::uint8_t* prismatic;  // n
  int bodies;                     // of the arm first, then of the scene
  const int* link;                // bodies: how many joints move it, 0 for what stands still
  const double* place;            // bodies x 16: in the frame just after its last joint has moved, or in the world
  const double* half;             // bodies x 3: (0, 0, half length), a box's, or (radius, radius, half height)
  const double* radius;           // bodies: a layer about it
  const std::uint8_t* kind;       // bodies: Solid
  int pairs;
  const int* pair;            // pairs x 2, the body with the lower link second
  const std::uint8_t* outer;  // pairs: whether the two are only what encloses the real ones
};

// What a path comes to; s counts segments: 3.25 is a quarter behind point 3.
struct Sweep {
  bool hit;
  double hit_s;
  int hit_pair;
  double hit_distance;
  long doubtful;  // places that are neither proved clear nor seen to hit
  double doubtful_s;
  int doubtful_pair;
  double doubtful_distance;
  long evaluated;  // postures
};

// Told of every segment on which an enclosing pair is not proved clear.
struct OuterPairs {
  void* context;
  void (*told)(void* context, long segment, int pair);
};

}  // namespace pieper
