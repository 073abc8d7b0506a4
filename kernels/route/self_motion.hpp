// Points of what a pose leaves free, each with proof of what lies around it. Scalar; lengths and slides count in lengths of the arm.
//
// At a point x let B be the pseudo-inverse of the Jacobian J (6 by n), and let |B (J(y) - J(z))| be at most b |y - z| in a ball of
// some radius around x. Then
//   - in a ball of radius 1 / (2 b) the points of the same pose are one curve (n = 7) or x alone (n = 6): the part of y - z
//     across the curve's tangent is B (J(x) - J)(y - z) with a J between, at most half of y - z;
//   - while the pose moves by a twist t, a point near x is carried along by the shortest steps that follow, and these have at a
//     distance r from x a speed of at most |B t| / (1 - b r): B J(y) is the projection on J's rows but for b r.
// This is Newton's and Kantorovich's argument in the form that does not depend on how the pose is measured (Deuflhard 2004, 2.1).
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA {

inline constexpr int kMostCoordinates = 7;
inline constexpr double kTurnAround = 6.283185307179586476925286766559;
// A point with its Jacobian, what bounds it, and the direction of the curve through it.
struct Point {
  double y[kMostCoordinates], tangent[kMostCoordinates];
  double J[6][kMostCoordinates], A[21];  // A: the lower triangle of the Cholesky factor of J J^T
  double B[kMostCoordinates][6];         // pseudo-inverse of J
  double bend, radius;                   // b of above, and where it holds
};

// y of n coordinates on a chain, without units.
class Curves {
 public:
  Curves(int n, const double* links, const std::uint8_t* prismatic, double length) : n(n), links_(n + 1), lever_(n) {
    for (int j = 0; j <= n; ++j) links_[j] = read_rigid(links + 16 * j, length);
    for (int j = 0; j < n; ++j) slides_[j] = prismatic[j];
  }

  const int n;
  bool slides(int j) const { return slides_[j]; }

  // Levers of the joints at most, where slides are at most so long: the links behind, added up.
  void reach(const double* slide) {
    double sum = 0;
    for (int j = n - 1; j >= 0; --j) {
      sum += std::sqrt(dot(links_[j + 1].t, links_[j + 1].t));
      lever_[j] = slides_[j] ? 1.0 : sum;
      if (slides_[j]) sum += slide[j];
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int first = i < j ? i : j, last = i < j ? j : i;
        sideways_[i][j] = slides_[first] || (i == j && slides_[i]) ? 0.0 : lever_[last];
      }
    for (int j = 0; j < n; ++j) {
      double c = 0;
      for (int a = 0; a < n; ++a) c += sideways_[a][j] * sideways_[a][j];
      swing_[j] = std::sqrt(c);
    }
    for (int j = 0; j < n; ++j) {
      double sum = 0;
      for (int i = 0; i < n; ++i) {
        const int first = i < j ? i : j, last = i < j ? j : i;
        const double p = slides_[first] ? 0.0 : std::sqrt(double(first)) * lever_[last] + swing_[last];
        sum += p * p;
      }
      rough_[j] = std::sqrt(sum);
    }
  }

  // Takes y onto a pose by the shortest steps. False where it does not come there, or has lost its grip.
  bool settle(const Rigid& goal, Point& at) const {
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 12; ++step) {
      double e[6];
      look(goal, at, e);
      double left = 0;
      for (double v : e) left += v * v;
      left = std::sqrt(left);
      if (!factor(at)) return false;
      if (left < kFrontLeft) {
        return bound(at);
      }
      if (left > 4 * before) return false;
      before = left;
      back(at, e);
      double d[kMostCoordinates], most = 0;
      for (int j = 0; j < n; ++j) {
        d[j] = 0;
        for (int i = 0; i < 6; ++i) d[j] += at.J[i][j] * e[i];
        most = std::fmax(most, std::fabs(d[j]));
      }
      if (!(most < 0.5)) return false;
      for (int j = 0; j < n; ++j) at.y[j] += d[j];
    }
    return false;
  }

  // The direction of the curve through a point, in the sense of another one.
  void aim(Point& at, const double* like) const {
    double t[kMostCoordinates];
    if (like) {
      across(at, like, t);
    } else {
      double best = -1, u[kMostCoordinates], v[kMostCoordinates];
      for (int c = 0; c < n; ++c) {
        for (int j = 0; j < n; ++j) u[j] = j == c;
        across(at, u, v);
        if (v[c] > best) {
          best = v[c];
          for (int j = 0; j < n; ++j) t[j] = v[j];
        }
      }
    }
    double size = 0;
    for (int j = 0; j < n; ++j) size += t[j] * t[j];
    size = std::sqrt(size);
    for (int j = 0; j < n; ++j) at.tangent[j] = t[j] / size;
  }

 private:
  std::vector<Rigid> links_;
  std::vector<double> lever_;
  bool slides_[kMostCoordinates] = {};
  double sideways_[kMostCoordinates][kMostCoordinates], swing_[kMostCoordinates];  // of columns' linear parts, at most
  double rough_[kMostCoordinates];  // how fast the size of what joints do to a column can change

  using Table = double[kMostCoordinates][kMostCoordinates];

  // The largest singular value of a table of numbers not below zero, or a little more (Collatz and Wielandt).
  // y is where its search begins, all above zero, and what it comes to.
  double size_of(const Table& h, double* y, int turns) const {
    double z[kMostCoordinates], w[kMostCoordinates], most = 0;
    for (int turn = 0; turn < turns; ++turn) {
      most = 0;
      double largest = 0;
      for (int i = 0; i < n; ++i) {
        z[i] = 0;
        for (int j = 0; j < n; ++j) z[i] += h[i][j] * y[j];
      }
      for (int j = 0; j < n; ++j) {
        w[j] = 0;
        for (int i = 0; i < n; ++i) w[j] += h[i][j] * z[i];
        most = std::fmax(most, w[j] / y[j]);
        largest = std::fmax(largest, w[j]);
      }
      if (largest == 0) return 0;
      for (int j = 0; j < n; ++j) y[j] = w[j] / largest + kFrontAboveZero;
    }
    return std::sqrt(most);
  }

  void look(const Rigid& goal, Point& at, double* e) const {
    Vec3 axis[kMostCoordinates], point[kMostCoordinates];
    const Rigid end = walk(
        n, links_[0], [&](int k) { return links_[k + 1]; }, [&](int k) { return motion_of(at.y[k], slides_[k]); },
        slides_, [&](int k, const Rigid& frame) { axis[k] = frame.z, point[k] = frame.t; });
    for (int j = 0; j < n; ++j) {
      double column[6];
      moved_end(axis[j], point[j], slides_[j], end.t, column);
      for (int k = 0; k < 6; ++k) at.J[k][j] = column[k];
    }
    const Vec3 p = goal.t - end.t, w = sine_between(end, goal);
    e[0] = p.x, e[1] = p.y, e[2] = p.z, e[3] = w.x, e[4] = w.y, e[5] = w.z;
  }

  bool factor(Point& at) const {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j <= i; ++j) {
        double sum = 0;
        for (int c = 0; c < n; ++c) sum += at.J[i][c] * at.J[j][c];
        for (int c = 0; c < j; ++c) sum -= at.A[i * (i + 1) / 2 + c] * at.A[j * (j + 1) / 2 + c];
        if (i == j) {
          if (!(sum > kFrontPivot)) return false;
          at.A[i * (i + 1) / 2 + i] = std::sqrt(sum);
        } else {
          at.A[i * (i + 1) / 2 + j] = sum / at.A[j * (j + 1) / 2 + j];
        }
      }
    return true;
  }

  static void back(const Point& at, double* e) {
    for (int i = 0; i < 6; ++i) {
      for (int c = 0; c < i; ++c) e[i] -= at.A[i * (i + 1) / 2 + c] * e[c];
      e[i] /= at.A[i * (i + 1) / 2 + i];
    }
    for (int i = 5; i >= 0; --i) {
      for (int c = i + 1; c < 6; ++c) e[i] -= at.A[c * (c + 1) / 2 + i] * e[c];
      e[i] /= at.A[i * (i + 1) / 2 + i];
    }
  }

  void across(const Point& at, const double* u, double* t) const {
    double e[6];
    for (int i = 0; i < 6; ++i) {
      e[i] = 0;
      for (int j = 0; j < n; ++j) e[i] += at.J[i][j] * u[j];
    }
    back(at, e);
    for (int j = 0; j < n; ++j) {
      t[j] = u[j];
      for (int i = 0; i < 6; ++i) t[j] -= at.J[i][j] * e[i];
    }
  }

  // The Jacobian's column j changes with joint i by z x v and z x w, z the axis of the earlier of both and v, w the linear and
  // turning part of the later's column; w changes with the joints before it only.
  bool bound(Point& at) const {
    double linear = 0, turning = 0;
    for (int j = 0; j < n; ++j) {
      double e[6];
      for (int i = 0; i < 6; ++i) e[i] = at.J[i][j];
      back(at, e);
      for (int i = 0; i < 6; ++i) {
        at.B[j][i] = e[i];
        (i < 3 ? linear : turning) += e[i] * e[i];
      }
    }
    linear = std::sqrt(linear);
    turning = std::sqrt(turning);
    if (!(linear + turning < kFrontLoose)) return false;
    Table h;
    double lever[kMostCoordinates], column[kMostCoordinates] = {};
    for (int j = 0; j < n; ++j)
      lever[j] = std::sqrt(at.J[0][j] * at.J[0][j] + at.J[1][j] * at.J[1][j] + at.J[2][j] * at.J[2][j]);
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j) {
        const Vec3 z = {at.J[3][i], at.J[4][i], at.J[5][i]}, v = {at.J[0][j], at.J[1][j], at.J[2][j]},
                   w = {at.J[3][j], at.J[4][j], at.J[5][j]}, p = cross(z, v), o = cross(z, w);
        double early = 0, late = 0;  // what joint i does to column j, and j to i
        for (int c = 0; c < n; ++c) {
          const double* b = at.B[c];
          const double a = b[0] * p.x + b[1] * p.y + b[2] * p.z, t = b[3] * o.x + b[4] * o.y + b[5] * o.z;
          early += (a + t) * (a + t);
          late += a * a;
        }
        h[i][j] = std::sqrt(early);
        h[j][i] = std::sqrt(late);
        const double square = dot(p, p);
        column[j] += square;
        if (i != j) column[i] += square;
      }
    double y[kMostCoordinates];
    for (int j = 0; j < n; ++j) y[j] = 1;
    const double here = size_of(h, y, 3);
    double radius = 0.5 / std::fmax(here, 0.1);
    for (int turn = 0; turn < 2; ++turn) {
      // in the whole ball: axes turn with the joints before them, columns with all
      Table wider;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const int first = i < j ? i : j, last = i < j ? j : i;
          const double swing = std::fmin(swing_[last], std::sqrt(column[last]) + radius * rough_[last]),
                       v = std::fmin(lever_[last], lever[last] + radius * swing),
                       p = slides_[first] ? 0.0 : std::sqrt(double(first)) * v + swing,
                       w = i < j && !slides_[i] && !slides_[j] ? std::sqrt(double(i)) + std::sqrt(double(j)) : 0.0;
          wider[i][j] = h[i][j] + radius * (linear * p + turning * w);
        }
      at.bend = size_of(wider, y, 1) / kFrontSafe;
      if (turn == 0) radius = std::fmin(radius, 0.5 / at.bend);
    }
    at.radius = radius;
    return true;
  }
};

}  // namespace pieper::PIEPER_ISA
