// Whether the solutions found of one pose are all there are, told by the signs of a determinant that has lost digits.
//
// Every solution's hidden angle is a zero of the determinant, a trigonometric polynomial of a known degree. What rounding has made of that
// polynomial is measured: by what lies above its degree, and by what it is at the solutions, where it ought to vanish. Where its
// signs isolate its real zeros beyond that (hidden_angle/trigonometric_roots.hpp), and these are as many as solutions with hidden
// angles of their own, each zero belongs to one of them and none is left for another. For one pose alone.
#pragma once

#include "elimination/by_signs.hpp"

namespace pieper::PIEPER_ISA::general {

// A trigonometric polynomial at an angle; that of the first of the lanes.
template <class F, int D> double at_angle(const trigonometric::Series<F, D>& p, double angle) {
  double value = lane(p.a[0], 0);
  for (int m = 1; m <= D; ++m)
    value += lane(p.a[m], 0) * __builtin_cos(m * angle) + lane(p.b[m], 0) * __builtin_sin(m * angle);
  return value;
}

// How surely one elimination tells that: 0 not at all, 1 with what rounding has left taken ten times, 2 a hundred times.
template <int N> int counted(const Model& model, const Variant& v, const Rigid& pose, const Found& found) {
  constexpr int D = 2 * N / 3, M = 2 * D + 4;
  using F = Lanes<2>;  // both the same pose
  const int hidden = v.roles.joint[2];
  for (int i = 0; i < found.count; ++i)
    for (int j = 0; j < i; ++j)
      if (angle_apart(found.q[i][hidden], found.q[j][hidden]) < kGeneralOneRoot) return 0;
  Eliminated<F> poses;
  equations_of<F, N>(model, v, spread<F>(pose), poses);
  F value[M], size;
  determinants_at<F, N, M>(poses.eq, v.layout, trigonometric::circle<M>(), value);
  trigonometric::Series<F, D> series;
  const double above = lane(trigonometric::series_of<F, D, M>(value, series, size), 0);
  double left = kGeneralCounted * above;  // one harmonic of many
  for (int i = 0; i < found.count; ++i) {
    const double here = __builtin_fabs(at_angle(series, found.q[i][hidden]));
    if (!(here <= left)) left = here;  // NaN stays
  }
  trigonometric::Sectors<F, D> sectors;
  sectors_of(series, sectors);
  const auto clear = [&](double times) {
    const trigonometric::Isolation<F, D> roots(sectors, max(kSignNoise * size, F(times * left)), 1u, 1);
    return !roots.unclear && roots.count == found.count;
  };
  return !clear(kGeneralCounted) ? 0 : clear(kGeneralProven) ? 2 : 1;
}

// The same by the eliminations of the arm itself: surely by one, or by two that hide different joints or go another way round. One
// solution or none is no measure of what rounding has left.
inline bool counted(const Model& model, const Rigid& pose, const Found& found) {
  if (found.count < kToldByReal) return false;
  for (int i = 0; i < found.count; ++i)
    if (found.merged[i]) return false;
  int sure = 0;
  for (int n = 0; n < model.variants && sure < 2; ++n) {
    const Variant& v = model.variant[n];
    if (v.arm) continue;
    sure += v.layout == kTwelve ? counted<12>(model, v, pose, found) : counted<6>(model, v, pose, found);
  }
  return sure >= 2;
}

}  // namespace pieper::PIEPER_ISA::general
