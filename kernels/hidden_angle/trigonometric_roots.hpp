// All real roots of trigonometric polynomials of degree D, several at once, isolated with certainty and without eigenvalues.
//
// p(theta) = a0 + sum a_m cos(m theta) + b_m sin(m theta) is a form of degree 2D in (cos, sin) of theta / 2. On a sector that
// form has Bernstein coefficients (of the two edge directions), and the changes of sign among them bound its roots: none
// means no root, one means exactly one, more are halved by de Casteljau's scheme (Descartes' rule in Bernstein's basis;
// Lane and Riesenfeld, 1981). What is still open in a very narrow sector, a pair of roots about to merge or just gone, is
// handed back as not clear. Templates over the number type for the polynomials; isolating roots goes lane by lane.
#pragma once

#include "lanes/lanes.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA::trigonometric {

inline constexpr int kSectors = 16;
inline constexpr int kDeepest = 13;  // halvings: sectors of about 5e-5 rad

template <class F, int D> struct Series {
  F a[D + 1], b[D + 1];  // b[0] is not used
};

// Cosine and sine of the multiples of a whole turn's M-th part.
template <int M> struct Circle {
  double c[M], s[M];
  Circle() {
    for (int i = 0; i < M; ++i)
      c[i] = __builtin_cos(6.28318530717958647693 * i / M), s[i] = __builtin_sin(6.28318530717958647693 * i / M);
  }
};
template <int M> inline const Circle<M>& circle() {
  static const Circle<M> table;
  return table;
}

// Coefficients from M > 2D + 1 values at the multiples of a whole turn's M-th part. Returns what lies just above degree D:
// zero but for rounding, so it tells how noisy the values are; `size` is the sum of all coefficients without signs.
template <class F, int D, int M> F series_of(const F* value, Series<F, D>& out, F& size) {
  static_assert(M > 2 * D + 1);
  const Circle<M>& at = circle<M>();
  F above = 0.0;
  size = 0.0;
  for (int m = 0; m <= D + 1; ++m) {
    F a = 0.0, b = 0.0;
    for (int i = 0; i < M; ++i) {
      const int k = i * m % M;
      a += at.c[k] * value[i];
      b += at.s[k] * value[i];
    }
    a = a * ((m ? 2.0 : 1.0) / M);
    b = b * (2.0 / M);
    if (m > D) {
      above = max(abs(a), abs(b));
      break;
    }
    out.a[m] = a;
    out.b[m] = b;
    size += abs(a) + abs(b);
  }
  return above;
}

// Bernstein coefficients 0..D on a sector about zero of each cosine and sine; the others follow by symmetry.
template <int D> struct SectorBasis {
  double cosine[D + 1][D + 1], sine[D + 1][D + 1];  // [coefficient][multiple]
  SectorBasis() {
    double pascal[2 * D + 1][2 * D + 1] = {};
    for (int n = 0; n <= 2 * D; ++n)
      for (int k = 0; k <= n; ++k) pascal[n][k] = k == 0 || k == n ? 1.0 : pascal[n - 1][k - 1] + pascal[n - 1][k];
    const double half = 3.14159265358979323846 / kSectors;  // of the sector's width
    for (int k = 0; k <= D; ++k)
      for (int m = 0; m <= D; ++m) {
        double c = 0, s = 0;
        for (int j = 0; j <= k; ++j) {
          if (j > D + m || k - j > D - m) continue;
          const double weight = pascal[D + m][j] * pascal[D - m][k - j] / pascal[2 * D][k],
                       angle = half * (2 * j - m - k);
          c += weight * __builtin_cos(angle);
          s += weight * __builtin_sin(angle);
        }
        cosine[k][m] = c;
        sine[k][m] = s;
      }
  }
};
template <int D> inline const SectorBasis<D>& sector_basis() {
  static const SectorBasis<D> table;
  return table;
}

template <class F, int D> struct Sectors {
  F coefficient[kSectors][2 * D + 1];
  F changes[kSectors];  // of sign
  F least[kSectors];    // smallest coefficient, without sign
};

template <class F, int N> PIEPER_INLINE F sign_changes(const F (&b)[N]) {
  F count = 0.0, before = select(b[0] < 0.0, F(1.0), F(0.0));
  for (int k = 1; k < N; ++k) {
    const F now = select(b[k] < 0.0, F(1.0), F(0.0));
    count += abs(now - before);
    before = now;
  }
  return count;
}

template <class F, int D> void sectors_of(const Series<F, D>& p, Sectors<F, D>& out) {
  const SectorBasis<D>& basis = sector_basis<D>();
  const Circle<2 * kSectors>& turn = circle<2 * kSectors>();
  for (int i = 0; i < kSectors; ++i) {
    F a[D + 1], b[D + 1];
    a[0] = p.a[0];
    for (int m = 1; m <= D; ++m) {
      const int at = (2 * i + 1) * m % (2 * kSectors);
      a[m] = p.a[m] * turn.c[at] + p.b[m] * turn.s[at];
      b[m] = p.b[m] * turn.c[at] - p.a[m] * turn.s[at];
    }
    F(&coefficient)[2 * D + 1] = out.coefficient[i];
    for (int k = 0; k <= D; ++k) {
      F even = a[0] * basis.cosine[k][0], odd = 0.0;
      for (int m = 1; m <= D; ++m) {
        even += a[m] * basis.cosine[k][m];
        odd += b[m] * basis.sine[k][m];
      }
      coefficient[k] = even + odd;
      coefficient[2 * D - k] = even - odd;
    }
    // one value at a shared edge, so that rounding can not put a root into both sectors or into none
    if (i) coefficient[0] = out.coefficient[i - 1][2 * D];
    if (i + 1 == kSectors) coefficient[2 * D] = out.coefficient[0][0];
  }
  for (int i = 0; i < kSectors; ++i) {
    out.changes[i] = sign_changes(out.coefficient[i]);
    out.least[i] = abs(out.coefficient[i][0]);
    for (int k = 1; k <= 2 * D; ++k) out.least[i] = min(out.least[i], abs(out.coefficient[i][k]));
  }
}

// One simple root, in one lane of the polynomials: e^{i theta} = e^{i centre} (1 + i u)^2 / (1 + u^2) with u between low and high.
struct Bracket {
  int lane, sector;
  double low, high;
  double at_low, at_high;  // of opposite sign
};

template <int N> inline int changes_of(const double* b) {
  int count = 0;
  for (int k = 1; k < N; ++k) count += (b[k] < 0) != (b[k - 1] < 0);
  return count;
}

template <int N> inline double least_of(const double* b) {
  double least = __builtin_fabs(b[0]);
  for (int k = 1; k < N; ++k) least = __builtin_fabs(b[k]) < least ? __builtin_fabs(b[k]) : least;
  return least;
}

// Appends the roots of one lane to `list`, at most 2D of them; returns false when some of it is not clear: where a coefficient that
// decides lies below `noise`, or roots do not part.
template <class F, int D>
bool isolate(const Sectors<F, D>& sectors, int of_lane, double noise, Bracket* list, int& count) {
  constexpr int N = 2 * D + 1;
  const double reach = __builtin_tan(0.78539816339744830962 * 2 / kSectors);  // of u at a sector's edge
  struct Cell {
    double b[N], low, high;  // in units of `reach`, from -1 to 1
    int depth;
  };
  Cell stack[kDeepest + 2];
  const int most = count + 2 * D;
  for (int i = 0; i < kSectors; ++i) {
    const double changes = lane(sectors.changes[i], of_lane);
    if (changes < 2 && lane(sectors.least[i], of_lane) < noise) return false;
    if (changes == 0) continue;
    if (count == most) return false;
    if (changes == 1) {
      list[count++] = {of_lane,
                       i,
                       -reach,
                       reach,
                       lane(sectors.coefficient[i][0], of_lane),
                       lane(sectors.coefficient[i][N - 1], of_lane)};
      continue;
    }
    int waiting = 1;
    for (int k = 0; k < N; ++k) stack[0].b[k] = lane(sectors.coefficient[i][k], of_lane);
    stack[0].low = -1, stack[0].high = 1, stack[0].depth = 0;
    while (waiting) {
      Cell& cell = stack[--waiting];
      const int found = changes_of<N>(cell.b);
      if (found < 2 && least_of<N>(cell.b) < noise) return false;
      if (found == 0) continue;
      if (count == most) return false;
      if (found == 1) {
        list[count++] = {of_lane, i, cell.low * reach, cell.high * reach, cell.b[0], cell.b[N - 1]};
        continue;
      }
      if (cell.depth == kDeepest) return false;
      Cell left;
      for (int k = 0; k < N; ++k) {  // de Casteljau: what is left in the cell is the right half
        left.b[k] = cell.b[0];
        for (int j = 0; j + k + 1 < N; ++j) cell.b[j] = 0.5 * (cell.b[j] + cell.b[j + 1]);
      }
      const double middle = 0.5 * (cell.low + cell.high);
      left.low = cell.low, left.high = middle, left.depth = ++cell.depth;
      cell.low = middle;
      ++waiting;
      stack[waiting++] = left;
    }
  }
  return true;
}

// Newton's method kept inside the brackets: the roots as cosine and sine. p: of each root's own polynomial.
template <class F, int D>
void refine(const Series<F, D>& p, F centre_c, F centre_s, F low, F high, F at_low, F at_high, F& c, F& s) {
  const auto negative = at_low < 0.0;
  F u = low + (high - low) * min(max(at_low / (at_low - at_high), F(0.05)), F(0.95));
  auto done = mask_of<F>(false);
  for (int step = 0; step < 40; ++step) {
    const F over = 1.0 / (1.0 + u * u), x = (1.0 - u * u) * over, y = 2.0 * u * over;
    c = centre_c * x - centre_s * y;
    s = centre_s * x + centre_c * y;
    // Horner's scheme in e^{i theta} for the sum of (a - i b) e^{i m theta} and its derivative
    F re = p.a[D], im = -p.b[D], dre = F(double(D)) * p.a[D], dim = F(double(-D)) * p.b[D];
    for (int m = D - 1; m >= 0; --m) {
      F t = re * c - im * s + p.a[m];
      im = re * s + im * c - (m ? p.b[m] : F(0.0));
      re = t;
      if (m == 0) {
        t = dre * c - dim * s;
        dim = dre * s + dim * c;
      } else {
        t = dre * c - dim * s + double(m) * p.a[m];
        dim = dre * s + dim * c - double(m) * p.b[m];
      }
      dre = t;
    }
    const F slope = (0.0 - dim) * 2.0 * over;  // dp/du
    if (all(done)) break;
    const auto below = re < 0.0, left = (below & negative) | !(below | negative);
    low = select(left & !done, u, low);
    high = select(!left & !done, u, high);
    F next = u - re / select(slope == 0.0, F(kTiny), slope);
    const auto inside = (next > low) & (next < high);
    next = select(inside, next, 0.5 * (low + high));
    const auto small = abs(next - u) < kHiddenRootStep;
    u = select(done, u, next);
    done = done | small;
  }
}

}  // namespace pieper::PIEPER_ISA::trigonometric
