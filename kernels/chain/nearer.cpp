// The work of `nearer`. Compiled once, for the plainest processor.
#include "chain/nearer.hpp"

#include <algorithm>
#include <cmath>

#include "chain/rigid.hpp"

namespace pieper {
namespace {

using namespace PIEPER_ISA;

constexpr double kShrink = 0.1, kGrow = 8.0;  // of the damping, where a step helped and where not
constexpr double kLongest = 0.8;              // longest step, rad or lengths

// A symmetric matrix m x m of columns, with what Newton's step needs of it.
struct Bent {
  int m;
  std::vector<double> A, V;
  double& at(int i, int j) { return A[i * m + j]; }

  // x solves (|A| + damping largest) x = b. False where A has eigenvalues below zero.
  bool positive_step(double damping, const std::vector<double>& b, std::vector<double>& x) const {
    double most = 0;
    for (int i = 0; i < m; ++i) {
      double sum = 0;
      for (int j = 0; j < m; ++j) sum += std::fabs(A[i * m + j]);
      most = std::fmax(most, sum);
    }
    std::vector<double> L = A;
    const double more = (damping + kDescentFlat) * most;
    for (int j = 0; j < m; ++j) {
      double d = L[j * m + j];
      for (int k = 0; k < j; ++k) d -= L[j * m + k] * L[j * m + k];
      if (!(d > kDescentFlat * most)) return false;  // of A itself
      d = std::sqrt(d + more);
      L[j * m + j] = d;
      for (int i = j + 1; i < m; ++i) {
        double s = L[i * m + j];
        for (int k = 0; k < j; ++k) s -= L[i * m + k] * L[j * m + k];
        L[i * m + j] = s / d;
      }
    }
    x = b;
    for (int i = 0; i < m; ++i) {
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
  void step(double damping, const std::vector<double>& b, std::vector<double>& x) {
    V.assign(m * m, 0.0);
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
    for (int i = 0; i < m; ++i) most = std::fmax(most, std::fabs(at(i, i)));
    x.assign(m, 0.0);
    for (int k = 0; k < m; ++k) {
      double part = 0;
      for (int i = 0; i < m; ++i) part += V[k * m + i] * b[i];
      part /= std::fmax(std::fmax(std::fabs(at(k, k)), kDescentFlat * most) + damping * most, kTiny);
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

struct Downhill {
  const DownhillChain& chain;
  Rigid goal;
  double turning;
  int n;
  std::vector<Rigid> links;
  std::vector<Vec3> turn, move, axis, point;
  std::vector<double> slope, bend, plain, C;  // n; n x n

  Downhill(const DownhillChain& given, const double* T, double by)
      : chain(given),
        goal(read_rigid(T, given.length)),
        turning(by),
        n(given.n),
        links(n + 1),
        turn(n),
        move(n),
        axis(n),
        point(n),
        slope(n),
        bend(n * n),
        plain(n) {
    for (int k = 0; k <= n; ++k) links[k] = read_rigid(chain.links + 16 * k, chain.length);
    if (!chain.coupling) return;
    C.resize(n * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) C[i * n + j] = chain.coupling[i * n + j] * unit(j) / unit(i);
  }
  double unit(int k) const { return chain.prismatic[k] ? chain.length : 1.0; }

  // Value at q (rad; m), and slope and second derivative without units.
  double expand(const double* q) {
    for (int k = 0; k < n; ++k) {
      plain[k] = q[k] / unit(k);
      if (chain.coupling) {
        double sum = 0;
        for (int j = 0; j < n; ++j) sum += chain.coupling[k * n + j] * q[j];
        plain[k] = sum / unit(k);
      }
    }
    const Rigid end = walk(
        n, links[0], [&](int k) -> const Rigid& { return links[k + 1]; },
        [&](int k) { return motion_of(plain[k], chain.prismatic[k]); }, chain.prismatic,
        [&](int k, const Rigid& frame) { axis[k] = frame.z, point[k] = frame.t; });
    for (int k = 0; k < n; ++k) {
      turn[k] = chain.prismatic[k] ? Vec3{0, 0, 0} : axis[k];
      move[k] = chain.prismatic[k] ? axis[k] : cross(axis[k], end.t - point[k]);
    }
    const Vec3 gap = goal.t - end.t;
    const double trace = dot(end.x, goal.x) + dot(end.y, goal.y) + dot(end.z, goal.z);
    const Vec3 skew = -1.0 * (cross(end.x, goal.x) + cross(end.y, goal.y) + cross(end.z, goal.z));
    const double near = std::isinf(turning) ? 0 : 1, turned = std::isinf(turning) ? 1 : turning;
    for (int i = 0; i < n; ++i) {
      slope[i] = -near * dot(move[i], gap) + turned * 0.5 * dot(turn[i], skew);
      // M = R G^T applied from the left: turn_i . M turn_j = sum over columns (turn_i . end_c)(goal_c . turn_j)
      const Vec3 lean = cross(gap, turn[i]);
      const Vec3 image = dot(turn[i], end.x) * goal.x + dot(turn[i], end.y) * goal.y + dot(turn[i], end.z) * goal.z;
      for (int j = i; j < n; ++j) {
        const double around = 0.5 * (dot(turn[i], turn[j]) * trace - dot(image, turn[j]));
        bend[i * n + j] = bend[j * n + i] = near * (dot(move[i], move[j]) - dot(lean, move[j])) + turned * around;
      }
    }
    if (chain.coupling) couple();
    return near * dot(gap, gap) / 2 + turned * (3 - trace) / 2;
  }

 private:
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

}  // namespace

double nearer(const DownhillChain& chain, const double* T, double turning, int steps, double* q) {
  Downhill hill(chain, T, turning);
  const int n = chain.n;
  for (int k = 0; k < n; ++k) q[k] = std::fmin(std::fmax(q[k], chain.lower[k]), chain.upper[k]);
  double damping = kDescentDamping, value = hill.expand(q);
  std::vector<double> slope = hill.slope, bend = hill.bend, b, x, tried(n);
  std::vector<int> free;
  Bent bent{};
  for (int taken = 0; taken < steps && damping < kDescentMostDamping; ++taken) {
    free.clear();
    for (int k = 0; k < n; ++k)
      if (!((q[k] <= chain.lower[k] && slope[k] > 0) || (q[k] >= chain.upper[k] && slope[k] < 0))) free.push_back(k);
    const int m = bent.m = static_cast<int>(free.size());
    if (m == 0) break;
    b.resize(m), bent.A.resize(m * m);
    for (int i = 0; i < m; ++i) {
      b[i] = slope[free[i]];
      for (int j = 0; j < m; ++j) bent.at(i, j) = bend[free[i] * n + free[j]];
    }
    if (!bent.positive_step(damping, b, x)) bent.step(damping, b, x);
    double size = 0;
    for (double v : x) size += v * v;
    size = std::sqrt(size);
    if (!(size >= kDescentSettled)) break;
    const double shrink = std::fmin(1.0, kLongest / size);
    std::copy(q, q + n, tried.begin());
    for (int i = 0; i < m; ++i) {
      const int k = free[i];
      tried[k] = std::fmin(std::fmax(q[k] - shrink * x[i] * hill.unit(k), chain.lower[k]), chain.upper[k]);
    }
    const double next = hill.expand(tried.data());
    if (next < value) {
      std::copy(tried.begin(), tried.end(), q);
      value = next, slope = hill.slope, bend = hill.bend;
      damping = std::fmax(damping * kShrink, kDescentLeastDamping);
    } else {
      damping *= kGrow;
    }
  }
  return value;
}

}  // namespace pieper
