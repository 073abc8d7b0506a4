// The closed-form families for many poses at once: the straight road. A lane in which anything is delicate (a root pair about to
// merge, a wrist about to line up, a residual above the verified one) is handed back and solved by the careful scalar road.
#pragma once

#include <new>

#include "lanes/batch.hpp"
#include "closed_form/closed_forms.hpp"
#include "closed_form/lanes/planar.hpp"
#include "chain/row_order.hpp"
#include "closed_form/careful/spherical_wrist.hpp"
#include "closed_form/careful/three_parallel.hpp"

namespace pieper::PIEPER_ISA::closed_form {

template <class F> PIEPER_INLINE RigidT<F> spread(const Rigid& A) {
  auto v = [](Vec3 a) { return Vec3T<F>{F(a.x), F(a.y), F(a.z)}; };
  return {v(A.x), v(A.y), v(A.z), v(A.t)};
}
template <class F> PIEPER_INLINE Vec3T<F> combined(const RigidT<F>& A, Vec3 b) {
  return {A.x.x * b.x + (A.y.x * b.y + A.z.x * b.z), A.x.y * b.x + (A.y.y * b.y + A.z.y * b.z), A.x.z * b.x + (A.y.z * b.y + A.z.z * b.z)};
}
template <class F> PIEPER_INLINE RigidT<F> times(const RigidT<F>& A, const Rigid& B) {
  return {combined(A, B.x), combined(A, B.y), combined(A, B.z), combined(A, B.t) + A.t};
}
template <class F> PIEPER_INLINE RigidT<F> moved(const RigidT<F>& A, Motion<F> m, bool slides) {
  if (slides) return {A.x, A.y, A.z, A.t + m.c * A.z};
  return {m.c * A.x + m.s * A.y, m.c * A.y - m.s * A.x, A.z, A.t};
}

// What a family computes for a group of poses.
template <class F> struct LaneSolutions {
  F q[8][6];  // rad; a slide in lengths of the arm
  Mask<F> valid[8];
  Mask<F> unclear;
};

// Everything of an arm that does not depend on the pose; made once, kept behind the arm's params.
struct PreparedArm {
  Rigid links[7];
  double length, unit[6];  // unit: what a joint's value is multiplied with at the end, 1 rad or the length
  int first;
  int order[3];  // joints a, b, c
  bool slides[6], hide_c, first_c, apart;
  bool straight;  // the loop's links are the arm's own within rounding: what closes the one closes the other

  PreparedArm(const double* params, const int* iparams) {
    length = params[0];
    first = iparams[6];
    hide_c = iparams[10] != 0, first_c = iparams[11] != 0, apart = iparams[12] != 0;
    for (int k = 0; k < 7; ++k) links[k] = read_rigid(params + 113 + 16 * k, length);
    for (int k = 0; k < 6; ++k) slides[k] = iparams[k] != 0, unit[k] = slides[k] ? length : 1.0;
    for (int k = 0; k < 3; ++k) order[k] = (first + 3 + k) % 6;
    straight = true;
    for (int sample = 0; sample < 4; ++sample) {
      Rigid truth = read_rigid(params + 1, length), loop = links[0];
      for (int k = 0; k < 6; ++k) {
        const double value = 2.3 * std::sin(1.7 * sample + 2.1 * k + 0.4);
        const bool inside = k >= first && k < first + 3;
        truth = joint(truth, value, slides[k]) * read_rigid(params + 1 + 16 * (k + 1), length);
        if (inside && slides[k]) loop.t = loop.t + value * loop.x;  // a plane's frames have x along a slide
        else loop = joint(loop, inside ? iparams[7 + k - first] * value : value, slides[k]);
        loop = loop * links[k + 1];
      }
      straight = straight && apart_by(truth, loop) <= 0.2 * kVerified;
    }
  }
  static double apart_by(const Rigid& A, const Rigid& B) {
    const Vec3 d[4] = {A.x - B.x, A.y - B.y, A.z - B.z, A.t - B.t};
    double most = 0;
    for (const Vec3& v : d) most = std::fmax(most, std::sqrt(dot(v, v)));
    return most;
  }
};

template <class F> PIEPER_INLINE F largest(Vec3T<F> v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// The three joints beside a group, at each of the four pairs: the middle joint, and the motion of the loop around the group.
template <class F> struct Around {
  const PreparedArm& arm;
  const LoopRestT<F>& rest;
  const PairLanes<F>& s;
  RigidT<F> left, right;  // Pre Za A and B Zc C, each kept while its joint stays the same

  PIEPER_INLINE RigidT<F> at(int i, Motion<F> b) {
    const bool *slides = arm.slides, second = s.apart && i % 2;
    if (!second || s.first_c) left = moved(rest.pre, s.a[i], slides[arm.order[0]]) * rest.A;
    if (!second || !s.first_c) right = moved(rest.B, s.c[i], slides[arm.order[2]]) * rest.C;
    return moved(left, b, slides[arm.order[1]]) * right;
  }
};

// The turn about z that takes `from` to `to`.
template <class F> PIEPER_INLINE Motion<F> turn_between(Vec3T<F> from, Vec3T<F> to, Mask<F>& unclear, Mask<F> found) {
  unclear = unclear | (found & !((from.x * from.x + from.y * from.y) > kRootsMerge));
  return unit(to.x * from.x + to.y * from.y, to.y * from.x - to.x * from.y);
}

template <class F> PIEPER_INLINE void start_pair(const PreparedArm& arm, PairLanes<F>& s) {
  s.slides_a = arm.slides[arm.order[0]], s.slides_c = arm.slides[arm.order[2]];
  s.hide_c = arm.hide_c, s.first_c = arm.first_c, s.apart = arm.apart;
}

template <class F> PIEPER_INLINE void put_pair(const PreparedArm& arm, const PairLanes<F>& s, int i, F b, F* q) {
  q[arm.order[0]] = s.angle_a[i], q[arm.order[1]] = b, q[arm.order[2]] = s.angle_c[i];
}

struct SphericalWristLanes {
  static constexpr auto careful = &solve_spherical_wrist<double>;
  double c0, s0, c1, s1, cos_sum, cos_difference, shift[3];
  bool square;     // right angles between neighbours: the other turn of the wrist is half a turn of its outer joints
  bool straight = true;

  SphericalWristLanes(const PreparedArm& arm, const int*) {
    const Wrist w = read_wrist(arm.links[arm.first + 1], arm.links[arm.first + 2]);
    c0 = std::cos(w.twist[0]), s0 = std::sin(w.twist[0]), c1 = std::cos(w.twist[1]), s1 = std::sin(w.twist[1]);
    shift[0] = one_turn(-w.before[0]), shift[1] = one_turn(-w.after[0] - w.before[1]), shift[2] = one_turn(-w.after[1]);
    cos_sum = std::cos(w.twist[0] + w.twist[1]);
    cos_difference = std::cos(w.twist[0] - w.twist[1]);
    square = std::fabs(c0) < 1e-15 && std::fabs(c1) < 1e-15;
  }

  template <class F>
  __attribute__((noinline)) void solve(const PreparedArm& arm, const LoopRestT<F>& rest, LaneSolutions<F>& out) const {
    const bool slides[3] = {arm.slides[arm.order[0]], arm.slides[arm.order[1]], arm.slides[arm.order[2]]};
    Vec3T<F> g = turn_back(rest.pre, F(-1.0) * rest.pre.t);
    SwingT<F> w = swing_back(rest.A, g, slides[0]), u = swing_of(rest.B, rest.C.t, slides[2]);
    PairLanes<F> s;
    start_pair(arm, s);
    position_pair(w, u, slides, s.M, s.N, s.e);
    solve_pair(s);
    out.unclear = s.unclear;
    Around<F> loop{arm, rest, s, {}, {}};
    const double scale = 1 / (s0 * s1);
#pragma GCC unroll 1
    for (int i = 0; i < 4; ++i) {
      Vec3T<F> to = w.at + s.a[i].c * w.first, from = u.at + s.c[i].c * u.first;
      if (!slides[0]) to = to + s.a[i].s * w.second;
      if (!slides[2]) from = from + s.c[i].s * u.second;
      Motion<F> b = slides[1] ? Motion<F>{to.z - from.z, F(0.0)} : turn_between(from, to, out.unclear, s.found[i]);
      const RigidT<F> around = loop.at(i, b);
      const F angle_b = joint_value(b, slides[1]), off = largest(around.t);
      // the wrist's rotation R is the transpose of `around`
      const Vec3T<F> rx = {around.x.x, around.y.x, around.z.x}, ry = {around.x.y, around.y.y, around.z.y},
                     rz = {around.x.z, around.y.z, around.z.z};
      F up = rz.z - cos_sum, down = cos_difference - rz.z, side = rz.x * rz.x + rz.y * rz.y;
      Mask<F> exists = s.found[i] & (up > 0.0) & (down > 0.0);
      out.unclear = out.unclear | (s.found[i] & ((abs(up) < kRootsMerge) | (abs(down) < kRootsMerge)));
      out.unclear = out.unclear | (exists & !(side > kRootsMerge));
      F ct = (c0 * c1 - rz.z) * scale, st = sqrt(max(up * down, F(0.0))) * scale;
      F vy = -c0 * s1 * ct - s0 * c1, vx = s1 * st, middle = joint_value(Motion<F>{ct, st}, false);
      const F over = 1.0 / sqrt(max(side * (vx * vx + vy * vy), F(1e-300)));
#pragma GCC unroll 1
      for (int n = 0; n < 2; ++n) {
        F* q = out.q[2 * i + n];
        put_pair(arm, s, i, angle_b, q);
        out.valid[2 * i + n] = exists;
        q[arm.first + 1] = wrapped((n ? -middle : middle) + shift[1]);
        if (n && square) {
          for (int j = 0; j < 3; j += 2) {
            const F first = out.q[2 * i][arm.first + j];
            q[arm.first + j] = select(first > 0.0, first - kPi, first + kPi);
          }
          continue;
        }
        if (n) st = -st, vx = -vx;
        Motion<F> t1 = {(rz.x * vx + rz.y * vy) * over, (rz.y * vx - rz.x * vy) * over};
        // columns x, y of Rz(t1) Rx Rz(t2) Rx and from them the last turn
        Vec3T<F> x1 = {t1.c, t1.s, F(0.0)}, y1 = {-c0 * t1.s, c0 * t1.c, F(s0)}, z1 = {s0 * t1.s, -s0 * t1.c, F(c0)};
        Vec3T<F> x2 = ct * x1 + st * y1, y2 = ct * y1 - st * x1;
        Vec3T<F> y3 = F(c1) * y2 + F(s1) * z1;
        Motion<F> t3 = {0.5 * (dot(x2, rx) + dot(y3, ry)), 0.5 * (dot(y3, rx) - dot(x2, ry))};
        F miss = max(largest(t3.c * x2 + t3.s * y3 - rx), largest(t3.c * y3 - t3.s * x2 - ry));
        out.unclear = out.unclear | (exists & !(max(miss, off) <= 0.5 * kVerified));
        q[arm.first] = wrapped(atan2_closed(t1.s, t1.c) + shift[0]);
        q[arm.first + 2] = wrapped(atan2_closed(t3.s, t3.c) + shift[2]);
      }
    }
  }
};

struct ThreeParallelLanes {
  static constexpr auto careful = &solve_three_parallel<double>;
  PlanarLanes plane;
  bool straight;

  ThreeParallelLanes(const PreparedArm& arm, const int* iparams)
      : plane(read_planar(arm.links[arm.first + 1]), read_planar(arm.links[arm.first + 2]), arm.slides + arm.first, iparams + 7) {
    straight = plane.usable;
  }

  template <class F>
  __attribute__((noinline)) void solve(const PreparedArm& arm, const LoopRestT<F>& rest, LaneSolutions<F>& out) const {
    const bool slides[3] = {arm.slides[arm.order[0]], arm.slides[arm.order[1]], arm.slides[arm.order[2]]};
    const PlaneProblem<F> P(rest, slides);
    PairLanes<F> s;
    start_pair(arm, s);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) s.M[i][j] = P.M[i][j], s.N[i][j] = P.N[i][j];
      s.e[i] = P.e[i];
    }
    solve_pair(s);
    out.unclear = s.unclear;
    Around<F> loop{arm, rest, s, {}, {}};
#pragma GCC unroll 1
    for (int i = 0; i < 4; ++i) {
      Vec3T<F> to = slides[0] ? P.w.at : P.w.at + s.a[i].c * P.w.first + s.a[i].s * P.w.second;
      Vec3T<F> from = slides[2] ? P.u.at : P.u.at + s.c[i].c * P.u.first + s.c[i].s * P.u.second;
      Motion<F> b;
      if (!slides[1]) {
        b = turn_between(from, to, out.unclear, s.found[i]);
      } else {
        Vec3T<F> turned_a = slides[0] ? P.ha.at : P.ha.at + s.a[i].c * P.ha.first + s.a[i].s * P.ha.second;
        F rise = P.climb + dot(turned_a, P.At) + dot(from, P.Bt);
        if (slides[0]) rise = rise + s.a[i].c * P.h.z;
        if (slides[2]) rise = rise + s.c[i].c * P.k.z;
        out.unclear = out.unclear | (s.found[i] & !(abs(to.z) > 1e-4));
        b = {-rise / to.z, F(0.0)};
      }
      // the plane's motion is the inverse of `around`
      const RigidT<F> around = loop.at(i, b);
      const F whole_c = 0.5 * (around.x.x + around.y.y), whole_s = 0.5 * (around.y.x - around.x.y);
      const F tx = -dot(around.x, around.t), ty = -dot(around.y, around.t), tz = dot(around.z, around.t);
      const F lean = max(max(abs(around.z.x), abs(around.z.y)), abs(tz));
      out.unclear = out.unclear | (s.found[i] & !((lean <= 0.5 * kVerified) & (around.z.z > 0.0)));
      F bent[2][3];
      const Mask<F> exists = plane.solve(whole_c, whole_s, tx, ty, s.found[i], bent, out.unclear);
      const F angle_b = joint_value(b, slides[1]);
      for (int n = 0; n < 2; ++n) {
        F* q = out.q[2 * i + n];
        put_pair(arm, s, i, angle_b, q);
        for (int j = 0; j < 3; ++j) q[arm.first + j] = bent[n][j];
        out.valid[2 * i + n] = n && plane.one_solution ? mask_of<F>(false) : exists;
      }
    }
  }
};

// What `prepare_closed` leaves behind the params.
template <class Family> struct PreparedClosed {
  PreparedArm arm;
  Family family;
};

// Lanes of poses through a family, verified by closing the loop, rows in order; bits of the lanes that need the careful road.
template <class F, class Family>
__attribute__((noinline)) unsigned solve_clear(const PreparedClosed<Family>& prepared, const double* T, int lanes, double* q,
                                               std::uint8_t* valid, std::uint8_t* flag) {
  constexpr int W = width_of<F>;
  const PreparedArm& arm = prepared.arm;
  const Pose<F> pose = load_poses<F>(T);
  const double scale = 1 / arm.length;
  // the loop closes through links[6] T^-1 links[0]
  const Vec3T<F> tx = {pose.r[0][0], pose.r[0][1], pose.r[0][2]}, ty = {pose.r[1][0], pose.r[1][1], pose.r[1][2]},
                 tz = {pose.r[2][0], pose.r[2][1], pose.r[2][2]};
  const RigidT<F> back = {tx, ty, tz, F(-scale) * (pose.p[0] * tx + pose.p[1] * ty + pose.p[2] * tz)};
  const RigidT<F> closing = spread<F>(arm.links[6]) * times(back, arm.links[0]);
  LoopRestT<F> rest;
  RigidT<F>* place[4] = {&rest.pre, &rest.A, &rest.B, &rest.C};
  for (int k = 0; k < 4; ++k) {
    const int link = (arm.first + 3 + k) % 6;
    const double* constant = &arm.links[link].x.x;
    F* to = &place[k]->x.x;
    for (int i = 0; i < 12; ++i) to[i] = link == 0 ? (&closing.x.x)[i] : F(constant[i]);
  }
  LaneSolutions<F> out;
  prepared.family.template solve<F>(arm, rest, out);
  F values[8][6];
  for (int m = 0; m < 8; ++m)
    for (int j = 0; j < 6; ++j) values[m][j] = select(out.valid[m], out.q[m][j] * arm.unit[j], F(0.0));
  Bits<F> rank[8];
  rank_rows<F, 8, 6>(values, out.valid, arm.slides, rank);
  // as many different ranks as rows, or the lane's order is left to the careful road
  Bits<F> seen = {}, count = {};
  for (int m = 0; m < 8; ++m) {
    seen |= (Bits<F>{} + 1) << rank[m];
    count += word_where(out.valid[m], 1);
  }
  std::int64_t ranks[8][W], counts[W], all_seen[W];
  __builtin_memcpy(ranks, rank, sizeof ranks);
  __builtin_memcpy(counts, &count, sizeof counts);
  __builtin_memcpy(all_seen, &seen, sizeof all_seen);
  unsigned unclear = bits_of(out.unclear);
  double rows[48 * W];
  store_records<F, 48>(rows, values[0], W);
  for (int i = 0; i < lanes; ++i) {
    for (int m = 0; m < 8; ++m) __builtin_memcpy(q + 48 * i + 6 * ranks[m][i], rows + 48 * i + 6 * m, 48);
    if (all_seen[i] != 255) unclear |= 1u << i;
    const std::uint64_t ones = 0x0101010101010101u, word = counts[i] == 8 ? ones : ones & ((1ull << (8 * counts[i])) - 1);
    __builtin_memcpy(valid + 8 * i, &word, 8);
    flag[i] = counts[i] ? 0 : kOutOfReach;
  }
  return unclear & ((1u << lanes) - 1u);
}

template <class Family> void prepare_closed(double* params, const int* iparams) {
  const PreparedArm arm(params, iparams);
  new (params + kClosedParams) PreparedClosed<Family>{arm, Family(arm, iparams)};
}

template <class Family>
void solve_closed(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid,
                  std::uint8_t* flag) {
  constexpr int W = PIEPER_LANES;
  const auto& prepared = *reinterpret_cast<const PreparedClosed<Family>*>(params + kClosedParams);
  auto again = [&](unsigned unclear, long first) {
    for (; unclear; unclear &= unclear - 1) {
      const long i = first + __builtin_ctz(unclear);
      Family::careful(params, iparams, T + 16 * i, 1, q + 48 * i, valid + 8 * i, flag + i);
      std::uint8_t slides[6];
      for (int j = 0; j < 6; ++j) slides[j] = prepared.arm.slides[j];
      put_in_order(q + 48 * i, valid + 8 * i, 8, 6, slides);
    }
  };
  if (!prepared.arm.straight || !prepared.family.straight) {
    for (long i = 0; i < count; ++i) again(1, i);
    return;
  }
  if (count == 1) {
    again(solve_clear<double>(prepared, T, 1, q, valid, flag), 0);
    return;
  }
  long done = 0;
  for (; done + W <= count; done += W)
    again(solve_clear<Lanes<W>>(prepared, T + 16 * done, W, q + 48 * done, valid + 8 * done, flag + done), done);
  if (done < count) {
    const int rest = static_cast<int>(count - done);
    double padded[16 * W];
    for (int i = 0; i < W; ++i)  // idle lanes repeat the last pose
      for (int k = 0; k < 16; ++k) padded[16 * i + k] = T[16 * (done + (i < rest ? i : rest - 1)) + k];
    again(solve_clear<Lanes<W>>(prepared, padded, rest, q + 48 * done, valid + 8 * done, flag + done), done);
  }
}

}  // namespace pieper::PIEPER_ISA::closed_form
