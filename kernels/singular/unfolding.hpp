// The equation that is left of a pose where one direction of the joints is free to first order: its order is a root's multiplicity. Scalar.
//
// In all pose directions that the Jacobian reaches, the pose is solved along the weakest joint direction t, by power series
// (Lyapunov and Schmidt's reduction; Golubitsky and Schaeffer, 1985). What remains is c0 + c1 t + c2 t^2 + ..., one coefficient a
// pose direction that is not reached. A root of multiplicity m is where all below c_m vanish. Rounding turns it into m roots about
// it, some (rounding / c_m)^(1/m) away, but hardly moves the one place where c_(m-1) vanishes: that is the root, to the last digits.
#pragma once

#include <complex>
#include <vector>

#include "singular/six.hpp"

namespace pieper::PIEPER_ISA {

// How many roots of c[0] + c[1] t + ... + c[4] t^4 lie nearer to zero than `within`; vanishing leading coefficients are left out.
inline int roots_within(const double* c, double within) {
  int degree = 4;
  while (degree > 0 && c[degree] == 0) --degree;
  if (degree == 0) return 0;
  std::complex<double> t[4];
  for (int k = 0; k < degree; ++k) t[k] = std::pow(std::complex<double>(0.4, 0.9), k);
  // all roots at once (Durand 1960, Kerner 1966), in units of a root's largest size
  double size = 0;
  for (int k = 0; k < degree; ++k) size = std::fmax(size, std::pow(std::fabs(c[k] / c[degree]), 1.0 / (degree - k)));
  if (size == 0) return degree;
  double a[5];
  for (int k = 0; k <= degree; ++k) a[k] = c[k] / c[degree] * std::pow(size, k - degree);
  for (int i = 0; i < 200; ++i) {
    double most = 0;
    for (int k = 0; k < degree; ++k) {
      std::complex<double> value = a[degree], others = 1;
      for (int j = degree - 1; j >= 0; --j) value = value * t[k] + a[j];
      for (int j = 0; j < degree; ++j)
        if (j != k) others *= t[k] - t[j];
      if (std::abs(others) == 0) others = kRootsCoincide;
      const std::complex<double> step = value / others;
      t[k] -= step;
      most = std::fmax(most, std::abs(step));
    }
    if (most < kRootsFound) break;
  }
  int count = 0;
  for (int k = 0; k < degree; ++k) count += std::abs(t[k]) * size < within;
  return count;
}

// A chain whose axes move by themselves, or are moved by fewer joints: axes = mixed joints. Lengths in units of the arm.
struct UnfoldedChain {
  int axes, joints;            // joints <= 6
  const Rigid* links;          // axes + 1
  const std::uint8_t* slides;  // axes
  const double* mixed;         // axes x joints, row-major; none where joint k is axis k
};

// A root as its equation tells it.
struct Unfolded {
  double q[6];
  int branches;  // as many roots are one
  double blur;   // how far from it rounding lets one of them be; 0 where that is not told
};

class Unfolding {
 public:
  static constexpr int kOrder = 8, kMostSteps = 8;

  Unfolding(const UnfoldedChain& chain, const Rigid& T)
      : chain_(chain),
        T_(T),
        rounding_(kMergedRounding * (1 + std::sqrt(dot(T.t, T.t)))),
        frame_((chain.axes + 1) * kCoefficients),
        cosine_(chain.axes * kCoefficients),
        sine_(chain.axes * kCoefficients),
        value_(chain.axes * kCoefficients) {}

  // The root about q (rad; lengths), where branches are nearer together than `same` or rounding cannot tell them apart.
  Unfolded root(const double* q, double same) {
    Unfolded out{{}, 1, 0};
    std::copy(q, q + chain_.joints, out.q);
    if (!expand(q)) {
      const double scattered = centred(out.q);
      out.branches = 1 << free_, out.blur = 3 * std::fmax(scattered, 0.0);
      if (scattered >= 0 || free_ > 2) return out;
      expand(q, true);
    }
    bool near[kOrder];
    double least = INFINITY;
    for (int m = 1; m < kOrder; ++m) near[m] = m > 1 && in_reach(m, centre(m)), least = std::fmin(least, blur_of(m));
    // as far apart what is missed between two of them is as much as roots that are one may miss
    const double nearer = std::fmax(same, 2 * std::sqrt(kUnfoldingRounding) * least);
    const int simple = roots_nearer(nearer);
    for (int m = kOrder - 1; m > 1; --m)
      if (near[m] && merged(q, m, out)) return out;
    std::copy(q, q + chain_.joints, out.q);
    out.branches = std::max(1, simple), out.blur = out.branches > 1 ? nearer : 0;
    return out;
  }

 private:
  static constexpr int kCoefficients = kOrder + 1;
  static constexpr double kCentreHolds = 3.0;  // times rounding: what is held as well as its root

  // How far from zero rounding alone lets a root of c_k t^k be.
  double blur_of(int k) const { return std::pow(rounding_ / std::fmax(size_[k], kTiny), 1.0 / k); }
  // Where the coefficient below c_m vanishes, to first order.
  double centre(int m) const { return -along(m, m - 1) / (m * std::fmax(size_[m], kTiny)); }
  bool in_reach(int m, double t) const {
    const double blur = blur_of(m);
    return blur < kUnfoldingWidest && std::fabs(t) < kUnfoldingReach * blur;
  }

  // Whether m roots about q are one to rounding: it is put where the coefficient below c_m vanishes.
  bool merged(const double* q, int m, Unfolded& out) {
    std::copy(q, q + chain_.joints, out.q);
    double gone = 0, before = INFINITY;
    const bool at_most = free_ > 1;
    for (int step = 0; step < kMostSteps; ++step) {
      if (!expand(out.q, at_most)) return false;
      const double t = centre(m);
      gone += std::fabs(t);
      if (!in_reach(m, gone)) return false;
      if (std::fabs(t) < kUnfoldingFound || !(std::fabs(t) < 0.5 * before)) break;
      before = std::fabs(t);
      for (int i = 0; i < chain_.joints; ++i) {
        double x = 0;
        for (int k = kOrder; k >= 0; --k) x = x * t + way_[k][i];
        out.q[i] = x;
      }
    }
    const double blur = blur_of(m);
    for (int k = 0; k < m; ++k)
      if (size_[k] * std::pow(blur, k) > kUnfoldingRounding * rounding_) return false;
    std::copy(way_[0], way_[0] + chain_.joints, out.q);
    out.branches = m, out.blur = 3 * blur;
    return true;
  }

  // Puts q, where several directions are free, at the place about which rounding scatters their root: there the Jacobian lacks them to the
  // last digits. Returns how far it scatters them; otherwise q is as it was: 0 where no such place is told, less where that place, or half way
  // there, misses the pose by more than rounding. Then q is a root of its own, or of fewer, next to where several directions are free.
  double centred(double* q) {
    const int n = chain_.joints, strong = n - free_;
    double at[6], gone = 0;
    bool apart = false;  // as a fold's two roots are, in the direction that is least free
    std::copy(q, q + n, at);
    for (int step = 0; step < kMostSteps; ++step) {
      double J[6][6], e[6], t[6], size = 0;
      jacobian(at, J), missing(0, e);
      const SingularSix d(J);
      bends(d, at);
      if (!to_centre(d, J, t)) return 0;
      for (int a = 0; a < free_; ++a) size += t[a] * t[a];
      size = std::sqrt(size), gone += size;
      if (!(gone < kUnfoldingWidest)) return 0;
      apart = d.s[strong] > 2 * std::sqrt(rounding_ * bent());
      for (int i = 0; i < n; ++i)
        for (int a = 0; a < free_; ++a) at[i] += t[a] * d.joint[strong + a][i];
      reach(d, e, strong, n, at);
      if (size < kUnfoldingFound) break;
    }
    // where Newton's method has stalled on the way to q what q itself misses is no more than rounding either
    const double holds = kCentreHolds * rounding_;
    double between[6];
    for (int i = 0; i < n; ++i) between[i] = q[i] + 0.5 * (at[i] - q[i]);
    if (apart || !(missed(at) < holds) || !(missed(between) < std::fmax(holds, missed(q)))) return -1;
    std::copy(at, at + n, q);
    return gone;
  }
  // What the direction that is least free misses to second order.
  double bent() const {
    double sum = 0;
    for (int r = chain_.joints - free_; r < 6; ++r) sum += bend_[0][0][r] * bend_[0][0][r];
    return std::sqrt(sum);
  }
  double missed(const double* q) {
    double J[6][6], e[6], sum = 0;
    jacobian(q, J), missing(0, e);
    for (double x : e) sum += x * x;
    return std::sqrt(sum);
  }
  void jacobian(const double* q, double (*J)[6]) {
    std::copy(q, q + chain_.joints, way_[0]);
    set(0), coefficient(0);
    std::fill(&J[0][0], &J[0][0] + 36, 0.0);
    columns(J);
  }
  // How what the Jacobian does along one free direction changes along another, in the pose directions that are not reached.
  void bends(const SingularSix& d, const double* q) {
    const int n = chain_.joints, strong = n - free_;
    for (int a = 0; a < free_; ++a) {
      double sides[2][6][6], there[6];
      for (int side = 0; side < 2; ++side) {
        for (int i = 0; i < n; ++i)
          there[i] = q[i] + (side ? kUnfoldingAcross : -kUnfoldingAcross) * d.joint[strong + a][i];
        jacobian(there, sides[side]);
      }
      for (int b = 0; b < free_; ++b)
        for (int r = strong; r < 6; ++r) {
          double sum = 0;
          for (int i = 0; i < n; ++i)
            for (int c = 0; c < 6; ++c)
              sum += d.pose[r][c] * (sides[1][i][c] - sides[0][i][c]) * d.joint[strong + b][i];
          bend_[b][a][r] = sum / (2 * kUnfoldingAcross);
        }
    }
  }
  // The way t along the free directions to where the Jacobian J lacks them most nearly, by least squares; false where that is not told.
  // What it does along one is not its singular value times a direction of the pose: of values that are rounding those are any.
  bool to_centre(const SingularSix& d, const double (*J)[6], double* t) const {
    const int k = free_, strong = chain_.joints - k;
    double A[6][7] = {};
    for (int b = 0; b < k; ++b)
      for (int r = strong; r < 6; ++r) {
        double lacks = 0;
        for (int i = 0; i < chain_.joints; ++i)
          for (int c = 0; c < 6; ++c) lacks += d.pose[r][c] * J[i][c] * d.joint[strong + b][i];
        for (int i = 0; i < k; ++i) {
          for (int j = 0; j < k; ++j) A[i][j] += bend_[b][i][r] * bend_[b][j][r];
          A[i][k] -= bend_[b][i][r] * lacks;
        }
      }
    for (int i = 0; i < k; ++i) {
      int best = i;
      for (int r = i + 1; r < k; ++r)
        if (std::fabs(A[r][i]) > std::fabs(A[best][i])) best = r;
      if (!(std::fabs(A[best][i]) > kUnfoldingNoBend * kUnfoldingNoBend)) return false;
      if (best != i) std::swap_ranges(A[best], A[best] + 7, A[i]);
      for (int r = 0; r < k; ++r) {
        if (r == i) continue;
        const double part = A[r][i] / A[i][i];
        for (int c = i; c <= k; ++c) A[r][c] -= part * A[i][c];
      }
    }
    for (int i = 0; i < k; ++i) t[i] = A[i][k] / A[i][i];
    return true;
  }

  // c_k along the direction of c_m.
  double along(int m, int k) const {
    double sum = 0;
    for (int r = 0; r < open_; ++r) sum += left_[m][r] * left_[k][r];
    return sum / std::fmax(size_[m], kTiny);
  }

  int roots_nearer(double within) const {
    // orders above the fourth count nothing so near; what is of no size at this distance is none
    double c[5], most = 0;
    int main = 1;
    for (int k = 1; k < 5; ++k) {
      const double at = size_[k] * std::pow(within, k);
      if (at > most) most = at, main = k;
    }
    c[0] = 0;
    for (int k = 1; k < 5; ++k) c[k] = along(main, k);
    return roots_within(c, within);
  }

  // Fills the series about q; false where several directions are free: each is left to second order at least, and equations of second
  // order in k unknowns have 2^k roots. Where it is known that these stand apart, one is free `at_most`.
  bool expand(const double* q, bool at_most = false) {
    const int n = chain_.joints;
    std::copy(q, q + n, way_[0]);
    set(0), coefficient(0);
    double J[6][6] = {};
    columns(J);
    const SingularSix d(J);
    free_ = 0;
    for (int k = 0; k < n; ++k) free_ += !(d.s[k] > kOneWayFree * d.s[0]);
    if (free_ > 1 && !at_most) return false;
    open_ = 7 - n;
    std::copy(d.joint[n - 1], d.joint[n - 1] + n, way_[1]);
    double e[6];
    // onto the pose in what is reached, and then order by order
    missing(0, e);
    reach(d, e, way_[0]);
    set(0), coefficient(0), missing(0, e), leave(d, e, 0);
    for (int k = 1; k <= kOrder; ++k) {
      if (k > 1) std::fill(way_[k], way_[k] + n, 0.0);
      set(k), coefficient(k), missing(k, e), leave(d, e, k);
      if (k == 1) continue;
      reach(d, e, way_[k]);
      set(k), coefficient(k);
    }
    return true;
  }

  // Adds the shortest joint step that makes up for e in all but the weakest direction.
  void reach(const SingularSix& d, const double* e, double* step) const {
    reach(d, e, chain_.joints - 1, chain_.joints, step);
  }
  static void reach(const SingularSix& d, const double* e, int strong, int joints, double* step) {
    for (int k = 0; k < strong; ++k) {
      double part = 0;
      for (int r = 0; r < 6; ++r) part += d.pose[k][r] * e[r];
      for (int i = 0; i < joints; ++i) step[i] += part / d.s[k] * d.joint[k][i];
    }
  }
  void leave(const SingularSix& d, const double* e, int k) {
    double sum = 0;
    for (int r = 0; r < open_; ++r) {
      double part = 0;
      for (int i = 0; i < 6; ++i) part += d.pose[chain_.joints - 1 + r][i] * e[i];
      left_[k][r] = part, sum += part * part;
    }
    size_[k] = std::sqrt(sum);
  }

  // Coefficient k of the axes' values and their cosines and sines.
  void set(int k) {
    for (int a = 0; a < chain_.axes; ++a) {
      double* x = &value_[a * kCoefficients];
      x[k] = 0;
      for (int i = 0; i < chain_.joints; ++i)
        x[k] += (chain_.mixed ? chain_.mixed[a * chain_.joints + i] : a == i ? 1.0 : 0.0) * way_[k][i];
      if (chain_.slides[a]) continue;
      double *c = &cosine_[a * kCoefficients], *s = &sine_[a * kCoefficients];
      if (k == 0) {
        c[0] = std::cos(x[0]), s[0] = std::sin(x[0]);
        continue;
      }
      c[k] = s[k] = 0;
      for (int i = 1; i <= k; ++i) c[k] -= i * x[i] * s[k - i] / k, s[k] += i * x[i] * c[k - i] / k;
    }
  }
  // Coefficient k of all frames.
  void coefficient(int k) {
    const Rigid none = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    frame_[k] = k ? none : chain_.links[0];
    for (int a = 0; a < chain_.axes; ++a) {
      const Rigid* before = &frame_[a * kCoefficients];
      Rigid now = none;
      now.z = before[k].z, now.t = before[k].t;
      if (chain_.slides[a]) now.x = before[k].x, now.y = before[k].y;
      for (int i = 0; i <= k; ++i) {
        if (chain_.slides[a]) {
          now.t = now.t + value_[a * kCoefficients + i] * before[k - i].z;
          continue;
        }
        const double c = cosine_[a * kCoefficients + i], s = sine_[a * kCoefficients + i];
        now.x = now.x + c * before[k - i].x + s * before[k - i].y;
        now.y = now.y + c * before[k - i].y - s * before[k - i].x;
      }
      frame_[(a + 1) * kCoefficients + k] = now * chain_.links[a + 1];
    }
  }
  // Coefficient k of what is missing: way, and sine of the turn.
  void missing(int k, double* e) const {
    const Rigid& end = frame_[chain_.axes * kCoefficients + k];
    const Vec3 p = (k ? Vec3{0, 0, 0} : T_.t) - end.t, w = sine_between(end, T_);
    e[0] = p.x, e[1] = p.y, e[2] = p.z, e[3] = w.x, e[4] = w.y, e[5] = w.z;
  }
  void columns(double (*J)[6]) const {
    const Vec3 end = frame_[chain_.axes * kCoefficients].t;
    for (int a = 0; a < chain_.axes; ++a) {
      const Rigid& before = frame_[a * kCoefficients];
      double column[6];
      moved_end(before.z, before.t, chain_.slides[a], end, column);
      for (int i = 0; i < chain_.joints; ++i) {
        const double by = chain_.mixed ? chain_.mixed[a * chain_.joints + i] : a == i ? 1.0 : 0.0;
        for (int r = 0; r < 6; ++r) J[i][r] += by * column[r];
      }
    }
  }

  UnfoldedChain chain_;
  Rigid T_;
  double rounding_;
  std::vector<Rigid> frame_;                   // [axis][coefficient], before the axis moves; the end last
  std::vector<double> cosine_, sine_, value_;  // [axis][coefficient]
  double way_[kCoefficients][6];               // of the joints
  double left_[kCoefficients][6], size_[kCoefficients];
  double bend_[6][6][6];  // [free joint direction][along which][pose direction]
  int open_ = 1, free_ = 1;
};

inline Unfolded unfolded(const SixJoints& arm, const Rigid& T, const double* q) {
  std::uint8_t slides[6];
  for (int i = 0; i < kSix; ++i) slides[i] = arm.slides[i];
  return Unfolding({kSix, kSix, arm.links, slides, nullptr}, T).root(q, kMergedSame);
}

}  // namespace pieper::PIEPER_ISA
