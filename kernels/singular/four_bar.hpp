// Four revolute joints that close on themselves: parallel axes (a planar four-bar linkage) or axes through one point (a spherical
// one). exp(x1 d1) exp(x2 d2) exp(x3 d3) exp(x4 d4) = 1 is a scalar equation between the angle that leads and the one opposite, each
// side a constant and one harmonic, so that every joint may lead, and where it can go is known exactly. Scalar.
#pragma once

#include <complex>

#include "singular/six.hpp"

namespace pieper::PIEPER_ISA {

// An angle (rad) with its cosine and sine.
struct Turn {
  double angle, cosine, sine;
  explicit Turn(double by) : angle(by), cosine(std::cos(by)), sine(std::sin(by)) {}
  Turn(double by, double cosine, double sine) : angle(by), cosine(cosine), sine(sine) {}
  Turn operator-() const { return {-angle, cosine, -sine}; }
  Turn operator+(const Turn& b) const {
    return {angle + b.angle, cosine * b.cosine - sine * b.sine, sine * b.cosine + cosine * b.sine};
  }
  // e^(i sense angle)
  std::complex<double> round(double sense) const { return {cosine, sense * sine}; }
};

// middle + size cos(angle - phase)
struct Harmonic {
  double middle, size, phase;
  Turn at_phase{0};
  static Harmonic of(double constant, double cosine, double sine) {
    const double phase = std::atan2(sine, cosine);
    return {constant, std::hypot(cosine, sine), phase, Turn(phase)};
  }
  double at(double angle) const { return middle + size * std::cos(angle - phase); }
  double at(const Turn& turn) const {
    return middle + size * (turn.cosine * at_phase.cosine + turn.sine * at_phase.sine);
  }
  // How far from the phase, in [0, pi], the value is taken; the nearest end where it is not.
  Turn from_phase(double value) const {
    const double cosine = std::fmin(std::fmax((value - middle) / size, -1.0), 1.0);
    return {std::acos(cosine), cosine, std::sqrt((1 - cosine) * (1 + cosine))};
  }
};

struct FourBar {
  using Complex = std::complex<double>;
  int joint[4];  // ascending
  Vec3 axis[4];
  bool flat;            // parallel axes; else through one point
  Complex spot[4];      // of flat ones: points on the axes in the plane across them
  double sense[4];      // which way each turns in that plane, 1 or -1
  Harmonic side[4][2];  // by who leads: of its angle, and of the one opposite

  // What must be equal when each of them leads; to be called once the axes are known.
  void prepare() {
    for (int lead = 0; lead < 4; ++lead) {
      const int i1 = lead, i2 = (lead + 1) % 4, i3 = (lead + 2) % 4, i4 = (lead + 3) % 4;
      for (int k = 0; k < 2; ++k) {
        const int i = k ? i3 : i1;
        if (flat) {
          const double turn = k ? sense[i3] : -sense[i1];
          const Complex m = 2.0 * std::conj(spot[i] - spot[i2]) * (spot[i4] - spot[i]);
          side[lead][k] =
              Harmonic::of(std::norm(spot[i] - spot[i2]) + std::norm(spot[i4] - spot[i]), m.real(), -turn * m.imag());
        } else {
          const double turn = k ? 1 : -1, constant = dot(axis[i], axis[i2]) * dot(axis[i], axis[i4]);
          side[lead][k] = Harmonic::of(constant, dot(axis[i2], axis[i4]) - constant,
                                       turn * dot(axis[i2], cross(axis[i], axis[i4])));
        }
      }
    }
  }
  const Harmonic& opposite(int lead) const { return side[lead][1]; }

  // The four angles that a leading angle asks for, rad from the solution; false where it cannot go there. `way`: 1 or -1, on which
  // side of its phase the opposite angle is.
  bool turned(int lead, double angle, double way, double* out) const {
    const Turn led(angle);
    const Harmonic &mine = side[lead][0], &other = side[lead][1];
    const double value = mine.at(led);
    const Turn off = other.from_phase(value);
    closed(lead, led, other.at_phase + (way < 0 ? -off : off), out);
    return std::fabs(value - other.middle) <= other.size * (1 + kDeadCentre);
  }

  // The same of a joint that turns back at `low` and `high`, at u of its way there and back: how near it is to an end, and so how far
  // the joint opposite is from its phase, is told by half angles, to the last digit.
  void back(int lead, double low, double high, double u, double* out) const {
    const Harmonic &mine = side[lead][0], &other = side[lead][1];
    const double sine = std::sin(kPi * u), cosine = std::cos(kPi * u), gone = (high - low) * sine * sine,
                 left = (high - low) * cosine * cosine;
    const bool above = mine.at(low) > other.middle, alike = above == (mine.at(high) > other.middle);
    const double from_low = alike ? 2 * mine.size / other.size * std::fabs(std::sin(gone / 2) * std::sin(left / 2))
                                  : beyond(lead, low, gone),
                 from_high = alike ? 2 - from_low : beyond(lead, high, -left);
    const double one = std::sqrt(from_low), two = std::sqrt(std::fmax(from_high, 0.0)), turn = 2 * std::atan2(one, two),
                 whole = one * one + two * two, cos = (two * two - one * one) / whole, sin = 2 * one * two / whole;
    const Turn across = above ? Turn(turn, cos, sin) : Turn(kPi - turn, -cos, sin);
    closed(lead, Turn(low + gone), other.at_phase + (u - std::floor(u) < 0.5 ? across : -across), out);
  }
  // u of angles on that way.
  double place_back(int lead, double low, double high, double angle, double across) const {
    const Harmonic &mine = side[lead][0], &other = side[lead][1];
    const double off = short_way(angle - (low + high) / 2), half = (high - low) / 2, end = off < 0 ? low : high,
                 way = off < 0 ? 1 : -1, from_phase = short_way(across - other.phase);
    double gone = half - std::fabs(off);
    if (gone < half / 2) {  // what is left of a difference is refined by the joint opposite, which moves as its root
      const double from = mine.at(end) > other.middle ? from_phase : kPi - std::fabs(from_phase),
                   wanted = 2 * std::sin(from / 2) * std::sin(from / 2);
      for (int step = 0; step < 3; ++step) {
        const double slope = mine.size / other.size * std::fabs(std::sin(end + way * gone - mine.phase));
        if (!(slope > kLoopCritical)) break;
        gone = std::fmax(0.0, gone - (std::copysign(beyond(lead, end, way * gone), gone) - wanted) / slope);
      }
    }
    const double u = std::asin(std::sqrt(std::fmin(gone / (2 * half), 1.0))) / kPi, there = off < 0 ? u : 0.5 - u;
    return from_phase < 0 ? 1 - there : there;
  }

  // The same on a course that goes round twice and crosses itself where the leading joint is at `crosses`: by how much the joint
  // opposite is off there is the sine of half of what the leading one is, and changes its sign from round to round.
  void twice(int lead, double crosses, double angle, double* out) const {
    const bool top = std::cos(crosses - side[lead][0].phase) > 0;
    const double off = off_crossing(lead, angle - crosses), phase = side[lead][1].phase;
    closed(lead, angle, top ? phase + off : phase + kPi - off, out);
  }
  // The leading angle of such a place, the second round a turn on.
  double place_twice(int lead, double crosses, double angle, double across) const {
    const bool top = std::cos(crosses - side[lead][0].phase) > 0;
    const double gone = short_way(angle - crosses), off = off_crossing(lead, gone),
                 from_phase = across - side[lead][1].phase, there = short_way(top ? from_phase : kPi - from_phase);
    return crosses + gone + (std::fabs(there - off) <= std::fabs(there + off) ? 0 : kTwoPi);
  }

  // The four angles that those of the leading joint and of the one opposite leave.
  void closed(int lead, double angle, double across, double* out) const {
    closed(lead, Turn(angle), Turn(across), out);
  }
  void closed(int lead, const Turn& angle, const Turn& across, double* out) const {
    const int i1 = lead, i2 = (lead + 1) % 4, i3 = (lead + 2) % 4, i4 = (lead + 3) % 4;
    out[i1] = angle.angle, out[i3] = across.angle;
    if (flat) {
      const Complex ends = spot[i1] + times(angle.round(-sense[i1]), spot[i4] - spot[i1]) - spot[i2];
      const Complex starts = spot[i3] + times(across.round(sense[i3]), spot[i4] - spot[i3]) - spot[i2];
      const Complex turned = times(ends, std::conj(starts));
      out[i2] = sense[i2] * std::atan2(turned.imag(), turned.real());
      out[i4] = -sense[i4] * (sense[i1] * out[i1] + sense[i2] * out[i2] + sense[i3] * out[i3]);
    } else {
      out[i2] = about(axis[i2], rotated(axis[i3], across, axis[i4]), rotated(axis[i1], -angle, axis[i4]));
      out[i4] = about(axis[i4], rotated(axis[i1], angle, axis[i2]), rotated(axis[i3], -across, axis[i2]));
    }
  }

 private:
  double off_crossing(int lead, double gone) const {
    const double part = std::sqrt(side[lead][0].size / side[lead][1].size) * std::sin(gone / 2);
    return 2 * std::asin(std::fmin(std::fmax(part, -1.0), 1.0));
  }
  // By how much the cosine of the joint opposite departs from what it is where the leading joint turns back, `gone` from there.
  double beyond(int lead, double end, double gone) const {
    const Harmonic& mine = side[lead][0];
    return 2 * mine.size / side[lead][1].size * std::fabs(std::sin(gone / 2) * std::sin(end + gone / 2 - mine.phase));
  }
  // Complex multiplication without the care for infinities that the standard asks for.
  static Complex times(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }
  static Vec3 rotated(Vec3 about, const Turn& by, Vec3 v) {
    const Vec3 along = dot(about, v) * about;
    return along + by.cosine * (v - along) + by.sine * cross(about, v);
  }
  // The angle about an axis that turns start to end.
  static double about(Vec3 axis, Vec3 start, Vec3 end) {
    return std::atan2(dot(cross(start, end), axis), dot(start, end) - dot(start, axis) * dot(end, axis));
  }
};

inline double length_of(Vec3 v) { return std::sqrt(dot(v, v)); }

// By how much two axes miss being one line (rad and lengths, added up).
inline double line_gap(const Standing& at, int i, int j) {
  return length_of(cross(at.z[i], at.z[j])) + length_of(cross(at.o[j] - at.o[i], at.z[i]));
}

// The point nearest to four lines, in the least squares; along a direction that all of them have it is anywhere.
inline Vec3 nearest_to_lines(const Vec3* z, const Vec3* o) {
  const Vec3 middle = 0.25 * (o[0] + o[1] + o[2] + o[3]);
  double A[3][4] = {};
  for (int k = 0; k < 4; ++k) {
    const Vec3 p = o[k] - middle, side = p - dot(p, z[k]) * z[k];
    const double a[3] = {z[k].x, z[k].y, z[k].z}, b[3] = {side.x, side.y, side.z};
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) A[r][c] += (r == c) - a[r] * a[c];
      A[r][3] += b[r];
    }
  }
  double x[3] = {};
  int order[3] = {0, 1, 2}, done = 0;
  for (; done < 3; ++done) {  // symmetric elimination, the largest pivot first
    int best = done;
    for (int k = done; k < 3; ++k)
      if (A[order[k]][order[k]] > A[order[best]][order[best]]) best = k;
    std::swap(order[done], order[best]);
    const int p = order[done];
    if (A[p][p] < kLinkagePivot) break;
    for (int k = done + 1; k < 3; ++k) {
      const double f = A[order[k]][p] / A[p][p];
      for (int c = 0; c < 4; ++c) A[order[k]][c] -= f * A[p][c];
    }
  }
  for (int k = done - 1; k >= 0; --k) {
    double sum = A[order[k]][3];
    for (int m = k + 1; m < done; ++m) sum -= A[order[k]][order[m]] * x[order[m]];
    x[order[k]] = sum / A[order[k]][order[k]];
  }
  return middle + Vec3{x[0], x[1], x[2]};
}

// Four joints (ascending) as a linkage, and by how much (rad and lengths) their axes miss being one.
inline double close_four(const Standing& at, const int* joints, FourBar& bar) {
  Vec3 o[4];
  for (int k = 0; k < 4; ++k)
    bar.joint[k] = joints[k], bar.axis[k] = at.z[joints[k]], o[k] = at.o[joints[k]], bar.sense[k] = 1;
  const Vec3 n = bar.axis[0], point = nearest_to_lines(bar.axis, o);
  double tilt = 0, apart = 0;
  for (int k = 0; k < 4; ++k) {
    tilt = std::fmax(tilt, length_of(cross(bar.axis[k], n)));
    apart = std::fmax(apart, length_of(cross(o[k] - point, bar.axis[k])));
  }
  bar.flat = !(tilt > apart);
  if (!bar.flat) return apart;
  const double a[3] = {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const int least = static_cast<int>(std::min_element(a, a + 3) - a);
  Vec3 x = cross(n, Vec3{least == 0 ? 1.0 : 0.0, least == 1 ? 1.0 : 0.0, least == 2 ? 1.0 : 0.0});
  x = (1 / length_of(x)) * x;
  const Vec3 y = cross(n, x);
  for (int k = 0; k < 4; ++k) {
    bar.spot[k] = {dot(o[k] - o[0], x), dot(o[k] - o[0], y)};
    bar.sense[k] = dot(bar.axis[k], n) < 0 ? -1 : 1;
  }
  return tilt;
}

// The four-bar that a null direction moves, and by how much its axes miss being one. False where the direction moves other than
// turning joints, or more than four of them.
inline bool four_bar(const SixJoints& arm, const Standing& at, const double* null, const int* order, FourBar& bar,
                     double& gap) {
  if (std::fabs(null[order[4]]) > kLoopMoves) return false;
  int moving[4];
  std::copy(order, order + 4, moving);
  std::sort(moving, moving + 4);
  if (std::fabs(null[order[3]]) > kLoopMoves) {
    for (int j : moving)
      if (arm.slides[j]) return false;
    gap = close_four(at, moving, bar);
    return true;
  }
  for (int k = 0; k < 3; ++k)
    if (arm.slides[order[k]]) return false;
  // one of the four may stand still for a moment, where it turns back
  gap = INFINITY;
  for (int j = 0; j < kSix; ++j) {
    if (arm.slides[j] || j == order[0] || j == order[1] || j == order[2]) continue;
    int four[4] = {order[0], order[1], order[2], j};
    std::sort(four, four + 4);
    FourBar tried;
    const double missed = close_four(at, four, tried);
    if (missed < gap) gap = missed, bar = tried;
  }
  return gap < INFINITY;
}

}  // namespace pieper::PIEPER_ISA
