// Which row inside the limits lies nearest to a joint vector, whole turns chosen, for blocks of poses.
//
// The distance is sqrt(sum of weight_j (q_j - near_j)^2), angles as they stand: a joint moves by whole turns to the place
// inside its limits that is nearest. The weights hold the units of sliding joints. Where rows tie, the first one counts.
// Lanes over W rows at a time; a scalar twin for the rest.
#pragma once

#include "chain/limits.hpp"
#include "dispatch/isa.hpp"

namespace pieper::PIEPER_ISA {

// A number rounded to an integer, halves to even; where doubles are no finer than integers it stays about what it is, and so do
// infinities.
template <class F> PIEPER_INLINE F nearest_integer(F x) {
  constexpr double to_integer = 6755399441055744.0;  // 1.5 * 2^52
  return (x + to_integer) - to_integer;
}

// q moved by whole turns towards `near`, as far as [low, high] lets it, where q itself lies inside.
template <class F> PIEPER_INLINE F unwound(F q, F near, F low, F high) {
  F turns = nearest_integer((near - q) * (1 / kTwoPi));
  const F x = (low - q) * (1 / kTwoPi), y = (high - q) * (1 / kTwoPi);
  F least = nearest_integer(x), most = nearest_integer(y);
  least = select(least < x, least + 1.0, least);
  most = select(most > y, most - 1.0, most);
  // q is inside: zero turns are always possible, and what rounding says of the stops must not take that away
  turns = min(max(turns, min(least, F(0.0))), max(most, F(0.0)));
  return q + turns * kTwoPi;
}

// What selecting needs of the joints, laid out with the period of W rows. N: how many there are, 0 where that is not known here.
template <int N> class Selector {
 public:
  static constexpr int W = PIEPER_LANES;

  Selector(const Selection& by, int slots)
      : by_(by), slots_(slots), whole_(by.n * W <= kLimitPattern ? slots / W * W : 0) {
    if (!whole_) return;
    for (int k = 0; k < by.n * W; ++k) {
      const int j = k % by.n;
      low_[k] = by.lower[j], high_[k] = by.upper[j], weight_[k] = by.weight[j];
      // a row inside has one place alone in a range of less than a turn
      turn_[k] = turns(j) ? kTwoPi : 0.0;
    }
  }

  // One pose: q slots x n, inside: slots. Returns whether there is a row; `chosen` (n) may be `near` itself.
  bool operator()(const double* q, const std::uint8_t* inside, const double* near, double* chosen) const {
    using V = Lanes<W>;
    const int n = N ? N : by_.n;
    double around[kLimitPattern + W];  // `near` and its beginning again
    double row[kLimitPattern], square[kLimitPattern], nearest[kLimitPattern];
    int best = -1;
    double least = __builtin_inf();
    if (whole_) {
      for (int j = 0; j < n; ++j) around[j] = near[j];
      for (int j = 0; j < W; ++j) around[n + j] = around[j];
    }
    for (int m = 0; m < whole_; m += W) {
      for (int k = 0, turn = 0; k < n; ++k) {
        const int at = k * W;
        const V here = load<V>(q + m * n + at), to = load<V>(around + turn), low = load<V>(low_ + at),
                high = load<V>(high_ + at), period = load<V>(turn_ + at);
        V v = here + nearest_integer((to - here) * (1 / kTwoPi)) * period;
        const Mask<V> beyond = (period > 0.0) & ((v < low) | (v > high));
        if (any(beyond)) v = select(beyond, unwound(here, to, low, high), v);
        const V gap = v - to;
        store(row + at, v);
        store(square + at, gap * gap * load<V>(weight_ + at));
        turn += W;
        while (turn >= n) turn -= n;
      }
      double sum[W];
      constexpr double penalty[] = {__builtin_inf(), 0.0};
      for (int i = 0; i < W; ++i) {
        double even = penalty[inside[m + i]], odd = 0;
        for (int j = 0; j + 1 < n; j += 2) even += square[i * n + j], odd += square[i * n + j + 1];
        if (n % 2) odd += square[i * n + n - 1];
        sum[i] = even + odd;
      }
      double smallest = sum[0];
      for (int i = 1; i < W; ++i) smallest = min(sum[i], smallest);
      if (!(smallest < least)) continue;
      least = smallest;
      const int i = __builtin_ctz(bits_of(load<V>(sum) == smallest));
      best = m + i;
      for (int j = 0; j < n; ++j) nearest[j] = row[i * n + j];
    }
    // what does not fill the lanes, or is so far away that squares overflow
    for (int m = best < 0 ? 0 : whole_; m < slots_; ++m) {
      if (!inside[m]) continue;
      double sum = 0;
      for (int j = 0; j < n; ++j) {
        const double gap = place(q[m * n + j], near[j], j) - near[j];
        sum += by_.weight[j] * (gap * gap);
      }
      if (best < 0 || sum < least) best = m, least = sum;
    }
    if (best < 0) return false;
    if (best < whole_ && least < __builtin_inf())
      for (int j = 0; j < n; ++j) chosen[j] = nearest[j];
    else
      for (int j = 0; j < n; ++j) chosen[j] = place(q[best * n + j], near[j], j);
    return true;
  }

 private:
  PIEPER_INLINE bool turns(int j) const { return !by_.prismatic[j] && by_.upper[j] - by_.lower[j] >= kTwoPi; }
  PIEPER_INLINE double place(double v, double near, int j) const {
    return turns(j) ? unwound(v, near, by_.lower[j], by_.upper[j]) : v;
  }

  const Selection& by_;
  int slots_, whole_;  // whole_: slots that fill the lanes
  double low_[kLimitPattern], high_[kLimitPattern], weight_[kLimitPattern], turn_[kLimitPattern];
};

// Calls work(selector) with one that knows the number of joints, where that is a usual one.
template <class Work> PIEPER_INLINE void with_selector(const Selection& by, int slots, Work work) {
  switch (by.n) {
    case 6:
      return work(Selector<6>(by, slots));
    case 7:
      return work(Selector<7>(by, slots));
    default:
      return work(Selector<0>(by, slots));
  }
}

// Each pose for itself, nearest to near + i * stride; zeros where there is no row.
inline void choose(const Selection& by, const double* q, const std::uint8_t* inside, long count, int slots,
                   const double* near, int stride, double* chosen, std::uint8_t* has) {
  const long n = by.n, record = n * slots;
  with_selector(by, slots, [&](const auto& select_row) {
    for (long i = 0; i < count; ++i) {
      has[i] = select_row(q + i * record, inside + i * slots, near + i * stride, chosen + i * n);
      if (!has[i])
        for (int j = 0; j < n; ++j) chosen[i * n + j] = 0.0;
    }
  });
}

// Each pose nearest to what was chosen for the one before it; `now` (n) is where that is, if `started`, and is kept up to
// date. Until then the first row inside counts. A pose without a row keeps the joint vector before it, or zeros.
inline void choose_in_turn(const Selection& by, const double* q, const std::uint8_t* inside, long count, int slots,
                           double* now, bool* started, double* chosen, std::uint8_t* has) {
  const long n = by.n, record = n * slots;
  with_selector(by, slots, [&](const auto& select_row) {
    for (long i = 0; i < count; ++i) {
      const std::uint8_t* in = inside + i * slots;
      const double* rows = q + i * record;
      has[i] = 0;
      if (*started) {
        has[i] = select_row(rows, in, now, now);
      } else {
        for (int m = 0; m < slots && !has[i]; ++m)
          if (in[m]) {
            for (int j = 0; j < n; ++j) now[j] = rows[m * n + j];
            has[i] = *started = true;
          }
      }
      for (int j = 0; j < n; ++j) chosen[i * n + j] = now[j];
    }
  });
}

}  // namespace pieper::PIEPER_ISA
