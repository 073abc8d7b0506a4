// The general solver's quick road: the real zeros of the determinant by its signs, without eigenvalues.
//
// In the hidden angle the determinant is a trigonometric polynomial of degree 8 (or 4). Its values at a few angles give it, and the
// signs of its Bernstein coefficients isolate its real roots: a count with a bound on what rounding does to the values. A pose is settled
// when every root has a verified, regular solution of its own beside it; every other pose is left to the eigenvalues (solve.hpp).
// Templates over the number type.
#pragma once

#include "elimination/solve.hpp"
#include "hidden_angle/refined_roots.hpp"

namespace pieper::PIEPER_ISA::general {

// The determinants at M angles around the circle. Of one pose alone, in fewer lanes than there are, lanes are the angles.
template <class F, int N, int M>
void determinants_at(const Equations<F>& eq, int layout, const trigonometric::Circle<M>& angle, F (&value)[M]) {
  if constexpr (width_of<F> < PIEPER_LANES) {
    constexpr int W = PIEPER_LANES;
    using G = Lanes<W>;
    Equations<G> wide;
    for (int r = 0; r < 6; ++r)
      for (int j = 0; j < 27; ++j) wide.e[r][j] = G(lane(eq.e[r][j], 0));
    for (int k = 0; k < M; k += W) {
      G c(1.0), s(0.0);
      for (int i = 0; i < W && k + i < M; ++i) set_lane(c, i, angle.c[k + i]), set_lane(s, i, angle.s[k + i]);
      const G d = determinant<G, N>(wide, layout, c, s);
      for (int i = 0; i < W && k + i < M; ++i) value[k + i] = F(lane(d, i));
    }
  } else {
    for (int k = 0; k < M; ++k) value[k] = determinant<F, N>(eq, layout, F(angle.c[k]), F(angle.s[k]));
  }
}

// What W roots of any poses of the group, from `first` on, lead to: entered where clear; the poses of the others are marked.
template <class F, class G, int D>
void enter_roots(const Model& model, const Eliminated<F>& poses, const trigonometric::Series<F, D>& series,
                 const trigonometric::Isolation<F, D>& roots, int first, Found* found, unsigned& unclear) {
  constexpr int W = width_of<G>;
  const Variant& v = model.variant[0];
  const int* const of = roots.list.lane + first;
  const int used = roots.count - first < W ? roots.count - first : W;
  const LanePicker<W> pick(of);
  trigonometric::Series<G, D> own;
  Equations<G> eq;
  RightSide<G> right;
  RigidT<G> link[6];
  pick_lanes<G, F>(own, series, pick);
  pick_lanes<G, F>(eq, poses.eq, pick);
  pick_lanes<G, F>(right, poses.right, pick);
  pick_lanes<G, F>(link, poses.link, pick);
  G c3, s3, slope;
  trigonometric::refine(own, roots.list, first, c3, s3, slope);
  Motion<G> q[6];
  complete_candidate(eq, right, link, v.roles, v.chart, v.layout, v.swap, start_vector(0), c3, s3, q);
  const Closure<G> end = polish(link, v.roles, q, 8);
  const G moved = s3 * q[2].c - c3 * q[2].s, along = c3 * q[2].c + s3 * q[2].s;
  const unsigned clear = bits_of((end.residual < kGeneralVerified) & (end.sigma > kGeneralDegenerate) &
                                 (abs(moved) < kGeneralAccurate) & (along > 0.0));
  double joint[6][W], sigma[W], residual[W];
  for (int k = 0; k < 6; ++k) store(joint[v.roles.joint[k]], v.roles.prismatic[k] ? q[k].c : atan2(q[k].s, q[k].c));
  store(sigma, end.sigma);
  store(residual, end.residual);
  for (int i = 0; i < used; ++i) {
    double values[6];
    for (int k = 0; k < 6; ++k) values[k] = joint[k][i];
    const int before = found[of[i]].count;
    const bool own_solution =
        ((clear >> i) & 1u) && insert(found[of[i]], values, sigma[i], residual[i], model.prismatic) == before;
    if (!own_solution) unclear |= 1u << of[i];
  }
}

// W poses by the best variant. Returns the bits of those that are not settled. Of one without solutions that is settled it is clear that
// poses beside it have none either: on no sector does the determinant come near to zero beside what it is elsewhere on it.
template <class F, int N> unsigned solve_by_signs(const Model& model, const RigidT<F>& pose, int used, Found* found) {
  constexpr int D = 2 * N / 3, M = 2 * D + 4, W = PIEPER_LANES;
  const Variant& v = model.variant[0];
  Eliminated<F> poses;
  equations_of<F, N>(model, v, pose, poses);
  F value[M], size, largest(0.0);
  determinants_at<F, N, M>(poses.eq, v.layout, trigonometric::circle<M>(), value);
  for (const F& x : value) largest = max(largest, abs(x));
  trigonometric::Series<F, D> series;
  const F above = trigonometric::series_of<F, D, M>(value, series, size);
  const F noise = max(kSignNoise * size, 100.0 * above);
  unsigned unclear = bits_of(!(above < kHiddenDegree * size) | !(largest > 2 * kGeneralTrusted * v.typical));
  trigonometric::Sectors<F, D> sectors;
  sectors_of(series, sectors);
  const trigonometric::Isolation<F, D> roots(sectors, noise, ~unclear, used);
  unclear |= roots.unclear;
  unsigned nowhere = 0;  // without roots, and not clearly so
  for (int i = 0; i < used; ++i) {
    found[i].count = 0;
    if (!(roots.apart[i] > kSignApart)) nowhere |= 1u << i;
  }
  for (int k = 0; k < roots.count; ++k) nowhere &= ~(1u << roots.list.lane[k]);
  unclear |= nowhere;
  for (int first = 0; first < roots.count; first += W)
    enter_roots<F, Lanes<W>, D>(model, poses, series, roots, first, found, unclear);
  return unclear & ((1u << used) - 1u);
}

template <class F> unsigned solve_by_signs(const Model& model, const RigidT<F>& pose, int used, Found* found) {
  return model.variant[0].layout == kTwelve ? solve_by_signs<F, 12>(model, pose, used, found)
                                            : solve_by_signs<F, 6>(model, pose, used, found);
}

}  // namespace pieper::PIEPER_ISA::general
