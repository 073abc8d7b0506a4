// Three turning and three sliding joints in any order: orientation alone gives the turns (two ways), position then the slides.
#pragma once

#include "elimination/solve.hpp"

namespace pieper::PIEPER_ISA::general {

// A rotation about z by the angle with this cosine and sine, times a.
inline void turn_rows(double c, double s, double (&a)[3][3]) {
  for (int j = 0; j < 3; ++j) {
    const double t = c * a[0][j] - s * a[1][j];
    a[1][j] = s * a[0][j] + c * a[1][j];
    a[0][j] = t;
  }
}

inline void product(const double (&a)[3][3], const double (&b)[3][3], double (&out)[3][3]) {
  double t[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[i][j] = t[i][j];
}

// x with m x = b by Cramer's rule; false when the three slides depend on each other here.
inline bool solve3(const double (&m)[3][3], const double* b, double* x) {
  double cross[3][3], det = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    for (int r = 0; r < 3; ++r) {
      const int s = (r + 1) % 3, t = (r + 2) % 3;
      cross[i][r] = m[s][j] * m[t][k] - m[t][j] * m[s][k];
    }
  }
  for (int r = 0; r < 3; ++r) det += m[r][0] * cross[0][r];
  if (!(__builtin_fabs(det) > 1e-10)) return false;
  for (int i = 0; i < 3; ++i) x[i] = (cross[i][0] * b[0] + cross[i][1] * b[1] + cross[i][2] * b[2]) / det;
  return true;
}

// Returns false when a continuous family is possible: turning axes in line, or dependent slides.
inline bool solve_slides(const Model& model, const Pose<double>& pose, Found& found) {
  int turn[3], slide[3], turns = 0, slides = 0;
  for (int k = 0; k < 6; ++k) (model.prismatic[k] ? slide[slides++] : turn[turns++]) = k;
  // R0 Z(a) R1 Z(b) R2 Z(c) R3, the links between turns lumped
  double lump[4][3][3];
  for (int part = 0; part < 4; ++part) {
    const int from = part == 0 ? 0 : turn[part - 1] + 1, to = part == 3 ? 6 : turn[part];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) lump[part][i][j] = i == j;
    for (int k = from; k <= to; ++k) product(lump[part], model.link[0][k].r, lump[part]);
  }
  double k[3][3];  // R0^T R R3^T
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      k[i][j] = 0;
      for (int r = 0; r < 3; ++r)
        for (int s = 0; s < 3; ++s) k[i][j] += lump[0][r][i] * pose.r[r][s] * lump[3][j][s];
    }
  const double(&m)[3][3] = lump[1];
  const double(&n)[3][3] = lump[2];
  const double a = m[2][0] * n[0][2] + m[2][1] * n[1][2], b = m[2][1] * n[0][2] - m[2][0] * n[1][2];
  const double reach = __builtin_sqrt(a * a + b * b), want = k[2][2] - m[2][2] * n[2][2];
  if (!(reach > 1e-12)) return false;
  double ratio = want / reach;
  if (__builtin_fabs(ratio) > 1 + 1e-12) return true;
  ratio = ratio > 1 ? 1 : ratio < -1 ? -1 : ratio;
  const double middle = __builtin_atan2(b, a), half = __builtin_atan2(__builtin_sqrt((1 - ratio) * (1 + ratio)), ratio);
  bool isolated = true;
  Roles roles;
  roles.assign(0, 0, model.prismatic);
  Frame<double> link[6];
  role_links(model, 0, roles, pose, link);
  for (int side = -1; side <= 1; side += 2) {
    double q[6] = {};
    q[turn[1]] = middle + side * half;
    double inner[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) inner[i][j] = n[i][j];
    turn_rows(__builtin_cos(q[turn[1]]), __builtin_sin(q[turn[1]]), inner);
    product(m, inner, inner);
    // Z(a) inner Z(c) = k
    if (inner[0][2] * inner[0][2] + inner[1][2] * inner[1][2] < 1e-20) {
      isolated = false;  // first and last turning axis in line: only their sum counts
      double in_plane[3][3];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          in_plane[i][j] = inner[0][i] * k[0][j] + inner[1][i] * k[1][j] + inner[2][i] * k[2][j];
      q[turn[2]] = __builtin_atan2(in_plane[1][0], in_plane[0][0]);
    } else {
      q[turn[0]] =
          __builtin_atan2(k[1][2] * inner[0][2] - k[0][2] * inner[1][2], k[0][2] * inner[0][2] + k[1][2] * inner[1][2]);
      q[turn[2]] =
          __builtin_atan2(k[2][0] * inner[2][1] - k[2][1] * inner[2][0], k[2][0] * inner[2][0] + k[2][1] * inner[2][1]);
    }
    double along[3][3], at[3] = {model.link[0][0].p[0], model.link[0][0].p[1], model.link[0][0].p[2]}, r[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r[i][j] = model.link[0][0].r[i][j];
    for (int joint = 0, s = 0; joint < 6; ++joint) {
      if (model.prismatic[joint]) {
        for (int i = 0; i < 3; ++i) along[i][s] = r[i][2];
        ++s;
      } else {
        const double c = __builtin_cos(q[joint]), sn = __builtin_sin(q[joint]);
        for (int i = 0; i < 3; ++i) {
          const double t = r[i][0] * c + r[i][1] * sn;
          r[i][1] = r[i][1] * c - r[i][0] * sn;
          r[i][0] = t;
        }
      }
      const Frame<double>& l = model.link[0][joint + 1];
      for (int i = 0; i < 3; ++i) at[i] += r[i][0] * l.p[0] + r[i][1] * l.p[1] + r[i][2] * l.p[2];
      product(r, l.r, r);
    }
    double missing[3], d[3];
    for (int i = 0; i < 3; ++i) missing[i] = pose.p[i] / model.scale - at[i];
    if (!solve3(along, missing, d)) {
      isolated = false;
      continue;
    }
    for (int i = 0; i < 3; ++i) q[slide[i]] = d[i];
    Joints<double> joints;
    for (int i = 0; i < 6; ++i) {
      joints.c[i] = model.prismatic[i] ? q[i] : __builtin_cos(q[i]);
      joints.s[i] = model.prismatic[i] ? 0.0 : __builtin_sin(q[i]);
    }
    const Closure<double> end = polish(link, roles, joints, 4);
    if (!(end.residual < kVerified * (1 + __builtin_fabs(d[0]) + __builtin_fabs(d[1]) + __builtin_fabs(d[2]))))
      continue;
    for (int i = 0; i < 6; ++i) q[i] = model.prismatic[i] ? joints.c[i] : __builtin_atan2(joints.s[i], joints.c[i]);
    insert(found, q, end.sigma, end.residual, model.prismatic);
  }
  return isolated;
}

}  // namespace pieper::PIEPER_ISA::general
