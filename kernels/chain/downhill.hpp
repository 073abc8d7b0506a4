// Newton on the distance between a chain's tool and a pose inside limits, with its second derivatives; room for the work is kept from
// posture to posture. Scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "chain/closest.hpp"
#include "chain/rigid.hpp"

namespace pieper::PIEPER_ISA {

inline double larger(double a, double b) { return a > b ? a : b; }

// A symmetric matrix m x m, with what Newton's step needs of it.
struct Bent {
  int m = 0;
  std::vector<double> A, V, L;

  explicit Bent(int most) : A(most * most), V(most * most), L(most * most) {}
  double& at(int i, int j) { return A[i * m + j]; }

  // x solves (|A| + damping largest) x = b. False where A has eigenvalues below zero. A joint that does nothing, as the last one does to
  // a position, leaves a pivot of nothing with nothing beside it.
  bool positive_step(double damping, const double* b, double* x) {
    double most = 0;
    for (int i = 0; i < m; ++i) {
      double sum = 0;
      for (int j = 0; j < m; ++j) sum += std::fabs(A[i * m + j]);
      most = larger(most, sum);
    }
    const double more = (damping + kDescentFlat) * most;
    for (int j = 0; j < m; ++j) {
      double d = A[j * m + j];
      for (int k = 0; k < j; ++k) d -= L[j * m + k] * L[j * m + k];
      const bool flat = !(d > kDescentFlat * most);  // of A itself
      if (flat && !(d > -kDescentFlat * most)) return false;
      d = std::sqrt(larger(d, 0.0) + more);
      L[j * m + j] = d;
      for (int i = j + 1; i < m; ++i) {
        double s = A[i * m + j];
        for (int k = 0; k < j; ++k) s -= L[i * m + k] * L[j * m + k];
        if (flat && std::fabs(s) > kDescentFlat * most) return false;
        L[i * m + j] = s / d;
      }
    }
    for (int i = 0; i < m; ++i) {
      x[i] = b[i];
      for (int k = 0; k < i; ++k) x[i] -= L[i * m + k] * x[k];
      x[i] /= L[i * m + i];
    }
    for (int i = m - 1; i >= 0; --i) {
      for (int k = i + 1; k < m; ++k) x[i] -= L[k * m + i] * x[k];
      x[i] /= L[i * m + i];
    }
    return true;
  }

  // The same by eigenvalues (Jacobi), whatever their signs.
  void step(double damping, const double* b, double* x) {
    std::fill(V.begin(), V.begin() + m * m, 0.0);
    for (int i = 0; i < m; ++i) V[i * m + i] = 1;
    for (int sweep = 0; sweep < 20; ++sweep) {
      double off = 0, all = 0;
      for (int i = 0; i < m; ++i)
        for (int j = 0; j < m; ++j) (i == j ? all : off) += at(i, j) * at(i, j);
      if (off <= kJacobiDone * (off + all)) break;
      // what is left of the others together does not count either
      const double nothing = kJacobiDone * (off + all) / (2 * m * m);
      for (int i = 0; i < m; ++i)
        for (int j = i + 1; j < m; ++j)
          if (at(i, j) * at(i, j) > nothing) turn(i, j);
    }
    double most = 0;
    for (int i = 0; i < m; ++i) most = larger(most, std::fabs(at(i, i)));
    std::fill(x, x + m, 0.0);
    for (int k = 0; k < m; ++k) {
      double part = 0;
      for (int i = 0; i < m; ++i) part += V[k * m + i] * b[i];
      part /= larger(larger(std::fabs(at(k, k)), kDescentFlat * most) + damping * most, kTiny);
      for (int i = 0; i < m; ++i) x[i] += part * V[k * m + i];
    }
  }

 private:
  // Rows are turned as they lie in memory, columns are copied from them; the rows of V become eigenvectors.
  void turn(int i, int j) {
    const double zeta = (at(j, j) - at(i, i)) / (2 * at(i, j));
    const double t = (zeta >= 0 ? 1 : -1) / (std::fabs(zeta) + std::sqrt(1 + zeta * zeta)),
                 c = 1 / std::sqrt(1 + t * t), s = c * t;
    const double first = at(i, i) - t * at(i, j), second = at(j, j) + t * at(i, j);
    double *a = &at(i, 0), *b = &at(j, 0), *v = &V[i * m], *w = &V[j * m];
    for (int k = 0; k < m; ++k) {
      const double x = a[k], y = b[k];
      a[k] = c * x - s * y, b[k] = s * x + c * y;
    }
    for (int k = 0; k < m; ++k) {
      const double x = v[k], y = w[k];
      v[k] = c * x - s * y, w[k] = s * x + c * y;
    }
    for (int k = 0; k < m; ++k) at(k, i) = a[k], at(k, j) = b[k];
    at(i, i) = first, at(j, j) = second, at(i, j) = at(j, i) = 0;
  }
};

class Downhill {
 public:
  const int n;
  // What is missing at the posture that was looked at last: half the square of the way, and 1 - cos of the turn.
  double way = 0, lean = 0;

  Downhill(const DownhillChain& given, const double* T)
      : n(given.n),
        chain(given),
        goal(read_rigid(T, given.length)),
        links(n + 1),
        turns(n),
        moves(n),
        axis(n),
        point(n),
        plain(n),
        slope(n),
        bend(n * n),
        slope_here(n),
        bend_here(n * n),
        b(n),
        x(n),
        tried(n),
        free(n),
        bent(n) {
    for (int k = 0; k <= n; ++k) links[k] = read_rigid(chain.links + 16 * k, chain.length);
    if (!chain.coupling) return;
    C.resize(n * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) C[i * n + j] = chain.coupling[i * n + j] * chain.unit(j) / chain.unit(i);
  }

  // What `nearer` does; `way` and `lean` are those of where it ends.
  double down(double turning, int steps, double* q) {
    clip(q);
    double damping = kDescentDamping, value = expand(q, turning), way_here = way, lean_here = lean;
    slope_here.swap(slope), bend_here.swap(bend);
    for (int taken = 0; taken < steps && damping < kDescentMostDamping; ++taken) {
      int m = 0;
      for (int k = 0; k < n; ++k)
        if (!((q[k] <= chain.lower[k] && slope_here[k] > 0) || (q[k] >= chain.upper[k] && slope_here[k] < 0)))
          free[m++] = k;
      if (m == 0) break;
      bent.m = m;
      for (int i = 0; i < m; ++i) {
        b[i] = slope_here[free[i]];
        for (int j = 0; j < m; ++j) bent.at(i, j) = bend_here[free[i] * n + free[j]];
      }
      if (!bent.positive_step(damping, b.data(), x.data())) bent.step(damping, b.data(), x.data());
      double size = 0;
      for (int i = 0; i < m; ++i) size += x[i] * x[i];
      size = std::sqrt(size);
      if (!(size >= kDescentSettled)) break;
      const double shrink = std::min(1.0, kDescentLongest / size);
      std::copy(q, q + n, tried.begin());
      for (int i = 0; i < m; ++i) tried[free[i]] -= shrink * x[i] * chain.unit(free[i]);
      clip(tried.data());
      const double next = expand(tried.data(), turning);
      if (next < value) {
        std::copy(tried.begin(), tried.end(), q);
        value = next, way_here = way, lean_here = lean;
        slope_here.swap(slope), bend_here.swap(bend);
        damping = larger(damping * kDescentShrink, kDescentLeastDamping);
      } else {
        damping *= kDescentGrow;
      }
    }
    way = way_here, lean = lean_here;
    return value;
  }

  // Gauss's and Newton's damped steps to the position alone, from q (n; left at the best). They crawl where a position is out of
  // reach, but come into narrower valleys than steps of second order. Not for coupled joints.
  void towards_place(const Crawl& how, double* q) {
    clip(q);
    stand(q);
    double damping = how.damping, value = way;
    Vec3 gap = goal.t - end.t;
    std::vector<Vec3>& J = moves;
    std::vector<Vec3>& here = turns;  // the Jacobian at q
    here = J;
    for (int taken = 0; taken < how.steps && damping < kDescentMostDamping && value > how.reached; ++taken) {
      double A[6] = {damping, 0, 0, damping, 0, damping};  // xx xy xz yy yz zz
      int m = 0;
      for (int k = 0; k < n; ++k) {
        const double pull = dot(here[k], gap);
        if ((q[k] <= chain.lower[k] && pull < 0) || (q[k] >= chain.upper[k] && pull > 0)) continue;
        const Vec3 c = here[k];
        free[m++] = k;
        A[0] += c.x * c.x, A[1] += c.x * c.y, A[2] += c.x * c.z, A[3] += c.y * c.y, A[4] += c.y * c.z,
            A[5] += c.z * c.z;
      }
      if (m == 0) break;
      const Vec3 r0 = {A[0], A[1], A[2]}, r1 = {A[1], A[3], A[4]}, r2 = {A[2], A[4], A[5]};
      const Vec3 c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
      const Vec3 y = (1 / larger(dot(r0, c0), kTiny)) * (gap.x * c0 + gap.y * c1 + gap.z * c2);
      double size = 0;
      for (int i = 0; i < m; ++i) x[i] = dot(here[free[i]], y), size += x[i] * x[i];
      size = std::sqrt(size);
      if (!(size >= kDescentSettled)) break;
      const double shrink = std::min(1.0, kDescentLongest / size);
      std::copy(q, q + n, tried.begin());
      for (int i = 0; i < m; ++i) tried[free[i]] += shrink * x[i] * chain.unit(free[i]);
      clip(tried.data());
      stand(tried.data());
      if (way < value) {
        std::copy(tried.begin(), tried.end(), q);
        value = way, gap = goal.t - end.t, here = J;
        damping = larger(damping * how.shrink, kDescentLeastDamping);
      } else {
        damping *= how.grow;
      }
    }
    way = value;
  }

 private:
  const DownhillChain& chain;
  Rigid goal, end{};
  std::vector<Rigid> links;
  std::vector<Vec3> turns, moves, axis, point;
  std::vector<double> plain, slope, bend, slope_here, bend_here, b, x, tried, C;  // n; n x n
  std::vector<int> free;
  Bent bent;

  void clip(double* q) const {
    for (int k = 0; k < n; ++k) q[k] = std::min(larger(q[k], chain.lower[k]), chain.upper[k]);
  }

  // Puts the chain to q (rad; m): the tool, each joint's axis and what it does to the tool's position; `way`.
  void stand(const double* q) {
    for (int k = 0; k < n; ++k) {
      plain[k] = q[k] / chain.unit(k);
      if (chain.coupling) {
        double sum = 0;
        for (int j = 0; j < n; ++j) sum += chain.coupling[k * n + j] * q[j];
        plain[k] = sum / chain.unit(k);
      }
    }
    end = walk(
        n, links[0], [&](int k) -> const Rigid& { return links[k + 1]; },
        [&](int k) { return motion_of(plain[k], chain.prismatic[k]); }, chain.prismatic,
        [&](int k, const Rigid& frame) { axis[k] = frame.z, point[k] = frame.t; });
    for (int k = 0; k < n; ++k) moves[k] = chain.prismatic[k] ? axis[k] : cross(axis[k], end.t - point[k]);
    const Vec3 gap = goal.t - end.t;
    way = dot(gap, gap) / 2;
  }

  // Value at q (rad; m), and slope and second derivative without units.
  double expand(const double* q, double turning) {
    stand(q);
    for (int k = 0; k < n; ++k) turns[k] = chain.prismatic[k] ? Vec3{0, 0, 0} : axis[k];
    const Vec3 gap = goal.t - end.t;
    const double trace = dot(end.x, goal.x) + dot(end.y, goal.y) + dot(end.z, goal.z);
    lean = (3 - trace) / 2;
    const double near = std::isinf(turning) ? 0 : 1, turned = std::isinf(turning) ? 1 : turning;
    const Vec3 skew = -2.0 * sine_between(end, goal);
    for (int i = 0; i < n; ++i) {
      slope[i] = -near * dot(moves[i], gap) + turned * 0.5 * dot(turns[i], skew);
      const Vec3 bent_gap = cross(gap, turns[i]);
      for (int j = i; j < n; ++j) bend[i * n + j] = near * (dot(moves[i], moves[j]) - dot(bent_gap, moves[j]));
      if (turned != 0) {
        // M = R G^T applied from the left: turn_i . M turn_j = sum over columns (turn_i . end_c)(goal_c . turn_j)
        const Vec3 image =
            dot(turns[i], end.x) * goal.x + dot(turns[i], end.y) * goal.y + dot(turns[i], end.z) * goal.z;
        const Vec3 around = turned * 0.5 * (trace * turns[i] - image);
        for (int j = i; j < n; ++j) bend[i * n + j] += dot(around, turns[j]);
      }
      for (int j = i + 1; j < n; ++j) bend[j * n + i] = bend[i * n + j];
    }
    if (chain.coupling) couple();
    return near * way + turned * lean;
  }

  void couple() {
    std::vector<double> s(n, 0.0), half(n * n, 0.0), whole(n * n, 0.0);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) s[j] += slope[i] * C[i * n + j];
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) half[i * n + j] += bend[i * n + k] * C[k * n + j];
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) whole[i * n + j] += C[k * n + i] * half[k * n + j];
    slope = s, bend = whole;
  }
};

}  // namespace pieper::PIEPER_ISA
