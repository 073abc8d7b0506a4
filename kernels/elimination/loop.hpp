// The closed loop of a six-joint chain as the general solver sees it: rigid frames, joint roles, the fourteen features.
//
// The chain closes on itself, Z1 L1 Z2 L2 ... Z6 L6 = 1, with the pose inside one of the links. Starting the loop at another
// joint, or walking it backwards, renames the joints: twelve ways to hand out the same six *roles*
//   1, 2 eliminated by linear algebra; 3 hidden (the one unknown of the eigenvalue problem); 4, 5 the pair whose monomials
//   are the unknown vector; 6 dropped (the features are those of the line of its axis). Templates over the number type.
#pragma once

#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA::general {

template <class F> struct Complex {
  F re, im;
};
template <class F> PIEPER_INLINE Complex<F> operator*(Complex<F> a, Complex<F> b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class F> PIEPER_INLINE Complex<F> conj_times(Complex<F> a, Complex<F> b) {  // conj(a) b
  return {a.re * b.re + a.im * b.im, a.re * b.im - a.im * b.re};
}

// A half turn about x on both sides turns an inverse joint motion into a forward one: Z(q)^-1 = X Z(q) X.
template <class F> PIEPER_INLINE RigidT<F> flipped(const RigidT<F>& a) {
  auto turned = [](Vec3T<F> v) { return Vec3T<F>{v.x, -v.y, -v.z}; };
  return {turned(a.x), -1.0 * turned(a.y), -1.0 * turned(a.z), turned(a.t)};
}

// How a variant of the elimination hands out the roles. `joint[k]` is the 0-based joint that plays role k + 1.
struct Roles {
  int shift, reverse;
  int joint[6];
  bool prismatic[6];
  int pose_link;  // 0-based role link that holds the pose

  void assign(int first, int backwards, const bool* is_prismatic) {
    shift = first;
    reverse = backwards;
    for (int k = 0; k < 6; ++k) {
      const int at = (k + shift) % 6;
      joint[k] = reverse ? 5 - at : at;
      prismatic[k] = is_prismatic[joint[k]];
      if (loop_link(k) == 5) pose_link = k;
    }
  }
  // Which loop link (5 holds the pose) follows role k, when walking in this variant's direction.
  int loop_link(int k) const {
    const int at = (k + shift) % 6;
    return reverse ? (10 - at) % 6 : at;
  }
};

// The line of an axis: a point on it and its direction, moved along by links and joints.
template <class F> struct Line {
  Vec3T<F> p, l;
};
template <class F> PIEPER_INLINE Line<F> move(const RigidT<F>& a, const Line<F>& x) {
  return {pieper::PIEPER_ISA::move(a, x.p), turn(a, x.l)};
}
template <class F> PIEPER_INLINE Line<F> move_back(const RigidT<F>& a, const Line<F>& x) {
  return {pieper::PIEPER_ISA::move_back(a, x.p), turn_back(a, x.l)};
}
template <class F> PIEPER_INLINE void turn(Line<F>& x, F c, F s) {
  auto turned = [&](Vec3T<F> v) { return Vec3T<F>{c * v.x - s * v.y, s * v.x + c * v.y, v.z}; };
  x = {turned(x.p), turned(x.l)};
}

// Raghavan and Roth's fourteen functions of a line (1993): six that a rotation about z leaves alone,
//   p_z, l_z, p.p, p.l, (p x l)_z, ((p.p) l - 2 (p.l) p)_z,
// and the x, y parts of p, l, p x l, (p.p) l - 2 (p.l) p, which it turns like four complex numbers.
template <class F> PIEPER_INLINE void features(const Line<F>& x, F* out) {
  const auto& [p, l] = x;
  const F pp = dot(p, p), pl = dot(p, l);
  const Vec3T<F> moment = cross(p, l), last = pp * l - (pl + pl) * p;
  out[0] = p.z;
  out[1] = l.z;
  out[2] = pp;
  out[3] = pl;
  out[4] = moment.z;
  out[5] = last.z;
  out[6] = p.x;
  out[7] = p.y;
  out[8] = l.x;
  out[9] = l.y;
  out[10] = moment.x;
  out[11] = moment.y;
  out[12] = last.x;
  out[13] = last.y;
}

}  // namespace pieper::PIEPER_ISA::general
