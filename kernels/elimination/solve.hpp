// One variant of the elimination applied to W poses: eigenvalues, candidates in lanes, polished solutions, and what is open.
// Templates over the number type.
#pragma once

#include "elimination/model.hpp"

namespace pieper::PIEPER_ISA::general {

inline constexpr int kMaxFound = 32;
// So many real eigenvalues tell what rounding has left of a determinant.
inline constexpr int kToldByReal = 2;

// Distinct verified solutions of one pose, joints in robot order, lengths scaled.
struct Found {
  int count;
  double q[kMaxFound][6];
  double sigma[kMaxFound], residual[kMaxFound];
  bool merged[kMaxFound];  // found twice, from two candidates that were not the same root
};

// Whether all joints of two postures are less than this apart.
inline bool nearer_than(double apart, const double* a, const double* b, const bool* prismatic) {
  for (int k = 0; k < 6; ++k) {
    double d = __builtin_fabs(a[k] - b[k]);
    if (!prismatic[k] && d > kPi) d = __builtin_fabs(kTwoPi - d);
    if (d >= apart) return false;
  }
  return true;
}

// Index of the solution in the set, added when new.
inline int insert(Found& set, const double* q, double sigma, double residual, const bool* prismatic) {
  // what polish can resolve, and what it left: over the smallest singular value
  for (int i = 0; i < set.count; ++i) {
    const double smaller = sigma < set.sigma[i] ? sigma : set.sigma[i];
    double same =
        (kGeneralResolved + residual + set.residual[i]) / (smaller > kGeneralLeastSigma ? smaller : kGeneralLeastSigma);
    same = same > kGeneralSameMost ? kGeneralSameMost : same < kGeneralSame ? kGeneralSame : same;
    if (nearer_than(same, set.q[i], q, prismatic)) {
      if (residual < set.residual[i]) {
        for (int k = 0; k < 6; ++k) set.q[i][k] = q[k];
        set.residual[i] = residual;
      }
      if (sigma < set.sigma[i]) set.sigma[i] = sigma;
      return i;
    }
  }
  if (set.count == kMaxFound) return kMaxFound - 1;
  const int i = set.count++;
  for (int k = 0; k < 6; ++k) set.q[i][k] = q[k];
  set.sigma[i] = sigma;
  set.residual[i] = residual;
  set.merged[i] = false;
  return i;
}

struct Candidate {
  int pose;        // lane of the block; those of one pose follow each other
  int first;       // place of the first of its pose
  double angle;    // of the hidden joint
  double partner;  // imaginary part: 0 for a real eigenvalue
  int solution;    // index in the pose's set, or -1
};

inline double angle_apart(double a, double b) {
  const double d = a - b;
  return __builtin_fabs(d - kTwoPi * __builtin_floor(d / kTwoPi + 0.5));
}

// What one variant left open for one pose.
struct Report {
  int real;        // real eigenvalues
  int unresolved;  // of them without a solution of their own
  int nearly;      // complex ones near enough to the real line to be tried as a double root
  int blind;       // of a nearby arm, complex ones that may be real for the arm itself
  int lost;        // eigenvalues, real or nearly, that share a regular solution with another, or have none
  bool doubtful;   // eigenvalues missing or the matrix meaningless
  bool strayed;    // the eigenvalues are not the zeros of the determinant: they have lost their digits
  double spread;   // largest distance of an eigenvalue from the hidden angle of its polished solution
  double size;     // largest |determinant| met
  bool proven;     // of a determinant that has lost digits: its real zeros tell that no other can be real
};

inline const double* start_vector(int which) {
  static const double v[3][6] = {
      {1, 0.83, -0.71, 0.93, 1.11, -0.87}, {1, -0.9, 0.8, -1.1, 0.7, 0.95}, {0.6, 1, 1.2, 0.9, -1, -0.8}};
  return v[which % 3];
}

// Candidates in groups of lanes: complete, polish, insert.
template <class F> void try_candidates(const Model& model, const Variant& v, const Eliminated<F>& poses,
                                       Candidate* list, int count, int start, int steps, Found* found) {
  using G = Lanes<PIEPER_LANES>;
  constexpr int W = PIEPER_LANES;
  for (int first = 0; first < count; first += W) {
    const int used = count - first < W ? count - first : W;
    Eliminated<G> group;
    G c3(1.0), s3(0.0);
    int of[W];
    for (int i = 0; i < W; ++i) {
      const Candidate& c = list[first + (i < used ? i : used - 1)];
      of[i] = c.pose;
      set_lane(c3, i, c.angle);
    }
    const LanePicker<W> pick(of);
    pick_lanes<G, F>(group.eq, poses.eq, pick);
    pick_lanes<G, F>(group.right, poses.right, pick);
    pick_lanes<G, F>(group.link, poses.link, pick);
    if (v.arm) pick_lanes<G, F>(group.arm_link, poses.arm_link, pick);
    sincos(G(c3), s3, c3);
    Motion<G> q[6];
    complete_candidate(group.eq, group.right, group.link, v.roles, v.chart, v.layout, v.swap, start_vector(start), c3,
                       s3, q);
    Closure<G> end = polish(group.link, v.roles, q, v.arm ? 8 : steps);
    if (v.arm) end = polish(group.arm_link, v.roles, q, steps);
    double joint[6][W];
    for (int k = 0; k < 6; ++k) store(joint[v.roles.joint[k]], v.roles.prismatic[k] ? q[k].c : atan2(q[k].s, q[k].c));
    for (int i = 0; i < used; ++i) {
      Candidate& c = list[first + i];
      c.solution = -1;
      if (!(lane(end.residual, i) < kGeneralVerified)) continue;
      double values[6];
      for (int k = 0; k < 6; ++k) values[k] = joint[k][i];
      c.solution = insert(found[c.pose], values, lane(end.sigma, i), lane(end.residual, i), model.prismatic);
    }
  }
}

// Counts the eigenvalues whose own regular solution was not found though rounding alone made them complex.
//
// A root of several solutions, of which special poses have some, is a multiple eigenvalue and may come as pairs that are nearly
// real: they lie about its solutions, and there must be as many.
inline void count_lost(const Variant& v, const Candidate* list, int count, const Found* found, Report* report) {
  const auto about = [&](const Candidate& c) {
    return c.solution >= 0 && angle_apart(found[c.pose].q[c.solution][v.roles.joint[2]], c.angle - c.partner) <
                                  kGeneralSplit * __builtin_fabs(c.partner) + kGeneralOneRoot;
  };
  for (int k = 0; k < count; ++k) {
    const Candidate& c = list[k];
    const bool as_real = c.partner != 0 && __builtin_fabs(c.partner) < kGeneralOneRoot, near = about(c);
    bool lost = as_real && !near;
    for (int j = c.first; j < k && near && !lost; ++j)
      lost = list[j].solution == c.solution && about(list[j]) && found[c.pose].sigma[c.solution] >= kGeneralMerged;
    report[c.pose].lost += lost;
  }
}

// Whether no complex eigenvalue can be real, told by the real ones, each of which has a solution of its own.
//
// How far those lie from their solutions says what rounding has left of this determinant, however small it is: about a root it is off by
// its slope there times that. A pair that is no pair for rounding alone leaves no more between its two on the real line.
inline bool told_by_real_ones(int eigenvalues, const double* re, const double* im, double chart, const Candidate* list,
                              int count, const Found& found, int hidden) {
  // at an angle counted from the chart's, beside what it is where t is infinite; one factor may be left out
  const auto determinant_at = [&](double angle, int without) {
    const double c = __builtin_cos(angle / 2), s = __builtin_sin(angle / 2);
    double square = 1;
    for (int k = 0; k < eigenvalues; ++k) {
      const double x = c * re[k] - s, y = c * im[k], whole = 1 + re[k] * re[k] + im[k] * im[k];
      square *= k == without ? whole : x * x + y * y;
    }
    return __builtin_sqrt(square);
  };
  double left = kGeneralPerfect;
  int real = 0;
  for (int k = 0, at = 0; k < eigenvalues; ++k) {
    if (im[k] != 0) continue;
    while (at < count && list[at].partner != 0) ++at;  // real candidates stand in the order of their eigenvalues
    if (at == count || list[at].solution < 0) return false;
    const double off = angle_apart(found.q[list[at].solution][hidden], list[at].angle);
    const double there = 0.5 * determinant_at(list[at].angle - chart, k) * off;
    left = there > left ? there : left;
    ++at, ++real;
  }
  if (real < kToldByReal) return false;
  for (int k = 0; k < eigenvalues; ++k)
    if (im[k] > 0 && !(determinant_at(real_part(re[k], im[k]), -1) > kGeneralProven * left)) return false;
  return true;
}

// All solutions that one variant finds for `used` poses in lanes; adds to `found`, writes one report per pose.
template <class F, int N> void solve_variant(const Model& model, const Variant& v, const RigidT<F>& pose, int used,
                                             Found* found, Report* report) {
  constexpr int S = 4 * N / 3, W = width_of<F>;
  Eliminated<F> poses;
  Compressed<F, N> matrix;
  eliminate_poses<F, N>(model, v, pose, poses, matrix);
  hessenberg(matrix.h);
  double re[W][S], im[W][S];
  int eigenvalues[W];
  hessenberg_eigenvalues(matrix.h, re, im, eigenvalues);
  const auto chart_of = [&](int i) { return __builtin_atan2(lane(poses.chart_s, i), lane(poses.chart_c, i)); };
  Candidate list[W * 20];
  int count = 0;
  for (int i = 0; i < used; ++i) {
    const double chart = chart_of(i);
    const double size = lane(poses.largest, i);
    double around[kRound];
    for (int k = 0; k < kRound; ++k) around[k] = lane(poses.around[k], i);
    // a determinant that has lost its own digits is no measure
    const bool astray =
        size > kGeneralTrusted * v.typical && !(strayed(eigenvalues[i], re[i], im[i], around) < kGeneralStrayed);
    report[i] = {0, 0, 0, 0, 0, eigenvalues[i] < S || !(size > kGeneralVanishing * v.typical), astray, 0, size, false};
    const int first = count;
    for (int k = 0; k < eigenvalues[i]; ++k) {
      const double a = re[i][k], b = im[i][k], imaginary = imaginary_part(a, b);
      report[i].blind += v.arm && b != 0 && nearly_real(a, b, kGeneralBlind);
      if (imaginary == 0) ++report[i].real;
      else if (!(__builtin_fabs(imaginary) < kGeneralNearlyReal)) continue;
      else ++report[i].nearly;
      list[count++] = {i, first, chart + real_part(a, b) + imaginary, imaginary, -1};
    }
  }
  try_candidates(model, v, poses, list, count, 0, 25, found);
  // Slow ones once more, with time: near a double root Newton only halves the error, and a null vector may mix two roots.
  for (int start = 1; start <= 2; ++start) {
    Candidate open[W * 20];
    int index[W * 20], n = 0;
    for (int k = 0; k < count; ++k) {
      bool again = list[k].solution < 0 && __builtin_fabs(list[k].partner) < kGeneralTryAgain;
      for (int j = list[k].first; j < k && !again; ++j)
        again = list[k].solution >= 0 && list[j].solution == list[k].solution;
      if (!again) continue;
      index[n] = k;
      open[n++] = list[k];
    }
    if (n == 0) break;
    try_candidates(model, v, poses, open, n, start, 25, found);
    for (int k = 0; k < n; ++k)
      if (open[k].solution >= 0) list[index[k]].solution = open[k].solution;
  }
  count_lost(v, list, count, found, report);
  for (int k = 0; k < count; ++k) {
    if (list[k].partner != 0) continue;
    bool own = list[k].solution >= 0;
    for (int j = list[k].first; j < count && list[j].pose == list[k].pose && own; ++j)
      if (j != k && list[j].partner == 0 && list[j].solution == list[k].solution) {
        const double d = angle_apart(list[j].angle, list[k].angle);
        Found& all = found[list[k].pose];
        // a double root; roots that coincide where the posture is far from singular belong to two solutions, one of them not found
        if (d < kGeneralOneRoot && all.sigma[list[k].solution] < kGeneralMerged) all.merged[list[k].solution] = true;
        else if (j < k) own = false;
      }
    Report& r = report[list[k].pose];
    if (!own) {
      ++r.unresolved;
      continue;
    }
    const double d = angle_apart(found[list[k].pose].q[list[k].solution][v.roles.joint[2]], list[k].angle);
    if (d > r.spread) r.spread = d;
  }
  for (int i = 0, first = 0; i < used; ++i) {
    int own = 0;
    while (first + own < count && list[first + own].pose == i) ++own;
    const bool lost_digits = !(report[i].size > kGeneralTrusted * v.typical) || !(v.noise < kGeneralQuiet);
    if (!v.arm && lost_digits && eigenvalues[i] == S && report[i].unresolved == 0) {
      double around[kRound];
      for (int k = 0; k < kRound; ++k) around[k] = lane(poses.around[k], i);
      report[i].proven = strayed(S, re[i], im[i], around) < kGeneralStrayed &&
                         told_by_real_ones(S, re[i], im[i], chart_of(i), list + first, own, found[i], v.roles.joint[2]);
    }
    first += own;
  }
}

template <class F> void solve_variant(const Model& model, const Variant& v, const RigidT<F>& pose, int used,
                                      Found* found, Report* report) {
  if (v.layout == kTwelve) solve_variant<F, 12>(model, v, pose, used, found, report);
  else solve_variant<F, 6>(model, v, pose, used, found, report);
}

}  // namespace pieper::PIEPER_ISA::general
