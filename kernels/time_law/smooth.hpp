// A profile of the path's parameter evened out over a window of time, and split where the curve's pieces meet.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "time_law/timed_path.hpp"

namespace pieper {

// Rounds in which a crossing is met; halvings alone would take this many.
constexpr int kCrossingRounds = 60;

// s(t) in pieces of third degree: t (pieces + 1), c (pieces x 4) s, its rate, second and third derivative at the beginning.
struct Profile {
  std::vector<double> t, c;

  long pieces() const { return static_cast<long>(t.size()) - 1; }
  double duration() const { return t.back(); }
};

// Walks along a profile, forward.
class Walk {
 public:
  explicit Walk(const Profile& profile) : p_(profile) {}

  // s and its first three derivatives at a time that is not before the last one asked for
  void at(double time, double out[4]) {
    while (i_ + 1 < p_.pieces() && time >= p_.t[i_ + 1]) ++i_;
    const double *c = &p_.c[4 * i_], tau = time - p_.t[i_];
    out[0] = c[0] + tau * (c[1] + tau * (c[2] / 2 + tau * c[3] / 6));
    out[1] = c[1] + tau * (c[2] + tau * c[3] / 2);
    out[2] = c[2] + tau * c[3];
    out[3] = c[3];
  }
  long piece() const { return i_; }

 private:
  const Profile& p_;
  long i_ = 0;
};

// Times without those that follow another by rounding alone (`moment`, of the whole duration); the last one is the end.
inline void one_moment_each(std::vector<double>& t, double end, double moment) {
  size_t kept = 1;
  for (size_t i = 1; i < t.size(); ++i)
    if (t[i] - t[i - 1] > moment * end) t[kept++] = t[i];
  t.resize(kept);
  t.back() = end;
}

// The profile averaged over the window of time before each moment; it lasts longer by the window. Its pieces are cubic where
// the given ones are quadratic: ds/dt becomes (s(t) - s(t - window)) / window, and so on.
inline Profile evened(const Profile& p, double window, double moment) {
  const double T = p.duration(), w = window;
  const long m = p.pieces();
  std::vector<double> area(m + 1, 0.0);
  for (long i = 0; i < m; ++i) {
    const double *c = &p.c[4 * i], h = p.t[i + 1] - p.t[i];
    area[i + 1] = area[i] + h * (c[0] + h * (c[1] / 2 + h * (c[2] / 6 + h * c[3] / 24)));
  }
  Walk last(p);
  double finish[4];
  last.at(T, finish);
  const double end = finish[0];

  Profile out;
  out.t.resize(2 * (m + 1));
  std::vector<double> later(p.t);
  for (double& t : later) t += w;
  std::merge(p.t.begin(), p.t.end(), later.begin(), later.end(), out.t.begin());
  one_moment_each(out.t, T + w, moment);

  // the integral of s up to a time, s, and its first two derivatives; before and behind the profile s stands
  struct Sums {
    const Profile& p;
    const std::vector<double>& area;
    double end;
    Walk walk;
    void at(double time, double sums[4]) {
      const double T = p.duration();
      if (time < 0 || time >= T) {
        sums[0] = time < 0 ? 0.0 : area.back() + end * (time - T);
        sums[1] = time < 0 ? 0.0 : end;
        sums[2] = sums[3] = 0.0;
        return;
      }
      double s[4];
      walk.at(time, s);
      const long i = walk.piece();
      const double *c = &p.c[4 * i], tau = time - p.t[i];
      sums[0] = area[i] + tau * (c[0] + tau * (c[1] / 2 + tau * (c[2] / 6 + tau * c[3] / 24)));
      for (int k = 0; k < 3; ++k) sums[k + 1] = s[k];
    }
  };
  Sums now{p, area, end, Walk(p)}, before{p, area, end, Walk(p)};
  const long pieces = out.pieces();
  out.c.resize(4 * pieces);
  double a[4], b[4];
  for (long i = 0; i < pieces; ++i) {
    now.at(out.t[i], a), before.at(out.t[i] - w, b);
    for (int k = 0; k < 3; ++k) out.c[4 * i + k] = (a[k] - b[k]) / w;
    // the bend on a piece is that of its middle: at its ends two pieces meet
    const double middle = (out.t[i] + out.t[i + 1]) / 2;
    now.at(middle, a), before.at(middle - w, b);
    out.c[4 * i + 3] = (a[3] - b[3]) / w;
  }
  return out;
}

// A profile that never goes back, split where it passes the ends of the curve's pieces too.
inline Profile split_at(const Profile& p, const CubicPieces& curve, double moment) {
  std::vector<double> crossings;
  crossings.reserve(curve.cells);
  long i = 0;
  for (long k = 1; k < curve.cells; ++k) {
    while (i + 1 < p.pieces() && curve.s[k] >= p.c[4 * (i + 1)]) ++i;
    const double* c = &p.c[4 * i];
    double low = 0, high = p.t[i + 1] - p.t[i], tau = high / 2;
    // Newton kept between what is known to be before and behind
    for (int round = 0; round < kCrossingRounds && low < high; ++round) {
      const double off = c[0] + tau * (c[1] + tau * (c[2] / 2 + tau * c[3] / 6)) - curve.s[k];
      const double rate = c[1] + tau * (c[2] + tau * c[3] / 2);
      (off < 0 ? low : high) = tau;
      double next = rate > 0 ? tau - off / rate : low;
      if (!(next > low && next < high)) next = (low + high) / 2;
      if (next == tau) break;
      tau = next;
    }
    crossings.push_back(p.t[i] + tau);
  }
  Profile out;
  out.t.resize(p.t.size() + crossings.size());
  std::sort(crossings.begin(), crossings.end());
  std::merge(p.t.begin(), p.t.end(), crossings.begin(), crossings.end(), out.t.begin());
  one_moment_each(out.t, p.duration(), moment);
  out.c.resize(4 * out.pieces());
  Walk walk(p);
  for (long k = 0; k < out.pieces(); ++k) walk.at(out.t[k], &out.c[4 * k]);
  return out;
}

}  // namespace pieper
