// Forward kinematics of a chain T(q) = L0 Z(q1) L1 ... Z(qn) Ln: poses, frames and Jacobians, W joint vectors at a time.
#pragma once

#include "lanes/batch.hpp"
#include "lanes/math.hpp"

namespace pieper::PIEPER_ISA {

// T <- constant 4x4 (row-major).
template <class F> PIEPER_INLINE void set_constant(Pose<F>& T, const double* link) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) T.r[i][j] = F(link[4 * i + j]);
    T.p[i] = F(link[4 * i + 3]);
  }
}

// The product of a pose and a constant 4x4.
template <class F> PIEPER_INLINE Pose<F> times_constant(const Pose<F>& T, const double* link) {
  Pose<F> out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.r[i][j] = T.r[i][0] * link[j] + (T.r[i][1] * link[4 + j] + T.r[i][2] * link[8 + j]);
    out.p[i] = T.p[i] + (T.r[i][0] * link[3] + (T.r[i][1] * link[7] + T.r[i][2] * link[11]));
  }
  return out;
}

// T <- T Z(q): a turn about, or a slide along, the local z.
template <class F> PIEPER_INLINE void turn(Pose<F>& T, F s, F c) {
  for (int i = 0; i < 3; ++i) {
    F x = T.r[i][0], y = T.r[i][1];
    T.r[i][0] = x * c + y * s;
    T.r[i][1] = y * c - x * s;
  }
}
template <class F> PIEPER_INLINE void slide(Pose<F>& T, F d) {
  for (int i = 0; i < 3; ++i) T.p[i] += T.r[i][2] * d;
}
template <class F> PIEPER_INLINE void move(Pose<F>& T, F q, bool prismatic) {
  if (prismatic) slide(T, q);
  else {
    F s, c;
    sincos(q, s, c);
    turn(T, s, c);
  }
}

// The pose of a chain; for families that verify by the chain itself. links: (n + 1) x 16.
template <class F>
PIEPER_INLINE Pose<F> chain_pose(const double* links, const std::uint8_t* prismatic, int n, const F* q) {
  Pose<F> T;
  set_constant(T, links);
  for (int i = 0; i < n; ++i) {
    move(T, q[i], prismatic[i]);
    T = times_constant(T, links + 16 * (i + 1));
  }
  return T;
}

// Largest difference of rotation entries, and of positions (m), between two poses.
template <class F> PIEPER_INLINE void pose_difference(const Pose<F>& a, const Pose<F>& b, F& rotation, F& position) {
  rotation = position = F(0.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rotation = max(rotation, abs(a.r[i][j] - b.r[i][j]));
    position = max(position, abs(a.p[i] - b.p[i]));
  }
}

template <class F> PIEPER_INLINE void store_pose(double* out, const Pose<F>& T, int lanes, long stride) {
  constexpr int W = width_of<F>;
  F value[16];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) value[4 * i + j] = T.r[i][j];
    value[4 * i + 3] = T.p[i];
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
template <class F> PIEPER_INLINE F joint(const double* q, int n, int j, int lanes) {
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

// Calls group(type tag, first, lanes) for all poses: whole lanes, then the rest; one pose alone in plain doubles.
template <class Group> PIEPER_INLINE void in_groups(long count, Group group) {
  constexpr int W = PIEPER_LANES;
  if (count == 1) {
    group(double(), 0L, 1);
    return;
  }
  long done = 0;
  for (; done + W <= count; done += W) group(Lanes<W>(), done, W);
  if (done < count) group(Lanes<W>(), done, static_cast<int>(count - done));
}

inline void forward_fk(const double* links, const std::uint8_t* prismatic, int n, const double* q, long count,
                       double* out) {
  in_groups(count, [&](auto tag, long first, int lanes) {
    using F = decltype(tag);
    Pose<F> T;
    set_constant(T, links);
    for (int i = 0; i < n; ++i) {
      move(T, joint<F>(q + first * n, n, i, lanes), prismatic[i]);
      T = times_constant(T, links + 16 * (i + 1));
    }
    store_pose(out + 16 * first, T, lanes, 16);
  });
}

inline void forward_frames(const double* links, const std::uint8_t* prismatic, int n, const double* base,
                           const double* after, const double* q, long count, double* out) {
  const long stride = 16L * (n + 2);
  in_groups(count, [&](auto tag, long first, int lanes) {
    using F = decltype(tag);
    double* record = out + stride * first;
    Pose<F> T;
    set_constant(T, base);
    store_pose(record, T, lanes, stride);
    set_constant(T, links);
    for (int i = 0; i < n; ++i) {
      move(T, joint<F>(q + first * n, n, i, lanes), prismatic[i]);
      store_pose(record + 16 * (i + 1), times_constant(T, after + 16 * i), lanes, stride);
      T = times_constant(T, links + 16 * (i + 1));
    }
    store_pose(record + 16 * (n + 1), T, lanes, stride);
  });
}

inline constexpr int kJacobianJoints = 16;  // arms with more joints take their records from the heap

template <class F> PIEPER_INLINE void jacobian_group(const double* links, const std::uint8_t* prismatic, int n,
                                                     const double* q, int lanes, double* out, F* axes, F* value) {
  Pose<F> T;
  set_constant(T, links);
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) {
      axes[6 * i + k] = T.r[k][2];
      axes[6 * i + 3 + k] = T.p[k];
    }
    move(T, joint<F>(q, n, i, lanes), prismatic[i]);
    T = times_constant(T, links + 16 * (i + 1));
  }
  for (int i = 0; i < n; ++i) {
    const F* z = axes + 6 * i;
    F d[3];
    for (int k = 0; k < 3; ++k) d[k] = T.p[k] - z[3 + k];
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
