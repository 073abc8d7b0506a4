// All real roots of trigonometric polynomials of degree D, several at once, isolated with certainty and without eigenvalues.
//
// p(theta) = a0 + sum a_m cos(m theta) + b_m sin(m theta) is a form of degree 2D in (cos, sin) of theta / 2. On a sector that
// form has Bernstein coefficients (of the two edge directions), and the changes of sign among them bound its roots: none
// means no root, one means exactly one, more are parted by de Casteljau's scheme (Descartes' rule in Bernstein's basis;
// Lane and Riesenfeld, 1981). What is still open in a very narrow sector, a pair of roots about to merge or just gone, is
// handed back as not clear. Templates over the number type; only what is decided of each piece goes lane by lane.
#pragma once

#include "lanes/lanes.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA::trigonometric {

inline constexpr int kSectors = 16;
inline constexpr double kNarrowest = 1.0 / 4096;  // of a sector: about 1e-4 rad

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

template <class F, int N> PIEPER_INLINE F smallest(const F (&b)[N]) {
  F least = abs(b[0]);
  for (int k = 1; k < N; ++k) least = min(least, abs(b[k]));
  return least;
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
    out.least[i] = smallest(out.coefficient[i]);
  }
}

// One simple root, in one lane of the polynomials: e^{i theta} = e^{i centre} (1 + i u)^2 / (1 + u^2) with u between low and high.
struct Bracket {
  int lane, sector;
  double low, high, start;  // start: where the polygon of Bernstein coefficients crosses zero
  bool rising;              // whether the polynomial is negative at `low`
};

// The same for one whose coefficients b change sign once between low and high.
template <int N> inline Bracket bracket_of(int of_lane, int sector, const double* b, double low, double high) {
  const bool rising = b[0] < 0;
  int k = 1;
  while (k < N - 1 && (b[k] < 0) == rising) ++k;
  const double at = k - 1 + b[k - 1] / (b[k - 1] - b[k]);
  return {of_lane, sector, low, high, low + (high - low) * at / (N - 1), rising};
}

// A piece of a sector whose coefficients b change sign more than once; from low to high in units of the sector's edge.
template <int N> struct Cell {
  double b[N], low, high;
  double part;  // where to part it, between 0 and 1
  int lane, sector;
};

// Halfway between the first and the last place where the polygon of the coefficients crosses zero: two roots lie on either side, and
// where there is none the polynomial is nearest to zero about here.
template <int N> inline double parting(const double* b) {
  int first = 1, last = N - 1;
  while ((b[first] < 0) == (b[0] < 0)) ++first;
  while ((b[last - 1] < 0) == (b[N - 1] < 0)) --last;
  const auto crossing = [&](int k) { return k - 1 + b[k - 1] / (b[k - 1] - b[k]); };
  const double at = 0.5 / (N - 1) * (crossing(first) + crossing(last));
  return at < 0.15 ? 0.15 : at > 0.85 ? 0.85 : at;
}

// Isolates the roots of W polynomials: `used` of the lanes are asked for.
template <class F, int D> class Isolation {
 public:
  static constexpr int N = 2 * D + 1, W = width_of<F>, kMost = 2 * D;

  Bracket list[W * kMost];
  int count = 0;
  unsigned unclear = 0;  // lanes where a coefficient that decides lies below `noise`, or roots do not part
  double away[W];        // where there is no root a lane's polynomial is no nearer to zero

  Isolation(const Sectors<F, D>& sectors, F noise, unsigned wanted, int used) : noise_(noise) {
    int begun = 0;
    for (int i = 0; i < used; ++i) {
      away[i] = __builtin_inf();
      if (!((wanted >> i) & 1u)) continue;
      for (int k = 0; k < kSectors && !lost(i); ++k) {
        const int changes = static_cast<int>(lane(sectors.changes[k], i));
        if (decided(i, changes, lane(sectors.least[k], i))) continue;
        Cell<N>& cell = stack_[waiting_];
        for (int j = 0; j < N; ++j) cell.b[j] = lane(sectors.coefficient[k][j], i);
        if (changes == 1) {
          enter(i, k, cell.b, -1, 1);
          continue;
        }
        cell.low = -1, cell.high = 1, cell.part = parting<N>(cell.b), cell.lane = i, cell.sector = k;
        // what is parted makes room for two
        if (++waiting_ == kRoom - W) part();
      }
    }
    while (waiting_) part();
    int kept = 0;
    for (int k = begun; k < count; ++k)
      if (!lost(list[k].lane)) list[kept++] = list[k];
    count = kept;
  }

 private:
  static constexpr int kRoom = W * (kSectors + 2);

  bool lost(int i) const { return (unclear >> i) & 1u; }

  // Whether nothing is left to do where coefficients change sign so often, the smallest of them being `least`.
  bool decided(int i, int changes, double least) {
    if (changes < 2 && least < lane(noise_, i)) unclear |= 1u << i;
    else if (changes == 0) away[i] = least < away[i] ? least : away[i];
    else return false;
    return true;
  }

  void enter(int i, int sector, const double* b, double low, double high) {
    static const double reach = __builtin_tan(0.78539816339744830962 * 2 / kSectors);  // of u at a sector's edge
    if (found_[i]++ == kMost) unclear |= 1u << i;
    else list[count++] = bracket_of<N>(i, sector, b, low * reach, high * reach);
  }

  // Takes up to W pieces off the stack and puts back what is not decided of their halves.
  void part() {
    const int taken = waiting_ < W ? waiting_ : W;
    Cell<N>* const top = stack_ + (waiting_ - taken);
    double halves[2][N][W];
    const Cell<N>* from[W];
    Place place[W];
    for (int i = 0; i < W; ++i) {
      from[i] = top + (i < taken ? i : 0);
      place[i] = {from[i]->low, from[i]->high, from[i]->part, from[i]->lane, from[i]->sector};
    }
    F b[N], left[N], at;
    for (int i = 0; i < W; ++i) set_lane(at, i, place[i].part);
    for (int j = 0; j < N; ++j) {
      F row;
      for (int i = 0; i < W; ++i) set_lane(row, i, from[i]->b[j]);
      b[j] = row;
    }
    for (int k = 0; k < N; ++k) {  // de Casteljau: what is left in b is the right part
      left[k] = b[0];
      for (int j = 0; j + k + 1 < N; ++j) b[j] = b[j] + at * (b[j + 1] - b[j]);
    }
    F changes[2] = {sign_changes(left), sign_changes(b)}, least[2] = {smallest(left), smallest(b)};
    for (int j = 0; j < N; ++j) store(halves[0][j], left[j]), store(halves[1][j], b[j]);
    waiting_ -= taken;
    for (int i = 0; i < taken; ++i) {
      const Place& of = place[i];
      if (lost(of.lane)) continue;
      if (of.high - of.low < 2 * kNarrowest) {
        unclear |= 1u << of.lane;
        continue;
      }
      const double middle = of.low + of.part * (of.high - of.low);
      for (int half = 0; half < 2 && !lost(of.lane); ++half) {
        const int signs = static_cast<int>(lane(changes[half], i));
        if (decided(of.lane, signs, lane(least[half], i))) continue;
        Cell<N>& cell = stack_[waiting_];
        for (int j = 0; j < N; ++j) cell.b[j] = halves[half][j][i];
        cell.low = half ? middle : of.low, cell.high = half ? of.high : middle;
        cell.lane = of.lane, cell.sector = of.sector;
        if (signs == 1) {
          enter(of.lane, of.sector, cell.b, cell.low, cell.high);
          continue;
        }
        cell.part = parting<N>(cell.b);
        ++waiting_;
      }
    }
  }

  struct Place {
    double low, high, part;
    int lane, sector;
  };

  const F noise_;
  int found_[W] = {}, waiting_ = 0;
  Cell<N> stack_[kRoom];
};

// Newton's method kept inside the brackets: the roots as cosine and sine. p: of each root's own polynomial.
template <class F, int D>
void refine(const Series<F, D>& p, F centre_c, F centre_s, F low, F high, F u, Mask<F> rising, F& c, F& s) {
  auto done = mask_of<F>(false);
  for (int step = 0; step < 40; ++step) {
    const F over = 1.0 / (1.0 + u * u), x = (1.0 - u * u) * over, y = 2.0 * u * over;
    c = centre_c * x - centre_s * y;
    s = centre_s * x + centre_c * y;
    if (all(done)) break;
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
    const auto below = re < 0.0, left = (below & rising) | !(below | rising);
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
