// Sine, cosine and arctangent for the number types of lanes.hpp: branch-free, about 2 ulp.
//
// The polynomials are weighted minimax fits made for these kernels (Remez exchange in 60 digits). The reduction by
// multiples of pi/2 follows Cody and Waite (1980): pi/2 is cut into pieces so short that n times a piece is exact.
// Templates over the number type, used for double and for lanes.
#pragma once

#include "lanes/lanes.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kTwoPi = 6.28318530717958647693;
inline constexpr double kHalfPi = 1.57079632679489661923;

template <class F> PIEPER_INLINE F sine_polynomial(F r, F tail) {
  F t = r * r;
  F p = -2.505075875015891e-08 + t * 1.589683084517093e-10;
  p = 2.7557313696227665e-06 + t * p;
  p = -0.00019841269829821339 + t * p;
  p = 0.008333333333322432 + t * p;
  p = -0.16666666666666632 + t * p;
  return r + (r * t * p + tail * (1.0 - 0.5 * t));
}

template <class F> PIEPER_INLINE F cosine_polynomial(F r, F tail) {
  F t = r * r;
  F p = 2.087572551196537e-09 + t * -1.1359755337367016e-11;
  p = -2.755731437032182e-07 + t * p;
  p = 2.4801587289551407e-05 + t * p;
  p = -0.001388888888887425 + t * p;
  p = 0.0416666666666666 + t * p;
  F half = 0.5 * t;
  F one_less = 1.0 - half;
  // (1 - one_less) - half is what rounding took from 1 - t/2 (Dekker, 1971).
  return one_less + (((1.0 - one_less) - half) + (t * t * p - r * tail));
}

// s = sin(x), c = cos(x). NaN and infinity give NaN.
template <class F> PIEPER_INLINE void sincos(F x, F& s, F& c) {
  constexpr double to_integer = 6755399441055744.0;  // 1.5 * 2^52: adding and subtracting it rounds to an integer
  constexpr double piece1 = 1.57079632673412561417e+00, piece2 = 6.07710050630396597660e-11,
                   piece3 = 2.02226624879595063154e-21;  // their sum is pi/2 to 118 bits
  F shifted = x * 0.63661977236758134308 + to_integer;
  F n = shifted - to_integer;
  F high = x - n * piece1;
  F step = n * piece2;
  F middle = high - step;
  F low = n * piece3 - ((high - middle) - step);
  F r = middle - low;
  F tail = (middle - r) - low;
  F sr = sine_polynomial(r, tail), cr = cosine_polynomial(r, tail);
  auto quadrant = bits_in(shifted);  // its lowest two bits count quarter turns
  auto swap = is_odd<F>(quadrant);
  s = turned(select(swap, cr, sr), quadrant);
  c = turned(select(swap, sr, cr), quadrant + 1);
  auto huge = !(abs(x) <= kReductionLimit);
  if (__builtin_expect(any(huge), 0)) {
    for (int i = 0; i < width_of<F>; ++i) {
      double xi = lane(x, i);
      if (!(__builtin_fabs(xi) <= kReductionLimit)) {
        set_lane(s, i, __builtin_sin(xi));
        set_lane(c, i, __builtin_cos(xi));
      }
    }
  }
}

// The same for |x| of a few turns at most, and good to about 1e-16 absolute rather than relative: what a check needs.
template <class F> PIEPER_INLINE void sincos_of_turns(F x, F& s, F& c) {
  constexpr double to_integer = 6755399441055744.0, piece1 = 1.57079632673412561417e+00,
                   rest = 6.07710050650619224932e-11;
  F shifted = x * 0.63661977236758134308 + to_integer;
  F n = shifted - to_integer;
  F r = (x - n * piece1) - n * rest;
  F t = r * r, t2 = t * t;
  F sp = (-0.16666666666666632 + t * 0.008333333333322432) +
         t2 * ((-0.00019841269829821339 + t * 2.7557313696227665e-06) +
               t2 * (-2.505075875015891e-08 + t * 1.589683084517093e-10));
  F cp = (0.0416666666666666 + t * -0.001388888888887425) +
         t2 * ((2.4801587289551407e-05 + t * -2.755731437032182e-07) +
               t2 * (2.087572551196537e-09 + t * -1.1359755337367016e-11));
  F sr = r + (r * t) * sp, cr = (1.0 - 0.5 * t) + t2 * cp;
  auto quadrant = bits_in(shifted);
  auto swap = is_odd<F>(quadrant);
  s = turned(select(swap, cr, sr), quadrant);
  c = turned(select(swap, sr, cr), quadrant + 1);
}

// By how much the arctangents below miss the angle of the two numbers they are given, at most, rad, where these are of ordinary
// size. With u = 2^-53: folded at tan(pi/8), z = numerator / denominator is below 0.4143 and good to 3 u (a difference, a sum, a quotient),
// 1.4e-16; the polynomial and its sums add 0.5e-16; pi/4 + (r + low) rounds below 1/2 and 1, 0.9e-16; pi/2 - (r - low) below 1 and 2,
// 1.7e-16; pi - (r - low) below 2 and 4, 3.4e-16. The low halves of the three constants leave nothing. Together 7.9e-16, below
// kAngleError; measured against 50 digits: 4.9e-16 (tests/kernels/test_elementary.py).

// The angle of (x, y) without its sign, in [0, pi]; 0 for (0, 0). NaN in, NaN out.
template <class F> PIEPER_INLINE F unsigned_angle(F y, F x) {
  constexpr double tan_pi_8 = 0.41421356237309503, quarter_pi = 0.78539816339744830962;
  constexpr double quarter_pi_low = 3.061616997868383e-17, half_pi_low = 6.123233995736766e-17,
                   pi_low = 1.2246467991473532e-16;
  F ay = abs(y), ax = abs(x);
  auto steep = ay > ax;
  F large = max(ay, ax), small = min(ax, ay);  // in this order NaN of either one stays
  auto middle = small > large * tan_pi_8;
  F numerator = select(middle, small - large, small), denominator = select(middle, small + large, large);
  denominator = max(F(kLeastNumber), denominator);
  F z = numerator / denominator;
  F t = z * z, t2 = t * t, t4 = t2 * t2;
  // Estrin's scheme: shorter chains of dependent operations than Horner's.
  F p01 = -0.33333333333333204 + t * 0.19999999999954846, p23 = -0.14285714280310588 + t * 0.11111110788747243;
  F p45 = -0.09090897901285451 + t * 0.07692062652872914, p67 = -0.06663130696725132 + t * 0.058480766634173724;
  F p89 = -0.05040123450359924 + t * 0.03808479461027858;
  F p = (p01 + t2 * p23) + t4 * ((p45 + t2 * p67) + t4 * (p89 + t2 * -0.01792881487686344));
  F r = z + (z * t) * p;
  r = select(middle, quarter_pi + (r + quarter_pi_low), r);
  r = select(steep, kHalfPi - (r - half_pi_low), r);
  return select(x < 0.0, kPi - (r - pi_low), r);
}

// The angle of (x, y) in (-pi, pi]; 0 for (0, 0). NaN in, NaN out.
template <class F> PIEPER_INLINE F atan2(F y, F x) {
  F r = unsigned_angle(y, x);
  // An angle that rounds to -pi is said as +pi, so that every answer lies in (-pi, pi].
  return select((y < 0.0) & (r < kPi), -r, r);
}

// The same in [-pi, pi], for an angle that `wrapped` brings into (-pi, pi] afterwards.
template <class F> PIEPER_INLINE F atan2_closed(F y, F x) { return with_sign_of(unsigned_angle(y, x), y); }

// An angle of at most three half turns brought into (-pi, pi].
template <class F> PIEPER_INLINE F wrapped(F angle) {
  angle = select(angle > kPi, angle - kTwoPi, angle);
  return select(angle <= -kPi, angle + kTwoPi, angle);
}

// An angle in (-pi, pi] turned by half a turn, there again: rounding takes one next to zero to either end.
template <class F> PIEPER_INLINE F half_a_turn_on(F angle) {
  angle = select(angle > 0.0, angle - kPi, angle + kPi);
  return select(angle <= -kPi, F(kPi), angle);
}

// Takes a step again and again, at most `steps` times, until it says that nothing moves in any lane. `state` is all that a step
// leaves for the next one and for what follows.
template <class F, int Count, class Step> PIEPER_INLINE void repeat(int steps, F (&)[Count], Step step) {
  for (int k = 0; k < steps; ++k)
    if (!any(step())) break;
}

}  // namespace pieper::PIEPER_ISA
