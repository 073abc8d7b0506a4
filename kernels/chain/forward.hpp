// Forward kinematics of a chain T(q) = L0 Z(q1) L1 ... Z(qn) Ln: poses, frames and Jacobians, W joint vectors at a time.
// Templates over the number type, used for lanes only.
#pragma once

#include "lanes/batch.hpp"
#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA {

template <class F> PIEPER_INLINE void store_pose(double* out, const RigidT<F>& T, int lanes, long stride) {
  constexpr int W = width_of<F>;
  F value[16];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) value[4 * i + j] = T.r(i, j);
    value[4 * i + 3] = T.p(i);
  }
  value[12] = value[13] = value[14] = F(0.0);
  value[15] = F(1.0);
  if (W > 1 && lanes == W) {
    for (int block = 0; block < 16; block += W) {
      transpose(value + block);
      for (int i = 0; i < W; ++i) store(out + i * stride + block, value[block + i]);
    }
  } else {
    for (int k = 0; k < 16; ++k)
      for (int i = 0; i < lanes; ++i) out[i * stride + k] = lane(value[k], i);
  }
}

// Joint `j` of up to W joint vectors; idle lanes repeat the last one.
template <class F> PIEPER_INLINE F joint_of(const double* q, int n, int j, int lanes) {
  constexpr int W = width_of<F>;
  if constexpr (W == 1) return q[j];
  else {
    F r;
    if (__builtin_expect(lanes == W, 1)) {
      for (int i = 0; i < W; ++i) r.v[i] = q[i * n + j];
    } else {
      for (int i = 0; i < W; ++i) r.v[i] = q[(i < lanes ? i : lanes - 1) * n + j];
    }
    return r;
  }
}

// All joints of W joint vectors, each in its lanes, or false where that is not one load a vector and a transposition: it takes
// half the time of reading joint by joint.
template <class F> PIEPER_INLINE bool joints_of([[maybe_unused]] const double* q, [[maybe_unused]] int n,
                                                [[maybe_unused]] int lanes, [[maybe_unused]] F* joints) {
#if defined(__AVX512F__)
  constexpr int W = width_of<F>;
  if constexpr (W == 8) {
    if (n > W || lanes < W) return false;
    const __mmask8 all = static_cast<__mmask8>((1 << n) - 1);
    for (int i = 0; i < W; ++i) joints[i] = F{_mm512_maskz_loadu_pd(all, q + i * n)};
    transpose(joints);
    return true;
  }
#endif
  return false;
}

// Calls group(type tag, first, lanes) for all poses: whole lanes, then the rest. One alone takes the narrowest lanes: of vectors of
// every width a compiler fuses the same products with sums, of plain numbers others.
template <class Group> PIEPER_INLINE void in_groups(long count, Group group) {
  constexpr int W = PIEPER_LANES;
  if (count == 1) {
    group(Lanes<2>(), 0L, 1);
    return;
  }
  long done = 0;
  for (; done + W <= count; done += W) group(Lanes<W>(), done, W);
  if (done < count) group(Lanes<W>(), done, static_cast<int>(count - done));
}

// links: (n + 1) x 16 row-major, m. visit(k, frame): of joint k before it moves.
template <class F, class Visit> PIEPER_INLINE RigidT<F> chain_end(const double* links, const std::uint8_t* prismatic,
                                                                  int n, const double* q, int lanes, Visit visit) {
  F joints[width_of<F>];
  const bool read = joints_of(q, n, lanes, joints);
  auto motion = [&](int k) {
    const F value = read ? joints[k] : joint_of<F>(q, n, k, lanes);
    return prismatic[k] ? Motion<F>{value, F(0.0)} : turned_by(value);
  };
  return walk(
      n, spread<F>(read_rigid(links, 1)), [&](int k) { return read_rigid(links + 16 * (k + 1), 1); }, motion, prismatic,
      visit);
}

inline void forward_fk(const double* links, const std::uint8_t* prismatic, int n, const double* q, long count,
                       double* out) {
  in_groups(count, [&](auto tag, long first, int lanes) {
    using F = decltype(tag);
    const RigidT<F> end = chain_end<F>(links, prismatic, n, q + first * n, lanes, [](int, const RigidT<F>&) {});
    store_pose(out + 16 * first, end, lanes, 16);
  });
}

inline void forward_frames(const double* links, const std::uint8_t* prismatic, int n, const double* base,
                           const double* after, const double* q, long count, double* out) {
  const long stride = 16L * (n + 2);
  in_groups(count, [&](auto tag, long first, int lanes) {
    using F = decltype(tag);
    double* record = out + stride * first;
    store_pose(record, spread<F>(read_rigid(base, 1)), lanes, stride);
    RigidT<F> T = spread<F>(read_rigid(links, 1));
    for (int i = 0; i < n; ++i) {
      const F value = joint_of<F>(q + first * n, n, i, lanes);
      T = moved(T, prismatic[i] ? Motion<F>{value, F(0.0)} : turned_by(value), prismatic[i]);
      store_pose(record + 16 * (i + 1), T * read_rigid(after + 16 * i, 1), lanes, stride);
      T = T * read_rigid(links + 16 * (i + 1), 1);
    }
    store_pose(record + 16 * (n + 1), T, lanes, stride);
  });
}

inline constexpr int kJacobianJoints = 16;  // arms with more joints take their records from the heap

template <class F> PIEPER_INLINE void jacobian_group(const double* links, const std::uint8_t* prismatic, int n,
                                                     const double* q, int lanes, double* out, F* axes, F* value) {
  const RigidT<F> T = chain_end<F>(links, prismatic, n, q, lanes, [&](int i, const RigidT<F>& frame) {
    for (int k = 0; k < 3; ++k) axes[6 * i + k] = frame.r(k, 2), axes[6 * i + 3 + k] = frame.p(k);
  });
  for (int i = 0; i < n; ++i) {
    const F* z = axes + 6 * i;
    F d[3];
    for (int k = 0; k < 3; ++k) d[k] = T.p(k) - z[3 + k];
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      value[k * n + i] = prismatic[i] ? z[k] : z[a] * d[b] - z[b] * d[a];
      value[(3 + k) * n + i] = prismatic[i] ? F(0.0) : z[k];
    }
  }
  const long size = 6L * n;
  constexpr int W = width_of<F>;
  long k = 0;
  if (W > 1 && lanes == W) {
    for (; k + W <= size; k += W) {
      transpose(value + k);
      for (int i = 0; i < W; ++i) store(out + i * size + k, value[k + i]);
    }
  }
  for (; k < size; ++k)
    for (int i = 0; i < lanes; ++i) out[i * size + k] = lane(value[k], i);
}

inline void forward_jacobian(const double* links, const std::uint8_t* prismatic, int n, const double* q, long count,
                             double* out) {
  using Wide = Lanes<PIEPER_LANES>;
  Wide axes[6 * kJacobianJoints], value[6 * kJacobianJoints];
  Wide *a = axes, *v = value, *heap = nullptr;
  if (n > kJacobianJoints) {
    heap = static_cast<Wide*>(__builtin_malloc(sizeof(Wide) * (12 * n + 1)));
    // malloc aligns to 16 bytes; vectors want their own size
    a = reinterpret_cast<Wide*>((reinterpret_cast<std::uintptr_t>(heap) + sizeof(Wide) - 1) & ~(sizeof(Wide) - 1));
    v = a + 6 * n;
  }
  in_groups(count, [&](auto tag, long first, int lanes) {
    using F = decltype(tag);
    jacobian_group<F>(links, prismatic, n, q + first * n, lanes, out + 6L * n * first, reinterpret_cast<F*>(a),
                      reinterpret_cast<F*>(v));
  });
  if (heap) __builtin_free(heap);
}

}  // namespace pieper::PIEPER_ISA
