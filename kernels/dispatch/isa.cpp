// Everything that is compiled once per instruction set, and the table through which it is called.
//
// To add a family:
//   1. write kernels/<family>.hpp in namespace pieper::PIEPER_ISA: a struct with `joints`, `slots` and
//      `template <class F> static void solve(const double* params, const int* iparams, const Pose<F>&, Branches<F, slots, joints>&)`
//      (see batch.hpp; spherical_wrist_parallel.hpp is the model), or a whole SolveFn of your own when lanes are used otherwise;
//   2. include it below;
//   3. add one line to `families` (FamilyEntry in isa.hpp). The string is the `kind` that KernelSpec carries in Python; slots and joints are
//      given there too (KernelSpec.max_solutions, the chain's n).
// CMake compiles this file with -DPIEPER_ISA=<namespace> -DPIEPER_LANES=<width>. Keep templates of the standard library
// out of the headers: the linker merges them across instruction sets.
#include "dispatch/isa.hpp"

#include "lanes/batch.hpp"
#include "chain/forward.hpp"
#include "chain/limits.hpp"
#include "chain/posecheck.hpp"
#include "chain/row_order.hpp"
// families
#include "closed_form/closed_forms.hpp"
#include "elimination/entry.hpp"
#include "closed_form/lanes/spherical_wrist_parallel.hpp"

#define PIEPER_TEXT2(x) #x
#define PIEPER_TEXT(x) PIEPER_TEXT2(x)
#define PIEPER_JOIN2(a, b) a##b
#define PIEPER_JOIN(a, b) PIEPER_JOIN2(a, b)

namespace pieper {
namespace PIEPER_ISA {

const FamilyEntry families[] = {
    {"spherical_wrist_parallel", &solve_batch<SphericalWristParallel>, true},
    {"spherical_wrist", &closed_spherical_wrist, true, &prepare_spherical_wrist, kClosedParams, kPreparedClosed},
    {"three_parallel", &closed_three_parallel, true, &prepare_three_parallel, kClosedParams, kPreparedClosed},
    {"offset_wrist", &offset_wrist_any, false},
    {"offset_wrist_alike", &offset_wrist_alike, false},
    {"two_slides", &two_slides_any, false},
    {"position3", &closed_position3, false},
    {"orientation3", &closed_orientation3, false},
    {"general", &solve_general, false},
};

void order_rows(double* q, std::uint8_t* valid, long count, int slots, int n, const std::uint8_t* prismatic) {
  for (long i = 0; i < count; ++i) put_in_order(q + i * slots * n, valid + i * slots, slots, n, prismatic);
}

void elementary(int what, const double* x, long count, double* out) {
  constexpr int W = PIEPER_LANES;
  for (long i = 0; i < count; i += W) {
    const int lanes = count - i < W ? static_cast<int>(count - i) : W;
    Lanes<W> a(1.0), b(1.0), s, c;
    for (int k = 0; k < lanes; ++k) {
      a.v[k] = what == 0 ? x[i + k] : x[2 * (i + k)];
      b.v[k] = what == 0 ? 0.0 : x[2 * (i + k) + 1];
    }
    if (what == 0) sincos(a, s, c);
    else s = atan2(a, b);
    for (int k = 0; k < lanes; ++k) {
      if (what == 0) out[2 * (i + k)] = lane(s, k), out[2 * (i + k) + 1] = lane(c, k);
      else out[i + k] = lane(s, k);
    }
  }
}

}  // namespace PIEPER_ISA

const IsaTable& PIEPER_JOIN(isa_, PIEPER_ISA)() {
  using namespace PIEPER_ISA;
  static const IsaTable table = {PIEPER_TEXT(PIEPER_ISA),
                                 PIEPER_LANES,
                                 families,
                                 static_cast<int>(sizeof(families) / sizeof(families[0])),
                                 &forward_fk,
                                 &forward_frames,
                                 &forward_jacobian,
                                 &pose_deviation,
                                 &pose_straighten,
                                 &apply_limits,
                                 &order_rows,
                                 &general_model_size,
                                 &general_model,
                                 &elementary};
  return table;
}

}  // namespace pieper
