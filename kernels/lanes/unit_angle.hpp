// The angle of a pair (x, y) that is of length one but for rounding, without a division: turned back by the nearest of eight angles
// of a table it is an arcsine of little. Vectors of eight lanes hold the table in a register; other numbers take the arctangent.
#pragma once

#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA {

// In [-pi, pi], for an angle that is brought into (-pi, pi] afterwards. NaN in, NaN out; of a pair whose length is off by more than a millionth, any value.
template <class F> PIEPER_INLINE F unit_angle(F y, F x) { return atan2_closed(y, x); }

// The same in (-pi, pi], and no zero below zero.
template <class F> PIEPER_INLINE F unit_angle_wrapped(F y, F x) { return atan2(y, x); }

// By how much it misses the angle of its pair. With u = 2^-53: turning back loses u / 4 (a product below 1/2, a difference below 1/4),
// the polynomial and its sums u / 4, the table's angle and the sum with it u / 2 each below 1 and u below 2, pi - r rounds by 2 u and pi
// itself by 1.1 u: 5.6 u together, 6.2e-16, below kAngleError. A pair of length 1 + d turns by at most tan(0.2267) d = 0.231 d more:
// kUnitAngleSkew.
inline constexpr double kUnitAngleSkew = 0.231;

#if defined(__AVX512DQ__)
// Cosine, sine and angle of eight directions of the first quadrant: |y| - |x| in steps of 1/4, the first and the last at its ends.
alignas(64) inline constexpr double kCosines[8] = {1.0,
                                                   0.9468057228182637,
                                                   0.8692945071647321,
                                                   0.7668392293490403,
                                                   0.6418392293490403,
                                                   0.49429450716473217,
                                                   0.3218057228182637,
                                                   0.0};
alignas(64) inline constexpr double kSines[8] = {0.0,
                                                 0.3218057228182637,
                                                 0.49429450716473217,
                                                 0.6418392293490403,
                                                 0.7668392293490403,
                                                 0.8692945071647321,
                                                 0.9468057228182637,
                                                 1.0};
alignas(64) inline constexpr double kAngles[8] = {0.0,
                                                  0.32763604425047105,
                                                  0.5170230747830927,
                                                  0.6968943202534328,
                                                  0.8739020065414638,
                                                  1.053773252011804,
                                                  1.2431602825444255,
                                                  1.5707963267948966};

PIEPER_INLINE Lanes<8> unit_angle(Lanes<8> y, Lanes<8> x) {
  using F = Lanes<8>;
  // 1.5 * 2^52, a multiple of eight: the last three bits of a sum with it count
  constexpr double to_integer = 6755399441055744.0;
  const F ay = abs(y), ax = abs(x), between = ay - ax;
  // towards minus infinity: -4 to 3, of a pair that is too long by a millionth too; four more, and the last three bits are the place
  const __m512i place = _mm512_castpd_si512(
      _mm512_fmadd_round_pd((__m512d)between.v, _mm512_set1_pd(4.0 * (1 - 0x1p-20)), _mm512_set1_pd(to_integer + 4),
                            _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
  const auto pick = [&](const double* table) {
    return F((F::Values)_mm512_permutexvar_pd(place, _mm512_load_pd(table)));
  };
  const F s = ay * pick(kCosines) - ax * pick(kSines), t = s * s, t2 = t * t;
  const F even = 0.16666666666666804014 +
                 t2 * (0.044642857985347888947 + t2 * (0.022377754964729751535 + t2 * 0.016205762961675647453));
  const F odd = 0.074999999997335368909 + t2 * (0.030381844775422357748 + t2 * 0.017192504294744689805);
  F r = pick(kAngles) + (s + (s * t) * (even + t * odd));
  r = select(x < 0.0, kPi - r, r);
  return with_sign_of(r, y);
}
PIEPER_INLINE Lanes<8> unit_angle_wrapped(Lanes<8> y, Lanes<8> x) {
  const Lanes<8> angle = unit_angle(y, x);
  return select(angle <= -kPi, Lanes<8>(kPi), angle + 0.0);
}
#endif

}  // namespace pieper::PIEPER_ISA
