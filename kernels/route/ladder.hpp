// The cheapest chain of joint vectors through a ladder: one rung a station, its rows on a grid of spare coordinates.
//
// Scalar. A row is a joint vector modulo whole turns; a joint whose limits are wider than a turn has lifts, and a node is
// a row with its lifts. From rung to rung the coordinates move to near cells only; on a rung they may move on the spot.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pieper {

struct Ladder {
  std::int64_t rungs, cells;
  int rows, joints, nearby, beside;
  const double* q;             // (rungs, cells, rows, joints), bounded revolute joints in [lower, that + turn)
  const std::uint8_t* valid;   // (rungs, cells, rows)
  const double* lower;         // (joints)
  const double* upper;         // (joints)
  const std::uint8_t* circle;  // (joints) whether a whole turn leads to the same row
  const double* weights;       // (joints) of squared differences
  const double* longest;       // (rungs - 1, joints) largest step between rungs
  const double* parts;         // (rungs - 1) steps that the way between rungs is made in
  const std::int32_t* near;    // (cells, nearby) cells that a step leads to, -1 for none
  const std::int32_t* spot;    // (cells, beside) cells that a step on the spot leads to, -1 for none
  const double* on_spot;       // (joints) largest step on the spot, negative for no such steps
  bool largest;                // whether a step costs its largest joint difference instead of the sum of squares
  double slack;                // of limits
  const std::int32_t* first;   // (joints) whole turns above the rows that the way begins with, negative for any
  const std::int32_t* last;    // the same of its end
};

struct Climbed {
  double cost = std::numeric_limits<double>::infinity();
  std::int64_t furthest = -1;  // last rung that is reached
  std::int64_t edges = 0;
  std::vector<std::int64_t> rung;
  std::vector<double> q;  // (path, joints), whole turns continuous where joints are bounded
};

class Climb {
 public:
  explicit Climb(const Ladder& ladder)
      : l(ladder), nodes(l.cells * l.rows), turns(l.joints), stride(l.joints), root(l.joints) {
    lifts = 1;
    for (int j = 0; j < l.joints; ++j) {
      root[j] = std::sqrt(l.weights[j]);
      const double width = l.upper[j] - l.lower[j];
      turns[j] =
          l.circle[j] && std::isfinite(width) ? static_cast<int>(std::floor((width + 2 * l.slack) / kTurn)) + 1 : 1;
      stride[j] = lifts;
      lifts *= turns[j];
    }
  }

  Climbed run() {
    const std::size_t size = static_cast<std::size_t>(nodes) * lifts;
    cost.assign(size, kNone);
    next.assign(size, kNone);
    back.assign(size * static_cast<std::size_t>(l.rungs), -1);
    allowed.assign(size, 0);
    Climbed out;
    allow(0);
    for (std::size_t i = 0; i < size; ++i) cost[i] = allowed[i] ? 0.0f : kNone;
    settle(0, out);
    if (!any()) return out;
    out.furthest = 0;
    for (std::int64_t r = 1; r < l.rungs; ++r) {
      allow(r);
      rise(r, out);
      cost.swap(next);
      if (!any()) return out;
      settle(r, out);
      out.furthest = r;
    }
    trace(out);
    return out;
  }

 private:
  static constexpr double kTurn = 6.283185307179586476925286766559;
  static constexpr float kNone = std::numeric_limits<float>::infinity();
  // Costs are sums of single precision: a step that is dearer by so much of them is dearer for certain.
  static constexpr double kDearer = 4 * std::numeric_limits<float>::epsilon();
  const Ladder& l;
  std::int64_t nodes;
  int lifts;
  std::vector<int> turns, stride;
  std::vector<double> root;  // of the weights
  std::vector<float> cost, next;
  std::vector<std::int32_t> back;  // node and lift it came from; below zero: -2 - that, on the same rung
  std::vector<std::uint8_t> allowed;

  const double* row(std::int64_t rung, std::int64_t node) const { return l.q + (rung * nodes + node) * l.joints; }

  bool alive_at(std::int64_t node) const {
    return std::any_of(&cost[node * lifts], &cost[node * lifts] + lifts, [](float c) { return c < kNone; });
  }

  bool any() const {
    return std::any_of(cost.begin(), cost.end(), [](float c) { return c < kNone; });
  }

  void allow(std::int64_t rung) {
    for (std::int64_t node = 0; node < nodes; ++node) {
      std::uint8_t* to = &allowed[node * lifts];
      std::fill(to, to + lifts, 0);
      if (!l.valid[rung * nodes + node]) continue;
      const double* q = row(rung, node);
      for (int w = 0; w < lifts; ++w) {
        bool inside = (rung > 0 || meant(l.first, w)) && (rung + 1 < l.rungs || meant(l.last, w));
        for (int j = 0; j < l.joints && inside; ++j) {
          const double value = q[j] + (turns[j] > 1 ? kTurn * (w / stride[j] % turns[j]) : 0.0);
          inside = value >= l.lower[j] - l.slack && value <= l.upper[j] + l.slack;
        }
        to[w] = inside;
      }
    }
  }

  bool meant(const std::int32_t* digits, int w) const {
    for (int j = 0; j < l.joints; ++j)
      if (digits[j] >= 0 && turns[j] > 1 && w / stride[j] % turns[j] != digits[j]) return false;
    return true;
  }

  // The cost of a step from a to b, and by how many whole turns each joint's number changes; negative for none, and
  // where it comes to more than `dear`.
  double step(const double* a, const double* b, const double* longest, double dear, int* moved, bool& straight) const {
    double price = 0.0;
    straight = true;
    for (int j = 0; j < l.joints; ++j) {
      double e = b[j] - a[j];
      moved[j] = 0;
      const double turned = e * (1.0 / kTurn);
      if (l.circle[j] && std::fabs(turned) > 0.5) {
        const double n = std::nearbyint(turned);
        e -= kTurn * n;
        if (std::isfinite(l.upper[j] - l.lower[j])) {
          // the row is a turn lower than where the way leads: its lift is that much higher
          moved[j] = -static_cast<int>(n);
          straight = false;
        }
      }
      const double size = std::fabs(e);
      if (size > longest[j]) return -1.0;
      price = l.largest ? std::max(price, root[j] * size) : price + l.weights[j] * e * e;
      if (price > dear) return -1.0;
    }
    return price;
  }

  // The dearest of the lifts of a node that a way may lead to.
  float dearest(const std::vector<float>& of, std::int64_t node) const {
    float most = -kNone;
    for (std::int64_t i = node * lifts; i < (node + 1) * lifts; ++i)
      if (allowed[i]) most = std::max(most, of[i]);
    return most;
  }

  int lifted(int w, const int* moved) const {
    int to = w;
    for (int j = 0; j < l.joints; ++j) {
      if (!moved[j]) continue;
      const int digit = w / stride[j] % turns[j] + moved[j];
      if (digit < 0 || digit >= turns[j]) return -1;
      to += moved[j] * stride[j];
    }
    return to;
  }

  bool relax(std::vector<float>& to, std::int32_t* from, std::int64_t source, std::int64_t target, double price,
             const int* moved, bool straight, const std::vector<float>& known, bool spot) const {
    bool better = false;
    const float add = static_cast<float>(price);
    for (int w = 0; w < lifts; ++w) {
      const float base = known[source * lifts + w];
      if (!(base < kNone)) continue;
      const int x = straight ? w : lifted(w, moved);
      if (x < 0 || !allowed[target * lifts + x]) continue;
      const std::size_t at = target * lifts + x;
      if (base + add < to[at]) {
        to[at] = base + add;
        const std::int32_t node = static_cast<std::int32_t>(source * lifts + w);
        from[at] = spot ? -2 - node : node;
        better = true;
      }
    }
    return better;
  }

  void rise(std::int64_t r, Climbed& out) {
    std::fill(next.begin(), next.end(), kNone);
    std::int32_t* from = &back[static_cast<std::size_t>(r) * nodes * lifts];
    const double* longest = l.longest + (r - 1) * l.joints;
    const double part = l.largest ? 1.0 : 1.0 / l.parts[r - 1];
    std::vector<int> moved(l.joints);
    std::vector<float> least(nodes);
    for (std::int64_t node = 0; node < nodes; ++node)
      least[node] = *std::min_element(&cost[node * lifts], &cost[node * lifts] + lifts);
    for (std::int64_t c = 0; c < l.cells; ++c)
      for (int b = 0; b < l.rows; ++b) {
        const std::int64_t target = c * l.rows + b;
        if (!l.valid[r * nodes + target]) continue;
        const double* to = row(r, target);
        float most = dearest(next, target);
        if (most < 0.0f) continue;  // none of its lifts is allowed
        // rows of one place in their cells are mostly one branch: tried first, what they cost spares the others
        for (int turn = 0; turn < l.rows; ++turn)
          for (int n = 0; n < l.nearby; ++n) {
            const std::int32_t other = l.near[c * l.nearby + n];
            if (other < 0) continue;
            const std::int64_t source = static_cast<std::int64_t>(other) * l.rows + (b + turn) % l.rows;
            if (!(least[source] < kNone)) continue;
            const double dear = (most - least[source] + kDearer * most) / part;
            if (dear < 0.0) continue;
            bool straight;
            const double price = step(row(r - 1, source), to, longest, dear, moved.data(), straight);
            if (price < 0.0) continue;
            ++out.edges;
            if (relax(next, from, source, target, price * part, moved.data(), straight, cost, false))
              most = dearest(next, target);
          }
      }
  }

  // Moves on the spot, to and fro until nothing improves.
  void settle(std::int64_t r, Climbed& out) {
    if (l.on_spot[0] < 0.0) return;
    std::int32_t* from = &back[static_cast<std::size_t>(r) * nodes * lifts];
    std::vector<int> moved(l.joints);
    bool better = true;
    for (int sweep = 0; better && sweep < 200; ++sweep) {
      better = false;
      for (std::int64_t i = 0; i < l.cells; ++i) {
        const std::int64_t c = sweep % 2 ? l.cells - 1 - i : i;
        for (int n = 0; n < l.beside; ++n) {
          const std::int32_t other = l.spot[c * l.beside + n];
          if (other < 0) continue;
          for (int b = 0; b < l.rows; ++b) {
            const std::int64_t target = c * l.rows + b;
            if (!l.valid[r * nodes + target]) continue;
            for (int a = 0; a < l.rows; ++a) {
              const std::int64_t source = static_cast<std::int64_t>(other) * l.rows + a;
              if (!l.valid[r * nodes + source] || source == target || !alive_at(source)) continue;
              bool straight;
              const double price = step(row(r, source), row(r, target), l.on_spot, kNone, moved.data(), straight);
              if (price < 0.0) continue;
              ++out.edges;
              // a step on the spot is free of nothing: it costs what it would as one step of the way
              better |= relax(cost, from, source, target, price, moved.data(), straight, cost, true);
            }
          }
        }
      }
    }
  }

  void trace(Climbed& out) const {
    const std::size_t size = static_cast<std::size_t>(nodes) * lifts;
    std::size_t at = std::min_element(cost.begin(), cost.end()) - cost.begin();
    out.cost = cost[at];
    std::int64_t r = l.rungs - 1;
    for (;;) {
      const std::int64_t node = static_cast<std::int64_t>(at) / lifts;
      const int w = static_cast<int>(at % lifts);
      out.rung.push_back(r);
      for (int j = 0; j < l.joints; ++j)
        out.q.push_back(row(r, node)[j] + (turns[j] > 1 ? kTurn * (w / stride[j] % turns[j]) : 0.0));
      const std::int32_t from = back[static_cast<std::size_t>(r) * size + at];
      if (from == -1) break;
      if (from >= 0) {
        at = from;
        --r;
      } else {
        at = static_cast<std::size_t>(-2 - from);
      }
    }
    std::reverse(out.rung.begin(), out.rung.end());
    std::vector<double> turned;
    for (std::size_t k = out.rung.size(); k-- > 0;)
      turned.insert(turned.end(), out.q.begin() + k * l.joints, out.q.begin() + (k + 1) * l.joints);
    out.q.swap(turned);
  }
};

}  // namespace pieper
