// What one build of the kernels (one instruction set) offers; plain types, no templates, no vector types.
#pragma once

#include <cstdint>

#include "collision/model.hpp"
#include "dispatch/geometry.hpp"
#include "time_law/timed_path.hpp"

#define PIEPER_TEXT2(x) #x
#define PIEPER_TEXT(x) PIEPER_TEXT2(x)
#define PIEPER_JOIN2(a, b) a##b
#define PIEPER_JOIN(a, b) PIEPER_JOIN2(a, b)

namespace pieper {

struct General;

// A family's kernel for one arm, made once from its geometry, which must outlive it.
// T: count x 16 row-major, proper rotations. q: count x slots x joints, zeros where not valid. valid: count x slots. flag: count.
struct FamilyEntry {
  const char* name;
  int joints, slots;
  bool in_order;  // rows come in an order of their own (by branch, or sorted); else the solver sorts them
  const void* (*make)(const Geometry&);
  void (*drop)(const void* kernel);
  void (*solve)(const void* kernel, const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag);
  // Checks, solves, limits and stores poses in one go, with limits of which `once` holds; null for a family that leaves that to others.
  // False where a pose departs from a rigid motion by more than is exact: what has been written then is of no meaning.
  bool (*solve_inside)(const void* kernel, const double* T, long count, const Directly& how, const Answers& to);
};

// How rows of a pose are compared with a joint vector (chain/selection.hpp). lower, upper: of q, slack included, rad or m;
// weight: of the squared differences, the units of sliding joints in it.
struct Selection {
  int n;
  const double *lower, *upper, *weight;
  const std::uint8_t* prismatic;
};

struct DownhillChain;  // chain/nearer.hpp
struct Crawl;          // chain/closest.hpp

// Joints of a chain whose postures descend side by side, at most.
inline constexpr int kDescendingJoints = 12;
// What Newton's step is where a matrix A (m x m, written over) has eigenvalues below zero: x solves (|A| + damping largest) x = b.
using IndefiniteStep = void (*)(int m, double* A, double damping, const double* b, double* x);

struct IsaTable {
  const char* name;
  int lanes;
  const FamilyEntry* const* families;  // in the order of the table

  // links: (n + 1) x 16 row-major; q: count x n. out: count x 16.
  void (*fk)(const double* links, const std::uint8_t* prismatic, int n, const double* q, long count, double* out);
  // base: 16; after: n x 16. out: count x (n + 2) x 16.
  void (*frames)(const double* links, const std::uint8_t* prismatic, int n, const double* base, const double* after,
                 const double* q, long count, double* out);
  // out: count x 6 x n, linear rows first.
  void (*jacobian)(const double* links, const std::uint8_t* prismatic, int n, const double* q, long count, double* out);

  // J: count x 36, row-major, linear rows first. out: count x 2, the determinant, and the smallest singular value with lengths divided
  // by `length`.
  void (*posture_measures)(const double* J, long count, double length, double* out);

  // For each of count poses: how far it is from a rigid motion (max abs of R^T R - 1 and of the last row; 2 when left
  // handed; NaN when not finite). Returns the largest; NaN counts as largest.
  double (*deviation)(const double* T, long count, double* out);
  // The nearest rotation (polar factor) of each pose whose deviation exceeds `exact`; copies the others.
  void (*straighten)(const double* T, const double* deviation, double exact, long count, double* out);
  // Whole turns where only they lie inside; in_limits: count x slots, false where not valid.
  void (*limits)(double* q, const std::uint8_t* valid, long rows, int n, const double* lower, const double* upper,
                 const std::uint8_t* prismatic, std::uint8_t* in_limits);

  // Moves the valid rows of each of count poses to the front, ordered by their joint values (row_order.hpp).
  void (*put_in_order)(double* q, std::uint8_t* valid, long count, int slots, int n, const std::uint8_t* prismatic);

  // Rows chosen near joint vectors, or near the one chosen before; and what is known of each pose (chain/selection.hpp).
  void (*choose)(const Selection& by, const double* q, const std::uint8_t* inside, long count, int slots,
                 const double* near, int stride, double* chosen, std::uint8_t* has);
  void (*choose_in_turn)(const Selection& by, const double* q, const std::uint8_t* inside, long count, int slots,
                         double* now, bool* started, double* chosen, std::uint8_t* has);
  void (*outcomes)(const std::uint8_t* valid, const std::uint8_t* inside, long count, int slots, std::uint8_t* out);
  // Copies past the cache.
  void (*stream)(double* to, const double* from, long count);

  // Downhill from count rows q (written over) as `nearer` says, many side by side; left: count x 2, half the square of the way and
  // 1 - cos of the turn. No coupled joints, at most kDescendingJoints.
  void (*downhill)(const DownhillChain& chain, const double* T, double turning, int steps, IndefiniteStep indefinite,
                   long count, double* q, double* left);
  // The same to the position alone, as `Crawl` says; left: count, half the square of the way.
  void (*crawl)(const DownhillChain& chain, const double* T, const Crawl& how, long count, double* q, double* left);

  // The general solver's model of an arm (elimination/general.hpp).
  void (*make_model)(General& arm);
  void (*drop_model)(General& arm);

  // Distances of bodies and the swept proof (collision/nearest.hpp, sweep.hpp); rooms come from the caller.
  void (*collision_nearest)(const CollisionModel& m, const double* q, long count, void* room, double* distance,
                            int* pair, double* points, double* normal, double* each);
  Sweep (*collision_sweep)(const CollisionModel& m, const double* q, long count, double margin, double gap,
                           double slack, void* room, int* lists, const OuterPairs& outer);
  long (*sweep_bytes)(const CollisionModel& m);
  int (*sweep_levels)();

  // Time laws (time_law/fastest.hpp, in_time.hpp); the room, in doubles, comes from the caller.
  long (*fastest_doubles)(const TimedPath& path);
  Timing (*fastest)(const TimedPath& path, double start, double end, double* room, double* x, double* highest);
  void (*peak_ratios)(const CubicPieces& p, const double* x, const double* speed, const double* acceleration,
                      const double* share, double* out);
  void (*jerk_ratios)(const CubicPieces& curve, long pieces, const double* t, const double* c, const JerkBounds& bounds,
                      const double* coefficients, int places, double* out, double* fastest);
  void (*in_time)(const CubicPieces& p, long pieces, const double* t, const double* c, const double* times, long count,
                  double* s, double* q, double* dq, double* ddq, double* dddq);

  // sin and cos (what = 0: out is count x 2), or of pairs (x is count x 2) atan2 (what = 1) or the angle of one of length one
  // (what = 2), for the tests.
  void (*elementary)(int what, const double* x, long count, double* out);
};

const IsaTable& isa_baseline();
const IsaTable& isa_avx2();
const IsaTable& isa_avx512();

// The build chosen for this processor, or the one that environment variable PIEPER_ISA names.
const IsaTable& isa();
// Names of the builds this processor can run, separated by blanks.
const char* isa_names();

}  // namespace pieper
