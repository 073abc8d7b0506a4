// Curves that hold a pose but for what the weakest direction of a row cannot reach: solutions lie where nothing is missed of that
// either, and all those of poses close beside lie along it too.
//
// A point of the curve is found by Newton's method on the pose bordered by the weakest directions of joints and pose,
//
//   [J left; null' 0] [dq; miss] = [e; 0],
//
// which stays regular where J is singular. The same matrix gives the tangent, the direction that is missed, and how what is missed changes
// along the way: two neighbouring points and their slopes make a cubic, whose roots are the solutions between them. Scalar.
#pragma once

#include <vector>

#include "singular/motions.hpp"

namespace pieper::PIEPER_ISA {

// [J left; null' 0] as a product of triangles, rows exchanged.
class Bordered {
 public:
  Bordered(const double (*J)[6], const double* left, const double* null) {
    for (int r = 0; r < 6; ++r) {
      for (int i = 0; i < 6; ++i) A_[r][i] = J[i][r];
      A_[r][6] = left[r], A_[6][r] = null[r];
    }
    A_[6][6] = 0;
    for (int k = 0; k < 7; ++k) {
      int best = k;
      for (int r = k + 1; r < 7; ++r)
        if (std::fabs(A_[r][k]) > std::fabs(A_[best][k])) best = r;
      from_[k] = best;
      if (best != k) std::swap_ranges(A_[best], A_[best] + 7, A_[k]);
      for (int r = k + 1; r < 7; ++r) {
        A_[r][k] /= A_[k][k];
        for (int c = k + 1; c < 7; ++c) A_[r][c] -= A_[r][k] * A_[k][c];
      }
    }
  }
  double determinant() const {
    double out = 1;
    for (int k = 0; k < 7; ++k) out *= from_[k] == k ? A_[k][k] : -A_[k][k];
    return out;
  }
  void solve(double* b) const {
    for (int k = 0; k < 7; ++k) std::swap(b[k], b[from_[k]]);
    for (int r = 1; r < 7; ++r)
      for (int c = 0; c < r; ++c) b[r] -= A_[r][c] * b[c];
    for (int r = 6; r >= 0; --r) {
      for (int c = r + 1; c < 7; ++c) b[r] -= A_[r][c] * b[c];
      b[r] /= A_[r][r];
    }
  }
  void solve_turned(double* b) const {
    for (int r = 0; r < 7; ++r) {
      for (int c = 0; c < r; ++c) b[r] -= A_[c][r] * b[c];
      b[r] /= A_[r][r];
    }
    for (int r = 6; r >= 0; --r)
      for (int c = r + 1; c < 7; ++c) b[r] -= A_[c][r] * b[c];
    for (int k = 6; k >= 0; --k) std::swap(b[k], b[from_[k]]);
  }

 private:
  double A_[7][7];
  int from_[7];
};

// A point of such a curve (rad; lengths): what is missing there along `left`, and how that changes along `null`.
struct CurvePoint {
  double q[6], null[6], left[6], miss, slope, pivots;  // pivots: determinant of the bordered matrix

  // Brings q onto the curve by steps across `null`; false where that does not succeed.
  bool settle(const SixJoints& arm, const Rigid& T) {
    constexpr int kSteps = 8;
    for (int step = 0; step < kSteps; ++step) {
      const Standing at(arm, q);
      double b[7] = {};
      at.missing(T, b);
      const Bordered A(at.J, left, null);
      A.solve(b);
      double size = 0;
      for (int i = 0; i < kSix; ++i) size += b[i] * b[i], q[i] += b[i];
      if (!(size < 1)) return false;
      if (size > kCurveSettled * kCurveSettled) continue;
      miss = b[6], pivots = A.determinant();
      double along[7] = {0, 0, 0, 0, 0, 0, 1}, missed[7] = {0, 0, 0, 0, 0, 0, 1}, joints = 0, pose = 0;
      A.solve(along), A.solve_turned(missed);
      for (int i = 0; i < 6; ++i) joints += along[i] * along[i], pose += missed[i] * missed[i];
      slope = along[6] / std::sqrt(joints);
      for (int i = 0; i < 6; ++i) null[i] = along[i] / std::sqrt(joints), left[i] = missed[i] / std::sqrt(pose);
      return joints < INFINITY && pose < INFINITY;
    }
    return false;
  }
};

// Places between two points of a curve by their cubic, s from 0 to 1.
struct CurvePiece {
  const CurvePoint &a, &b;
  double length;  // along the curve

  CurvePiece(const SixJoints& arm, const CurvePoint& from, const CurvePoint& to) : a(from), b(to) {
    double square = 0;
    for (int i = 0; i < kSix; ++i) square += std::pow(arm.way(b.q, a.q, i), 2);
    length = std::sqrt(square);
  }
  double miss(double s) const { return cubic(a.miss, b.miss, a.slope, b.slope, s); }
  void point(const SixJoints& arm, double s, double* q) const {
    for (int i = 0; i < kSix; ++i) q[i] = cubic(a.q[i], a.q[i] + arm.way(b.q, a.q, i), a.null[i], b.null[i], s);
  }
  // Places where what is missed vanishes, or is as near to that as `touch` without a change of sign.
  void roots(double touch, std::vector<double>& out) const {
    // as a power series in s: d0 + d1 s + d2 s^2 + d3 s^3
    const double d0 = a.miss, d1 = a.slope * length, rest = b.miss - d0 - d1, bend = b.slope * length - d1,
                 d3 = bend - 2 * rest, d2 = rest - d3;
    double ends[4] = {0};
    int count = 1;
    const double half = d2 * d2 - 3 * d3 * d1;
    if (half >= 0) {
      const double w = -(d2 + std::copysign(std::sqrt(half), d2));
      double turns[2] = {w / (3 * d3), d1 / w};
      if (turns[0] > turns[1]) std::swap(turns[0], turns[1]);
      for (double t : turns)
        if (t > ends[count - 1] && t < 1) ends[count++] = t;
    }
    ends[count++] = 1;
    for (int k = 0; k + 1 < count; ++k) {
      double low = ends[k], high = ends[k + 1];
      const bool rising = miss(low) < 0;
      if (k && std::fabs(miss(low)) <= touch) out.push_back(low);
      if (rising == (miss(high) < 0)) continue;
      for (int step = 0; step < 40; ++step) {
        const double middle = (low + high) / 2;
        (((miss(middle) < 0) == rising) ? low : high) = middle;
      }
      out.push_back((low + high) / 2);
    }
  }

 private:
  double cubic(double x, double y, double dx, double dy, double s) const {
    const double r = 1 - s;
    return r * r * ((1 + 2 * s) * x + s * length * dx) + s * s * ((1 + 2 * r) * y - r * length * dy);
  }
};

// Such a curve, followed both ways until it closes or misses the pose by more than poses beside it are away.
class NearCurve {
 public:
  std::vector<CurvePoint> points;
  bool closed = false;
  Rigid pose = kNoMotion;

  bool follow(const SixJoints& arm, const Rigid& T, CurvePoint start) {
    pose = T;
    if (!start.settle(arm, T)) return false;
    std::vector<CurvePoint> back;
    points.assign(1, start);
    if (!walk(arm, T, points)) return false;
    if (closed) return true;
    for (int i = 0; i < 6; ++i) start.null[i] = -start.null[i];
    start.slope = -start.slope;
    back.assign(1, start);
    if (!walk(arm, T, back)) return false;
    for (CurvePoint& p : back) {
      for (double& x : p.null) x = -x;
      p.slope = -p.slope;
    }
    points.insert(points.begin(), back.rbegin(), back.rend() - 1);
    return true;
  }
  int pieces() const { return static_cast<int>(points.size()) - 1; }
  CurvePiece piece(const SixJoints& arm, int k) const { return {arm, points[k], points[k + 1]}; }

  // How far it holds the pose at a stretch: nowhere, or along some of it, which is left to a slower look, or all along, closed and
  // not crossed by another: where one crosses the determinant changes its sign, or comes near to zero.
  enum class Held { NOWHERE, SOMEWHERE, ALONG };
  Held held(const SixJoints& arm) const {
    double way = 0, longest = 0, most = 0;
    bool all = true, crossed = !closed, slides = false;
    for (const CurvePoint& p : points) most = std::fmax(most, std::fabs(p.pivots)), all &= std::fabs(p.miss) < kOnCurve;
    for (bool one : arm.slides) slides |= one;
    for (int k = 0; k < pieces(); ++k) {
      const CurvePiece piece = this->piece(arm, k);
      const bool on = std::fmax(std::fabs(piece.a.miss), std::fabs(piece.b.miss)) < kOnCurve;
      way = on ? way + piece.length : 0, longest = std::fmax(longest, way);
      crossed |= piece.a.pivots * piece.b.pivots <= 0 || std::fabs(piece.a.pivots) < kCurvesCross * most;
    }
    if (all && !crossed) return Held::ALONG;
    // where joints only turn, what does not hold the pose all along holds it nowhere
    return (all || slides) && longest > kProbe ? Held::SOMEWHERE : Held::NOWHERE;
  }
  // Whether a joint vector lies on it.
  bool holds(const SixJoints& arm, const double* q, double within) const {
    double s, foot[6];
    for (int k = 0; k < pieces(); ++k)
      if (arm.apart(q, points[k].q) < kPieceReach && beside(arm, piece(arm, k), q, within, s, foot)) return true;
    return false;
  }
  // The point that stands for it: inside the limits if any is, and of those the one with the smallest joint values.
  void representative(const SixJoints& arm, const Rigid& T, const Limits& limits, double* q) const {
    double least = INFINITY;
    bool within = false;
    for (const CurvePoint& p : points) {
      double at[6], square = 0;
      bool inside = true;
      for (int i = 0; i < kSix; ++i) {
        at[i] = arm.slides[i] ? p.q[i] : unwound(p.q[i], 0, -INFINITY, INFINITY);
        inside &= turned_inside(at[i], arm.slides[i], limits.lower[i], limits.upper[i]);
        square += at[i] * at[i];
      }
      // rounding makes equal costs unequal: a coarse key first, then the first point
      const double cost = std::nearbyint(std::sqrt(square) / kRowOrderGrid);
      if ((inside && !within) || (inside == within && cost < least))
        least = cost, within = inside, std::copy(at, at + kSix, q);
    }
    pieper::PIEPER_ISA::settle(arm, T, q, 6, kCurveRank);
  }

  // Whether a solution of a pose that is missed by e, of size `far`, is one of this curve that has moved.
  bool leads_to(const SixJoints& arm, const double* a, const double* e, double far) const {
    for (int k = 0; k < pieces(); ++k) {
      if (arm.apart(a, points[k].q) > kPieceReach) continue;
      const CurvePiece piece = this->piece(arm, k);
      double s, foot[6];
      if (!beside(arm, piece, a, kCurveBeside, s, foot)) continue;
      const double missed = piece.miss(s);
      double lean = missed;
      for (int r = 0; r < 6; ++r) lean += e[r] * ((1 - s) * piece.a.left[r] + s * piece.b.left[r]);
      if (std::fabs(lean) <= kAsideAstray * std::fabs(missed) + 4 * kCurveLeans * far) return true;
    }
    return false;
  }

 private:
  static constexpr int kMostPoints = 400;
  static constexpr double kPieceReach = 3 * kCurveStep;
  static constexpr double kPieceStrays = kCurveStep / 4;  // a piece from the curve, at a bend
  static constexpr double kProbe = 0.04, kFirst = 0.02, kGrow = 1.6;

  // The foot of a joint vector on a piece, s there, and whether it is near.
  bool beside(const SixJoints& arm, const CurvePiece& piece, const double* q, double within, double& s,
              double* foot) const {
    s = 0.5;
    for (int turn = 0; turn < 5; ++turn) {
      piece.point(arm, s, foot);
      double along = 0;
      for (int i = 0; i < kSix; ++i) along += arm.way(q, foot, i) * ((1 - s) * piece.a.null[i] + s * piece.b.null[i]);
      if (turn == 4 || std::fabs(along) > 2 * piece.length) break;
      s = std::fmin(std::fmax(s + along / piece.length, -kCurveOver), 1 + kCurveOver);
    }
    const double off = arm.apart(q, foot);
    return off <= within || (off < kPieceStrays && exactly_beside(arm, piece, q, within, s, foot));
  }
  // The same from the curve itself, which bends more sharply than its pieces where two directions are nearly free.
  bool exactly_beside(const SixJoints& arm, const CurvePiece& piece, const double* q, double within, double s,
                      double* foot) const {
    CurvePoint at = s < 0.5 ? piece.a : piece.b;
    std::copy(foot, foot + kSix, at.q);
    for (int turn = 0; turn < 5; ++turn) {
      if (!at.settle(arm, pose) || arm.apart(q, at.q) > 2 * kPieceStrays) return false;
      std::copy(at.q, at.q + kSix, foot);
      double along = 0;
      for (int i = 0; i < kSix; ++i) along += arm.way(q, at.q, i) * at.null[i];
      if (std::fabs(along) < within / 10) break;
      for (int i = 0; i < kSix; ++i) at.q[i] += along * at.null[i];
    }
    return arm.apart(q, foot) <= within;
  }

  // Appends points onwards; false where there are too many.
  bool walk(const SixJoints& arm, const Rigid& T, std::vector<CurvePoint>& to) {
    double step = kFirst, before = 0, last = 0;
    const CurvePoint first = to[0];
    while (static_cast<int>(to.size()) < kMostPoints) {
      const CurvePoint& here = to.back();
      CurvePoint next = here;
      for (int i = 0; i < kSix; ++i) next.q[i] += step * here.null[i];
      double turn = 0, size = 0, kept = 0, third = 0;
      bool good = next.settle(arm, T);
      for (int i = 0; i < 6; ++i) {
        turn += next.null[i] * here.null[i], kept += next.left[i] * here.left[i];
        size += std::pow(next.q[i] - here.q[i], 2);
      }
      size = std::sqrt(size);
      good = good && turn > 0.9 && kept > 0.8 && size > 0.5 * step && size < 2 * step;
      if (good) {
        // what a cubic cannot follow shows in the change of the third difference from piece to piece
        third = next.miss - here.miss - (here.slope + next.slope) * size / 2;
        good = !last || std::fabs(third - before * std::pow(size / last, 3)) < 32 * kCurveTold * kAsideStep;
      }
      if (!good) {
        step /= 2;
        if (step < kNearCurveShortest) return true;
        continue;
      }
      before = third, last = size;
      to.push_back(next);
      if (std::fabs(next.miss) > kCurveMisses || std::fabs(next.slope) > kCurveSteepens) return true;
      step = std::fmin(kCurveStep, step * kGrow);
      double home = 0, ahead = 0, same = 0;
      for (int i = 0; i < kSix; ++i) {
        const double gap = arm.way(first.q, next.q, i);
        home += gap * gap, ahead += gap * next.null[i], same += first.null[i] * next.null[i];
      }
      if (to.size() > 4 && home < step * step && ahead > 0 && same > 0.8) {
        // home: the first point once more, as many turns on as the curve went round
        to.push_back(first);
        for (int i = 0; i < kSix; ++i)
          if (!arm.slides[i]) to.back().q[i] += kTwoPi * std::round((next.q[i] - first.q[i]) / kTwoPi);
        double side = 0;
        for (int r = 0; r < 6; ++r) side += next.left[r] * first.left[r];
        if (side < 0) {
          // the missed direction came home the other way round
          for (double& x : to.back().left) x = -x;
          to.back().miss = -first.miss, to.back().slope = -first.slope;
        }
        closed = true;
        return true;
      }
    }
    return false;
  }
};

}  // namespace pieper::PIEPER_ISA
