// All real roots of trigonometric polynomials of degree D, several at once, isolated with certainty and without eigenvalues.
//
// p(theta) = a0 + sum a_m cos(m theta) + b_m sin(m theta) is a form of degree 2D in (cos, sin) of theta / 2. On a sector that
// form has Bernstein coefficients (of the two edge directions), and the changes of sign among them bound its roots: none
// means no root, one means exactly one, more are parted by de Casteljau's scheme (Descartes' rule in Bernstein's basis;
// Lane and Riesenfeld, 1981). What is still open in a very narrow sector, a pair of roots about to merge or just gone, is
// handed back as not clear. Templates over the number type; only what is decided of each piece goes lane by lane.
#pragma once

#include "lanes/batch.hpp"
#include "tolerances.hpp"

namespace pieper::PIEPER_ISA::trigonometric {

inline constexpr int kSectors = 16;
inline constexpr double kNarrowest = 1.0 / 4096;  // of a sector: about 1e-4 rad
inline constexpr int kOften = 3;        // a piece that was parted too near to a root is parted elsewhere so often,
inline constexpr double kAside = 0.11;  // each time this part of it aside

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

// How the coefficients b[0..N-1] of a piece change sign: at all, and more than once.
template <class F> struct Shape {
  Mask<F> some, more;
  F least, most;  // smallest and largest coefficient, without sign
  F last;         // where the polygon of the coefficients crosses zero last, in steps from one to the next; else a half
};

template <class F, int N> PIEPER_INLINE Shape<F> shape_of(const F (&b)[N]) {
  Shape<F> out;
  out.least = out.most = abs(b[0]);
  out.some = out.more = mask_of<F>(false);
  F before = F(1.0), after = F(-1.0), step = F(0.0);
  Mask<F> below = b[0] < 0.0;
#pragma GCC unroll 32
  for (int k = 1; k < N; ++k) {
    const Mask<F> now = b[k] < 0.0, changed = differ(now, below);
    below = now;
    const F size = abs(b[k]);
    out.least = min(out.least, size);
    out.most = max(out.most, size);
    out.more = out.more | (out.some & changed);
    out.some = out.some | changed;
    before = select(changed, b[k - 1], before);
    after = select(changed, b[k], after);
    step = select(changed, F(k - 1.0), step);
  }
  out.last = step + before / (before - after);
  return out;
}

// Where the polygon crosses zero first, for coefficients that change sign.
template <class F, int N> PIEPER_INLINE F first_crossing(const F (&b)[N]) {
  F before = F(1.0), after = F(-1.0), step = F(0.0);
#pragma GCC unroll 32
  for (int k = N - 1; k > 0; --k) {
    const Mask<F> changed = differ(b[k] < 0.0, b[k - 1] < 0.0);
    before = select(changed, b[k - 1], before);
    after = select(changed, b[k], after);
    step = select(changed, F(k - 1.0), step);
  }
  return step + before / (before - after);
}

// What coefficients no larger than `noise` leave open of a piece whose ends are larger.
enum class Doubt { NONE, SIGNS, END };
template <int N> inline Doubt doubt_of(const double (&b)[N], double noise) {
  const auto small = [&](int k) { return !(abs(b[k]) >= noise); };
  if (small(0) || small(N - 1)) return Doubt::END;
  for (int k = 1; k + 1 < N; ++k)  // between two of different sign it changes sign once whatever its own is
    if (small(k) && (small(k - 1) || small(k + 1) || (b[k - 1] < 0.0) == (b[k + 1] < 0.0))) return Doubt::SIGNS;
  return Doubt::NONE;
}

template <class F, int D> struct Sectors {
  F coefficient[kSectors][2 * D + 1];
  Shape<F> shape[kSectors];
};

template <class F, int D> void sectors_of(const Series<F, D>& p, Sectors<F, D>& out) {
  const SectorBasis<D>& basis = sector_basis<D>();
  const Circle<2 * kSectors>& turn = circle<2 * kSectors>();
  constexpr int across = kSectors / 2;  // to the sector opposite, where odd multiples change sign
  for (int i = 0; i < across; ++i) {
    F a[D + 1], b[D + 1];
    a[0] = p.a[0];
    for (int m = 1; m <= D; ++m) {
      const int at = (2 * i + 1) * m % (2 * kSectors);
      a[m] = p.a[m] * turn.c[at] + p.b[m] * turn.s[at];
      b[m] = p.b[m] * turn.c[at] - p.a[m] * turn.s[at];
    }
    F(&here)[2 * D + 1] = out.coefficient[i];
    F(&there)[2 * D + 1] = out.coefficient[i + across];
    for (int k = 0; k <= D; ++k) {
      F sum[2] = {a[0] * basis.cosine[k][0], a[1] * basis.cosine[k][1]};  // of even and of odd multiples
      F skew[2] = {b[2] * basis.sine[k][2], b[1] * basis.sine[k][1]};
      for (int m = 2; m <= D; ++m) sum[m % 2] += a[m] * basis.cosine[k][m];
      for (int m = 3; m <= D; ++m) skew[m % 2] += b[m] * basis.sine[k][m];
      const F even = sum[0] + sum[1], odd = skew[0] + skew[1];
      here[k] = even + odd;
      here[2 * D - k] = even - odd;
      const F even_there = sum[0] - sum[1], odd_there = skew[0] - skew[1];
      there[k] = even_there + odd_there;
      there[2 * D - k] = even_there - odd_there;
    }
  }
  // one value at a shared edge, so that rounding can not put a root into both sectors or into none
  for (int i = 0; i < kSectors; ++i) out.coefficient[(i + 1) % kSectors][0] = out.coefficient[i][2 * D];
  for (int i = 0; i < kSectors; ++i) out.shape[i] = shape_of(out.coefficient[i]);
}

// Simple roots, each in one lane of the polynomials: e^{i theta} = e^{i centre} (1 + i u)^2 / (1 + u^2) with u between low and high.
// Filled up to whole lanes with what repeats the last.
template <int Most> struct Brackets {
  int lane[Most];
  double centre_c[Most], centre_s[Most], low[Most], high[Most];
  double start[Most];   // where the polygon of Bernstein coefficients crosses zero
  double rising[Most];  // 1 where the polynomial is negative at `low`, else 0

  void copy(int to, int from) {
    lane[to] = lane[from];
    centre_c[to] = centre_c[from], centre_s[to] = centre_s[from];
    low[to] = low[from], high[to] = high[from], start[to] = start[from], rising[to] = rising[from];
  }
};

// A piece of a sector whose coefficients b change sign more than once; from low to high in units of the sector's edge.
template <int N> struct Cell {
  double b[N], low, high;
  double last;  // where the polygon of the coefficients crosses zero last
  double most;  // largest coefficient of the sector, without sign
  int lane, sector;
  int again;  // how often it was parted where the polynomial is not clear of zero
};

// Halfway between the first and the last place where the polygon of the coefficients crosses zero: two roots lie on either side, and
// where there is none the polynomial is nearest to zero about here.
template <int N, class F> PIEPER_INLINE F parting(F first, F last) {
  return min(max(0.5 / (N - 1) * (first + last), F(0.15)), F(0.85));
}

// Isolates the roots of W polynomials: `used` of the lanes are asked for.
template <class F, int D> class Isolation {
 public:
  static constexpr int N = 2 * D + 1, W = width_of<F>, kMost = 2 * D;

  Brackets<W * kMost + PIEPER_LANES> list;
  int count = 0;
  unsigned unclear = 0;  // lanes where a coefficient that decides lies below `noise`, or roots do not part
  double away[W];        // where there is no root a lane's polynomial is no nearer to zero,
  double apart[W];       // nor nearer than this part of its largest coefficient on the same sector

  Isolation(const Sectors<F, D>& sectors, F noise, unsigned wanted, int used)
      : noise_(noise), away_(__builtin_inf()), apart_(1.0) {
    wanted &= (1u << used) - 1u;
    for (int k = 0; k < kSectors; ++k) {
      const Shape<F>& shape = sectors.shape[k];
      const Open open = open_of(shape);
      unclear |= open.lost & wanted;
      const unsigned once = open.once & wanted & ~unclear;
      if (once) {
        double at[W];
        store(at, shape.last);
        const unsigned rising = bits_of(sectors.coefficient[k][0] < 0.0);
        for (unsigned left = once; left; left &= left - 1) {
          const int i = __builtin_ctz(left);
          enter(i, k, -1, 1, at[i], (rising >> i) & 1u);
        }
      }
      const unsigned more = open.more & wanted & ~unclear;
      if (!more) continue;
      double last[W], most[W];
      store(last, shape.last), store(most, shape.most);
      for (unsigned left = more; left; left &= left - 1) {
        const int i = __builtin_ctz(left);
        Cell<N>& cell = stack_[waiting_];
        for (int j = 0; j < N; ++j) cell.b[j] = lane(sectors.coefficient[k][j], i);
        cell.low = -1, cell.high = 1, cell.last = last[i], cell.most = most[i], cell.lane = i, cell.sector = k,
        cell.again = 0;
        // what is parted makes room for two
        if (++waiting_ == kRoom - W) part();
      }
    }
    while (waiting_) part();
    store(away, away_), store(apart, apart_);
    if (unclear) {
      int kept = 0;
      for (int k = 0; k < count; ++k)
        if (!lost(list.lane[k])) list.copy(kept++, k);
      count = kept;
    }
    for (int k = count; count && k % PIEPER_LANES; ++k) list.copy(k, count - 1);
  }

 private:
  static constexpr int kRoom = W * (kSectors + 2);

  bool lost(int i) const { return (unclear >> i) & 1u; }

  struct Open {
    unsigned lost, once, more;  // lanes of a piece that are not clear, and with one or more changes of sign
  };
  Open open_of(const Shape<F>& shape) {
    const auto few = !shape.more, none = !shape.some;
    away_ = select(none, min(away_, shape.least), away_);
    apart_ = select(none & (shape.least < apart_ * shape.most), shape.least / max(shape.most, F(kTiny)), apart_);
    return {bits_of(few & (shape.least < noise_)), bits_of(shape.some & few), bits_of(shape.more)};
  }

  void enter(int i, int sector, double low, double high, double first, bool rising) {
    static const double reach = __builtin_tan(0.78539816339744830962 * 2 / kSectors);  // of u at a sector's edge
    static const Circle<2 * kSectors>& turn = circle<2 * kSectors>();
    if (found_[i]++ == kMost) return void(unclear |= 1u << i);
    list.lane[count] = i;
    list.centre_c[count] = turn.c[2 * sector + 1];
    list.centre_s[count] = turn.s[2 * sector + 1];
    list.low[count] = low * reach;
    list.high[count] = high * reach;
    list.start[count] = reach * (low + (high - low) * first / (N - 1));
    list.rising[count] = rising;
    ++count;
  }

  // Takes up to W pieces off the stack and puts back what is not decided of their halves.
  void part() {
    const int taken = waiting_ < W ? waiting_ : W;
    Cell<N>* const top = stack_ + (waiting_ - taken);
    const Cell<N>* from[W];
    Place place[W];
    unsigned narrow = 0;
    F last, shift(0.0);
    for (int i = 0; i < W; ++i) {
      from[i] = top + (i < taken ? i : 0);
      place[i] = {from[i]->low, from[i]->high, from[i]->most, from[i]->lane, from[i]->sector};
      if (place[i].high - place[i].low < 2 * kNarrowest) narrow |= 1u << i;
      set_lane(last, i, from[i]->last);
      if (from[i]->again) set_lane(shift, i, kAside * from[i]->again);
    }
    constexpr int whole = W > 1 ? N - N % W : 0;
    F b[N], left[N];
    for (int block = 0; block < whole; block += W) {
      for (int i = 0; i < W; ++i) b[block + i] = load<F>(from[i]->b + block);
      transpose(b + block);
    }
    for (int j = whole; j < N; ++j)
      for (int i = 0; i < W; ++i) set_lane(b[j], i, from[i]->b[j]);
    const F middle = parting<N>(first_crossing(b), last), at = select(middle > 0.5, middle - shift, middle + shift);
#pragma GCC unroll 32
    for (int k = 0; k < N; ++k) {  // de Casteljau: what is left in b is the right part
      left[k] = b[0];
      for (int j = 0; j + k + 1 < N; ++j) b[j] = b[j] + at * (b[j + 1] - b[j]);
    }
    waiting_ -= taken;
    unsigned all = (1u << taken) - 1u;
    for (unsigned rest = narrow & all; rest; rest &= rest - 1) unclear |= 1u << place[__builtin_ctz(rest)].lane;
    all &= ~narrow;
    const F noise = lanes_of(noise_, place);
    // parted too near to a root: it must be parted elsewhere
    Cell<N> elsewhere[W];
    int moved = 0;
    for (unsigned rest = bits_of(!(abs(b[0]) >= noise)) & all; rest; rest &= rest - 1) {
      const int i = __builtin_ctz(rest);
      all &= ~(1u << i);
      if (from[i]->again == kOften) unclear |= 1u << place[i].lane;
      else elsewhere[moved] = *from[i], ++elsewhere[moved++].again;
    }
    for (int half = 0; half < 2; ++half) {
      F(&c)[N] = half ? b : left;
      const Shape<F> shape = shape_of(c);
      unsigned more = bits_of(shape.more) & all, once = bits_of(shape.some) & all & ~more, none = all & ~(more | once);
      const unsigned rising = bits_of(c[0] < 0.0), doubtful = bits_of(shape.least < noise) & all & ~more;
      double record[N * W];
      if (more | doubtful) store_records<F, N>(record, c, W);
      for (unsigned rest = doubtful; rest; rest &= rest - 1) {
        const int i = __builtin_ctz(rest);
        const Doubt doubt = doubt_of<N>(*reinterpret_cast<const double (*)[N]>(record + N * i), lane(noise, i));
        if (doubt == Doubt::NONE) continue;
        if (doubt == Doubt::END) unclear |= 1u << place[i].lane;
        else more |= 1u << i;
        once &= ~(1u << i), none &= ~(1u << i);
      }
      double least[W], crossing[W], cut[W];
      store(least, shape.least), store(crossing, shape.last), store(cut, at);
      for (unsigned rest = none; rest; rest &= rest - 1) {
        const int i = __builtin_ctz(rest), of = place[i].lane;
        if (least[i] < lane(away_, of)) set_lane(away_, of, least[i]);
        if (least[i] < lane(apart_, of) * place[i].most) set_lane(apart_, of, least[i] / place[i].most);
      }
      const auto ends = [&](int i, double& low, double& high) {
        const double between = place[i].low + cut[i] * (place[i].high - place[i].low);
        low = half ? between : place[i].low, high = half ? place[i].high : between;
      };
      for (unsigned rest = once; rest; rest &= rest - 1) {
        const int i = __builtin_ctz(rest);
        double low, high;
        ends(i, low, high);
        if (!lost(place[i].lane)) enter(place[i].lane, place[i].sector, low, high, crossing[i], (rising >> i) & 1u);
      }
      for (unsigned rest = more; rest; rest &= rest - 1) {
        const int i = __builtin_ctz(rest);
        if (lost(place[i].lane)) continue;
        Cell<N>& cell = stack_[waiting_++];
        __builtin_memcpy(cell.b, record + N * i, sizeof cell.b);
        ends(i, cell.low, cell.high);
        cell.last = crossing[i], cell.most = place[i].most;
        cell.lane = place[i].lane, cell.sector = place[i].sector, cell.again = 0;
      }
    }
    for (int k = 0; k < moved; ++k)
      if (!lost(elsewhere[k].lane)) stack_[waiting_++] = elsewhere[k];
  }

  struct Place {
    double low, high, most;
    int lane, sector;
  };

  PIEPER_INLINE F lanes_of(F x, const Place (&place)[W]) const {
    F out = x;
    for (int i = 0; i < W; ++i) set_lane(out, i, lane(x, place[i].lane));
    return out;
  }

  const F noise_;
  F away_, apart_;
  int found_[W] = {}, waiting_ = 0;
  Cell<N> stack_[kRoom];
};

}  // namespace pieper::PIEPER_ISA::trigonometric
