// Signed distances between segments, boxes and cylinders: positive apart, negative by how far one must be moved to part
// them. A radius about a body is taken off by the caller: a capsule is a segment with one, a sphere a point with one.
//
// Templates over the number type. Nearest points come along; what is not asked for is not computed.
#pragma once

#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA {

inline constexpr double kSides[2] = {-1.0, 1.0};

template <class F> struct SegmentT {
  Vec3T<F> centre, half;  // both ends are centre +- half
};
// Signed distance, a point of each body, and the unit vector from the second to the first along which they are apart.
template <class F> struct Apart {
  F distance;
  Vec3T<F> a, b, normal;
};

template <class F> PIEPER_INLINE F clamped(F x, F low, F high) { return min(max(x, low), high); }
template <class F> PIEPER_INLINE Vec3T<F> chosen(Mask<F> m, Vec3T<F> a, Vec3T<F> b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
template <class F> PIEPER_INLINE F over(F numerator, F positive) { return numerator / max(positive, F(kTiny)); }

// A unit vector along v, or across u where v vanishes.
template <class F> PIEPER_INLINE Vec3T<F> along_or_across(Vec3T<F> v, Vec3T<F> u) {
  const Vec3T<F> x = {F(0.0), u.z, -1.0 * u.y}, y = {-1.0 * u.z, F(0.0), u.x};
  const F sx = dot(x, x), sy = dot(y, y), sv = dot(v, v);
  Vec3T<F> side = chosen(sx > sy, x, y);
  const F size = max(sx, sy);
  side = chosen(size > F(0.0), over(F(1.0), sqrt(size)) * side, Vec3T<F>{F(0.0), F(0.0), F(1.0)});
  return chosen(sv > F(0.0), over(F(1.0), sqrt(sv)) * v, side);
}

// Parts s and t of two half segments u and v at which they are nearest, and the way from the second's point to the first's.
template <class F> struct Nearest {
  F s, t;
  Vec3T<F> gap;
};

// t where the lines are nearest, held to the segment (over_A, over_E: 1 / u.u, 1 / v.v); s is the best for it, and t the best for s (Ericson 2005, 5.1.9: of two
// steps in turn from there none is left to gain). v is made square to u first: next to parallel, the two unknowns of the
// plain system are worth a square of the angle, these are worth the angle itself.
template <class F>
PIEPER_INLINE Nearest<F> nearest_of(const SegmentT<F>& one, const SegmentT<F>& other, F over_A, F over_E) {
  const Vec3T<F> u = one.half, v = other.half, w = one.centre - other.centre;
  const F end = F(1.0), B = dot(u, v), C = dot(u, w), D = dot(v, w);
  const Vec3T<F> across = v - (B * over_A) * u, off = w - (C * over_A) * u;
  const F lines = clamped(over(dot(off, across), dot(across, across)), -1.0 * end, end);
  const F s = clamped((B * lines - C) * over_A, -1.0 * end, end);
  const F t = clamped((B * s + D) * over_E, -1.0 * end, end);
  return {s, t, w + s * u - t * v};
}

// The distance of two segments whose half lengths are known to be so long.
template <class F>
PIEPER_INLINE F segments_apart(const SegmentT<F>& one, const SegmentT<F>& other, double half, double half_of_other) {
  const Vec3T<F> gap =
      nearest_of(one, other, F(over(1.0, half * half)), F(over(1.0, half_of_other * half_of_other))).gap;
  return sqrt(dot(gap, gap));
}

template <class F> PIEPER_INLINE Apart<F> apart(const SegmentT<F>& one, const SegmentT<F>& other) {
  const F A = dot(one.half, one.half), E = dot(other.half, other.half);
  const Nearest<F> at = nearest_of(one, other, over(F(1.0), A), over(F(1.0), E));
  const Vec3T<F> w = one.centre - other.centre;
  const F square = dot(at.gap, at.gap);
  // where they meet, the difference is rounding and has no direction
  const Mask<F> away = square > kBodiesMeet * (A + E + dot(w, w));
  const Vec3T<F> normal = along_or_across(chosen(away, at.gap, cross(one.half, other.half)), one.half);
  return {sqrt(square), one.centre + at.s * one.half, other.centre + at.t * other.half, normal};
}

// ---- a segment p + t d, t in [-1, 1], and a body about the origin -------------------------------------------------------

// What a coordinate exceeds +-h by.
template <class F> PIEPER_INLINE F excess(F x, F h) { return x - clamped(x, -1.0 * h, h); }

// Where a slope that never falls passes zero in [low, high]: sections between its kinks are looked at from both sides.
template <class F> struct Bracket {
  F low, high, below, above;

  PIEPER_INLINE void narrow(F t, F slope) {
    const Mask<F> left = (slope <= F(0.0)) & (t >= low), right = (slope >= F(0.0)) & (t <= high);
    low = select(left, t, low);
    below = select(left, slope, below);
    high = select(right, t, high);
    above = select(right, slope, above);
  }
  PIEPER_INLINE F straight() const {
    return clamped(low - below * (high - low) / max(above - below, F(kTiny)), low, high);
  }
};

template <class F> PIEPER_INLINE Vec3T<F> box_excess(Vec3T<F> p, Vec3T<F> h) {
  return {excess(p.x, h.x), excess(p.y, h.y), excess(p.z, h.z)};
}

// t of the point of a segment nearest to a box: half the squared distance has a slope that is straight between kinks.
template <class F> PIEPER_INLINE F nearest_to_box(Vec3T<F> p, Vec3T<F> d, Vec3T<F> h) {
  auto slope = [&](F t) { return dot(d, box_excess(p + t * d, h)); };
  const F one = F(1.0);
  Bracket<F> at = {-1.0 * one, one, slope(-1.0 * one), slope(one)};
  for (int i = 0; i < 3; ++i) {
    const F pi = (&p.x)[i], di = (&d.x)[i], hi = (&h.x)[i];
    const F step = select(abs(di) > F(kTiny), di, F(kTiny));
    for (double side : kSides) {
      const F t = clamped((side * hi - pi) / step, -1.0 * one, one);
      at.narrow(t, slope(t));
    }
  }
  return at.straight();
}

// The direction along which two convex bodies are farthest apart, of those looked at, where they overlap: across an edge
// of each, `own` and `edge`, or along a normal of one (no edges).
template <class F> struct Direction {
  F apart = F(-kEndless);
  Vec3T<F> normal = {F(0.0), F(0.0), F(1.0)}, own = {F(0.0), F(0.0), F(0.0)}, edge = own;

  // n need not be a unit vector; `shift` = n . (centre of the first - centre of the second), `reach` both bodies' along n.
  PIEPER_INLINE void look(Vec3T<F> n, F shift, F reach, Vec3T<F> mine, Vec3T<F> other) {
    const F size = dot(n, n), length = sqrt(size), sep = over(abs(shift) - reach, length);
    const Mask<F> better = (sep > apart) & (size > F(kTouchingFlat));
    apart = select(better, sep, apart);
    normal = chosen(better, over(select(shift < F(0.0), F(-1.0), F(1.0)), length) * n, normal);
    own = chosen(better, mine, own);
    edge = chosen(better, other, edge);
  }
};
template <class F> PIEPER_INLINE F reach_of(Vec3T<F> n, Vec3T<F> h) {
  return abs(n.x) * h.x + abs(n.y) * h.y + abs(n.z) * h.z;
}
// The corner of a box that is farthest along n.
template <class F> PIEPER_INLINE Vec3T<F> corner_along(Vec3T<F> n, Vec3T<F> h) {
  const F o = F(0.0);
  return {select(n.x < o, -1.0 * h.x, h.x), select(n.y < o, -1.0 * h.y, h.y), select(n.z < o, -1.0 * h.z, h.z)};
}
// The point of a segment p + t d that is deepest against a normal: an end, or, where the normal is square to it, what is
// nearest to an edge through `corner`; anywhere (t) where there is none.
template <class F>
PIEPER_INLINE Vec3T<F> deepest(Vec3T<F> p, Vec3T<F> d, Vec3T<F> n, Vec3T<F> edge, Vec3T<F> corner, F t) {
  const F lean = dot(n, d), level = F(kLevel) * sqrt(dot(d, d)), one = F(1.0);
  const Vec3T<F> across = cross(n, edge);
  const F slope = dot(across, d);
  const F met = clamped(dot(across, corner - p) / select(abs(slope) > F(kTiny), slope, one), -1.0 * one, one);
  const F inner = select(abs(slope) > F(kTiny), met, t);
  return p + select(lean > level, -1.0 * one, select(lean < -1.0 * level, one, inner)) * d;
}

// In the frame of the second body: away by `gap` where that is not zero, else by how far they overlap; `corner` is the
// second's point farthest along the normal.
template <class F> PIEPER_INLINE Apart<F> settled(Vec3T<F> p, Vec3T<F> d, F t, Vec3T<F> gap,
                                                  const Direction<F>& overlap, Vec3T<F> corner) {
  const F square = dot(gap, gap);
  const Vec3T<F> on = p + t * d;
  const Mask<F> away = square > kBodiesMeet * (dot(on, on) + dot(d, d));
  const F depth = min(overlap.apart, F(0.0));
  const Vec3T<F> deep = deepest(p, d, overlap.normal, overlap.edge, corner, t);
  return {select(away, sqrt(square), depth), chosen(away, on, deep),
          chosen(away, on - gap, deep - depth * overlap.normal), chosen(away, along_or_across(gap, d), overlap.normal)};
}

template <class F> PIEPER_INLINE Apart<F> segment_box(Vec3T<F> p, Vec3T<F> d, Vec3T<F> h) {
  const F t = nearest_to_box(p, d, h), o = F(0.0), i = F(1.0);
  Direction<F> overlap;
  const Vec3T<F> none = {o, o, o}, x = {i, o, o}, y = {o, i, o}, z = {o, o, i};
  auto look = [&](Vec3T<F> n, Vec3T<F> edge) { overlap.look(n, dot(n, p), reach_of(n, h) + abs(dot(n, d)), d, edge); };
  look(x, none), look(y, none), look(z, none);
  look({o, -1.0 * d.z, d.y}, x), look({d.z, o, -1.0 * d.x}, y), look({-1.0 * d.y, d.x, o}, z);
  return settled(p, d, t, box_excess(p + t * d, h), overlap, corner_along(overlap.normal, h));
}

// A cylinder about z: h = (radius, radius, half its height).
template <class F> PIEPER_INLINE Vec3T<F> cylinder_excess(Vec3T<F> p, Vec3T<F> h) {
  const F rho = sqrt(p.x * p.x + p.y * p.y), out = over(max(rho - h.x, F(0.0)), rho);
  return {out * p.x, out * p.y, excess(p.z, h.z)};
}

inline constexpr int kCylinderSteps = 16;

template <class F> PIEPER_INLINE F nearest_to_cylinder(Vec3T<F> p, Vec3T<F> d, Vec3T<F> h) {
  auto slope = [&](F t) { return dot(d, cylinder_excess(p + t * d, h)); };
  const F one = F(1.0), flat = d.x * d.x + d.y * d.y, lean = d.x * p.x + d.y * p.y;
  Bracket<F> at = {-1.0 * one, one, slope(-1.0 * one), slope(one)};
  const F step = select(abs(d.z) > F(kTiny), d.z, F(kTiny));
  const F middle = over(-1.0 * lean, flat);
  const F across = p.x * d.y - p.y * d.x;
  const F span = over(sqrt(max(h.x * h.x * flat - across * across, F(0.0))), flat);
  for (double side : kSides) {
    const F cap = clamped((side * h.z - p.z) / step, -1.0 * one, one),
            wall = clamped(middle + side * span, -1.0 * one, one);
    at.narrow(cap, slope(cap));
    at.narrow(wall, slope(wall));
  }
  // between kinks the slope is smooth: the chord and the middle close in on its zero from both sides
  for (int k = 0; k < kCylinderSteps; ++k) {
    const F chord = at.straight();
    at.narrow(chord, slope(chord));
    const F half = 0.5 * (at.low + at.high);
    at.narrow(half, slope(half));
  }
  return at.straight();
}

// The farthest apart along any direction square to the segment, into which a cylinder casts a stadium of ellipses.
inline void look_across(Direction<double>& best, Vec3 p, Vec3 d, Vec3 h) {
  const double flat = std::sqrt(d.x * d.x + d.y * d.y), length = std::sqrt(dot(d, d));
  if (flat <= kLevel * length || length == 0) return;
  const Vec3 a = {-d.y / flat, d.x / flat, 0}, b = (1 / length) * cross(d, a);
  auto at = [&](double angle) { return std::cos(angle) * a + std::sin(angle) * b; };
  auto apart_at = [&](double angle) {
    const Vec3 n = at(angle);
    return std::fabs(dot(n, p)) - h.x * std::sqrt(n.x * n.x + n.y * n.y) - h.z * std::fabs(n.z);
  };
  constexpr int parts = 64;
  constexpr double pi = 3.14159265358979323846;
  int top = 0;
  for (int k = 1; k < parts; ++k)
    if (apart_at(pi * k / parts) > apart_at(pi * top / parts)) top = k;
  double low = pi * (top - 1) / parts, high = pi * (top + 1) / parts;
  for (int k = 0; k < 80; ++k) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    (apart_at(left) < apart_at(right) ? low : high) = apart_at(left) < apart_at(right) ? left : right;
  }
  const Vec3 n = at((low + high) / 2);
  // level directions have been looked at, and touch the wall; else the rim is met, along which the way goes
  if (std::fabs(n.z) < kLevelDirection) return;
  best.look(n, dot(n, p), h.x * std::sqrt(n.x * n.x + n.y * n.y) + h.z * std::fabs(n.z), d, {-n.y, n.x, 0});
}

template <class F> PIEPER_INLINE Apart<F> segment_cylinder(Vec3T<F> p, Vec3T<F> d, Vec3T<F> h) {
  const F t = nearest_to_cylinder(p, d, h), o = F(0.0);
  const Vec3T<F> gap = cylinder_excess(p + t * d, h);
  Direction<F> overlap;
  const Vec3T<F> none = {o, o, o}, axis = {o, o, F(1.0)};
  overlap.look(axis, p.z, h.z + abs(d.z), d, none);
  // along horizontal directions the segment's shadow and the circle are apart by the shadow's distance from the middle
  const F flat = d.x * d.x + d.y * d.y, s = clamped(over(-1.0 * (d.x * p.x + d.y * p.y), flat), F(-1.0), F(1.0));
  const Vec3T<F> shadow = {p.x + s * d.x, p.y + s * d.y, o};
  const Vec3T<F> out = along_or_across(shadow, Vec3T<F>{d.x, d.y, o});
  overlap.look(out, dot(out, p), h.x + abs(dot(out, d)), d, axis);
  const Mask<F> inside = dot(gap, gap) == o;
  if (any(inside)) {
    for (int i = 0; i < width_of<F>; ++i) {
      Direction<double> best;
      best.apart = lane(overlap.apart, i);
      const Vec3T<F>* from[3] = {&overlap.normal, &overlap.own, &overlap.edge};
      Vec3* to[3] = {&best.normal, &best.own, &best.edge};
      for (int k = 0; k < 3; ++k) *to[k] = {lane(from[k]->x, i), lane(from[k]->y, i), lane(from[k]->z, i)};
      look_across(best, {lane(p.x, i), lane(p.y, i), lane(p.z, i)}, {lane(d.x, i), lane(d.y, i), lane(d.z, i)},
                  {lane(h.x, i), lane(h.y, i), lane(h.z, i)});
      set_lane(overlap.apart, i, best.apart);
      Vec3T<F>* back[3] = {&overlap.normal, &overlap.own, &overlap.edge};
      for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 3; ++c) set_lane((&back[k]->x)[c], i, (&to[k]->x)[c]);
    }
  }
  const Vec3T<F> n = overlap.normal;
  const F round = over(h.x, sqrt(n.x * n.x + n.y * n.y));
  const Vec3T<F> rim = {round * n.x, round * n.y, select(n.z < o, -1.0 * h.z, h.z)};
  return settled(p, d, t, gap, overlap, rim);
}

// Whether a normal is one of the first body's own faces'.
template <class F> PIEPER_INLINE Mask<F> faces_first(const RigidT<F>& M, Vec3T<F> n) {
  return largest(turn_back(M, n)) > F(1.0 - kFaceNormal);
}

// Two boxes, M the first's pose in the frame of the second. Apart, the nearest pair has an edge of the first or a corner of
// the second in it; overlapping, they part along a face's normal or across two edges.
template <class F> PIEPER_INLINE Apart<F> box_box(const RigidT<F>& M, Vec3T<F> a, Vec3T<F> b) {
  Direction<F> overlap;
  const F o = F(0.0), i = F(1.0);
  const Vec3T<F> unit[3] = {{i, o, o}, {o, i, o}, {o, o, i}}, column[3] = {M.x, M.y, M.z};
  const Vec3T<F> none = {o, o, o};
  auto look = [&](Vec3T<F> n, Vec3T<F> own, Vec3T<F> edge) {
    overlap.look(n, dot(n, M.t), reach_of(n, b) + reach_of(turn_back(M, n), a), own, edge);
  };
  for (int k = 0; k < 3; ++k) look(unit[k], none, none), look(column[k], none, none);
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l) look(cross(unit[k], column[l]), (&a.x)[l] * column[l], unit[k]);
  F square = F(kEndless);
  Vec3T<F> on_a = M.t, on_b = M.t;
  auto consider = [&](Vec3T<F> pa, Vec3T<F> pb) {
    const Vec3T<F> gap = pa - pb;
    const F size = dot(gap, gap);
    const Mask<F> nearer = size < square;
    square = select(nearer, size, square);
    on_a = chosen(nearer, pa, on_a);
    on_b = chosen(nearer, pb, on_b);
  };
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const Vec3T<F> d = (&a.x)[k] * column[k], el = (&a.x)[l] * column[l], em = (&a.x)[m] * column[m];
    for (double sl : kSides) {
      for (double sm : kSides) {
        const Vec3T<F> p = M.t + sl * el + sm * em, q = p + nearest_to_box(p, d, b) * d;
        consider(q, q - box_excess(q, b));
      }
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3T<F> at = {(corner & 1 ? 1.0 : -1.0) * b.x, (corner & 2 ? 1.0 : -1.0) * b.y,
                         (corner & 4 ? 1.0 : -1.0) * b.z};
    const Vec3T<F> q = move_back(M, at);
    consider(move(M, q - box_excess(q, a)), at);
  }
  const Mask<F> away = overlap.apart > o;
  // overlapping: the corner of the first that is deepest, or, across two edges, the place on its edge; of a normal of the
  // first itself, what lies under the second's deepest corner
  const Vec3T<F> n = overlap.normal, far = corner_along(n, b);
  const Vec3T<F> low = move(M, -1.0 * corner_along(turn_back(M, n), a));
  const F length = over(dot(low - M.t, overlap.own), dot(overlap.own, overlap.own));
  const Mask<F> edges = dot(overlap.own, overlap.own) > o, mine = faces_first(M, n);
  const Vec3T<F> on_edge = deepest(low - length * overlap.own, overlap.own, n, overlap.edge, far, F(0.0));
  const Vec3T<F> deep = chosen(edges, on_edge, chosen(mine, far + overlap.apart * n, low));
  const Mask<F> pointing = away & (square > kBodiesMeet * (dot(on_a, on_a) + dot(a, a)));
  return {select(away, sqrt(square), overlap.apart), chosen(away, on_a, deep),
          chosen(away, on_b, deep - overlap.apart * n), chosen(pointing, along_or_across(on_a - on_b, M.z), n)};
}

}  // namespace pieper::PIEPER_ISA
