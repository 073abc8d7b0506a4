// The closed-form families beyond the spherical wrist behind parallel axes, compiled once per instruction set.
#include "closed_form/closed_forms.hpp"

#include "closed_form/lanes/families.hpp"

namespace pieper::PIEPER_ISA {

#define PIEPER_CLOSED_FORM(name, solve)                                                                            \
  void name(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid, \
            std::uint8_t* flag) {                                                                                         \
    closed_form::solve(params, iparams, T, count, q, valid, flag);                                                 \
  }
PIEPER_CLOSED_FORM(closed_spherical_wrist, solve_closed<closed_form::SphericalWristLanes>)
PIEPER_CLOSED_FORM(closed_three_parallel, solve_closed<closed_form::ThreeParallelLanes>)
PIEPER_CLOSED_FORM(closed_position3, solve_position3<double>)
PIEPER_CLOSED_FORM(closed_orientation3, solve_orientation3<double>)
#undef PIEPER_CLOSED_FORM

void prepare_spherical_wrist(double* params, const int* iparams) { closed_form::prepare_closed<closed_form::SphericalWristLanes>(params, iparams); }
void prepare_three_parallel(double* params, const int* iparams) { closed_form::prepare_closed<closed_form::ThreeParallelLanes>(params, iparams); }
static_assert(sizeof(closed_form::PreparedClosed<closed_form::SphericalWristLanes>) <= 8 * kPreparedClosed);
static_assert(sizeof(closed_form::PreparedClosed<closed_form::ThreeParallelLanes>) <= 8 * kPreparedClosed);

}  // namespace pieper::PIEPER_ISA
