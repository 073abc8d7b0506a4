// Elimination of the first two roles: from the links of the loop to six equations in the hidden joint and the pair.
//
// Every feature of the axis line, carried through roles 5, 4, 3, is quadratic in each of the pair and has degree one in cos, sin
// of the hidden angle: 27 samples give its coefficients exactly. Seen from the other side of the loop it is a combination of
// three functions of role 1, (1, cos, sin) or (1, d, d^2). Two small null spaces remove role 1 (six real features: four rows)
// and roles 1 and 2 (four complex features, which role 2 only turns: one complex row). Householder reflections without
// pivoting give valid rows whatever the rank.
// Templates over the number type: doubles for what an arm has once and for one pose alone, lanes for many.
#pragma once

#include "elimination/loop.hpp"

namespace pieper::PIEPER_ISA::general {

// Which monomials and multipliers make the system square.
//   0: at most one prismatic joint: twelve monomials y^3..1 times x^2, x, 1; each equation also times y.
//   1: both joints of the pair prismatic: the six monomials y^2, yx, x^2, y, x, 1 (all features have total degree two).
//   2: role 1 and the pair's y prismatic: y, 1 times x^2, x, 1; only l_z (free of y) is also multiplied by y.
enum Layout { kTwelve = 0, kTwoInPair = 1, kTwoApart = 2 };

// What the left side contributes: per robot, unless the pose sits among its links.
template <class F> struct LeftSide {
  F feature[14][27];         // [feature][hidden 1, c, s][y^2, y, 1][x^2, x, 1]
  Complex<F> leading[4][9];  // the four functions that carry the highest power of e^{-i theta3}, in y, x
};

// f + sum over joints: the three samples of a joint, and what turns samples into coefficients.
struct JointSamples {
  double c[3], s[3], d[3];
  double to_coefficients[3][3];
};

inline JointSamples trig_samples() {  // coefficients of 1, cos, sin
  JointSamples out{};
  const double h = 0.86602540378443864676;
  const double c[3] = {1, -0.5, -0.5}, s[3] = {0, h, -h};
  for (int i = 0; i < 3; ++i) {
    out.c[i] = c[i];
    out.s[i] = s[i];
    out.to_coefficients[0][i] = 1.0 / 3.0;
    out.to_coefficients[1][i] = 2.0 / 3.0 * c[i];
    out.to_coefficients[2][i] = 2.0 / 3.0 * s[i];
  }
  return out;
}

inline JointSamples length_samples() {  // coefficients of 1, d, d^2
  JointSamples out{};
  const double t[3][3] = {{0, 1, 0}, {-0.5, 0, 0.5}, {0.5, -1, 0.5}};
  for (int i = 0; i < 3; ++i) {
    out.c[i] = 1.0;
    out.d[i] = i - 1.0;
    for (int k = 0; k < 3; ++k) out.to_coefficients[k][i] = t[k][i];
  }
  return out;
}

// Samples of a joint of the pair: coefficients of x^2, x, 1, where x is the half-angle tangent counted from a chart angle
// (any fixed angle; the straight arm should not sit at 0 or infinity), or the length itself.
inline JointSamples pair_samples(bool prismatic, double cos_chart, double sin_chart) {
  JointSamples t = prismatic ? length_samples() : trig_samples(), out = t;
  for (int i = 0; i < 3; ++i) {
    if (prismatic) {
      out.to_coefficients[0][i] = t.to_coefficients[2][i];
      out.to_coefficients[2][i] = t.to_coefficients[0][i];
    } else {
      out.c[i] = t.c[i] * cos_chart - t.s[i] * sin_chart;
      out.s[i] = t.s[i] * cos_chart + t.c[i] * sin_chart;
      out.to_coefficients[0][i] = t.to_coefficients[0][i] - t.to_coefficients[1][i];
      out.to_coefficients[1][i] = 2.0 * t.to_coefficients[2][i];
      out.to_coefficients[2][i] = t.to_coefficients[0][i] + t.to_coefficients[1][i];
    }
  }
  return out;
}

struct Charts {  // cosine and sine of the chart angles of roles 4 and 5
  double c4, s4, c5, s5;
};

template <class F> PIEPER_INLINE void sample(Line<F>& x, const JointSamples& joint, int i, bool prismatic) {
  if (prismatic) x.p.z = x.p.z + joint.d[i];
  else turn(x, F(joint.c[i]), F(joint.s[i]));
}

// `swap` stores role 5 as y and role 4 as x.
template <class F>
void left_side(const RigidT<F>* link, const Roles& roles, const Charts& chart, bool swap, LeftSide<F>& out) {
  const JointSamples j3 = trig_samples();
  const JointSamples j4 = pair_samples(roles.prismatic[3], chart.c4, chart.s4);
  const JointSamples j5 = pair_samples(roles.prismatic[4], chart.c5, chart.s5);
  F at[14][27], inner[8][9];
  for (int i5 = 0; i5 < 3; ++i5)
    for (int i4 = 0; i4 < 3; ++i4) {
      Line<F> x = {link[4].t, link[4].z};
      sample(x, j5, i5, roles.prismatic[4]);
      x = move(link[3], x);
      sample(x, j4, i4, roles.prismatic[3]);
      x = move(link[2], x);
      const int cell = swap ? i5 * 3 + i4 : i4 * 3 + i5;
      F value[14];
      features(x, value);
      for (int m = 0; m < 8; ++m) inner[m][cell] = value[6 + m];
      for (int i3 = 0; i3 < 3; ++i3) {
        Line<F> y = x;
        turn(y, F(j3.c[i3]), F(j3.s[i3]));
        y = move(link[1], y);
        features(y, value);
        for (int m = 0; m < 14; ++m) at[m][i3 * 9 + cell] = value[m];
      }
    }
  const double (*ky)[3] = swap ? j5.to_coefficients : j4.to_coefficients;
  const double (*kx)[3] = swap ? j4.to_coefficients : j5.to_coefficients;
  auto pair_coefficients = [&](F* v) {  // 9 samples -> 9 coefficients, in place
    F t[9];
    for (int a = 0; a < 3; ++a)
      for (int j = 0; j < 3; ++j) t[a * 3 + j] = ky[a][0] * v[j] + ky[a][1] * v[3 + j] + ky[a][2] * v[6 + j];
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        v[a * 3 + b] = kx[b][0] * t[a * 3] + kx[b][1] * t[a * 3 + 1] + kx[b][2] * t[a * 3 + 2];
  };
  for (int m = 0; m < 14; ++m) {
    for (int k = 0; k < 3; ++k) pair_coefficients(at[m] + 9 * k);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 9; ++j)
        out.feature[m][k * 9 + j] = j3.to_coefficients[k][0] * at[m][j] + j3.to_coefficients[k][1] * at[m][9 + j] +
                                    j3.to_coefficients[k][2] * at[m][18 + j];
  }
  for (int m = 0; m < 8; ++m) pair_coefficients(inner[m]);
  for (int m = 0; m < 4; ++m)
    for (int j = 0; j < 9; ++j) out.leading[m][j] = {inner[2 * m][j], 0.0 - inner[2 * m + 1][j]};
}

// The right side: functions of role 1, coefficients of (1, cos, sin) or (1, d, d^2).
template <class F> struct RightSide {
  F real[6][3];
  Complex<F> turned[4][3];
};

template <class F> void right_side(const RigidT<F>* link, const Roles& roles, RightSide<F>& out) {
  const JointSamples j1 = roles.prismatic[0] ? length_samples() : trig_samples();
  F value[3][14];
  for (int i = 0; i < 3; ++i) {
    const RigidT<F> back = inverse(link[5]);
    Line<F> x = {back.t, back.z};
    if (roles.prismatic[0]) x.p.z = x.p.z - j1.d[i];
    else turn(x, F(j1.c[i]), F(-j1.s[i]));
    x = move_back(link[0], x);
    features(x, value[i]);
  }
  for (int k = 0; k < 3; ++k) {
    const double* t = j1.to_coefficients[k];
    F v[14];
    for (int m = 0; m < 14; ++m) v[m] = t[0] * value[0][m] + t[1] * value[1][m] + t[2] * value[2][m];
    for (int m = 0; m < 6; ++m) out.real[m][k] = v[m];
    for (int m = 0; m < 4; ++m) out.turned[m][k] = {v[6 + 2 * m], v[7 + 2 * m]};
  }
}

// Reflect the complex vector v (from index k on) onto the first axis; afterwards v holds the reflector, scaled to |v|^2 = 2.
template <class F, int N> PIEPER_INLINE void reflector(Complex<F> (&v)[N], int k) {
  F tail = 0.0;
  for (int i = k + 1; i < N; ++i) tail += v[i].re * v[i].re + v[i].im * v[i].im;
  const F head2 = v[k].re * v[k].re + v[k].im * v[k].im;
  const F norm = sqrt(tail + head2), head = sqrt(head2);
  const F inv = 1.0 / select(head > kTiny, head, F(1.0));
  const F er = select(head > kTiny, v[k].re * inv, F(1.0)), ei = select(head > kTiny, v[k].im * inv, F(0.0));
  v[k].re += er * norm;
  v[k].im += ei * norm;
  const F size = norm * (norm + head);  // half of |v|^2
  const F scale = select(size > kHouseholderZero, 1.0 / sqrt(select(size > kHouseholderZero, size, F(1.0))), F(0.0));
  for (int i = k; i < N; ++i) v[i] = {v[i].re * scale, v[i].im * scale};
  for (int i = 0; i < k; ++i) v[i] = {F(0.0), F(0.0)};
}
template <class F, int N> PIEPER_INLINE void reflect(const Complex<F> (&v)[N], Complex<F> (&x)[N], int k) {
  Complex<F> w = {F(0.0), F(0.0)};
  for (int i = k; i < N; ++i) {
    const Complex<F> t = conj_times(v[i], x[i]);
    w.re += t.re;
    w.im += t.im;
  }
  for (int i = k; i < N; ++i) {
    const Complex<F> t = v[i] * w;
    x[i].re -= t.re;
    x[i].im -= t.im;
  }
}

// Rows that annihilate the last columns of `columns` (N x C), real: the last N - C rows of the transposed Householder Q.
template <class F, int N, int C> PIEPER_INLINE void left_null_rows(F (&columns)[C][N], F (&rows)[N - C][N]) {
  F scale[C];
  for (int c = 0; c < C; ++c) {
    F tail = 0.0;
    for (int i = c + 1; i < N; ++i) tail += columns[c][i] * columns[c][i];
    const F x0 = columns[c][c];
    F norm = sqrt(tail + x0 * x0);
    norm = select(x0 > 0.0, norm, 0.0 - norm);
    const F size = norm * (norm + x0);
    columns[c][c] = x0 + norm;
    scale[c] = select(size > kHouseholderZero, 1.0 / select(size > kHouseholderZero, size, F(1.0)), F(0.0));
    for (int d = c + 1; d < C; ++d) {
      F w = 0.0;
      for (int i = c; i < N; ++i) w += columns[c][i] * columns[d][i];
      w = w * scale[c];
      for (int i = c; i < N; ++i) columns[d][i] -= w * columns[c][i];
    }
  }
  for (int r = 0; r < N - C; ++r) {
    for (int i = 0; i < N; ++i) rows[r][i] = F(i == r + C ? 1.0 : 0.0);
    for (int c = C - 1; c >= 0; --c) {
      F w = 0.0;
      for (int i = c; i < N; ++i) w += columns[c][i] * rows[r][i];
      w = w * scale[c];
      for (int i = c; i < N; ++i) rows[r][i] -= w * columns[c][i];
    }
  }
}

// The complex row that annihilates `columns` (N x C).
template <class F, int N, int C>
PIEPER_INLINE void complex_null_row(Complex<F> (&columns)[C][N], Complex<F> (&row)[N]) {
  for (int c = 0; c < C; ++c) {
    reflector(columns[c], c);
    for (int d = c + 1; d < C; ++d) reflect(columns[c], columns[d], c);
  }
  for (int i = 0; i < N; ++i) row[i] = {F(i == N - 1 ? 1.0 : 0.0), F(0.0)};
  for (int c = C - 1; c >= 0; --c) reflect(columns[c], row, c);
  for (int i = 0; i < N; ++i) row[i].im = 0.0 - row[i].im;
}

// Six equations: [row][hidden 1, c, s][y^2, y, 1][x^2, x, 1]. In layout 2 row 0 is l_z and row 3 is not used.
template <class F> struct Equations {
  F e[6][27];
};

template <class L, class F> void eliminate(const LeftSide<L>& left, const RightSide<F>& right, int layout,
                                           bool y_prismatic, bool x_prismatic, Equations<F>& out) {
  F rows[4][6];
  Complex<F> mix[4];
  if (layout != kTwoApart) {
    F two[2][6];
    for (int m = 0; m < 6; ++m) {
      two[0][m] = right.real[m][1];
      two[1][m] = right.real[m][2];
    }
    left_null_rows<F, 6, 2>(two, rows);
    Complex<F> three[3][4];
    for (int k = 0; k < 3; ++k)
      for (int m = 0; m < 4; ++m) three[k][m] = right.turned[m][k];
    complex_null_row<F, 4, 3>(three, mix);
  } else {
    F one[1][3] = {{right.real[0][1], right.real[3][1], right.real[4][1]}}, pair[2][3];
    left_null_rows<F, 3, 1>(one, pair);
    for (int r = 0; r < 4; ++r)
      for (int m = 0; m < 6; ++m) rows[r][m] = 0.0;
    rows[0][1] = 1.0;
    const int which[3] = {0, 3, 4};
    for (int r = 0; r < 2; ++r)
      for (int m = 0; m < 3; ++m) rows[1 + r][which[m]] = pair[r][m];
    Complex<F> two[2][3], triple[3];
    for (int k = 0; k < 2; ++k)
      for (int m = 0; m < 3; ++m) two[k][m] = right.turned[m][k];
    complex_null_row<F, 3, 2>(two, triple);
    for (int m = 0; m < 3; ++m) mix[m] = triple[m];
    mix[3] = {F(0.0), F(0.0)};
  }
  for (int j = 0; j < 27; ++j) {
    L f[6], g[4], h[4];
    for (int m = 0; m < 6; ++m) f[m] = left.feature[m][j];
    for (int m = 0; m < 4; ++m) {
      g[m] = left.feature[6 + 2 * m][j];
      h[m] = left.feature[7 + 2 * m][j];
    }
    for (int r = 0; r < 4; ++r) {
      F s = rows[r][0] * f[0];
      for (int m = 1; m < 6; ++m) s += rows[r][m] * f[m];
      out.e[r][j] = s;
    }
    F re = 0.0, im = 0.0;
    for (int m = 0; m < 4; ++m) {
      re += mix[m].re * g[m] - mix[m].im * h[m];
      im += mix[m].re * h[m] + mix[m].im * g[m];
    }
    out.e[4][j] = re;
    out.e[5][j] = im;
  }
  // The constant on the right: 1 is (y^2 + 1)(x^2 + 1) over the half angles' common denominator, or 1 itself for lengths.
  for (int r = 0; r < 4; ++r) {
    F constant = 0.0;
    for (int m = 0; m < 6; ++m) constant += rows[r][m] * right.real[m][0];
    for (int y = y_prismatic ? 2 : 0; y <= 2; y += 2)
      for (int x = x_prismatic ? 2 : 0; x <= 2; x += 2) out.e[r][y * 3 + x] -= constant;
  }
}

}  // namespace pieper::PIEPER_ISA::general
