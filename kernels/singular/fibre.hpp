// The fibre of a pose at a row: a closed form's three joints of a group (a spherical wrist, three joints in a plane) over what the
// three joints beside them do.
//
// What the group cannot change (where its point is; the plane's normal and height) depends on the three joints beside it alone. Where
// these are an isolated solution of that, the fibre over it is all there is: two points, a line of two axes in one line, or, where one
// of them moves in the group as well, the pieces of a four-bar. So nothing crosses what is read here that is not read as well. Scalar.
#pragma once

#include "singular/merged.hpp"
#include "singular/pieces.hpp"

namespace pieper::PIEPER_ISA {

// Three neighbouring joints that turn about one point, or move in one plane.
struct Group3 {
  int first;
  bool flat;
  double along;  // of a point: where it is on the first axis, from that joint's origin
};

// The groups of an arm, whatever the joints' values are.
inline std::vector<Group3> groups_of(const SixJoints& arm) {
  double q[6] = {0.3, -0.7, 0.9, 0.5, 1.1, -0.4};
  const Standing at(arm, q);
  std::vector<Group3> groups;
  for (int first = 0; first + 2 < kSix; ++first) {
    const int a = first, b = first + 1, c = first + 2;
    if (arm.slides[a] || arm.slides[b] || arm.slides[c]) continue;
    const Vec3 n = cross(at.z[a], at.z[b]), m = cross(at.z[b], at.z[c]);
    if (length_of(n) < kGroupExact && length_of(m) < kGroupExact) {
      groups.push_back({first, true, 0});
    } else if (dot(n, n) > kClearlyCrossing && dot(m, m) > kClearlyCrossing) {
      const Vec3 gap = at.o[b] - at.o[a];
      const double along = dot(cross(gap, at.z[b]), n) / dot(n, n);
      const Vec3 w = at.o[a] + along * at.z[a];
      const double scale = kGroupExact * (1 + largest(w));
      if (length_of(cross(w - at.o[b], at.z[b])) < scale && length_of(cross(w - at.o[c], at.z[c])) < scale)
        groups.push_back({first, false, along});
    }
  }
  return groups;
}

// By how much (rad; lengths) an arm departs from one whose neighbouring axes are parallel, at right angles, or meet, where it is taken
// for such a one: so far its self-motions are those of that arm, and hold the pose no better.
inline double departs(const SixJoints& arm) {
  double q[6] = {0.3, -0.7, 0.9, 0.5, 1.1, -0.4}, most = 0;
  const Standing at(arm, q);
  auto counted = [&](double off, double scale) {
    if (off < kGroupExact * scale) most = std::fmax(most, off);
  };
  for (int i = 0; i + 1 < kSix; ++i) {
    const Vec3 n = cross(at.z[i], at.z[i + 1]);
    const double sine = length_of(n), scale = 1 + largest(at.o[i]);
    counted(sine, 1), counted(std::fabs(dot(at.z[i], at.z[i + 1])), 1);
    if (arm.slides[i] || arm.slides[i + 1] || sine < kClearlyCrossing) continue;
    counted(std::fabs(dot(at.o[i + 1] - at.o[i], n)) / sine, scale);
  }
  for (const Group3& group : groups_of(arm)) {
    if (group.flat) continue;
    const Vec3 point = at.o[group.first] + group.along * at.z[group.first];
    for (int k = group.first + 1; k < group.first + 3; ++k)
      counted(length_of(cross(point - at.o[k], at.z[k])), 1 + largest(point));
  }
  return most;
}

// What the joints beside a group do to what it cannot change, and the same of any twist (linear at the end of the arm).
struct Beside {
  int joint[3], free = -1, moving = 0, rest[3];
  Vec3 v[3];     // of joint[k]
  Vec3 unit[3];  // directions of v of rest[k], without the free one
  double size[3];
  Vec3 n, x, y, point, end;
  bool flat, several = false;

  Beside(const SixJoints& arm, const Standing& at, const Group3& group, double rounding) {
    flat = group.flat, end = at.end.t;
    n = at.z[group.first], point = at.o[group.first] + group.along * n;
    if (flat) {
      const double a[3] = {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
      const int least = static_cast<int>(std::min_element(a, a + 3) - a);
      x = cross(n, Vec3{least == 0 ? 1.0 : 0.0, least == 1 ? 1.0 : 0.0, least == 2 ? 1.0 : 0.0});
      x = (1 / length_of(x)) * x, y = cross(n, x);
    }
    for (int k = 0; k < 3; ++k) {
      const int i = (group.first + 3 + k) % kSix;
      joint[k] = i, v[k] = of(at.J[i]);
      const double reach = length_of(v[k]);
      if (reach <= rounding) {
        several |= free >= 0 || arm.slides[i];
        free = i;
      } else {
        rest[moving] = i, size[moving] = reach, unit[moving++] = (1 / reach) * v[k];
      }
    }
  }
  Vec3 of(const double* twist) const {
    const Vec3 turn = {twist[3], twist[4], twist[5]},
               way = Vec3{twist[0], twist[1], twist[2]} + cross(turn, point - end);
    return flat ? Vec3{dot(n, way), dot(turn, x), dot(turn, y)} : way;
  }
  // How far from depending on each other the moving ones are, about; -1 where they do in more than one way.
  double independent() const {
    if (moving < 2) return moving;
    double most = 0;
    for (int k = 0; k < moving; ++k)
      for (int m = 0; m < k; ++m) most = std::fmax(most, length_of(cross(unit[k], unit[m])));
    if (moving == 2) return most;
    return most < kOneWayFree ? -1 : std::fabs(dot(unit[0], cross(unit[1], unit[2]))) / most;
  }
  // How far three moving ones are from depending on each other, with its sign.
  double volume() const { return moving == 3 ? dot(unit[0], cross(unit[1], unit[2])) : 0; }

  // A way in which the moving ones depend on each other, per joint, and the direction `across` in which they then cannot go.
  void dependency(double* way, Vec3& across) const {
    // the two directions that are farthest apart, and the rest by them
    int i = 0, j = moving - 1, m = 1;
    std::fill(way, way + 3, 0.0);
    across = unit[i];
    if (moving == 2) {
      way[0] = 1, way[1] = dot(unit[0], unit[1]) > 0 ? -1 : 1;
    } else if (moving == 3) {
      for (int k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        if (length_of(cross(unit[a], unit[b])) > length_of(cross(unit[i], unit[j]))) i = a, j = b, m = k;
      }
      const double c = dot(unit[i], unit[j]), p = dot(unit[m], unit[i]), r = dot(unit[m], unit[j]), det = 1 - c * c;
      way[m] = -1, way[i] = (p - c * r) / det, way[j] = (r - c * p) / det;
      across = cross(unit[i], unit[j]);
    }
    across = (1 / length_of(across)) * across;
    for (int k = 0; k < moving; ++k) way[k] /= size[k];
  }

  // Where they do: what the group makes up for to first order is missed to second by this much per square of the joints' motion.
  double bend(const double (*J)[6], int first) const {
    double way[3], square = 0, group[6] = {}, x[6][6] = {};
    Vec3 across;
    dependency(way, across);
    for (int k = 0; k < moving; ++k) {
      square += way[k] * way[k];
      for (int r = 0; r < 6; ++r) x[rest[k]][r] = way[k] * J[rest[k]][r], group[r] -= x[rest[k]][r];
    }
    Bracket bracket;
    for (int k = 0; k < kSix; ++k) bracket.then(k == first ? group : x[k]);
    const Vec3 missed = of(bracket.sum);
    const double part = dot(missed, across);
    return 0.5 * (moving == 2 ? length_of(missed - part * across) : std::fabs(part)) / square;
  }
  // How far apart the roots of a fold are that bends so: the joints that move most tell, those on short levers.
  double roots_apart(double bend) const {
    double way[3], square = 0;
    Vec3 across;
    dependency(way, across);
    for (int k = 0; k < moving; ++k) square += way[k] * way[k];
    return independent() / (bend * std::sqrt(square));
  }
};

// What there is over a row.
enum class Over { UNKNOWN, ROOT, MOTIONS };

struct Fibre {
  Over over = Over::UNKNOWN;
  int branches = 1;                     // of a root
  std::vector<SelfMotionRead> motions;  // all of them
  bool fold = false;                    // whether a root or a motion is a double one
  double blur = 0;                      // within which rows of a double root have the same ones (rad; lengths)
  double apart = 0;                     // of the fold's roots (rad; lengths)

  bool over_fold() const { return over == Over::ROOT && fold; }
};

// Whether nothing crosses a line of two joints of one of the groups: whether what is beside it is a simple solution.
inline bool lone_line(const SixJoints& arm, const std::vector<Group3>& groups, const Standing& at, int i, int j,
                      double rounding) {
  for (const Group3& group : groups) {
    if (i < group.first || j > group.first + 2) continue;
    const Beside beside(arm, at, group, rounding);
    if (beside.free < 0 && beside.independent() > kOneWayFree) return true;
  }
  return false;
}

// Moves a row of a double root, which rounding places a square root of itself beside it, onto the root: to where the joints beside
// the group depend on each other, by secants along the way in which they nearly do.
inline void onto_fold(const SixJoints& arm, const Rigid& T, const Group3& group, double rounding, double* q) {
  for (int step = 0; step < 3; ++step) {
    const Beside here(arm, Standing(arm, q), group, rounding);
    const double volume = here.volume();
    if (here.moving != 3 || std::fabs(volume) < kOrthogonal) return;
    double way[3], aside[6], size = 0, shift[6];
    Vec3 across;
    here.dependency(way, across);
    for (double x : way) size = std::fmax(size, std::fabs(x));
    std::copy(q, q + kSix, aside);
    for (int k = 0; k < 3; ++k) aside[here.rest[k]] += kFoldStep * way[k] / size;
    OnCurve held(arm, T, aside, 4);
    const double other = Beside(arm, Standing(arm, held.q), group, rounding).volume(), part = volume / (volume - other);
    if (!(std::fabs(part) * kFoldStep < kMergedTwins)) return;
    for (int i = 0; i < kSix; ++i) shift[i] = q[i] + part * arm.way(held.q, q, i);
    const OnCurve moved(arm, T, shift, 3);
    if (!(std::hypot(moved.miss, moved.rest) < kHoldsToRounding)) return;
    std::copy(moved.q, moved.q + kSix, q);
  }
}

// Whether a double root of the joints beside a group is told: next to a line of its own the group is known less well than they.
inline bool is_told(const SixJoints& arm, const Group3& group, const Fibre& fibre, const Root& root,
                    const std::vector<Root>& roots) {
  for (const Root& other : roots) {
    bool same = fibre.fold && other.branches == root.branches && arm.apart(other.q, root.q) < kSameAlong;
    for (int k = 3; k < kSix; ++k)
      same = same && std::fabs(arm.way(other.q, root.q, (group.first + k) % kSix)) < fibre.blur;
    if (same) return true;
  }
  return false;
}

// Reads the fibre at a row.
inline Fibre fibre_over(const SixJoints& arm, const Group3& group, const double* q, const Standing& at,
                        double rounding) {
  Fibre fibre;
  const Beside beside(arm, at, group, rounding);
  if (beside.several) return fibre;
  const double firm = beside.independent();
  int branches = 1;
  if (!(firm > kOneWayFree)) {
    if (firm < 0) return fibre;
    // one way in which the joints beside the group do not move it: a fold, when the second order says so
    const double bend = beside.bend(at.J, group.first);
    if (!(bend > kClearFold)) return fibre;
    fibre.blur = std::fmax(kMergedSame, 3 * std::sqrt(kMergedRounding / bend));
    fibre.apart = beside.roots_apart(bend);
    fibre.fold = fibre.apart < fibre.blur;
    if (fibre.fold) branches = 2;
    else fibre.blur = 0;
  }
  const int a = group.first, b = a + 1, c = a + 2;
  if (beside.free < 0) {
    const int pairs[3][2] = {{a, c}, {a, b}, {b, c}};
    for (const auto& pair : pairs)
      if (line_gap(at, pair[0], pair[1]) <= rounding) {
        fibre.motions.emplace_back(line_of(q, at, pair[0], pair[1]));
        fibre.over = Over::MOTIONS;
        return fibre;
      }
    if (group.flat) {  // stretched or folded: a fold of its own
      const Vec3 e = at.o[b] - at.o[a], f = at.o[c] - at.o[b], n = at.z[a];
      const Vec3 g = e - dot(e, n) * n, h = f - dot(f, n) * n;
      const double bent = length_of(cross(g, h)) / std::fmax(length_of(g) * length_of(h), kTiny);
      if (bent < std::fmax(kMergedSame, 3 * std::sqrt(kMergedRounding))) branches *= 2;
    }
    fibre.over = Over::ROOT, fibre.branches = branches;
    return fibre;
  }
  int four[4] = {beside.free, a, b, c};
  std::sort(four, four + 4);
  FourBar bar;
  if (close_four(at, four, bar) > 4 * rounding) return fibre;
  if (!pieces_of(q, at, bar, fibre.motions)) return fibre;
  fibre.over = fibre.motions.empty() ? Over::ROOT : Over::MOTIONS, fibre.branches = 2 * branches;
  return fibre;
}

// The fibre at a double root, which a row is moved onto; unknown where the two sides of its fold, which rounding does not tell apart, turn
// the outer axes of the group past each other: what the pose leaves open there is a curve.
inline Fibre at_double_root(const SixJoints& arm, const Rigid& T, const Group3& group, double rounding,
                            const Fibre& fibre, double* q) {
  double exact[6];
  std::copy(q, q + kSix, exact);
  onto_fold(arm, T, group, rounding, exact);
  const Standing at(arm, exact);
  const Fibre exactly = fibre_over(arm, group, exact, at, rounding);
  if (exactly.over != Over::UNKNOWN) std::copy(exact, exact + kSix, q);
  const Fibre& told = exactly.over == Over::UNKNOWN ? fibre : exactly;
  const double gap = group.flat ? INFINITY : line_gap(at, group.first, group.first + 2);
  return told.over == Over::ROOT && gap < kNextToLinkage && gap < told.apart ? Fibre{} : told;
}

}  // namespace pieper::PIEPER_ISA
