// Three joints, each revolute or sliding, bring a point to a place: Za A Zb B Zc c = g (an arm of three joints that places a
// point, and the positioning part of every arm with a spherical wrist).
//
// With w(a) = A^-1 Za^-1 g and u(c) = B Zc c the middle joint only turns (slides) u into w: what it cannot change, w.z = u.z and
// |w|^2 = |u|^2 (or w.x = u.x and w.y = u.y), are two equations linear in the joint terms of a and c: a PairSystem.
// The equations are templates over the number type, which the lanes use too; solving them here is scalar.
#pragma once

#include "closed_form/careful/pair.hpp"

namespace pieper::PIEPER_ISA::closed_form {

// Whether a joint may have any value: all but free, rounding leaves it open to more than the others may bear.
enum class Free { NO, NEARLY, YES };

struct PositionRoots {
  static constexpr int most = 2 * kMostPairs;
  double q[most][3];
  Free free[most];  // whether the middle joint may have any value
  int count = 0;
  bool degenerate = false;

  void add(double a, double b, double c, Free any_b) {
    if (count == most) return;
    for (int k = 0; k < count; ++k)
      if (std::fabs(q[k][0] - a) + std::fabs(q[k][1] - b) + std::fabs(q[k][2] - c) < kOnePoint) return;
    q[count][0] = a, q[count][1] = b, q[count][2] = c, free[count++] = any_b;
  }
};

// The turn about z that takes `from` to `to`; any will do when both lie on the axis.
inline double turn_between(Vec3 from, Vec3 to, bool& free) {
  free = from.x * from.x + from.y * from.y < kOnMiddleAxis || to.x * to.x + to.y * to.y < kOnMiddleAxis;
  if (free) return 0;
  return std::atan2(to.y * from.x - to.x * from.y, to.x * from.x + to.y * from.y);
}

// An affine function of one joint's terms: at + first * f1 (+ second * f2), f2 absent for a sliding joint.
template <class F> struct SwingT {
  Vec3T<F> at, first, second;
};
using Swing = SwingT<double>;

inline Vec3 swing_at(const Swing& s, double x, bool slides) {
  if (slides) return s.at + x * s.first;
  return s.at + std::cos(x) * s.first + std::sin(x) * s.second;
}

// First and second derivative of a swing.
inline void swing_slopes(const Swing& s, double x, bool slides, Vec3& d, Vec3& dd) {
  if (slides) {
    d = s.first, dd = {0, 0, 0};
    return;
  }
  double c = std::cos(x), n = std::sin(x);
  d = c * s.second - n * s.first;
  dd = -c * s.first - n * s.second;
}

// By how much the squares of the distances of two points, p on a and r on c, from the z axis differ.
inline Separable aside_of_z(Vec3 p, Vec3 dp, Vec3 ddp, Vec3 r, Vec3 dr, Vec3 ddr) {
  return {(p.x - r.x) * (p.x + r.x) + (p.y - r.y) * (p.y + r.y), 2 * (p.x * dp.x + p.y * dp.y),
          -2 * (r.x * dr.x + r.y * dr.y), 2 * (p.x * ddp.x + p.y * ddp.y + dp.x * dp.x + dp.y * dp.y),
          -2 * (r.x * ddr.x + r.y * ddr.y + dr.x * dr.x + dr.y * dr.y)};
}

// The equation with the larger gradient first: the other's may vanish.
inline void flatter_first(Separable& flat, Separable& bent) {
  if (flat.a * flat.a + flat.c * flat.c >= bent.a * bent.a + bent.c * bent.c) return;
  const Separable swap = flat;
  flat = bent, bent = swap;
}

// What the middle joint cannot change of w(a) - u(c), as a pair of separable equations: the height and how far from the z axis where it
// turns, the two coordinates across the z axis where it slides.
struct BesideMiddle {
  const Swing &w, &u;
  const bool* slides;
  void operator()(double a, double c, Separable& flat, Separable& bent) const {
    Vec3 p = swing_at(w, a, slides[0]), r = swing_at(u, c, slides[2]), dp, ddp, dr, ddr;
    swing_slopes(w, a, slides[0], dp, ddp);
    swing_slopes(u, c, slides[2], dr, ddr);
    if (slides[1]) {
      flat = {p.x - r.x, dp.x, -dr.x, ddp.x, -ddr.x};
      bent = {p.y - r.y, dp.y, -dr.y, ddp.y, -ddr.y};
    } else {
      flat = {p.z - r.z, dp.z, -dr.z, ddp.z, -ddr.z};
      bent = aside_of_z(p, dp, ddp, r, dr, ddr);
    }
    flatter_first(flat, bent);
  }
};

// B Z c as a function of the joint.
template <class F> PIEPER_INLINE SwingT<F> swing_of(const RigidT<F>& B, Vec3T<F> c, bool slides) {
  const F zero(0.0);
  if (slides) return {move(B, c), B.z, {zero, zero, zero}};
  return {c.z * B.z + B.t, c.x * B.x + c.y * B.y, c.x * B.y - c.y * B.x};
}

// A^-1 Z^-1 g as a function of the joint.
template <class F> PIEPER_INLINE SwingT<F> swing_back(const RigidT<F>& A, Vec3T<F> g, bool slides) {
  const F zero(0.0), one(1.0);
  if (slides) return {move_back(A, g), F(-1.0) * turn_back(A, Vec3T<F>{zero, zero, one}), {zero, zero, zero}};
  return {move_back(A, Vec3T<F>{zero, zero, g.z}), turn_back(A, Vec3T<F>{g.x, g.y, zero}),
          turn_back(A, Vec3T<F>{g.y, -g.x, zero})};
}

// |.|^2 of a swing as constant and coefficients of the joint terms.
template <class F> PIEPER_INLINE void squared(const SwingT<F>& s, bool slides, F* k) {
  k[1] = 2.0 * dot(s.at, s.first);
  k[0] = dot(s.at, s.at);
  if (slides) {
    k[2] = F(1.0);
  } else {
    k[0] = k[0] + dot(s.first, s.first);
    k[2] = 2.0 * dot(s.at, s.second);
  }
}

// The pair of equations of a positioning problem.
template <class F> PIEPER_INLINE void position_pair(const SwingT<F>& w, const SwingT<F>& u, const bool* slides,
                                                    F (*M)[2], F (*N)[2], F* e) {
  const F zero(0.0);
  if (!slides[1]) {
    // the origin may slide along the middle axis: half way between the two sides keeps the squares small
    F shift = 0.5 * (w.at.z + u.at.z), kw[3], ku[3];
    SwingT<F> ws = w, us = u;
    ws.at.z = ws.at.z - shift;
    us.at.z = us.at.z - shift;
    squared(ws, slides[0], kw);
    squared(us, slides[2], ku);
    M[0][0] = ws.first.z, M[0][1] = slides[0] ? zero : ws.second.z, M[1][0] = kw[1], M[1][1] = kw[2];
    N[0][0] = -us.first.z, N[0][1] = slides[2] ? zero : -us.second.z, N[1][0] = -ku[1], N[1][1] = -ku[2];
    e[0] = us.at.z - ws.at.z;
    e[1] = ku[0] - kw[0];
  } else {
    M[0][0] = w.first.x, M[0][1] = w.second.x, M[1][0] = w.first.y, M[1][1] = w.second.y;
    N[0][0] = -u.first.x, N[0][1] = -u.second.x, N[1][0] = -u.first.y, N[1][1] = -u.second.y;
    e[0] = u.at.x - w.at.x;
    e[1] = u.at.y - w.at.y;
  }
}

// `apart`, `first_c`: of PairSystem.
inline void solve_position(const Rigid& A, const Rigid& B, Vec3 c, Vec3 g, const bool* slides, bool apart, bool first_c,
                           PositionRoots& out) {
  Swing w = swing_back(A, g, slides[0]), u = swing_of(B, c, slides[2]);
  PairSystem s;
  s.slides_a = slides[0];
  s.slides_c = slides[2];
  s.apart = apart, s.first_c = first_c;
  position_pair(w, u, slides, s.M, s.N, s.e);
  PairRoots pairs;
  solve_pair(s, pairs);
  out.degenerate = pairs.degenerate;
  const BesideMiddle equations{w, u, slides};
  for (int i = 0; i < pairs.count; ++i) {
    double refined[2][2] = {{pairs.a[i], pairs.c[i]}, {}};
    int branches = refine_pair(equations, pairs.a[i], pairs.c[i], refined);
    for (int k = 0; k < branches; ++k) {
      Vec3 from = swing_at(u, refined[k][1], slides[2]), to = swing_at(w, refined[k][0], slides[0]);
      bool free = false;
      double middle = slides[1] ? to.z - from.z : turn_between(from, to, free);
      out.degenerate |= free;
      out.add(refined[k][0], middle, refined[k][1], free ? Free::YES : Free::NO);
    }
  }
}

}  // namespace pieper::PIEPER_ISA::closed_form
