// Compiles the families that hide an angle for one instruction set; see CMakeLists.txt.
#include "hidden_angle/offset_wrist.hpp"
#include "hidden_angle/two_slides.hpp"

namespace pieper::PIEPER_ISA {

#define PIEPER_HIDDEN_ANGLE(name, family)                                                                          \
  void name(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid, \
            std::uint8_t* flag) {                                                                                  \
    hidden_angle::solve<family>(params, iparams, T, count, q, valid, flag);                                        \
  }
PIEPER_HIDDEN_ANGLE(offset_wrist_any, offset_wrist::Family<false>)
PIEPER_HIDDEN_ANGLE(offset_wrist_alike, offset_wrist::Family<true>)
PIEPER_HIDDEN_ANGLE(two_slides_any, two_slides::Family)
#undef PIEPER_HIDDEN_ANGLE

}  // namespace pieper::PIEPER_ISA
