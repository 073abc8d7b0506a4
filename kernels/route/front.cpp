// The work of `front`. Compiled once, for the plainest processor.
//
// What is reached at a pose is a set of stretches of its curves, each a row of points near enough to each other that nothing of the curve
// lies between them unseen. While the path goes on by a twist of size L, whatever moves along with it inside the limits stays within
// delta of a stretch that reaches past the limits by delta; carried to the next pose it lies on the curves through the carried points.
// Only points are let go on both sides of which the curve, told by its tangent and how far it can bend away, stays outside by
// more than all of that. Nothing is ever added but what hangs together with them.
#include "route/front.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "route/box.hpp"
#include "route/self_motion.hpp"
#include "route/way.hpp"

namespace pieper {
namespace {

using namespace PIEPER_ISA;

// Parts of 1 / bend: the distance of points of a row, and how far a twist may move them to first order.
constexpr double kSpacing = 0.3, kTwist = 0.1;
// Of the distance of points: how far the curve's points may lie from one, and how much farther along the curve it is looked
// for what is inside where points are let go than where a row must have one.
constexpr double kCover = 0.75, kBeyond = 0.5;
// Times b d^2: how far a curve is at a distance d from its tangent. Of the direction at an arc length s the part across is
// at most b s, so that across is at most b s^2 / 2, and s is at most 1.06 d while b d is at most a half.
constexpr double kSag = 0.6;

// After so much of a twist (rad; lengths) at most all rows are at one pose again, and what two of them have in common is kept once.
constexpr double kTogether = 0.05;

// Without proof: what is let go beyond the limits, in distances of points, and the longest move.
constexpr double kRoughly = 0.1, kLongest = 0.3;

struct Row {
  std::vector<Point> points;
  bool closed = false;
  double part = 0;  // of the way to the next pose
};

class Front {
 public:
  explicit Front(const FrontAsked& asked)
      : a(asked),
        rough(asked.fine > 1),
        way{asked},
        curves(asked.n, asked.links, asked.prismatic, asked.length),
        ring(asked.n) {
    std::vector<double> slide(a.n, 0.0), units(a.n, 1.0);
    for (int j = 0; j < a.n; ++j)
      if (curves.slides(j)) units[j] = a.length;
    box.emplace(a.n, a.joints, a.lower, a.upper, units.data());
    for (int j = 0; j < a.n; ++j) {
      ring[j] = !curves.slides(j) && box->free(j);
      if (curves.slides(j)) slide[j] = std::fmax(std::fabs(box->low[j]), std::fabs(box->high[j])) + 0.1;
    }
    curves.reach(slide.data());
  }

  FrontFound run() {
    FrontFound found;
    found.narrowest = std::numeric_limits<double>::infinity();
    std::vector<Point> given;
    for (std::int64_t s = 0; s < a.seeds; ++s) {
      Point p;
      for (int j = 0; j < a.n; ++j) p.y[j] = a.seed[s * a.n + j] / (curves.slides(j) ? a.length : 1.0);
      if (!curves.settle(way.pose(0, 0.0), p)) {
        // what is reached and not known would be lost
        found.end = FrontEnd::SINGULAR;
        return found;
      }
      given.push_back(p);
    }
    found.end = spread(given, way.pose(0, 0.0), found);
    for (std::int64_t k = 0; found.end == FrontEnd::ARRIVED && k + 1 < a.stations; ++k) {
      double t[6];
      const double size = way.twist(k, t);
      const int parts = std::max(1, static_cast<int>(std::ceil(size / kTogether)));
      for (int i = 0; i < parts && found.end == FrontEnd::ARRIVED; ++i) {
        found.rows_at = found.at;
        found.end = onwards(k, double(i) / parts, i + 1 < parts ? double(i + 1) / parts : 1.0, t, size, found);
      }
    }
    if (found.end == FrontEnd::ARRIVED || found.end == FrontEnd::DIED) found.rows_at = found.at;
    for (const Row& row : rows) {
      const std::int64_t count = static_cast<std::int64_t>(row.points.size());
      found.stretch.push_back(row.closed ? -count : count);
      for (const Point& p : row.points) {
        for (int j = 0; j < a.n; ++j) found.q.push_back(p.y[j] * (curves.slides(j) ? a.length : 1.0));
        found.within.push_back(kept(p));
      }
    }
    found.looked = looked;
    return found;
  }

 private:
  const FrontAsked& a;
  const bool rough;
  const Way way;
  Curves curves;
  std::optional<Box> box;
  std::vector<std::uint8_t> ring;
  std::vector<Row> rows, next;
  std::vector<Point> images;
  std::int64_t looked = 0;

  double spacing(const Point& p) const { return kSpacing * a.fine / p.bend; }
  // How far a twist of size one in the direction that the path has moves a point, to first order.
  double speed(const Point& p, const double* t) const {
    double sum = 0;
    for (int j = 0; j < a.n; ++j) {
      double v = 0;
      for (int i = 0; i < 6; ++i) v += p.B[j][i] * t[i];
      sum += v * v;
    }
    return std::sqrt(sum) / kFrontSafe;
  }
  // How far all that moves with the path may come from a point's curve while it moves by `way` to first order.
  double moved_by(const Point& p, double way) const {
    if (rough) return 0;
    const double c = 1 - kCover * kSpacing * a.fine, left = c * c - 4 * p.bend * way;
    return left > 0 ? 2 * way / (c + std::sqrt(left)) : std::numeric_limits<double>::infinity();
  }
  double kept(const Point& p) const {
    if (rough) return kRoughly * spacing(p);
    return spacing(p) + 2.5 * moved_by(p, kTwist * a.fine / p.bend) + kFrontOff;
  }

  // Whether the curve through a point comes, so far to either side of it, to where it may be inside or move inside before
  // the next pose; where nothing is free the point is all there is of it.
  bool inside_within(const Point& p, double far) const {
    if (rough) return box->outside(p.y) <= kept(p);
    const double slack = moved_by(p, kTwist * a.fine / p.bend) + kFrontOff;
    if (a.n == 6) return box->outside(p.y) <= slack;
    far = std::fmin(far, p.radius);
    return box->meets(p.y, p.tangent, far, slack + kSag * p.bend * far * far);
  }
  // A row has at least one such point, or nothing of it is inside.
  bool must_be_kept(const Point& p) const { return inside_within(p, kept(p)); }
  // Others only hang together with these.
  bool may_be_kept(const Point& p) const { return inside_within(p, kept(p) + kBeyond * spacing(p)); }

  double apart(const Point& p, const Point& q) const {
    double sum = 0;
    for (int j = 0; j < a.n; ++j) {
      double d = p.y[j] - q.y[j];
      if (ring[j]) d -= kTurnAround * std::nearbyint(d / kTurnAround);
      sum += d * d;
    }
    return std::sqrt(sum);
  }

  // How far the path may go on at once from a row, in parts of the way to the next pose whose twist is t.
  double allowed(const Row& row, const double* t) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Point& p : row.points) least = std::fmin(least, kTwist * a.fine / (p.bend * speed(p, t)));
    return least * kFrontSafe;
  }

  // Carries the rows from one part of the way between two poses to another, each by its own steps: one that swings fast
  // does not hold up the others. Where one loses its grip all stay as they were.
  FrontEnd onwards(std::int64_t k, double from, double to, const double* t, double size, FrontFound& found) {
    std::vector<Row> going = rows, there;
    for (Row& row : going) row.part = from;
    double latest = from;
    while (!going.empty()) {
      const auto last_of_all =
          std::min_element(going.begin(), going.end(), [](const Row& a, const Row& b) { return a.part < b.part; });
      std::swap(*last_of_all, going.back());
      const Row row = std::move(going.back());
      going.pop_back();
      found.at = k + row.part;
      if (looked > a.most) return FrontEnd::TIRED;
      double step = std::fmin(to - row.part, allowed(row, t));
      if (step * size < kFrontShortest && step < to - row.part) return FrontEnd::SINGULAR;
      if (step > 0.999 * (to - row.part)) step = to - row.part;
      bool carried = false;
      for (int halving = 0; halving < 12 && !carried; ++halving) {
        carried = carry(row, k, step, t);
        if (!carried) step /= 2;
      }
      if (!carried) return FrontEnd::SINGULAR;
      const double part = step == to - row.part ? to : row.part + step;
      latest = std::fmax(latest, part);
      ++found.steps;
      const Rigid at = way.pose(k, part);
      for (Row& grown : next) {
        for (int side = 0; side < 2 && a.n > 6 && !grown.closed; ++side)
          if (!stretch(grown, side == 0, at)) return FrontEnd::SINGULAR;
        for (const Point& p : grown.points) found.narrowest = std::fmin(found.narrowest, 1 / p.bend);
        grown.part = part;
        (part < to ? going : there).push_back(std::move(grown));
      }
    }
    found.at = k + latest;
    rows.clear();
    for (Row& row : there)
      if (!known(row)) rows.push_back(std::move(row));
    return rows.empty() ? FrontEnd::DIED : FrontEnd::ARRIVED;
  }

  // Whether the rows have each point of another: rows end where nothing is inside, or they would have grown on.
  bool known(const Row& row) const {
    std::size_t r = 0, index = 0;
    return std::all_of(row.points.begin(), row.points.end(), [&](const Point& p) { return covered(p, r, index); });
  }

  // Carries a row to the pose a step further. False where a step is too long for what is known.
  bool carry(const Row& row, std::int64_t k, double step, const double* t) {
    next.clear();
    const double there = row.part + step;
    const Rigid goal = way.pose(k, there > 1 - kFrontRounding ? 1.0 : there);
    images.resize(row.points.size());
    bool all = true;
    for (std::size_t i = 0; i < row.points.size(); ++i) {
      const Point& p = row.points[i];
      Point& q = images[i];
      q = p;
      ++looked;
      for (int j = 0; j < a.n; ++j)
        for (int c = 0; c < 6; ++c) q.y[j] += step * p.B[j][c] * t[c];
      if (!curves.settle(goal, q)) return false;
      const double moved = apart(p, q);
      if (rough) {
        if (moved > kLongest) return false;
      } else {
        // the carried point is on the same curve as what p and its surroundings become
        const double delta = moved_by(p, step * speed(p, t) + kFrontRounding),
                     far = delta + kCover * spacing(p) + moved;
        if (!(far < 0.9 * q.radius && kCover * spacing(p) + delta < p.radius && far <= kept(q))) return false;
      }
      if (a.n > 6) curves.aim(q, p.tangent);
      all = all && may_be_kept(q);
    }
    return take(row.closed, all, goal);
  }

  // Makes rows of the images of one.
  bool take(bool closed, bool all, const Rigid& at) {
    const std::size_t count = images.size();
    std::size_t start = 0;
    if (closed && !all)
      while (may_be_kept(images[start])) ++start;
    Row row;
    bool seen = false;
    auto done = [&] {
      if (seen) next.push_back(std::move(row));
      row = Row();
      seen = false;
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Point& q = images[(start + i) % count];
      if (!may_be_kept(q)) {
        done();
        continue;
      }
      // what is left out for standing too near counts too
      seen = seen || must_be_kept(q);
      if (!row.points.empty()) {
        const double d = apart(row.points.back(), q);
        if (d < 0.4 * spacing(q) && i + 1 < count) continue;
        if (!bridge(row, q, at)) return false;
      }
      row.points.push_back(q);
    }
    if (closed && all && !row.points.empty()) {
      const Point first = row.points.front();
      if (!bridge(row, first, at)) return false;
      row.closed = true;
    }
    done();
    return true;
  }

  // Puts points between the end of a row and a point that is too far from it.
  bool bridge(Row& row, const Point& to, const Rigid& at) {
    const double none[kMostCoordinates] = {};
    for (int more = 0; more < 20; ++more) {
      const Point here = row.points.back();
      const double d = apart(here, to);
      if (d <= 1.1 * spacing(here) && d <= 1.25 * spacing(to) && (rough || d < 0.9 * here.radius)) return true;
      Point added;
      if (a.n == 6 || !ahead(here, at, none, added)) return false;
      if (apart(added, to) >= d) return false;
      row.points.push_back(added);
    }
    return false;
  }

  // Lets a row grow at an end as far as it may be inside.
  bool stretch(Row& row, bool ahead_of, const Rigid& at) {
    double bow[kMostCoordinates] = {};
    std::vector<Point> more;
    Point here = ahead_of ? row.points.back() : row.points.front();
    const Point other = ahead_of ? row.points.front() : row.points.back();
    if (!ahead_of)
      for (double& t : here.tangent) t = -t;
    const bool some = row.points.size() > 3;
    while (looked <= a.most) {
      Point one;
      if (!ahead(here, at, bow, one)) return false;
      const double step = apart(here, one);
      for (int j = 0; j < a.n; ++j) bow[j] = (one.tangent[j] - here.tangent[j]) / step;
      if (!may_be_kept(one)) break;
      if ((some || more.size() > 3) && near(one, other)) {
        row.closed = true;
        more.push_back(one);
        break;
      }
      more.push_back(one);
      here = one;
    }
    auto& points = row.points;
    if (ahead_of) {
      points.insert(points.end(), more.begin(), more.end());
    } else {
      for (Point& p : more)
        for (double& t : p.tangent) t = -t;
      points.insert(points.begin(), more.rbegin(), more.rend());
    }
    return true;
  }

  // Makes rows of all that hangs together with the points given, as far as it may be inside.
  FrontEnd spread(const std::vector<Point>& given, const Rigid& at, FrontFound& found) {
    std::size_t row = 0, index = 0;
    for (const Point& image : given) {
      if (covered(image, row, index)) continue;
      Row fresh;
      fresh.points.push_back(image);
      if (a.n > 6) curves.aim(fresh.points[0], nullptr);
      if (!must_be_kept(fresh.points[0])) continue;
      rows.push_back(std::move(fresh));
      row = rows.size() - 1;
      index = 0;
      for (int side = 0; side < 2 && a.n > 6 && !rows[row].closed; ++side)
        if (!stretch(rows[row], side == 0, at)) return FrontEnd::SINGULAR;
      if (looked > a.most) return FrontEnd::TIRED;
    }
    for (const Row& row : rows)
      for (const Point& p : row.points) found.narrowest = std::fmin(found.narrowest, 1 / p.bend);
    return rows.empty() ? FrontEnd::DIED : FrontEnd::ARRIVED;
  }

  bool covered(const Point& p, std::size_t& row, std::size_t& index) const {
    if (row < rows.size()) {
      const auto& points = rows[row].points;
      const std::size_t from = index > 6 ? index - 6 : 0, to = std::min(points.size(), index + 7);
      for (std::size_t i = from; i < to; ++i)
        if (near(p, points[i])) {
          index = i;
          return true;
        }
    }
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t i = 0; i < rows[r].points.size(); ++i)
        if (near(p, rows[r].points[i])) {
          row = r, index = i;
          return true;
        }
    return false;
  }
  bool near(const Point& p, const Point& q) const {
    const double d = apart(p, q);
    return d <= spacing(q) && (rough || d < 0.9 * q.radius);
  }

  // The next point of a curve, near enough; bow is how the tangent turned before.
  bool ahead(const Point& here, const Rigid& at, const double* bow, Point& next) {
    double step = spacing(here);
    for (int turn = 0; turn < 30; ++turn) {
      next = here;
      for (int j = 0; j < a.n; ++j) next.y[j] += step * (here.tangent[j] + 0.5 * step * bow[j]);
      ++looked;
      if (curves.settle(at, next)) {
        const double d = apart(here, next);
        if (d <= 1.1 * spacing(here) && (rough || d < 0.9 * here.radius) && d <= 1.25 * spacing(next)) {
          curves.aim(next, here.tangent);
          return true;
        }
        step = std::fmin(0.9 * spacing(next), 0.7 * step);
      } else {
        step /= 2;
      }
      if (!(step > kFrontStill)) return false;
    }
    return false;
  }
};

}  // namespace

FrontFound front(const FrontAsked& asked) { return Front(asked).run(); }

}  // namespace pieper
