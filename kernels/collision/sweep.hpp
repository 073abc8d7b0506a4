// A proof that a path keeps bodies apart: no pair comes nearer than a margin anywhere between the points.
//
// In a box of joint values (middle m, half widths h) a point of a body moves, as seen from a body farther up the chain, by
// at most sum_j R_j h_j over the joints j between the two, R_j its largest distance from axis j. That is its distance in
// m, exact, and what the joints behind j can add: R_j = r_j(m) + sum_{i > j} R_i h_i. A pair whose distance in m is larger
// than the margin and this way is clear in the whole box. Pairs that are not are looked at in halves: of the points of a
// path first, of a segment between two points then.
#pragma once

#include "collision/posture.hpp"

namespace pieper::PIEPER_ISA {

class Sweeper {
 public:
  // room: as large as `bytes`; lists: (kLevels + 1) x pairs ints.
  Sweeper(const CollisionModel& m, const double* q, long count, double margin, double gap, double slack, void* room,
          int* lists, const OuterPairs& outer)
      : m_(m), q_(q), count_(count), margin_(margin), gap_(gap), slack_(slack), lists_(lists), outer_(outer) {
    double* at = static_cast<double*>(room);
    bodies_ = reinterpret_cast<Placed<double>*>(at);
    at += m.bodies * static_cast<long>(sizeof(Placed<double>) / sizeof(double));
    axes_ = reinterpret_cast<Rigid*>(at);
    at += m.n * static_cast<long>(sizeof(Rigid) / sizeof(double));
    middle_ = at;
    width_ = at + m.n;
    way_ = at + 2 * m.n;
    apart_ = way_ + m.bodies * (m.n + 1);
  }
  static long bytes(const CollisionModel& m) {
    return m.bodies * static_cast<long>(sizeof(Placed<double>)) + m.n * static_cast<long>(sizeof(Rigid)) +
           static_cast<long>(sizeof(double)) * (2 * m.n + m.bodies * (m.n + 1) + m.pairs);
  }
  static constexpr int kLevels = 128;

  Sweep run() {
    out_ = {false, 0.0, -1, 0.0, 0, 0.0, -1, 0.0, 0};
    if (count_ < 1 || m_.pairs < 1) return out_;
    place_still(m_, bodies_);
    for (int k = 0; k < m_.pairs; ++k) lists_[k] = k;
    if (count_ == 1) part(0, 0, 0.0, 0.0, lists_, m_.pairs, 0);
    else range(0, count_ - 1, lists_, m_.pairs, 0);
    return out_;
  }

 private:
  // All points from `first` to `last`, and the segments between: in the box of their joint values. True where one hits.
  bool range(long first, long last, const int* active, int count, int level) {
    if (last - first == 1) return part(first, last, 0.0, 1.0, active, count, level);
    for (int j = 0; j < m_.n; ++j) {
      double low = q_[first * m_.n + j], high = low;
      for (long i = first + 1; i <= last; ++i) {
        const double v = q_[i * m_.n + j];
        if (v < low) low = v;
        if (v > high) high = v;
      }
      middle_[j] = 0.5 * (low + high);
      width_[j] = 0.5 * (high - low);
    }
    int* left = lists_ + static_cast<long>(level + 1) * m_.pairs;
    const int open = look(active, count, left).open;
    if (open == 0) return false;
    const long half = first + (last - first) / 2;
    return range(first, half, left, open, level + 1) || range(half, last, left, open, level + 1);
  }

  struct Look {
    int open;       // pairs that are not proved clear, enclosing ones too
    int nearest;    // of the real ones; -1 if none
    double widest;  // the largest way of a real one
  };

  // A part [t0, t1] of a segment. True where it hits; then the left half has been looked at for an earlier place.
  bool part(long first, long last, double t0, double t1, const int* active, int count, int level) {
    const double tm = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
    for (int j = 0; j < m_.n; ++j) {
      const double a = q_[first * m_.n + j], step = q_[last * m_.n + j] - a;
      middle_[j] = a + tm * step;
      width_[j] = half * std::fabs(step);
    }
    int* left = lists_ + static_cast<long>(level + 1) * m_.pairs;
    const Look seen = look(active, count, left);
    int open = seen.open;
    if (open == 0) return false;
    if (t1 - t0 >= 1.0 || first == last) {
      // real pairs go on; of enclosing ones the caller is told
      open = 0;
      for (int k = 0; k < seen.open; ++k) {
        if (m_.outer[left[k]]) outer_.told(outer_.context, first, left[k]);
        else left[open++] = left[k];
      }
      if (open == 0) return false;
    }
    const double nearest = apart_[seen.nearest], widest = seen.widest;
    const int pair = seen.nearest;
    if (nearest < margin_ - slack_) {
      out_.hit = true;
      out_.hit_s = first + tm;
      out_.hit_pair = pair;
      out_.hit_distance = nearest;
      if (widest > gap_ && level < kLevels - 1) part(first, last, t0, tm, left, open, level + 1);
      return true;
    }
    if (widest <= gap_ || level >= kLevels - 1) {
      if (out_.doubtful++ == 0) {
        out_.doubtful_s = first + tm;
        out_.doubtful_pair = pair;
        out_.doubtful_distance = nearest;
      }
      return false;
    }
    return part(first, last, t0, tm, left, open, level + 1) || part(first, last, tm, t1, left, open, level + 1);
  }

  // Looks at pairs in the box about middle_; writes those that are not proved clear.
  Look look(const int* active, int count, int* left) {
    ++out_.evaluated;
    place_moving(m_, middle_, 1, bodies_, [&](int j, const Rigid& frame) { axes_[j] = frame; });
    ways();
    Look seen = {0, -1, 0.0};
    int segments[PIEPER_LANES], waiting = 0;
    auto judge = [&](int k, double distance) {
      const int moved = m_.pair[2 * k], from = m_.link[m_.pair[2 * k + 1]];
      const double way = way_[moved * (m_.n + 1) + from];
      apart_[k] = distance;
      if (distance - way > margin_ + slack_) return;
      left[seen.open++] = k;
      if (m_.outer[k]) return;
      if (way > seen.widest) seen.widest = way;
      if (seen.nearest < 0 || distance < apart_[seen.nearest]) seen.nearest = k;
    };
    auto together = [&]() {
      using Wide = Lanes<PIEPER_LANES>;
      SegmentT<Wide> a, b;
      for (int i = 0; i < PIEPER_LANES; ++i) {
        const int k = segments[i < waiting ? i : waiting - 1];
        const Placed<double>&x = bodies_[m_.pair[2 * k]], &y = bodies_[m_.pair[2 * k + 1]];
        for (int c = 0; c < 3; ++c) {
          set_lane((&a.centre.x)[c], i, (&x.at.t.x)[c]), set_lane((&a.half.x)[c], i, (&x.half.x)[c]);
          set_lane((&b.centre.x)[c], i, (&y.at.t.x)[c]), set_lane((&b.half.x)[c], i, (&y.half.x)[c]);
        }
      }
      const Wide d = apart(a, b).distance;
      for (int i = 0; i < waiting; ++i) {
        const int k = segments[i];
        judge(k, lane(d, i) - m_.radius[m_.pair[2 * k]] - m_.radius[m_.pair[2 * k + 1]]);
      }
      waiting = 0;
    };
    for (int i = 0; i < count; ++i) {
      const int k = active[i];
      const std::uint8_t plain = static_cast<std::uint8_t>(Solid::SEGMENT);
      if (m_.kind[m_.pair[2 * k]] == plain && m_.kind[m_.pair[2 * k + 1]] == plain) {
        segments[waiting++] = k;
        if (waiting == PIEPER_LANES) together();
      } else {
        judge(k, pair_apart(m_, k, bodies_).distance);
      }
    }
    if (waiting) together();
    return seen;
  }

  // way_[body][k]: how far a point of the body can come, in the box, as seen from link k.
  void ways() {
    for (int b = 0; b < m_.bodies; ++b) {
      double* way = way_ + b * (m_.n + 1);
      const int link = m_.link[b];
      way[link] = 0.0;
      for (int j = link - 1; j >= 0; --j) {
        const double h = width_[j];
        way[j] = way[j + 1];
        if (h == 0.0) continue;
        way[j] += h * (m_.prismatic[j] ? 1.0 : farthest(b, axes_[j]) + way[j + 1]);
      }
    }
  }
  // The largest distance of a body's points from an axis.
  double farthest(int b, const Rigid& axis) const {
    const Placed<double>& body = bodies_[b];
    auto square = [&](Vec3 p) {
      const Vec3 c = cross(axis.z, p - axis.t);
      return dot(c, c);
    };
    if (static_cast<Solid>(m_.kind[b]) == Solid::SEGMENT) {
      const double one = square(body.at.t + body.half), other = square(body.at.t - body.half);
      return std::sqrt(one > other ? one : other) + m_.radius[b];
    }
    const Vec3 half = half_of(m_, b);
    if (static_cast<Solid>(m_.kind[b]) == Solid::CYLINDER)
      return std::sqrt(square(body.at.t)) + std::sqrt(half.x * half.x + half.z * half.z) + m_.radius[b];
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 at = {(corner & 1 ? 1 : -1) * half.x, (corner & 2 ? 1 : -1) * half.y, (corner & 4 ? 1 : -1) * half.z};
      const double there = square(move(body.at, at));
      if (there > most) most = there;
    }
    return std::sqrt(most) + m_.radius[b];
  }

  const CollisionModel& m_;
  const double* q_;
  long count_;
  double margin_, gap_, slack_;
  int* lists_;
  OuterPairs outer_;
  Placed<double>* bodies_;
  Rigid* axes_;
  double *middle_, *width_, *way_, *apart_;
  Sweep out_;
};

inline long sweep_bytes(const CollisionModel& m) { return Sweeper::bytes(m); }
inline int sweep_levels() { return Sweeper::kLevels + 1; }
inline Sweep collision_sweep(const CollisionModel& m, const double* q, long count, double margin, double gap,
                             double slack, void* room, int* lists, const OuterPairs& outer) {
  return Sweeper(m, q, count, margin, gap, slack, room, lists, outer).run();
}

}  // namespace pieper::PIEPER_ISA
