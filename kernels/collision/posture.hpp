// Where the bodies of a model are in a posture, and how far a pair of them is apart. Templates over the number type.
#pragma once

#include "chain/forward.hpp"
#include "collision/model.hpp"
#include "collision/solids.hpp"

namespace pieper::PIEPER_ISA {

// A body in space: its frame, and half its segment (of a segment alone).
template <class F> struct Placed {
  RigidT<F> at;
  Vec3T<F> half;
};

PIEPER_INLINE Vec3 half_of(const CollisionModel& m, int body) {
  return {m.half[3 * body], m.half[3 * body + 1], m.half[3 * body + 2]};
}
template <class F> PIEPER_INLINE Placed<F> placed(const RigidT<F>& at, double half) { return {at, half * at.z}; }

// What stands still, once for all postures.
template <class F> PIEPER_INLINE void place_still(const CollisionModel& m, Placed<F>* out) {
  for (int k = 0; k < m.bodies; ++k)
    if (m.link[k] == 0) out[k] = placed(spread<F>(read_rigid(m.place + 16 * k, 1)), m.half[3 * k + 2]);
}
// Bodies of the arm at up to W joint vectors. visit(j, frame): of joint j (0-based) before it moves.
template <class F, class Visit>
PIEPER_INLINE void place_moving(const CollisionModel& m, const double* q, int lanes, Placed<F>* out, Visit visit) {
  RigidT<F> T = spread<F>(read_rigid(m.links, 1));
  int body = 0;
  while (body < m.bodies && m.link[body] == 0) ++body;
  for (int j = 0; j < m.n; ++j) {
    visit(j, T);
    const F value = joint_of<F>(q, m.n, j, lanes);
    T = moved(T, m.prismatic[j] ? Motion<F>{value, F(0.0)} : turned_by(value), m.prismatic[j]);
    for (; body < m.bodies && m.link[body] == j + 1; ++body)
      out[body] = placed(T * read_rigid(m.place + 16 * body, 1), m.half[3 * body + 2]);
    T = T * read_rigid(m.links + 16 * (j + 1), 1);
  }
}

// A pair's signed distance, layers taken off, and its nearest points and normal in space where they are asked for.
template <class F> PIEPER_INLINE Apart<F> pair_apart(const CollisionModel& m, int pair, const Placed<F>* at) {
  const int i = m.pair[2 * pair], j = m.pair[2 * pair + 1];
  const Solid one = static_cast<Solid>(m.kind[i]), other = static_cast<Solid>(m.kind[j]);
  const Placed<F>&a = at[i], &b = at[j];
  const double layers = m.radius[i] + m.radius[j];
  Apart<F> gap;
  if (one == Solid::SEGMENT && other == Solid::SEGMENT) {
    gap = apart(SegmentT<F>{a.at.t, a.half}, SegmentT<F>{b.at.t, b.half});
  } else {
    // the segment, if there is one, is looked at from the other body
    const bool swap = one != Solid::SEGMENT && other == Solid::SEGMENT;
    const Placed<F>&p = swap ? b : a, &s = swap ? a : b;
    const Vec3T<F> half = spread<F>(half_of(m, swap ? i : j));
    if (one == Solid::SEGMENT || other == Solid::SEGMENT) {
      const Vec3T<F> c = move_back(s.at, p.at.t), d = turn_back(s.at, p.half);
      gap = (swap ? one : other) == Solid::BOX ? segment_box(c, d, half) : segment_cylinder(c, d, half);
    } else {
      gap = box_box(inverse(s.at) * p.at, spread<F>(half_of(m, i)), half);
    }
    gap.a = move(s.at, gap.a);
    gap.b = move(s.at, gap.b);
    gap.normal = turn(s.at, gap.normal);
    if (swap) gap = {gap.distance, gap.b, gap.a, -1.0 * gap.normal};
  }
  gap.distance = gap.distance - layers;
  gap.a = gap.a - m.radius[i] * gap.normal;
  gap.b = gap.b + m.radius[j] * gap.normal;
  return gap;
}

// Its signed distance alone.
template <class F> PIEPER_INLINE F pair_distance(const CollisionModel& m, int pair, const Placed<F>* at) {
  const int i = m.pair[2 * pair], j = m.pair[2 * pair + 1];
  const std::uint8_t plain = static_cast<std::uint8_t>(Solid::SEGMENT);
  if (m.kind[i] != plain || m.kind[j] != plain) return pair_apart(m, pair, at).distance;
  const SegmentT<F> one = {at[i].at.t, at[i].half}, other = {at[j].at.t, at[j].half};
  return segments_apart(one, other, m.half[3 * i + 2], m.half[3 * j + 2]) - (m.radius[i] + m.radius[j]);
}

}  // namespace pieper::PIEPER_ISA
