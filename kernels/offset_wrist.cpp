// Compiles the offset-wrist family for one instruction set; see CMakeLists.txt.
#include "offset_wrist.hpp"

namespace pieper::PIEPER_ISA {

void closed_offset_wrist(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid,
                         std::uint8_t* flag) {
  offset_wrist::solve(params, iparams, T, count, q, valid, flag);
}

}  // namespace pieper::PIEPER_ISA
