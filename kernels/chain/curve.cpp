// The work of `follow_curve`. Compiled once, for the plainest processor.
#include "chain/curve.hpp"

#include <algorithm>
#include <cmath>

#include "chain/rigid.hpp"

namespace pieper {
namespace {

using namespace PIEPER_ISA;

constexpr int kNewtonSteps = 12;
constexpr double kTooFar = 1.0;        // a Newton step that is longer leads elsewhere, rad or lengths
constexpr double kWeakest = 1e-9;      // directions weaker than this part of the strongest are not corrected in
constexpr double kFree = 1e-7;         // singular values below this part of the largest leave their direction free
constexpr double kShortest = 1e-5;     // a curve ends where a step shorter than this does not go on
constexpr double kGrow = 1.3;          // by how much a step grows after one that went well
constexpr double kHome = 0.75;         // of a step: so near to where it began a curve is home,
constexpr double kAlong = 0.9;         // if it comes home along itself and not across
constexpr double kRoundedHome = 1e-9;  // rad; lengths

double dot_of(const double* a, const double* b, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}
double size_of(const double* a, int n) { return std::sqrt(dot_of(a, a, n)); }

// Rows (r x n, r up to 7) turned among each other until they are orthogonal (one-sided Jacobi): each is then a singular value
// times its joint direction, and what is asked of the rows is turned along.
struct Rows {
  int r, n;
  std::vector<double> A;
  double b[7];

  double* row(int i) { return &A[i * n]; }

  void diagonalise() {
    bool turned = true;
    for (int sweep = 0; sweep < 30 && turned; ++sweep) {
      turned = false;
      for (int i = 0; i < r; ++i)
        for (int j = i + 1; j < r; ++j) turned |= turn(i, j);
    }
  }
  double largest() {
    double most = 0;
    for (int i = 0; i < r; ++i) most = std::fmax(most, size_of(row(i), n));
    return most;
  }

 private:
  bool turn(int i, int j) {
    double *x = row(i), *y = row(j);
    const double a = dot_of(x, x, n), c = dot_of(y, y, n), d = dot_of(x, y, n);
    if (d * d <= kOrthogonal * kOrthogonal * a * c || d == 0) return false;
    const double zeta = (c - a) / (2 * d), t = (zeta >= 0 ? 1 : -1) / (std::fabs(zeta) + std::sqrt(1 + zeta * zeta));
    const double cos = 1 / std::sqrt(1 + t * t), sin = cos * t;
    for (int k = 0; k < n; ++k) {
      const double u = x[k], v = y[k];
      x[k] = cos * u - sin * v, y[k] = sin * u + cos * v;
    }
    const double u = b[i], v = b[j];
    b[i] = cos * u - sin * v, b[j] = sin * u + cos * v;
    return true;
  }
};

struct Follower {
  int n;
  double length;
  std::vector<Rigid> links;
  std::vector<std::uint8_t> slides;
  std::vector<Vec3> axis, point;
  Rigid goal, end;
  Rows rows;

  Follower(const FollowedChain& chain, const double* T)
      : n(chain.n),
        length(chain.length),
        links(n + 1),
        slides(chain.prismatic, chain.prismatic + n),
        axis(n),
        point(n),
        goal(read_rigid(T, length)) {
    for (int k = 0; k <= n; ++k) links[k] = read_rigid(chain.links + 16 * k, length);
  }

  // Puts the arm to q (rad; lengths).
  void stand(const double* q) {
    end = walk(
        n, links[0], [&](int k) -> const Rigid& { return links[k + 1]; },
        [&](int k) { return motion_of(q[k], slides[k]); }, slides,
        [&](int k, const Rigid& frame) { axis[k] = frame.z, point[k] = frame.t; });
  }

  // What is missing to the pose: way, then rotation vector; returns its size.
  double missing(double* e) const {
    const Vec3 p = goal.t - end.t;
    Vec3 w = 0.5 * (cross(end.x, goal.x) + cross(end.y, goal.y) + cross(end.z, goal.z));
    const double sine = std::sqrt(dot(w, w));
    const double cosine = 0.5 * (dot(end.x, goal.x) + dot(end.y, goal.y) + dot(end.z, goal.z) - 1);
    if (sine > 1e-150) w = (std::atan2(sine, cosine) / sine) * w;
    else if (cosine < 0) w = {kPi, 0, 0};
    e[0] = p.x, e[1] = p.y, e[2] = p.z, e[3] = w.x, e[4] = w.y, e[5] = w.z;
    return size_of(e, 6);
  }

  // The Jacobian's six rows, and a seventh after them.
  void linearise(const double* e, const double* seventh) {
    rows.n = n, rows.r = seventh ? 7 : 6;
    rows.A.resize(7 * n);
    for (int k = 0; k < n; ++k) {
      const Vec3 v = slides[k] ? axis[k] : cross(axis[k], end.t - point[k]), w = slides[k] ? Vec3{0, 0, 0} : axis[k];
      const double column[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
      for (int i = 0; i < 6; ++i) rows.A[i * n + k] = column[i];
    }
    for (int i = 0; i < 7; ++i) rows.b[i] = e && i < 6 ? e[i] : 0;
    if (seventh) std::copy(seventh, seventh + n, &rows.A[6 * n]);
  }

  // Newton's method onto the pose within the plane across `direction`; false where it does not get there.
  bool onto(double* q, const double* direction) {
    double e[6];
    std::vector<double> step(n);
    for (int taken = 0;; ++taken) {
      stand(q);
      const double size = missing(e);
      if (size < kOnCurve) return true;
      if (taken == kNewtonSteps || !(size < INFINITY)) return false;
      linearise(e, direction);
      rows.diagonalise();
      const double most = rows.largest();
      std::fill(step.begin(), step.end(), 0.0);
      for (int i = 0; i < 7; ++i) {
        const double* row = rows.row(i);
        const double square = dot_of(row, row, n);
        if (!(std::sqrt(square) > kWeakest * most)) continue;
        for (int k = 0; k < n; ++k) step[k] += rows.b[i] / square * row[k];
      }
      if (!(size_of(step.data(), n) <= kTooFar)) return false;
      for (int k = 0; k < n; ++k) q[k] += step[k];
    }
  }

  // The free direction at q nearest to the one of travel: where two curves cross straight on.
  void tangent(const double* q, const double* travel, double* out) {
    stand(q);
    linearise(nullptr, nullptr);
    rows.diagonalise();
    int order[6] = {0, 1, 2, 3, 4, 5};
    double s[6];
    for (int i = 0; i < 6; ++i) s[i] = size_of(rows.row(i), n);
    std::sort(order, order + 6, [&](int a, int b) { return s[a] > s[b]; });
    // of six joints or fewer the weakest direction is the curve's, however strong
    const int ways = std::min(n, 6);
    double free = kFree * s[order[0]];
    if (n <= 6) free = std::fmax(free, s[order[ways - 1]] * (1 + 1e-7));
    std::copy(travel, travel + n, out);
    for (int i = 0; i < ways; ++i) {
      if (s[order[i]] <= free) break;
      const double* row = rows.row(order[i]);
      const double part = dot_of(row, out, n) / (s[order[i]] * s[order[i]]);
      for (int k = 0; k < n; ++k) out[k] -= part * row[k];
    }
    const double size = size_of(out, n);
    if (size > 1e-6)
      for (int k = 0; k < n; ++k) out[k] /= size;
    else std::copy(travel, travel + n, out);
  }

  double way(double to, double from, int k) const {
    const double gap = to - from;
    return slides[k] ? gap : gap - kTwoPi * std::floor((gap + kPi) / kTwoPi);
  }
};

}  // namespace

bool follow_curve(const FollowedChain& chain, const double* T, const double* q, const double* direction,
                  const Following& how, std::vector<double>& points) {
  Follower arm(chain, T);
  const int n = chain.n;
  const auto unit = [&](int k) { return chain.prismatic[k] ? chain.length : 1.0; };
  std::vector<double> first(n), here(n), ahead(n), along(direction, direction + n), next(n), move(n);
  for (int k = 0; k < n; ++k) first[k] = here[k] = q[k] / unit(k);
  points.assign(q, q + n);
  const auto keep = [&](const std::vector<double>& at) {
    for (int k = 0; k < n; ++k) points.push_back(at[k] * unit(k));
  };
  double step = how.step / 2, gone = 0;
  for (int count = 1; count < how.most_steps;) {
    for (int k = 0; k < n; ++k) ahead[k] = here[k] + step * along[k];
    bool good = arm.onto(ahead.data(), along.data());
    for (int k = 0; k < n; ++k) move[k] = ahead[k] - here[k];
    const double went = size_of(move.data(), n);
    good = good && dot_of(move.data(), along.data(), n) > how.straight * went;
    if (!good) {
      step /= 2;
      if (step < kShortest) return false;
      continue;
    }
    gone += went;
    arm.tangent(ahead.data(), along.data(), next.data());
    keep(ahead), ++count;
    for (int k = 0; k < n; ++k) move[k] = arm.way(ahead[k], first[k], k);
    const double size = size_of(move.data(), n);
    if (gone > 3 * step && size < kHome * step &&
        (size < kRoundedHome || std::fabs(dot_of(move.data(), next.data(), n)) > kAlong * size)) {
      // home: the first point once more, as many turns on as the curve went round
      double* last = &points[points.size() - n];
      for (int k = 0; k < n; ++k)
        last[k] = chain.prismatic[k] ? q[k] : q[k] + kTwoPi * std::round((ahead[k] - first[k]) / kTwoPi);
      return true;
    }
    here = ahead, along = next;
    step = std::fmin(how.step, step * kGrow);
  }
  return false;
}

}  // namespace pieper
