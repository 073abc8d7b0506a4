// The closed-form families for many poses at once: the straight road. A lane in which anything is delicate (a root pair about to
// merge, a wrist about to line up, a residual above the verified one) is handed back and solved by the careful scalar road.
#pragma once

#include "batch.hpp"
#include "pair_lanes.hpp"
#include "spherical_wrist.hpp"
#include "three_parallel.hpp"

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
template <class F> PIEPER_INLINE Motion<F> turned(Motion<F> a, Motion<F> b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }
template <class F> PIEPER_INLINE Motion<F> turned(Motion<F> a, double c, double s) { return {a.c * c - a.s * s, a.s * c + a.c * s}; }
template <class F> PIEPER_INLINE Motion<F> back(Motion<F> a) { return {a.c, -a.s}; }

// What a family computes per pose group.
template <class F> struct LaneSolutions {
  Motion<F> q[8][6];
  Mask<F> valid[8];
  Mask<F> unclear;
};

// Everything of an arm that does not depend on the pose.
struct PreparedArm {
  Rigid truth[7], links[7];
  double length;
  int first;
  bool slides[6], hide_c, first_c;

  PreparedArm(const double* params, const int* iparams) {
    length = params[0];
    first = iparams[6];
    hide_c = iparams[10] != 0, first_c = iparams[11] != 0;
    for (int k = 0; k < 7; ++k) truth[k] = read_rigid(params + 1 + 16 * k, length), links[k] = read_rigid(params + 113 + 16 * k, length);
    for (int k = 0; k < 6; ++k) slides[k] = iparams[k] != 0;
  }
};

// The turn about z that takes `from` to `to`.
template <class F> PIEPER_INLINE Motion<F> turn_between(Vec3T<F> from, Vec3T<F> to, Mask<F>& unclear, Mask<F> found) {
  unclear = unclear | (found & !((from.x * from.x + from.y * from.y) > 1e-7));
  return unit(to.x * from.x + to.y * from.y, to.y * from.x - to.x * from.y);
}

struct SphericalWristLanes {
  static constexpr auto careful = &solve_spherical_wrist<double>;
  struct Constants {
    double c0, s0, c1, s1, cos_sum, cos_difference, before0[2], middle[2], after1[2];
    bool straight = true;
    explicit Constants(const PreparedArm& arm, const int*) {
      Wrist w = read_wrist(arm.links[arm.first + 1], arm.links[arm.first + 2]);
      c0 = std::cos(w.twist[0]), s0 = std::sin(w.twist[0]), c1 = std::cos(w.twist[1]), s1 = std::sin(w.twist[1]);
      before0[0] = std::cos(w.before[0]), before0[1] = -std::sin(w.before[0]);
      middle[0] = std::cos(w.after[0] + w.before[1]), middle[1] = -std::sin(w.after[0] + w.before[1]);
      after1[0] = std::cos(w.after[1]), after1[1] = -std::sin(w.after[1]);
      cos_sum = std::cos(w.twist[0] + w.twist[1]);
      cos_difference = std::cos(w.twist[0] - w.twist[1]);
    }
  };

  template <class F>
  __attribute__((noinline)) static void solve(const PreparedArm& arm, const Constants& k, const LoopRestT<F>& rest, const bool* slides, LaneSolutions<F>& out) {
    Vec3T<F> g = turn_back(rest.pre, F(-1.0) * rest.pre.t);
    SwingT<F> w = swing_back(rest.A, g, slides[0]), u = swing_of(rest.B, rest.C.t, slides[2]);
    PairLanes<F> s;
    s.slides_a = slides[0], s.slides_c = slides[2], s.hide_c = arm.hide_c, s.first_c = arm.first_c;
    position_pair(w, u, slides, s.M, s.N, s.e);
    solve_pair(s);
    out.unclear = s.unclear;
#pragma GCC unroll 1
    for (int i = 0; i < 4; ++i) {
      Vec3T<F> to = w.at + s.a[i].c * w.first, from = u.at + s.c[i].c * u.first;
      if (!slides[0]) to = to + s.a[i].s * w.second;
      if (!slides[2]) from = from + s.c[i].s * u.second;
      Motion<F> b = slides[1] ? Motion<F>{to.z - from.z, F(0.0)} : turn_between(from, to, out.unclear, s.found[i]);
      RigidT<F> around = moved(rest.pre, s.a[i], slides[0]) * rest.A;
      around = moved(around, b, slides[1]) * rest.B;
      around = moved(around, s.c[i], slides[2]) * rest.C;
      // the wrist's rotation R is the transpose of `around`
      const Vec3T<F> rx = {around.x.x, around.y.x, around.z.x}, ry = {around.x.y, around.y.y, around.z.y},
                     rz = {around.x.z, around.y.z, around.z.z};
      F up = rz.z - k.cos_sum, down = k.cos_difference - rz.z;
      Mask<F> exists = s.found[i] & (up > 0.0) & (down > 0.0);
      out.unclear = out.unclear | (s.found[i] & ((abs(up) < 1e-6) | (abs(down) < 1e-6)));
      const double scale = 1 / (k.s0 * k.s1);
      F ct = (k.c0 * k.c1 - rz.z) * scale, st = sqrt(max(up * down, F(0.0))) * scale;
      out.unclear = out.unclear | (exists & !((rz.x * rz.x + rz.y * rz.y) > 1e-7));
#pragma GCC unroll 1
      for (int n = 0; n < 2; ++n) {
        if (n) st = -st;
        F vx = k.s1 * st, vy = -k.c0 * k.s1 * ct - k.s0 * k.c1;
        Motion<F> t1 = unit(rz.x * vx + rz.y * vy, rz.y * vx - rz.x * vy), t2 = unit(ct, st);
        // columns x, y of Rz(t1) Rx Rz(t2) Rx and from them the last turn
        Vec3T<F> x1 = {t1.c, t1.s, F(0.0)}, y1 = {-k.c0 * t1.s, k.c0 * t1.c, F(k.s0)}, z1 = {k.s0 * t1.s, -k.s0 * t1.c, F(k.c0)};
        Vec3T<F> x2 = t2.c * x1 + t2.s * y1, y2 = t2.c * y1 - t2.s * x1;
        Vec3T<F> y3 = F(k.c1) * y2 + F(k.s1) * z1;
        Motion<F> t3 = unit(dot(x2, rx) + dot(y3, ry), dot(y3, rx) - dot(x2, ry));
        Motion<F>* q = out.q[2 * i + n];
        q[rest.joints[0]] = s.a[i], q[rest.joints[1]] = b, q[rest.joints[2]] = s.c[i];
        q[arm.first] = turned(t1, k.before0[0], k.before0[1]);
        q[arm.first + 1] = turned(t2, k.middle[0], k.middle[1]);
        q[arm.first + 2] = turned(t3, k.after1[0], k.after1[1]);
        out.valid[2 * i + n] = exists;
      }
    }
  }
};

struct ThreeParallelLanes {
  static constexpr auto careful = &solve_three_parallel<double>;
  struct Constants {
    double a, b, sum_c, sum_s, bend[2], first_turn[2], l1x, l1y, l2x, l2y, sense[3];
    bool straight;  // slides in the plane, or between the joints around it, take the careful road
    explicit Constants(const PreparedArm& arm, const int* iparams) {
      PlanarLink l1 = read_planar(arm.links[arm.first + 1]), l2 = read_planar(arm.links[arm.first + 2]);
      a = std::hypot(l1.at.x, l1.at.y), b = std::hypot(l2.at.x, l2.at.y);
      sum_c = std::cos(l1.angle + l2.angle), sum_s = -std::sin(l1.angle + l2.angle);
      double shift = heading(l1.at) - heading(l2.at) - l1.angle;
      bend[0] = std::cos(shift), bend[1] = std::sin(shift);
      first_turn[0] = std::cos(l1.angle), first_turn[1] = std::sin(l1.angle);
      l1x = l1.at.x, l1y = l1.at.y, l2x = l2.at.x, l2y = l2.at.y;
      straight = !arm.slides[(arm.first + 4) % 6];
      for (int j = 0; j < 3; ++j) sense[j] = iparams[7 + j], straight = straight && !arm.slides[arm.first + j];
    }
  };

  template <class F>
  __attribute__((noinline)) static void solve(const PreparedArm& arm, const Constants& k, const LoopRestT<F>& rest, const bool* slides, LaneSolutions<F>& out) {
    const PlaneProblem<F> P(rest, slides);
    PairLanes<F> s;
    s.slides_a = slides[0], s.slides_c = slides[2], s.hide_c = arm.hide_c, s.first_c = arm.first_c;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) s.M[i][j] = P.M[i][j], s.N[i][j] = P.N[i][j];
      s.e[i] = P.e[i];
    }
    solve_pair(s);
    out.unclear = s.unclear;
#pragma GCC unroll 1
    for (int i = 0; i < 4; ++i) {
      Vec3T<F> to = slides[0] ? P.w.at : P.w.at + s.a[i].c * P.w.first + s.a[i].s * P.w.second;
      Vec3T<F> from = slides[2] ? P.u.at : P.u.at + s.c[i].c * P.u.first + s.c[i].s * P.u.second;
      Motion<F> b = turn_between(from, to, out.unclear, s.found[i]);
      RigidT<F> around = moved(rest.pre, s.a[i], slides[0]) * rest.A;
      around = moved(around, b, slides[1]) * rest.B;
      around = inverse(moved(around, s.c[i], slides[2]) * rest.C);
      Motion<F> whole = unit(around.x.x + around.y.y, around.x.y - around.y.x);
      F tx = around.t.x, ty = around.t.y, r2 = tx * tx + ty * ty;
      F cosine = (r2 - (k.a * k.a + k.b * k.b)) * (0.5 / (k.a * k.b)), room = 1.0 - cosine * cosine;
      Mask<F> exists = s.found[i] & (room > 0.0);
      out.unclear = out.unclear | (s.found[i] & ((abs(room) < 1e-6) | !(r2 > 1e-7)));
      F sine = sqrt(max(room, F(0.0)));
#pragma GCC unroll 1
      for (int n = 0; n < 2; ++n) {
        if (n) sine = -sine;
        Motion<F> q2 = turned(unit(cosine, sine), k.bend[0], k.bend[1]), bent = turned(q2, k.first_turn[0], k.first_turn[1]);
        F vx = k.l1x + bent.c * k.l2x - bent.s * k.l2y, vy = k.l1y + bent.s * k.l2x + bent.c * k.l2y;
        Motion<F> q1 = unit(tx * vx + ty * vy, ty * vx - tx * vy);
        Motion<F> q3 = turned(turned(turned(whole, k.sum_c, k.sum_s), back(q1)), back(q2));
        Motion<F>* q = out.q[2 * i + n];
        q[rest.joints[0]] = s.a[i], q[rest.joints[1]] = b, q[rest.joints[2]] = s.c[i];
        q[arm.first] = {q1.c, k.sense[0] * q1.s};
        q[arm.first + 1] = {q2.c, k.sense[1] * q2.s};
        q[arm.first + 2] = {q3.c, k.sense[2] * q3.s};
        out.valid[2 * i + n] = exists;
      }
    }
  }
};

// Lanes of poses through a family, verified by the chain as described; bits of the lanes that need the careful road.
template <class F, class Family>
__attribute__((noinline)) unsigned solve_clear(const PreparedArm& arm, const typename Family::Constants& constants, const double* T, int lanes,
                                   double* q, std::uint8_t* valid, std::uint8_t* flag) {
  const Pose<F> pose = load_poses<F>(T);
  const double scale = 1 / arm.length;
  const RigidT<F> target = {{pose.r[0][0], pose.r[1][0], pose.r[2][0]},
                            {pose.r[0][1], pose.r[1][1], pose.r[2][1]},
                            {pose.r[0][2], pose.r[1][2], pose.r[2][2]},
                            {pose.p[0] * scale, pose.p[1] * scale, pose.p[2] * scale}};
  RigidT<F> links[7];
  for (int k = 0; k < 7; ++k) links[k] = spread<F>(arm.links[k]);
  const LoopRestT<F> rest(links, target, arm.first);
  bool slides[3];
  for (int k = 0; k < 3; ++k) slides[k] = arm.slides[rest.joints[k]];
  LaneSolutions<F> out;
  Family::template solve<F>(arm, constants, rest, slides, out);
  F values[48];
  unsigned bits[8], any_valid = 0;
#pragma GCC unroll 1
  for (int m = 0; m < 8; ++m) {
    RigidT<F> frame = spread<F>(arm.truth[0]);
#pragma GCC unroll 1
    for (int j = 0; j < 6; ++j) {
      frame = times(moved(frame, out.q[m][j], arm.slides[j]), arm.truth[j + 1]);
      F value = arm.slides[j] ? out.q[m][j].c * arm.length : atan2(out.q[m][j].s, out.q[m][j].c);
      values[6 * m + j] = select(out.valid[m], value, F(0.0));
    }
    auto apart = [](Vec3T<F> a, Vec3T<F> b) { return max(abs(a.x - b.x), max(abs(a.y - b.y), abs(a.z - b.z))); };
    F miss = max(max(apart(frame.x, target.x), apart(frame.y, target.y)), max(apart(frame.z, target.z), apart(frame.t, target.t)));
    out.unclear = out.unclear | (out.valid[m] & !(miss <= 0.5 * kVerified));
    bits[m] = bits_of(out.valid[m]);
    any_valid |= bits[m];
  }
  store_records<F, 48>(q, values, lanes);
  for (int i = 0; i < lanes; ++i) {
    for (int m = 0; m < 8; ++m) valid[i * 8 + m] = (bits[m] >> i) & 1u;
    flag[i] = (any_valid >> i) & 1u ? 0 : kOutOfReach;
  }
  return bits_of(out.unclear) & ((1u << lanes) - 1u);
}

template <class Family>
void solve_closed(const double* params, const int* iparams, const double* T, long count, double* q, std::uint8_t* valid,
                  std::uint8_t* flag) {
  constexpr int W = PIEPER_LANES;
  const PreparedArm arm(params, iparams);
  const typename Family::Constants constants(arm, iparams);
  if (!constants.straight) {
    Family::careful(params, iparams, T, count, q, valid, flag);
    return;
  }
  auto again = [&](unsigned unclear, long first) {
    for (; unclear; unclear &= unclear - 1) {
      long i = first + __builtin_ctz(unclear);
      Family::careful(params, iparams, T + 16 * i, 1, q + 48 * i, valid + 8 * i, flag + i);
    }
  };
  if (count == 1) {
    again(solve_clear<double, Family>(arm, constants, T, 1, q, valid, flag), 0);
    return;
  }
  long done = 0;
  for (; done + W <= count; done += W)
    again(solve_clear<Lanes<W>, Family>(arm, constants, T + 16 * done, W, q + 48 * done, valid + 8 * done, flag + done), done);
  if (done < count) {
    const int rest = static_cast<int>(count - done);
    double padded[16 * W];
    for (int i = 0; i < W; ++i)  // idle lanes repeat the last pose
      for (int k = 0; k < 16; ++k) padded[16 * i + k] = T[16 * (done + (i < rest ? i : rest - 1)) + k];
    again(solve_clear<Lanes<W>, Family>(arm, constants, padded, rest, q + 48 * done, valid + 8 * done, flag + done), done);
  }
}

}  // namespace pieper::PIEPER_ISA::closed_form
