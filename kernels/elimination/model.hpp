// What a robot is to the general solver: scaled links, and per variant of the elimination the constants that poses share.
#pragma once

#include "lanes/batch.hpp"
#include "elimination/entry.hpp"
#include "elimination/francis.hpp"
#include "elimination/polish.hpp"
#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA::general {

inline constexpr int kMaxVariants = 12;

struct Variant {
  Roles roles;
  int layout, swap;
  int arm;  // 0: the arm itself; 1, 2: a nearby arm, whose solutions are polished onto the arm
  Charts chart;
  LeftSide<double> left;       // valid unless the pose sits in links 2 to 5
  RowSpace<double, 12> basis;  // of layout 0
  RowSpace<double, 6> basis6;  // of layouts 1, 2
  Between<double, 12> between;
  Between<double, 6> between6;
  double noise;    // median over test poses of what should vanish, relative
  double typical;  // median over test poses of the largest |determinant|
  double open;     // eigenvalues a test pose that belong to no solution: roots that special geometry adds
  int pose_free() const { return roles.pose_link == 0 || roles.pose_link == 5; }
};

struct Model {
  double scale;  // one scaled unit of length, m
  // L0 .. L6, scaled, origins slid along the axes towards each other; of the arm and two nearby ones
  Rigid link[3][7];
  bool prismatic[6];
  int prismatic_count;
  double farthest;  // how far from its base's frame an arm of turns brings its tool, scaled; infinite with slides
  int variants;
  bool by_signs;  // whether the best way's determinant tells of most poses by its signs (by_signs.hpp)
  Variant variant[kMaxVariants];
};

// The six links of the loop in role order for poses T (lanes): the last loop link is L6 T^-1 L0.
template <class F>
void role_links(const Model& model, int arm, const Roles& roles, const RigidT<F>& pose, RigidT<F>* link) {
  const RigidT<F> closing = closing_link(model.link[arm], in_lengths(pose, model.scale));
  for (int k = 0; k < 6; ++k) {
    const RigidT<F> a = loop_link(model.link[arm], closing, roles.loop_link(k));
    link[k] = roles.reverse ? flipped(inverse(a)) : a;
  }
}

template <int N> inline const RowSpace<double, N>& basis_of(const Variant& v) {
  if constexpr (N == 12) return v.basis;
  else return v.basis6;
}
template <int N> inline const Between<double, N>& between_of(const Variant& v) {
  if constexpr (N == 12) return v.between;
  else return v.between6;
}

// Everything one variant says about W poses before eigenvalues.
template <class F> struct Eliminated {
  RigidT<F> link[6], arm_link[6];  // arm_link: of the arm itself, where a nearby one was eliminated
  RightSide<F> right;
  Equations<F> eq;
  F chart_c, chart_s;  // t = infinity lies half a turn away
  F largest;           // |determinant| there
  F around[kRound];    // and around the circle
};

// Of them what comes before the matrix: links, the right side and the six equations. use(basis, between) is told of the
// row space, of the arm or of the poses; where not Bases it is not made.
template <class F, int N, bool Bases = false, class Use>
void equations_of(const Model& model, const Variant& v, const RigidT<F>& pose, Eliminated<F>& out, Use use) {
  role_links(model, v.arm, v.roles, pose, out.link);
  if (v.arm) role_links(model, 0, v.roles, pose, out.arm_link);
  right_side(out.link, v.roles, out.right);
  const int yr = v.swap ? 4 : 3, xr = v.swap ? 3 : 4;
  const auto finish = [&](const auto& left, const auto& basis, const auto& between) {
    eliminate(left, out.right, v.layout, v.roles.prismatic[yr], v.roles.prismatic[xr], out.eq);
    use(basis, between);
  };
  if (v.pose_free()) return finish(v.left, basis_of<N>(v), between_of<N>(v));
  LeftSide<F> left;
  RowSpace<F, N> basis;
  Between<F, N> between;
  left_side(out.link, v.roles, v.chart, v.swap, left);
  if constexpr (Bases) {
    row_space<F, N>(left, v.layout, basis);
    products_of(basis, between);
  }
  finish(left, basis, between);
}
template <class F, int N>
void equations_of(const Model& model, const Variant& v, const RigidT<F>& pose, Eliminated<F>& out) {
  equations_of<F, N>(model, v, pose, out, [](const auto&, const auto&) {});
}

template <class F, int N> void eliminate_poses(const Model& model, const Variant& v, const RigidT<F>& pose,
                                               Eliminated<F>& out, Compressed<F, N>& matrix) {
  equations_of<F, N, true>(model, v, pose, out, [&](const auto& basis, const auto& between) {
    choose_chart<F, N>(out.eq, v.layout, out.chart_c, out.chart_s, out.largest, out.around);
    compress(out.eq, basis, between, v.layout, out.chart_c, out.chart_s, matrix);
  });
}

// By how much the eigenvalues fail to be the zeros of the determinant, whose sizes around the circle are given, of the largest.
//
// The determinant is a constant times the product of sin((theta - theta_k) / 2), which rounding moves little where single
// eigenvalues of a cluster are moved far: what a backward stable computation leaves is far below what an eigenvalue that has
// lost its digits does to it.
inline double strayed(int count, const double* re, const double* im, const double (&around)[kRound]) {
  using G = Lanes<PIEPER_LANES>;
  constexpr int W = PIEPER_LANES;
  const double c1 = 0.92387953251128675613, s1 = 0.38268343236508977173, h = 0.70710678118654752440;
  const double c[kRound] = {1, c1, h, s1, 0, -s1, -h, -c1}, s[kRound] = {0, s1, h, c1, 1, c1, h, s1};
  double product[kRound];
  for (int k = 0; k < kRound; k += W) {
    const G cosine = load<G>(c + k), sine = load<G>(s + k);
    G all = 1.0;
    for (int i = 0; i < count; ++i) {
      const double a = re[i], b = im[i], inv = 1 / (1 + a * a + b * b);
      const G x = sine * a + cosine, y = sine * b;
      all *= (x * x + y * y) * inv;
    }
    store(product + k, all);
  }
  int chart = 0;  // t is infinite there
  for (int k = 1; k < kRound; ++k)
    if (around[k] > around[chart]) chart = k;
  double worst = 0;
  for (int k = 1; k < kRound; ++k) {
    const double there = around[(chart + k) % kRound] / around[chart];
    const double d = __builtin_fabs(there - __builtin_sqrt(product[k] / product[0]));
    if (!(d <= worst)) worst = d;
  }
  return worst;
}

// The imaginary part of the hidden angle theta = 2 atan(t) of an eigenvalue t = a + ib; infinite where it is far from real.
inline double imaginary_part(double a, double b) {
  if (b == 0) return 0;
  const double up = a * a + (1 + b) * (1 + b), down = a * a + (1 - b) * (1 - b);
  // most are, and need no logarithm
  constexpr double far = 1 + 4 * kGeneralNearlyReal;
  if (!(up < far * down && down < far * up)) return __builtin_inf();
  return 0.5 * __builtin_log(up / (down > kTiny ? down : kTiny));
}
// Whether the angle's imaginary part is smaller than `within`: one of a nearby arm that may be real for this one.
inline bool nearly_real(double a, double b, double within) {
  const double up = a * a + (1 + b) * (1 + b), down = a * a + (1 - b) * (1 - b), far = __builtin_exp(2 * within);
  return up < far * down && down < far * up;
}
// The real part, without the chart's.
inline double real_part(double a, double b) {
  return b == 0 ? 2 * __builtin_atan(a) : __builtin_atan2(2 * a, 1 - a * a - b * b);
}

}  // namespace pieper::PIEPER_ISA::general
