// Vectors, rigid motions and joint motions, for one pose (double) or for lanes: the only ones of the kernels.
#pragma once

#include <cmath>

#include "lanes/math.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA {

template <class F> struct Vec3T {
  F x, y, z;
};
using Vec3 = Vec3T<double>;
template <class F> PIEPER_INLINE Vec3T<F> operator+(Vec3T<F> a, Vec3T<F> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class F> PIEPER_INLINE Vec3T<F> operator-(Vec3T<F> a, Vec3T<F> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
// A plain number times lanes is lanes.
template <class S, class F> PIEPER_INLINE auto operator*(S s, Vec3T<F> a) -> Vec3T<decltype(s * a.x)> {
  return {s * a.x, s * a.y, s * a.z};
}
template <class F> PIEPER_INLINE F dot(Vec3T<F> a, Vec3T<F> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class F> PIEPER_INLINE Vec3T<F> cross(Vec3T<F> a, Vec3T<F> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class F> PIEPER_INLINE F largest(Vec3T<F> v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// A rigid motion: columns x, y, z of its rotation and its translation t.
template <class F> struct RigidT {
  Vec3T<F> x, y, z, t;

  PIEPER_INLINE F& r(int row, int column) { return (&x.x)[3 * column + row]; }
  PIEPER_INLINE const F& r(int row, int column) const { return (&x.x)[3 * column + row]; }
  PIEPER_INLINE F& p(int row) { return (&t.x)[row]; }
  PIEPER_INLINE const F& p(int row) const { return (&t.x)[row]; }
};
using Rigid = RigidT<double>;
inline constexpr Rigid kNoMotion = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};

template <class F, class G> PIEPER_INLINE auto turn(const RigidT<F>& A, Vec3T<G> v) {
  return v.x * A.x + v.y * A.y + v.z * A.z;
}
template <class F> PIEPER_INLINE Vec3T<F> turn_back(const RigidT<F>& A, Vec3T<F> v) {
  return {dot(A.x, v), dot(A.y, v), dot(A.z, v)};
}
template <class F, class G> PIEPER_INLINE auto move(const RigidT<F>& A, Vec3T<G> p) { return turn(A, p) + A.t; }
template <class F> PIEPER_INLINE Vec3T<F> move_back(const RigidT<F>& A, Vec3T<F> p) { return turn_back(A, p - A.t); }
// Lanes times lanes, or lanes times a constant.
template <class F, class G> PIEPER_INLINE RigidT<F> operator*(const RigidT<F>& A, const RigidT<G>& B) {
  return {turn(A, B.x), turn(A, B.y), turn(A, B.z), move(A, B.t)};
}
template <class F> PIEPER_INLINE RigidT<F> inverse(const RigidT<F>& A) {
  return {{A.x.x, A.y.x, A.z.x}, {A.x.y, A.y.y, A.z.y}, {A.x.z, A.y.z, A.z.z}, turn_back(A, -1.0 * A.t)};
}
template <class F> PIEPER_INLINE Vec3T<F> spread(Vec3 a) { return {F(a.x), F(a.y), F(a.z)}; }
template <class F> PIEPER_INLINE RigidT<F> spread(const Rigid& A) {
  return {spread<F>(A.x), spread<F>(A.y), spread<F>(A.z), spread<F>(A.t)};
}
// Lengths divided by `length`.
template <class F> PIEPER_INLINE RigidT<F> in_lengths(const RigidT<F>& A, double length) {
  return {A.x, A.y, A.z, (1 / length) * A.t};
}
// From the upper three rows of a row-major 4x4.
PIEPER_INLINE Rigid read_rigid(const double* m, double length) {
  return in_lengths(Rigid{{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}, {m[3], m[7], m[11]}}, length);
}
template <int N> void read_links(const double (&from)[N][4][4], double length, Rigid* to) {
  for (int k = 0; k < N; ++k) to[k] = read_rigid(from[k][0], length);
}

// The motion of a joint about or along its z: cosine and sine of a turn, or the way of a slide in c.
template <class F> struct Motion {
  F c, s;
};
template <class F> PIEPER_INLINE Motion<F> turned_by(F angle) {
  Motion<F> m;
  sincos(angle, m.s, m.c);
  return m;
}
inline Motion<double> motion_of(double value, bool slides) {
  return slides ? Motion<double>{value, 0} : Motion<double>{std::cos(value), std::sin(value)};
}
// Along (c, s), made of length one.
template <class F> PIEPER_INLINE Motion<F> unit(F c, F s) {
  F n = 1.0 / sqrt(max(c * c + s * s, F(kTiny)));
  return {c * n, s * n};
}
// The same where (c, s) is of length one but for little, whose square is nothing.
template <class F> PIEPER_INLINE Motion<F> unit_again(F c, F s) {
  const F n = 1.5 - 0.5 * (c * c + s * s);
  return {c * n, s * n};
}
// A * Z
template <class F> PIEPER_INLINE RigidT<F> moved(const RigidT<F>& A, Motion<F> m, bool slides) {
  if (slides) return {A.x, A.y, A.z, A.t + m.c * A.z};
  return {m.c * A.x + m.s * A.y, m.c * A.y - m.s * A.x, A.z, A.t};
}
inline Rigid joint(const Rigid& A, double value, bool slides) { return moved(A, motion_of(value, slides), slides); }

// Forward kinematics L0 Z1 L1 ... Zn Ln: `start` is L0, link(k) follows joint k, motion(k) is what joint k does. Calls
// visit(k, frame) with each joint's frame before the joint moves it; returns the end.
template <class F, class Link, class Value, class Slides, class Visit>
PIEPER_INLINE RigidT<F> walk(int n, RigidT<F> start, Link link, Value motion, const Slides& slides, Visit visit) {
  for (int k = 0; k < n; ++k) {
    visit(k, start);
    start = moved(start, motion(k), slides[k]) * link(k);
  }
  return start;
}

// What a joint does to the end of a chain that stands at `at`, linear rows first.
template <class F>
PIEPER_INLINE void moved_end(const Vec3T<F>& axis, const Vec3T<F>& point, bool slides, const Vec3T<F>& at, F* column) {
  const Vec3T<F> zero = {F(0.0), F(0.0), F(0.0)}, v = slides ? axis : cross(axis, at - point), w = slides ? zero : axis;
  column[0] = v.x, column[1] = v.y, column[2] = v.z, column[3] = w.x, column[4] = w.y, column[5] = w.z;
}

// The turn from one rotation to another as axis times sine.
template <class F> PIEPER_INLINE Vec3T<F> sine_between(const RigidT<F>& from, const RigidT<F>& to) {
  return 0.5 * (cross(from.x, to.x) + cross(from.y, to.y) + cross(from.z, to.z));
}

// What is missing from one pose to another: way, then rotation vector; returns its size.
inline double missing_to(const Rigid& from, const Rigid& to, double* e) {
  const Vec3 p = to.t - from.t;
  Vec3 w = sine_between(from, to);
  const double sine = std::sqrt(dot(w, w));
  const double cosine = 0.5 * (dot(from.x, to.x) + dot(from.y, to.y) + dot(from.z, to.z) - 1);
  if (sine > kSineLeast) w = (std::atan2(sine, cosine) / sine) * w;
  else if (cosine < 0) w = {kPi, 0, 0};
  e[0] = p.x, e[1] = p.y, e[2] = p.z, e[3] = w.x, e[4] = w.y, e[5] = w.z;
  double sum = 0;
  for (int k = 0; k < 6; ++k) sum += e[k] * e[k];
  return std::sqrt(sum);
}

// By what twist of its end, in base coordinates, a chain misses `goal`, and the Jacobian's columns, linear rows first.
template <class F> struct Miss {
  RigidT<F> end;
  Vec3T<F> p, w;  // half a turn away w vanishes too: the caller looks at `end`
};
template <class F, class Link, class Value> PIEPER_INLINE Miss<F> missed_by(int n, const RigidT<F>& start, Link link,
                                                                            Value motion, const bool* slides,
                                                                            const RigidT<F>& goal, F (*column)[6]) {
  Vec3T<F> axis[6], point[6];
  Miss<F> miss;
  miss.end = walk(n, start, link, motion, slides, [&](int k, const RigidT<F>& frame) {
    axis[k] = frame.z;
    point[k] = frame.t;
  });
  miss.p = goal.t - miss.end.t;
  miss.w = sine_between(miss.end, goal);
  for (int k = 0; k < n; ++k) moved_end(axis[k], point[k], slides[k], miss.end.t, column[k]);
  return miss;
}

// A chain of six closes on itself, Z1 L1 Z2 ... Z6 L6' = 1, with the pose in the link that follows joint 5 (0-based).
template <class F> PIEPER_INLINE RigidT<F> closing_link(const Rigid* links, const RigidT<F>& T) {
  return spread<F>(links[6]) * (inverse(T) * links[0]);
}
// The link that follows a joint of the loop.
template <class F> PIEPER_INLINE RigidT<F> loop_link(const Rigid* links, const RigidT<F>& closing, int joint) {
  return joint == 5 ? closing : spread<F>(links[joint + 1]);
}

}  // namespace pieper::PIEPER_ISA
