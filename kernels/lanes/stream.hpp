// Numbers copied past the cache, for answers that are larger than it: no line is read before it is written.
#pragma once

#include "lanes/lanes.hpp"

namespace pieper::PIEPER_ISA {

#if defined(__SSE2__)
// `to` is aligned to the size of the lanes.
template <int W> PIEPER_INLINE void store_past_cache(double* to, Lanes<W> x) {
#if defined(__AVX512F__)
  if constexpr (W == 8) return _mm512_stream_pd(to, (__m512d)x.v);
#endif
#if defined(__AVX__)
  if constexpr (W == 4) return _mm256_stream_pd(to, (__m256d)x.v);
#endif
  if constexpr (W == 2) _mm_stream_pd(to, (__m128d)x.v);
}
#endif

// To be called once all is copied, before others are told of it.
inline void past_cache_done() {
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

inline void put_past_cache(double* to, const double* from, long count) {
#if defined(__SSE2__)
  constexpr int W = PIEPER_LANES;
  constexpr std::uintptr_t size = 8 * W;
  long k = 0;
  const auto one = [&](long i) {
    _mm_stream_si64(reinterpret_cast<long long*>(to + i), __builtin_bit_cast(long long, from[i]));
  };
  for (; k < count && reinterpret_cast<std::uintptr_t>(to + k) % size != 0; ++k) one(k);
  for (; k + W <= count; k += W) store_past_cache(to + k, load<Lanes<W>>(from + k));
  for (; k < count; ++k) one(k);
#else
  __builtin_memcpy(to, from, sizeof(double) * count);
#endif
}

inline void copy_past_cache(double* to, const double* from, long count) {
  put_past_cache(to, from, count);
  past_cache_done();
}

}  // namespace pieper::PIEPER_ISA
