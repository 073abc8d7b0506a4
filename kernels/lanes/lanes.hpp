// The number types of the kernels: `double` (one pose) and `Lanes<W>` (W poses side by side in one vector register).
//
// A kernel is written once as a template over the number type F and uses only what this file offers for both:
// + - * /, comparisons that give a Mask<F>, & | !, select, sqrt, abs, min, max, any, all. Plain doubles mix in freely.
// There is no branch on a value anywhere in a kernel unless it asks `any(...)` first.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#ifndef PIEPER_ISA
#error "compile kernels/dispatch/*.cpp with -DPIEPER_ISA=<namespace> -DPIEPER_LANES=<width>; see CMakeLists.txt"
#endif

#define PIEPER_INLINE inline __attribute__((always_inline))

// Everything below lives in a namespace of its own per instruction set: two builds of the same inline function
// must never be merged by the linker, or an old processor could be handed AVX-512 code.
namespace pieper::PIEPER_ISA {

template <int W> struct LaneTypes {
  typedef double Values __attribute__((vector_size(8 * W)));
  typedef std::int64_t Bits __attribute__((vector_size(8 * W)));
  typedef double Unaligned __attribute__((vector_size(8 * W), aligned(8), may_alias));
};

template <int W> struct LaneMask {
  typename LaneTypes<W>::Bits bits;  // all ones or all zeros per lane
};
#if defined(__AVX512DQ__)
template <> struct LaneMask<8> {
  __mmask8 bits;  // one bit per lane, in a mask register
};
#endif

template <int W> struct Lanes {
  using Values = typename LaneTypes<W>::Values;
  using Bits = typename LaneTypes<W>::Bits;
  Values v;

  Lanes() = default;
  PIEPER_INLINE Lanes(Values values) : v(values) {}
  PIEPER_INLINE Lanes(double x) {
#if defined(__AVX512F__)
    if constexpr (W == 8) v = (Values)_mm512_set1_pd(x);
    else
#endif
#if defined(__AVX__)
        if constexpr (W == 4)
      v = (Values)_mm256_set1_pd(x);
    else
#endif
#if defined(__SSE2__)
        if constexpr (W == 2)
      v = (Values)_mm_set1_pd(x);
    else
#endif
      for (int i = 0; i < W; ++i) v[i] = x;
  }
};

// ---- what depends on the type alone -------------------------------------------------------------------------------
template <class F> struct NumberTraits;
template <> struct NumberTraits<double> {
  static constexpr int width = 1;
  using Mask = bool;
};
template <int W> struct NumberTraits<Lanes<W>> {
  static constexpr int width = W;
  using Mask = LaneMask<W>;
};
template <class F> inline constexpr int width_of = NumberTraits<F>::width;
template <class F> using Mask = typename NumberTraits<F>::Mask;

// ---- arithmetic ---------------------------------------------------------------------------------------------------
#define PIEPER_BINARY(op)                                                                                    \
  template <int W> PIEPER_INLINE Lanes<W> operator op(Lanes<W> a, Lanes<W> b) { return a.v op b.v; }         \
  template <int W> PIEPER_INLINE Lanes<W> operator op(Lanes<W> a, double b) { return a.v op Lanes<W>(b).v; } \
  template <int W> PIEPER_INLINE Lanes<W> operator op(double a, Lanes<W> b) { return Lanes<W>(a).v op b.v; } \
  template <int W> PIEPER_INLINE Lanes<W>& operator op## = (Lanes<W> & a, Lanes<W> b) {                      \
    a.v = a.v op b.v;                                                                                        \
    return a;                                                                                                \
  }                                                                                                          \
  template <int W> PIEPER_INLINE Lanes<W>& operator op## = (Lanes<W> & a, double b) {                        \
    a.v = a.v op Lanes<W>(b).v;                                                                              \
    return a;                                                                                                \
  }
PIEPER_BINARY(+)
PIEPER_BINARY(-)
PIEPER_BINARY(*)
PIEPER_BINARY(/)
#undef PIEPER_BINARY
template <int W> PIEPER_INLINE Lanes<W> operator-(Lanes<W> a) { return -a.v; }

#if defined(__AVX512DQ__)
#define PIEPER_COMPARE_512(code)                                                       \
  if constexpr (W == 8) return {_mm512_cmp_pd_mask((__m512d)a.v, (__m512d)b.v, code)}; \
  else
#else
#define PIEPER_COMPARE_512(code)
#endif
#define PIEPER_COMPARE(op, code)                                                                            \
  template <int W> PIEPER_INLINE LaneMask<W> operator op(Lanes<W> a, Lanes<W> b) {                          \
    PIEPER_COMPARE_512(code)                                                                                \
    return {(typename LaneTypes<W>::Bits)(a.v op b.v)};                                                     \
  }                                                                                                         \
  template <int W> PIEPER_INLINE LaneMask<W> operator op(Lanes<W> a, double b) { return a op Lanes<W>(b); } \
  template <int W> PIEPER_INLINE LaneMask<W> operator op(double a, Lanes<W> b) { return Lanes<W>(a) op b; }
PIEPER_COMPARE(<, _CMP_LT_OQ)
PIEPER_COMPARE(<=, _CMP_LE_OQ)
PIEPER_COMPARE(>, _CMP_GT_OQ)
PIEPER_COMPARE(>=, _CMP_GE_OQ)
PIEPER_COMPARE(==, _CMP_EQ_OQ)
PIEPER_COMPARE(!=, _CMP_NEQ_UQ)
#undef PIEPER_COMPARE
#undef PIEPER_COMPARE_512

template <int W> PIEPER_INLINE LaneMask<W> operator&(LaneMask<W> a, LaneMask<W> b) {
  return {static_cast<decltype(a.bits)>(a.bits & b.bits)};
}
template <int W> PIEPER_INLINE LaneMask<W> operator|(LaneMask<W> a, LaneMask<W> b) {
  return {static_cast<decltype(a.bits)>(a.bits | b.bits)};
}
PIEPER_INLINE bool differ(bool a, bool b) { return a != b; }
template <int W> PIEPER_INLINE LaneMask<W> differ(LaneMask<W> a, LaneMask<W> b) {
  return {static_cast<decltype(a.bits)>(a.bits ^ b.bits)};
}
template <int W> PIEPER_INLINE LaneMask<W> operator!(LaneMask<W> a) { return {static_cast<decltype(a.bits)>(~a.bits)}; }

// ---- select, any, all ---------------------------------------------------------------------------------------------
PIEPER_INLINE double select(bool m, double a, double b) { return m ? a : b; }
template <int W> PIEPER_INLINE Lanes<W> select(LaneMask<W> m, Lanes<W> a, Lanes<W> b) {
#if defined(__AVX512DQ__)
  if constexpr (W == 8) return (typename LaneTypes<W>::Values)_mm512_mask_blend_pd(m.bits, (__m512d)b.v, (__m512d)a.v);
  else
#endif
    return m.bits ? a.v : b.v;
}
template <int W> PIEPER_INLINE Lanes<W> select(LaneMask<W> m, Lanes<W> a, double b) {
  return select(m, a, Lanes<W>(b));
}
template <int W> PIEPER_INLINE Lanes<W> select(LaneMask<W> m, double a, Lanes<W> b) {
  return select(m, Lanes<W>(a), b);
}
template <int W> PIEPER_INLINE Lanes<W> select(LaneMask<W> m, double a, double b) {
  return select(m, Lanes<W>(a), Lanes<W>(b));
}

// One bit per lane, lane 0 lowest.
PIEPER_INLINE unsigned bits_of(bool m) { return m ? 1u : 0u; }
template <int W> PIEPER_INLINE unsigned bits_of(LaneMask<W> m) {
#if defined(__AVX512DQ__)
  if constexpr (W == 8) return m.bits;
  else
#endif
#if defined(__AVX__)
      if constexpr (W == 4)
    return static_cast<unsigned>(_mm256_movemask_pd((__m256d)m.bits));
  else
#endif
#if defined(__SSE2__)
      if constexpr (W == 2)
    return static_cast<unsigned>(_mm_movemask_pd((__m128d)m.bits));
  else
#endif
  {
    unsigned bits = 0;
    for (int i = 0; i < W; ++i) bits |= (m.bits[i] ? 1u : 0u) << i;
    return bits;
  }
}
// The mask of such bits.
template <class F> PIEPER_INLINE Mask<F> mask_of_bits(unsigned bits) {
  if constexpr (width_of<F> == 1) return bits & 1u;
#if defined(__AVX512DQ__)
  else if constexpr (width_of<F> == 8) return {static_cast<__mmask8>(bits)};
#endif
  else {
    typename F::Bits place;
    for (int i = 0; i < width_of<F>; ++i) place[i] = 1ll << i;
    return {((typename F::Bits{} + static_cast<std::int64_t>(bits)) & place) == place};
  }
}

PIEPER_INLINE bool any(bool m) { return m; }
PIEPER_INLINE bool all(bool m) { return m; }
template <int W> PIEPER_INLINE bool any(LaneMask<W> m) { return bits_of(m) != 0; }
template <int W> PIEPER_INLINE bool all(LaneMask<W> m) { return bits_of(m) == (1u << W) - 1; }

template <class F> PIEPER_INLINE Mask<F> mask_of(bool value) {
  if constexpr (width_of<F> == 1) return value;
  else return F(0.0) == F(value ? 0.0 : 1.0);
}

// ---- abs, sqrt, min, max ------------------------------------------------------------------------------------------
PIEPER_INLINE double abs(double x) { return __builtin_fabs(x); }
PIEPER_INLINE double sqrt(double x) { return __builtin_sqrt(x); }
template <int W> PIEPER_INLINE Lanes<W> abs(Lanes<W> x) {
  using B = typename LaneTypes<W>::Bits;
  B keep;
  for (int i = 0; i < W; ++i) keep[i] = INT64_MAX;
  return (typename LaneTypes<W>::Values)((B)x.v & keep);
}
template <int W> PIEPER_INLINE Lanes<W> sqrt(Lanes<W> x) {
#if defined(__AVX512F__)
  if constexpr (W == 8) return (typename LaneTypes<W>::Values)_mm512_sqrt_pd((__m512d)x.v);
#endif
#if defined(__AVX__)
  if constexpr (W == 4) return (typename LaneTypes<W>::Values)_mm256_sqrt_pd((__m256d)x.v);
#endif
#if defined(__SSE2__)
  if constexpr (W == 2) return (typename LaneTypes<W>::Values)_mm_sqrt_pd((__m128d)x.v);
#endif
  Lanes<W> r;
  for (int i = 0; i < W; ++i) r.v[i] = __builtin_sqrt(x.v[i]);
  return r;
}
// The second argument when one is NaN, as the processor does it.
PIEPER_INLINE double max(double a, double b) { return a > b ? a : b; }
PIEPER_INLINE double min(double a, double b) { return a < b ? a : b; }
#if defined(__AVX512F__)
#define PIEPER_IF_512(name) \
  if constexpr (W == 8) return (typename LaneTypes<W>::Values)_mm512_##name##_pd((__m512d)a.v, (__m512d)b.v);
#else
#define PIEPER_IF_512(name)
#endif
#if defined(__AVX__)
#define PIEPER_IF_256(name) \
  if constexpr (W == 4) return (typename LaneTypes<W>::Values)_mm256_##name##_pd((__m256d)a.v, (__m256d)b.v);
#else
#define PIEPER_IF_256(name)
#endif
#define PIEPER_EXTREME(name, op)                                         \
  template <int W> PIEPER_INLINE Lanes<W> name(Lanes<W> a, Lanes<W> b) { \
    PIEPER_IF_512(name)                                                  \
    PIEPER_IF_256(name)                                                  \
    return select(a op b, a, b);                                         \
  }
PIEPER_EXTREME(max, >)
PIEPER_EXTREME(min, <)
#undef PIEPER_EXTREME
#undef PIEPER_IF_256
#undef PIEPER_IF_512

// ---- the bits of a number, for signs ------------------------------------------------------------------------------
template <class F> struct BitsOf {
  using type = std::int64_t;
};
template <int W> struct BitsOf<Lanes<W>> {
  using type = typename LaneTypes<W>::Bits;
};
template <class F> using Bits = typename BitsOf<F>::type;

PIEPER_INLINE std::int64_t bits_in(double x) { return __builtin_bit_cast(std::int64_t, x); }
PIEPER_INLINE double from_bits(std::int64_t b) { return __builtin_bit_cast(double, b); }
template <int W> PIEPER_INLINE typename LaneTypes<W>::Bits bits_in(Lanes<W> x) {
  return (typename LaneTypes<W>::Bits)x.v;
}

// `word` where the mask is set, else 0.
PIEPER_INLINE std::int64_t word_where(bool m, std::int64_t word) { return m ? word : 0; }
template <int W> PIEPER_INLINE typename LaneTypes<W>::Bits word_where(LaneMask<W> m, std::int64_t word) {
#if defined(__AVX512DQ__)
  if constexpr (W == 8) return (typename LaneTypes<W>::Bits)_mm512_maskz_set1_epi64(m.bits, word);
  else
#endif
    return m.bits & word;
}
PIEPER_INLINE std::int64_t word_of_lane(std::int64_t b, int) { return b; }
template <class B> PIEPER_INLINE std::int64_t word_of_lane(B b, int i) { return b[i]; }

// x with its sign turned where bit 1 (worth 2) of `quadrant` is set.
PIEPER_INLINE double turned(double x, std::int64_t quadrant) { return from_bits(bits_in(x) ^ ((quadrant & 2) << 62)); }
template <int W> PIEPER_INLINE Lanes<W> turned(Lanes<W> x, typename LaneTypes<W>::Bits quadrant) {
  return (typename LaneTypes<W>::Values)(bits_in(x) ^ ((quadrant & 2) << 62));
}
// x, which is not negative, with the sign of y.
PIEPER_INLINE double with_sign_of(double x, double y) { return from_bits(bits_in(x) | (bits_in(y) & INT64_MIN)); }
template <int W> PIEPER_INLINE Lanes<W> with_sign_of(Lanes<W> x, Lanes<W> y) {
  return (typename LaneTypes<W>::Values)(bits_in(x) | (bits_in(y) & INT64_MIN));
}
// Where bit 0 of `quadrant` is set.
template <class F> PIEPER_INLINE Mask<F> is_odd(Bits<F> quadrant) {
  if constexpr (width_of<F> == 1) return quadrant & 1;
#if defined(__AVX512DQ__)
  else if constexpr (width_of<F> == 8) return {_mm512_test_epi64_mask((__m512i)quadrant, _mm512_set1_epi64(1))};
#endif
  else return {-(quadrant & 1)};
}

// ---- memory -------------------------------------------------------------------------------------------------------
template <class F> PIEPER_INLINE F load(const double* p) {
  if constexpr (width_of<F> == 1) return *p;
  else return F((typename F::Values) * reinterpret_cast<const typename LaneTypes<width_of<F>>::Unaligned*>(p));
}
PIEPER_INLINE void store(double* p, double x) { *p = x; }
template <int W> PIEPER_INLINE void store(double* p, Lanes<W> x) {
  *reinterpret_cast<typename LaneTypes<W>::Unaligned*>(p) = x.v;
}
PIEPER_INLINE double lane(double x, int) { return x; }
template <int W> PIEPER_INLINE double lane(Lanes<W> x, int i) { return x.v[i]; }
PIEPER_INLINE void set_lane(double& x, int, double value) { x = value; }
template <int W> PIEPER_INLINE void set_lane(Lanes<W>& x, int i, double value) { x.v[i] = value; }

// Lane i of the result is lane from[i] of what it is given.
template <int W> struct LanePicker {
  typename LaneTypes<W>::Bits place;

  explicit LanePicker(const int* from) {
    for (int i = 0; i < W; ++i) {
#if defined(__AVX2__)
      // AVX2 moves halves of doubles about: 2 from[i] and the one behind it
      if constexpr (W == 4) {
        place[i] = 2ll * from[i] | (2ll * from[i] + 1) << 32;
        continue;
      }
#endif
      place[i] = from[i];
    }
  }
  PIEPER_INLINE Lanes<W> operator()(Lanes<W> x) const {
    using V = typename LaneTypes<W>::Values;
#if defined(__AVX512F__)
    if constexpr (W == 8) return (V)_mm512_permutexvar_pd((__m512i)place, (__m512d)x.v);
#endif
#if defined(__AVX2__)
    if constexpr (W == 4) return (V)_mm256_permutevar8x32_ps((__m256)x.v, (__m256i)place);
#endif
    V out = {};  // every lane is written below, which not every compiler sees
    for (int i = 0; i < W; ++i) out[i] = x.v[place[i]];
    return out;
  }
};

// Transpose a W x W block held in W registers: afterwards r[i] lane j is what r[j] lane i was.
PIEPER_INLINE void transpose(double*) {}
template <int W> PIEPER_INLINE void transpose(Lanes<W>* r) {
  using V = typename LaneTypes<W>::Values;
  if constexpr (W == 2) {
    V a = r[0].v, b = r[1].v;
    r[0].v = __builtin_shufflevector(a, b, 0, 2);
    r[1].v = __builtin_shufflevector(a, b, 1, 3);
  } else if constexpr (W == 4) {
    V a = __builtin_shufflevector(r[0].v, r[1].v, 0, 4, 2, 6), b = __builtin_shufflevector(r[0].v, r[1].v, 1, 5, 3, 7);
    V c = __builtin_shufflevector(r[2].v, r[3].v, 0, 4, 2, 6), d = __builtin_shufflevector(r[2].v, r[3].v, 1, 5, 3, 7);
    r[0].v = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    r[1].v = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    r[2].v = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    r[3].v = __builtin_shufflevector(b, d, 2, 3, 6, 7);
  } else {
    static_assert(W == 8);
    V even[4], odd[4];  // pairs of rows interleaved: the even and the odd columns
    for (int i = 0; i < 4; ++i) {
      even[i] = __builtin_shufflevector(r[2 * i].v, r[2 * i + 1].v, 0, 8, 2, 10, 4, 12, 6, 14);
      odd[i] = __builtin_shufflevector(r[2 * i].v, r[2 * i + 1].v, 1, 9, 3, 11, 5, 13, 7, 15);
    }
    V low[4], high[4];  // four rows each: columns c and c + 4, for c = 0..3
    for (int h = 0; h < 2; ++h) {
      V* out = h ? high : low;
      V a = even[2 * h], b = even[2 * h + 1], c = odd[2 * h], d = odd[2 * h + 1];
      out[0] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
      out[1] = __builtin_shufflevector(c, d, 0, 1, 8, 9, 4, 5, 12, 13);
      out[2] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
      out[3] = __builtin_shufflevector(c, d, 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (int c = 0; c < 4; ++c) {
      r[c].v = __builtin_shufflevector(low[c], high[c], 0, 1, 2, 3, 8, 9, 10, 11);
      r[c + 4].v = __builtin_shufflevector(low[c], high[c], 4, 5, 6, 7, 12, 13, 14, 15);
    }
  }
}

}  // namespace pieper::PIEPER_ISA
