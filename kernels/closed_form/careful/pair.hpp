// Two joints at once: M f(a) + N f(c) = e, two equations that are linear in f = (cos, sin) of a revolute joint or in
// f = (d, d^2) of a sliding one. Every three-joint problem of this folder comes down to this one pair.
//
// With M regular, f(a) = M^-1 (e - N f(c)) and the identity that f(a) must keep (cos^2 + sin^2 = 1, or f2 = f1^2) is a
// quartic form in c (at most four pairs). With M and N both of rank one the equations fall apart: one holds c alone, then one gives a.
// Scalar: the careful twin of closed_form/lanes/pair.hpp.
#pragma once

#include "closed_form/careful/standing.hpp"
#include "closed_form/careful/quartic.hpp"

namespace pieper::PIEPER_ISA::closed_form {

struct PairSystem {
  double M[2][2], N[2][2], e[2];
  bool slides_a, slides_c;
  bool apart = false, first_c = false;  // M (first_c) or N is of rank one at every pose
};

inline constexpr int kMostPairs = 16;
struct PairRoots {
  double a[kMostPairs], c[kMostPairs];
  int count = 0;
  bool degenerate = false;
};

// b . f(x) = rhs for one joint: at most two values. Touching within rounding gives the double root once; `terms` is the size of what
// rhs was added up from, whose rounding a slide near zero drowns in.
inline int one_joint(const double* b, double rhs, double terms, bool slides, double* x) {
  if (slides) {  // b0 d + b1 d^2 = rhs, citardauq so that a vanishing b1 is harmless
    double size = std::fabs(b[0]) + std::fabs(b[1]);
    if (!(size > 0)) return 0;
    double disc = b[0] * b[0] + 4 * b[1] * rhs;
    if (disc < 0) {
      const double blur = 64 * kPairRounding * std::fabs(b[1]) * (1 + terms);
      if (disc < -kPairTouching * (b[0] * b[0] + std::fabs(4 * b[1] * rhs)) - blur) return 0;
      x[0] = -b[0] / (2 * b[1]);  // a right side all but zero says nothing of where
      return 1;
    }
    double s = std::sqrt(disc), t = b[0] >= 0 ? b[0] + s : b[0] - s;
    int count = 0;
    if (t != 0) x[count++] = 2 * rhs / t;
    if (std::fabs(b[1]) > kPairLinear * size && (disc > 0 || count == 0)) x[count++] = -t / (2 * b[1]);
    return count;
  }
  double size = std::sqrt(b[0] * b[0] + b[1] * b[1]);
  double room = (size - rhs) * (size + rhs);
  if (!(size > 0)) return 0;
  double middle = std::atan2(b[1], b[0]);
  if (room <= 0) {
    if (std::fabs(rhs) - size > kPairTouching * size + kPairLinear) return 0;
    x[0] = rhs > 0 ? middle : middle + kPi;
    return 1;
  }
  double half = std::atan2(std::sqrt(room), rhs);
  x[0] = middle + half;
  x[1] = middle - half;
  return 2;
}

// f(x) and its derivative.
inline void joint_terms(double x, bool slides, double* f, double* df) {
  if (slides) {
    f[0] = x, f[1] = x * x, df[0] = 1, df[1] = 2 * x;
  } else {
    f[0] = std::cos(x), f[1] = std::sin(x), df[0] = -f[1], df[1] = f[0];
  }
}

// A few Newton steps on the pair, kept only while they help.
inline void polish_pair(const PairSystem& s, double& a, double& c) {
  double best = INFINITY;
  double kept_a = a, kept_c = c;
  for (int i = 0; i < 6; ++i) {
    double fa[2], da[2], fc[2], dc[2], r[2];
    joint_terms(a, s.slides_a, fa, da);
    joint_terms(c, s.slides_c, fc, dc);
    double J[2][2];
    for (int k = 0; k < 2; ++k) {
      r[k] = s.e[k] - s.M[k][0] * fa[0] - s.M[k][1] * fa[1] - s.N[k][0] * fc[0] - s.N[k][1] * fc[1];
      J[k][0] = s.M[k][0] * da[0] + s.M[k][1] * da[1];
      J[k][1] = s.N[k][0] * dc[0] + s.N[k][1] * dc[1];
    }
    double size = std::fabs(r[0]) + std::fabs(r[1]);
    if (!(size < best)) break;
    best = size;
    kept_a = a, kept_c = c;
    double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    double scale = J[0][0] * J[0][0] + J[0][1] * J[0][1] + J[1][0] * J[1][0] + J[1][1] * J[1][1];
    if (size < kPairRounding * scale || std::fabs(det) < kPairLinear * scale) break;
    double ea = (r[0] * J[1][1] - r[1] * J[0][1]) / det, ec = (J[0][0] * r[1] - J[1][0] * r[0]) / det;
    if (!(std::fabs(ea) < 0.2 && std::fabs(ec) < 0.2)) break;
    a += ea;
    c += ec;
  }
  a = kept_a;
  c = kept_c;
}

inline void keep_pair(const PairSystem& s, PairRoots& out, double a, double c) {
  polish_pair(s, a, c);
  if (out.count < kMostPairs) out.a[out.count] = a, out.c[out.count++] = c;
}

// v = V^-1 (e - H f(h)) put into the identity of v: a quartic form in the half angle of h (or in h itself).
inline void solve_by_quartic(const PairSystem& s, bool hide_c, double det, PairRoots& out) {
  const auto& V = hide_c ? s.M : s.N;
  const auto& H = hide_c ? s.N : s.M;
  bool slides_v = hide_c ? s.slides_a : s.slides_c, slides_h = hide_c ? s.slides_c : s.slides_a;
  double d[2][3];  // numerators of f(v) as constant and two coefficients of f(h)
  const double E[2][3] = {{s.e[0], -H[0][0], -H[0][1]}, {s.e[1], -H[1][0], -H[1][1]}};
  for (int k = 0; k < 3; ++k) {
    d[0][k] = E[0][k] * V[1][1] - E[1][k] * V[0][1];
    d[1][k] = V[0][0] * E[1][k] - V[1][0] * E[0][k];
  }
  // quadratic form in (1, f1, f2)
  double g00, g01, g02, g11, g12, g22;
  g00 = d[0][0] * d[0][0], g01 = 2 * d[0][0] * d[0][1], g02 = 2 * d[0][0] * d[0][2];
  g11 = d[0][1] * d[0][1], g12 = 2 * d[0][1] * d[0][2], g22 = d[0][2] * d[0][2];
  double scale = g00 + g11 + g22 + det * det;
  if (slides_v) {
    g00 -= det * d[1][0], g01 -= det * d[1][1], g02 -= det * d[1][2];
    scale += std::fabs(det) * (std::fabs(d[1][0]) + std::fabs(d[1][1]) + std::fabs(d[1][2]));
  } else {
    g00 += d[1][0] * d[1][0] - det * det, g01 += 2 * d[1][0] * d[1][1], g02 += 2 * d[1][0] * d[1][2];
    g11 += d[1][1] * d[1][1], g12 += 2 * d[1][1] * d[1][2], g22 += d[1][2] * d[1][2];
    scale += d[1][0] * d[1][0] + d[1][1] * d[1][1] + d[1][2] * d[1][2];
  }
  double f[5];
  if (slides_h) {
    f[0] = g00, f[1] = g01, f[2] = g02 + g11, f[3] = g12, f[4] = g22;
  } else {  // p/q = tan(h/2), multiplied by (p^2 + q^2)^2
    f[4] = g00 - g01 + g11;
    f[3] = 2 * g02 - 2 * g12;
    f[2] = 2 * g00 - 2 * g11 + 4 * g22;
    f[1] = 2 * g02 + 2 * g12;
    f[0] = g00 + g01 + g11;
  }
  Direction roots[12];
  int count = form_directions(f, kPairFree * scale, roots);
  if (count < 0) {  // h is free: one representative
    out.degenerate = true;
    roots[0] = {0, 1};
    count = 1;
  }
  for (int i = 0; i < count; ++i) {
    double h;
    if (slides_h) {
      if (std::fabs(roots[i].q) < kPairFar) continue;
      h = roots[i].p / roots[i].q;
    } else {
      h = 2 * std::atan2(roots[i].p, roots[i].q);
    }
    double fh[2], unused[2];
    joint_terms(h, slides_h, fh, unused);
    double v1 = d[0][0] + d[0][1] * fh[0] + d[0][2] * fh[1], v2 = d[1][0] + d[1][1] * fh[0] + d[1][2] * fh[1];
    double v = slides_v ? v1 / det : (det > 0 ? std::atan2(v2, v1) : std::atan2(-v2, -v1));
    if (hide_c) keep_pair(s, out, v, h);
    else keep_pair(s, out, h, v);
  }
}

// The unit row that annihilates a rank-one (or zero) 2x2.
inline void left_null(const double (*A)[2], double* u) {
  double r0 = A[0][0] * A[0][0] + A[0][1] * A[0][1], r1 = A[1][0] * A[1][0] + A[1][1] * A[1][1];
  double mixed = A[0][0] * A[1][0] + A[0][1] * A[1][1];
  if (r0 >= r1) u[0] = r0 > 0 ? -mixed / r0 : 0, u[1] = 1;
  else u[0] = 1, u[1] = -mixed / r1;
  double n = 1 / std::sqrt(u[0] * u[0] + u[1] * u[1]);
  u[0] *= n, u[1] *= n;
}

// What is left of the equations of joint h when the null row u of the other joint's matrix is put before them.
struct AloneEquation {
  double u[2], b[2], size;
  double
      wrong;  // what u leaves of the matrix it should annihilate, relative: one that is small in one row only is not of rank one
  AloneEquation(const double (*V)[2], const double (*H)[2]) {
    left_null(V, u);
    for (int k = 0; k < 2; ++k) b[k] = u[0] * H[0][k] + u[1] * H[1][k];
    size = b[0] * b[0] + b[1] * b[1];
    const double x = u[0] * V[0][0] + u[1] * V[1][0], y = u[0] * V[0][1] + u[1] * V[1][1];
    wrong = std::sqrt((x * x + y * y) / std::fmax(size, kTiny));
  }
};

// Returns whether the equation of the joint that comes first is a good one.
inline bool solve_apart(const PairSystem& s, bool first_c, PairRoots& out) {
  const auto& V = first_c ? s.M : s.N;
  const auto& H = first_c ? s.N : s.M;
  const bool slides_v = first_c ? s.slides_a : s.slides_c, slides_h = first_c ? s.slides_c : s.slides_a;
  const AloneEquation alone(V, H);
  double h[16], v[2], size_h = 0, size_v = 0;
  int count;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j) size_v += V[k][j] * V[k][j], size_h += H[k][j] * H[k][j];
  if (alone.size <=
      kPairVanished * (size_h + size_v) + kPairNoise) {  // one equation for two joints: points of a family
    out.degenerate = true;
    for (count = 0; count < 8; ++count) h[count] = slides_h ? 0.25 * (count - 4) : kPi / 4 * count;
  } else {
    const double r0 = alone.u[0] * s.e[0], r1 = alone.u[1] * s.e[1];
    count = one_joint(alone.b, r0 + r1, std::fabs(r0) + std::fabs(r1), slides_h, h);
  }
  double r0 = V[0][0] * V[0][0] + V[0][1] * V[0][1], r1 = V[1][0] * V[1][0] + V[1][1] * V[1][1];
  int row = r0 >= r1 ? 0 : 1;
  for (int i = 0; i < count; ++i) {
    double fh[2], unused[2];
    joint_terms(h[i], slides_h, fh, unused);
    const double t0 = H[row][0] * fh[0], t1 = H[row][1] * fh[1];
    int values =
        one_joint(V[row], s.e[row] - t0 - t1, std::fabs(s.e[row]) + std::fabs(t0) + std::fabs(t1), slides_v, v);
    if (std::fmax(r0, r1) <= kPairVanished) {
      out.degenerate = true;
      v[0] = 0;
      values = 1;
    }
    for (int k = 0; k < values; ++k) {
      if (first_c) keep_pair(s, out, v[k], h[i]);
      else keep_pair(s, out, h[i], v[k]);
    }
  }
  return alone.size > kPairAlone * size_h;
}

// Every pair (a, c): at most four, touches included more.
inline void solve_pair(const PairSystem& s, PairRoots& out) {
  if (s.apart && solve_apart(s, s.first_c, out)) return;
  double det_m = s.M[0][0] * s.M[1][1] - s.M[0][1] * s.M[1][0], det_n = s.N[0][0] * s.N[1][1] - s.N[0][1] * s.N[1][0];
  double size_m = 0, size_n = 0;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j) size_m += s.M[k][j] * s.M[k][j], size_n += s.N[k][j] * s.N[k][j];
  bool good_m = std::fabs(det_m) > kPairRankOne * size_m, good_n = std::fabs(det_n) > kPairRankOne * size_n;
  if (good_m && (!good_n || std::fabs(det_m) >= std::fabs(det_n))) solve_by_quartic(s, true, det_m, out);
  else if (good_n) solve_by_quartic(s, false, det_n, out);
  else {
    const AloneEquation c(s.M, s.N), a(s.N, s.M);
    solve_apart(s, std::fmax(c.wrong, a.wrong) > kPairNotRankOne ? c.wrong <= a.wrong : c.size >= a.size, out);
  }
}

// One equation f(a) + g(c) = 0 of a pair, with its derivatives.
struct Separable {
  double value, a, c, aa, cc;
};

// Where two roots of a pair come close, rounding in the quartic leaves both uncertain by its square root. This evaluates the
// equations afresh (`at(a, c, flat, bent)`, `bent` being the one whose gradient may vanish), steps to `flat` = 0 and solves `bent` to
// second order along it: both roots come back at full accuracy. At most two are written.
template <class Equations> inline int refine_pair(const Equations& at, double a, double c, double (*out)[2]) {
  double start[2][2] = {{a, c}, {a, c}};
  int branches = 1;
  double size_limit = 0.3;
  for (int branch = 0; branch < branches; ++branch) {
    double x = start[branch][0], y = start[branch][1];
    for (int i = 0; i < 7; ++i) {
      Separable flat, bent;
      at(x, y, flat, bent);
      double n2 = flat.a * flat.a + flat.c * flat.c;
      if (!(n2 > kPairVanished)) break;
      double da = -flat.value * flat.a / n2, dc = -flat.value * flat.c / n2, n = std::sqrt(n2);
      double ta = -flat.c / n, tc = flat.a / n;  // along flat = 0
      double value = bent.value + bent.a * da + bent.c * dc + 0.5 * (bent.aa * da * da + bent.cc * dc * dc);
      double slope = (bent.a + bent.aa * da) * ta + (bent.c + bent.cc * dc) * tc;
      double lean =
          (bent.a * flat.a + bent.c * flat.c) / n2;  // bending of flat = 0 itself, weighed by the gradient of bent
      double bend = bent.aa * ta * ta + bent.cc * tc * tc - lean * (flat.aa * ta * ta + flat.cc * tc * tc);
      double disc = slope * slope - 2 * bend * value, step;
      if (disc < 0) {
        step = std::fabs(bend) > 0 ? -slope / bend : 0;
      } else {
        double root = std::sqrt(disc), t = slope >= 0 ? slope + root : slope - root;
        step = t != 0 ? -2 * value / t : 0;
        double other = std::fabs(bend) > 0 ? -t / bend : 1;
        if (branch == 0 && i == 0 && std::fabs(other) < 0.05) {
          branches = 2;
          start[1][0] = x + da + other * ta, start[1][1] = y + dc + other * tc;
        }
      }
      da += step * ta;
      dc += step * tc;
      if (!(std::fabs(da) < size_limit && std::fabs(dc) < size_limit)) break;
      x += da;
      y += dc;
      if (std::fabs(da) + std::fabs(dc) < 4 * kPairRounding * (1 + std::fabs(x) + std::fabs(y))) break;
    }
    out[branch][0] = x;
    out[branch][1] = y;
  }
  return branches;
}

}  // namespace pieper::PIEPER_ISA::closed_form
