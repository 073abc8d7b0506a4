// The closed-form families of closed_forms.cpp and hidden_angle.cpp, to be listed in isa.cpp.
#pragma once

#include <cstdint>

namespace pieper::PIEPER_ISA {

#define PIEPER_CLOSED_FORM(name)                                                                                          \
  void name(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid, \
            std::uint8_t* flag);
PIEPER_CLOSED_FORM(closed_spherical_wrist)
PIEPER_CLOSED_FORM(closed_three_parallel)
PIEPER_CLOSED_FORM(closed_position3)
PIEPER_CLOSED_FORM(closed_orientation3)
PIEPER_CLOSED_FORM(offset_wrist_any)
PIEPER_CLOSED_FORM(offset_wrist_alike)
PIEPER_CLOSED_FORM(two_slides_any)
#undef PIEPER_CLOSED_FORM

// Writes what does not change with the pose behind the kClosedParams params; there is room for kPreparedClosed more.
inline constexpr int kClosedParams = 225, kPreparedClosed = 160;  // length and twice seven links
void prepare_spherical_wrist(double* params, const int* iparams);
void prepare_three_parallel(double* params, const int* iparams);

}  // namespace pieper::PIEPER_ISA
