// The roots that trigonometric_roots.hpp has isolated, refined side by side. Templates over the number type, used for lanes only.
#pragma once

#include "hidden_angle/trigonometric_roots.hpp"

namespace pieper::PIEPER_ISA::trigonometric {

// Halley's method kept inside W brackets from `first` on: the roots as cosine and sine. p: of each root's own polynomial; slope: dp/dtheta
// there, to the square of the last step.
template <class F, int D, int Most>
void refine(const Series<F, D>& p, const Brackets<Most>& list, int first, F& c, F& s, F& slope) {
  const F centre_c = load<F>(list.centre_c + first), centre_s = load<F>(list.centre_s + first);
  F low = load<F>(list.low + first), high = load<F>(list.high + first), u = load<F>(list.start + first);
  const auto rising = load<F>(list.rising + first) > 0.5;
  auto done = mask_of<F>(false);
  slope = F(0.0);
  for (int step = 0; step < 40; ++step) {
    const F over = 1.0 / (1.0 + u * u), x = (1.0 - u * u) * over, y = 2.0 * u * over;
    c = centre_c * x - centre_s * y;
    s = centre_s * x + centre_c * y;
    if (all(done)) break;
    // cosines and sines of the multiples by Chebyshev's recurrence; dp/dtheta, and its derivative
    const F twice = c + c;
    F value = p.a[0], rate = F(0.0), bend = F(0.0), before[2] = {F(1.0), F(0.0)}, now[2] = {c, s};
#pragma GCC unroll 16
    for (int m = 1; m <= D; ++m) {
      const F here = p.a[m] * now[0] + p.b[m] * now[1], across = p.b[m] * now[0] - p.a[m] * now[1];
      value += here;
      rate += double(m) * across;
      bend -= double(m * m) * here;
      for (int k = 0; k < 2; ++k) {
        const F next = twice * now[k] - before[k];
        before[k] = now[k], now[k] = next;
      }
    }
    const auto below = value < 0.0, left = (below & rising) | !(below | rising);
    low = select(left & !done, u, low);
    high = select(!left & !done, u, high);
    const F square = rate * rate, second = 0.5 * (value * bend), divisor = square - second;
    const F change = (0.0 - value * rate) / select(divisor == 0.0, F(kTiny), divisor);
    const F way = 0.5 * change * (1.0 + u * u);
    F next = u + (way + (u * over) * (way * way));
    const auto inside = (next > low) & (next < high);
    next = select(inside, next, 0.5 * (low + high));
    slope = select(done, slope, rate + bend * change);
    // what it leaves is of the order of the step times the square of second / square: more where another root is near
    const auto small =
        (abs(next - u) < kHiddenRootStep) & (abs(change) * (second * second) <= kHiddenNearRoot * (square * square));
    u = select(done, u, next);
    done = done | small;
  }
}

}  // namespace pieper::PIEPER_ISA::trigonometric
