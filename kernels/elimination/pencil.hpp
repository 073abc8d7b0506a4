// The hidden angle as a real eigenvalue problem of the smallest possible size: 16 x 16, or 8 x 8 with two prismatic joints.
//
// With t = tan((theta3 - chart) / 2) the six equations make a quadratic matrix polynomial A t^2 + B t + C of size N (12 or 6), and
// a companion matrix of size 2N. Its 2N/3 eigenvalues at t = +-i mean nothing (they come from clearing cos, sin), and their
// invariant subspace is known beforehand: it is { (i u; u) : W u = 0 } where W, the coefficients of the highest power of
// e^{-i theta3}, has only four independent functions. (i u; u) with complex u fills all of R^2N, so the orthogonal
// complement is { (i Y a; Y a) } with Y an orthonormal basis of the row space of W, whatever the chart. Compressing the
// companion matrix to that complement leaves exactly the 4N/3 eigenvalues that matter. Templates over the number type.
#pragma once

#include "chain/newton_step.hpp"
#include "elimination/elimination.hpp"

namespace pieper::PIEPER_ISA::general {

// The square matrix of one coefficient (or of the equations at one angle): e is [6][9], rows of y^2..1 x x^2..1.
template <class F, int N> PIEPER_INLINE void arrange(const F (*e)[9], int layout, F (&m)[N][N]) {
  if constexpr (N == 12) {
    for (int r = 0; r < 6; ++r)
      for (int j = 0; j < 12; ++j) {
        m[r][j] = j >= 3 ? e[r][j - 3] : F(0.0);
        m[6 + r][j] = j < 9 ? e[r][j] : F(0.0);
      }
  } else if (layout == kTwoInPair) {
    const int monomial[6] = {2, 4, 6, 5, 7, 8};  // y^2 1, y x, 1 x^2, y, x, 1 as cells of the 3 x 3 table
    for (int r = 0; r < 6; ++r)
      for (int j = 0; j < 6; ++j) m[r][j] = e[r][monomial[j]];
  } else {
    for (int r = 0; r < 6; ++r)
      for (int j = 0; j < 6; ++j) m[r][j] = r == 3 ? (j < 3 ? e[0][6 + j] : F(0.0)) : e[r][3 + j];
  }
}

template <class F> PIEPER_INLINE void at_angle(const Equations<F>& eq, F c, F s, F (*e)[9]) {
  for (int r = 0; r < 6; ++r)
    for (int j = 0; j < 9; ++j) e[r][j] = eq.e[r][j] + c * eq.e[r][9 + j] + s * eq.e[r][18 + j];
}

// Orthonormal basis (columns) of the row space of the leading coefficients.
template <class F, int N> struct RowSpace {
  F re[N][2 * N / 3], im[N][2 * N / 3];
};

// The products of its columns, G^T E below.
template <class F, int N> struct Between {
  static constexpr int size = 4 * N / 3;
  F of[size][size];
};

template <class F, int N> void products_of(const RowSpace<F, N>& y, Between<F, N>& out) {
  constexpr int P = 2 * N / 3;
  for (int a = 0; a < P; ++a)
    for (int k = 0; k < P; ++k) {
      F rr = 0.0, ri = 0.0, ir = 0.0, ii = 0.0;
      for (int j = 0; j < N; ++j) {
        rr += y.re[j][a] * y.re[j][k];
        ri += y.re[j][a] * y.im[j][k];
        ir += y.im[j][a] * y.re[j][k];
        ii += y.im[j][a] * y.im[j][k];
      }
      out.of[a][k] = 0.0 - ri;
      out.of[a][P + k] = 0.0 - rr;
      out.of[P + a][k] = ii;
      out.of[P + a][P + k] = ir;
    }
}

template <class F, int N> void row_space(const LeftSide<F>& left, int layout, RowSpace<F, N>& out) {
  constexpr int P = 2 * N / 3;
  Complex<F> column[P][N];
  const Complex<F> zero = {F(0.0), F(0.0)};
  for (int c = 0; c < P; ++c)
    for (int j = 0; j < N; ++j) column[c][j] = zero;
  auto put = [](Complex<F>& cell, const Complex<F>& w) { cell = {w.re, 0.0 - w.im}; };
  for (int m = 0; m < 4; ++m) {
    const Complex<F>* w = left.leading[m];
    if constexpr (N == 12) {
      for (int j = 0; j < 9; ++j) {
        put(column[2 * m][3 + j], w[j]);
        put(column[2 * m + 1][j], w[j]);
      }
    } else if (layout == kTwoInPair) {
      const int monomial[6] = {2, 4, 6, 5, 7, 8};
      for (int j = 0; j < 6; ++j) put(column[m][j], w[monomial[j]]);
    } else {
      // p, l, p x l, and y times l in place of the fourth function, which does not occur
      for (int j = 0; j < 6; ++j)
        if (m < 3) put(column[m][j], w[3 + j]);
        else if (j < 3) put(column[m][j], left.leading[1][6 + j]);
    }
  }
  for (int c = 0; c < P; ++c) {
    reflector(column[c], c);
    for (int d = c + 1; d < P; ++d) reflect(column[c], column[d], c);
  }
  for (int c = 0; c < P; ++c) {
    Complex<F> q[N];
    for (int j = 0; j < N; ++j) q[j] = {F(j == c ? 1.0 : 0.0), F(0.0)};
    for (int k = P - 1; k >= 0; --k) reflect(column[k], q, k);
    for (int j = 0; j < N; ++j) {
      out.re[j][c] = q[j].re;
      out.im[j][c] = q[j].im;
    }
  }
}

// Reflections that make a triangle of C columns of six rows, and what they do to another column. A column at a time, so that it
// stays in registers. The columns become the reflections; returns the product of the pivots.
template <class F, int C> PIEPER_INLINE F reflections(F (&v)[C][6], F (&scale)[C]) {
  F product = 1.0;
#pragma GCC unroll 6
  for (int c = 0; c < C; ++c) {
    if (c == 5) return product * v[5][5];
    F tail = v[c][c + 1] * v[c][c + 1];
#pragma GCC unroll 6
    for (int i = c + 2; i < 6; ++i) tail += v[c][i] * v[c][i];
    const F x0 = v[c][c], size2 = tail + x0 * x0;
    F norm = sqrt(size2);
    norm = select(x0 > 0.0, norm, 0.0 - norm);
    const F head = x0 + norm, size = norm * head;
    scale[c] = select(size > kHouseholderZero, 1.0 / select(size > kHouseholderZero, size, F(1.0)), F(0.0));
    v[c][c] = head;
    product = product * norm;
#pragma GCC unroll 6
    for (int d = c + 1; d < C; ++d) {
      F w = v[c][c] * v[d][c];
#pragma GCC unroll 6
      for (int i = c + 1; i < 6; ++i) w += v[c][i] * v[d][i];
      w = w * scale[c];
#pragma GCC unroll 6
      for (int i = c; i < 6; ++i) v[d][i] -= w * v[c][i];
    }
  }
  return product;
}
template <class F, int C> PIEPER_INLINE void reflect_all(const F (&v)[C][6], const F (&scale)[C], F (&x)[6]) {
#pragma GCC unroll 6
  for (int c = 0; c < C; ++c) {
    F w = v[c][c] * x[c];
#pragma GCC unroll 6
    for (int i = c + 1; i < 6; ++i) w += v[c][i] * x[i];
    w = w * scale[c];
#pragma GCC unroll 6
    for (int i = c; i < 6; ++i) x[i] -= w * v[c][i];
  }
}

// Six by six core of the twelve by twelve matrix [0 A B C; A B C 0], by columns: the columns y^3 and 1 eliminated by orthogonal
// reflections. Unknowns left: y^2, y times x^2, x, 1. Returns the product of the eliminated pivots.
template <class F> PIEPER_INLINE F core_columns(const F (*e)[9], F (&six)[6][6]) {
  F product = 1.0;
#pragma GCC unroll 2
  for (int half = 0; half < 2; ++half) {
    F v[3][6], scale[3];
#pragma GCC unroll 3
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 6
      for (int r = 0; r < 6; ++r) v[c][r] = e[r][half ? 6 + c : c];
    product = product * reflections<F, 3>(v, scale);
    // B', C': times y^2, y once the y^3 column is gone; then A', B'
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
      F x[6];
#pragma GCC unroll 6
      for (int r = 0; r < 6; ++r) x[r] = e[r][half ? j : 3 + j];
      reflect_all<F, 3>(v, scale, x);
#pragma GCC unroll 3
      for (int r = 0; r < 3; ++r) six[j][3 * half + r] = x[3 + r];
    }
  }
  return product;
}
template <class F> void core(const F (*e)[9], F (&six)[6][6]) {
  F column[6][6];
  core_columns(e, column);
  for (int r = 0; r < 6; ++r)
    for (int j = 0; j < 6; ++j) six[r][j] = column[j][r];
}

template <class F, int N> F determinant(const Equations<F>& eq, int layout, F c, F s) {
  F e[6][9], six[6][6], scale[6];
  at_angle(eq, c, s, e);
  if constexpr (N == 12) {
    const F pivots = core_columns(e, six);
    return pivots * reflections<F, 6>(six, scale);
  } else {
    arrange<F, 6>(e, layout, six);
    return reflections<F, 6>(six, scale);  // of the transposed
  }
}

// Angles around the circle at which the determinant is taken.
inline constexpr int kRound = 8;

inline constexpr double kRoundCos[kRound] = {1,  0.70710678118654752440,  0, -0.70710678118654752440,
                                             -1, -0.70710678118654752440, 0, 0.70710678118654752440},
                        kRoundSin[kRound] = {0, 0.70710678118654752440,  1,  0.70710678118654752440,
                                             0, -0.70710678118654752440, -1, -0.70710678118654752440};

// The sizes of the determinants there. Of one pose alone, in fewer lanes than there are, lanes are the angles.
template <class F, int N> void determinants_around(const Equations<F>& eq, int layout, F (&around)[kRound]) {
  if constexpr (width_of<F> < PIEPER_LANES) {
    using G = Lanes<PIEPER_LANES>;
    Equations<G> wide;
    for (int r = 0; r < 6; ++r)
      for (int j = 0; j < 27; ++j) wide.e[r][j] = G(lane(eq.e[r][j], 0));
    double sizes[kRound];
    for (int k = 0; k < kRound; k += PIEPER_LANES)
      store(sizes + k, abs(determinant<G, N>(wide, layout, load<G>(kRoundCos + k), load<G>(kRoundSin + k))));
    for (int k = 0; k < kRound; ++k) around[k] = F(sizes[k]);
  } else {
    for (int k = 0; k < kRound; ++k) around[k] = abs(determinant<F, N>(eq, layout, F(kRoundCos[k]), F(kRoundSin[k])));
  }
}

// The angle (of eight) where the matrix polynomial is farthest from singular becomes t = infinity. `around`: the determinants.
template <class F, int N>
void choose_chart(const Equations<F>& eq, int layout, F& c, F& s, F& largest, F (&around)[kRound]) {
  determinants_around<F, N>(eq, layout, around);
  largest = F(-1.0);
  c = F(1.0);
  s = F(0.0);
  for (int k = 0; k < kRound; ++k) {
    const auto better = around[k] > largest;
    largest = select(better, around[k], largest);
    c = select(better, F(-kRoundCos[k]), c);  // t is infinite half a turn away from the chart angle
    s = select(better, F(-kRoundSin[k]), s);
  }
}

template <class F, int N> struct Compressed {
  static constexpr int size = 4 * N / 3;
  F h[size][size + 1];  // rows a power of two apart would share their places in the cache
};

// Y, B: of the arm, or of the poses too.
template <class F, class Y, int N> void compress(const Equations<F>& eq, const RowSpace<Y, N>& y,
                                                 const Between<Y, N>& between, int layout, F c, F s,
                                                 Compressed<F, N>& out) {
  constexpr int P = 2 * N / 3, K = 2 * P;
  F constant[6][9], cosine[6][9], sine[6][9];
  for (int r = 0; r < 6; ++r)
    for (int j = 0; j < 9; ++j) {
      const F a = eq.e[r][9 + j], b = eq.e[r][18 + j], turned = a * c + b * s;
      cosine[r][j] = eq.e[r][j] + turned;    // C
      constant[r][j] = eq.e[r][j] - turned;  // A
      sine[r][j] = 2.0 * (b * c - a * s);    // B
    }
  F work[N][N + K];
  {
    F a[N][N], b[N][N], d[N][N];
    arrange<F, N>(constant, layout, a);
    arrange<F, N>(sine, layout, b);
    arrange<F, N>(cosine, layout, d);
    for (int r = 0; r < N; ++r) {
      for (int j = 0; j < N; ++j) work[r][j] = a[r][j];
      // beyond are noughts, see `arrange`
      const int from = N == 12 && r < 6 ? 3 : 0, to = N == 12 ? from + 9 : N;
      for (int k = 0; k < P; ++k) {
        F v = 0.0, w = 0.0;  // B E + C G for the two real columns of Y_k: E = (-im, -re), G = (re, -im)
        for (int j = from; j < to; ++j) {
          v += d[r][j] * y.re[j][k] - b[r][j] * y.im[j][k];
          w += d[r][j] * y.im[j][k] + b[r][j] * y.re[j][k];
        }
        work[r][N + k] = v;
        work[r][N + P + k] = 0.0 - w;
      }
    }
  }
  triangulate(work, N);
  for (int i = N - 1; i >= 0; --i) {
    const F d = work[i][i];
    const F inv = 1.0 / select(abs(d) > kPencilPivot, d, F(kPencilPivot));
    for (int k = N; k < N + K; ++k) {
      F v = work[i][k];
      for (int j = i + 1; j < N; ++j) v -= work[i][j] * work[j][k];
      work[i][k] = v * inv;
    }
  }
  for (int a = 0; a < P; ++a) {
    for (int k = 0; k < K; ++k) {
      F v = 0.0, w = 0.0;  // -E^T X
      for (int j = 0; j < N; ++j) {
        v += y.im[j][a] * work[j][N + k];
        w += y.re[j][a] * work[j][N + k];
      }
      out.h[a][k] = v + between.of[a][k];
      out.h[P + a][k] = w + between.of[P + a][k];
    }
  }
}

}  // namespace pieper::PIEPER_ISA::general
