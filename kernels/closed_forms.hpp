// The closed-form families of closed_forms.cpp and offset_wrist.cpp, to be listed in isa.cpp.
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
PIEPER_CLOSED_FORM(closed_offset_wrist)
#undef PIEPER_CLOSED_FORM

}  // namespace pieper::PIEPER_ISA
