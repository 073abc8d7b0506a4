// What is compiled once per instruction set beside the families, and the table through which all of it is called.
//
// CMake compiles this file with -DPIEPER_ISA=<namespace> -DPIEPER_LANES=<width>. Keep templates of the standard library
// out of the headers: the linker merges them across instruction sets.
#include "dispatch/isa.hpp"

#include "chain/downhill_lanes.hpp"
#include "chain/forward.hpp"
#include "chain/limits.hpp"
#include "chain/outcomes.hpp"
#include "chain/posecheck.hpp"
#include "chain/row_order.hpp"
#include "chain/selection.hpp"
#include "collision/nearest.hpp"
#include "collision/sweep.hpp"
#include "elimination/entry.hpp"
#include "lanes/stream.hpp"
#include "maps/posture_measures.hpp"
#include "time_law/fastest.hpp"
#include "lanes/unit_angle.hpp"
#include "time_law/in_time.hpp"

namespace pieper {
namespace PIEPER_ISA {

#define PIEPER_FAMILY(name) extern const FamilyEntry name##Entry;
#include "families.def"
#undef PIEPER_FAMILY

const FamilyEntry* const families[] = {
#define PIEPER_FAMILY(name) &name##Entry,
#include "families.def"
#undef PIEPER_FAMILY
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
    else s = what == 1 ? atan2(a, b) : unit_angle(a, b);
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
                                 &forward_fk,
                                 &forward_frames,
                                 &forward_jacobian,
                                 &posture_measures,
                                 &pose_deviation,
                                 &pose_straighten,
                                 &apply_limits,
                                 &order_rows,
                                 &choose,
                                 &choose_in_turn,
                                 &outcomes,
                                 &copy_past_cache,
                                 &go_downhill,
                                 &crawl_to_place,
                                 &make_model,
                                 &drop_model,
                                 &collision_nearest,
                                 &collision_sweep,
                                 &sweep_bytes,
                                 &sweep_levels,
                                 &fastest_doubles,
                                 &fastest,
                                 &peak_ratios,
                                 &jerk_ratios,
                                 &in_time,
                                 &elementary};
  return table;
}

}  // namespace pieper
