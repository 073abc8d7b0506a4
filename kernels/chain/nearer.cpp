// The work of `nearer` and `closest`. Compiled once, for the plainest processor.
#include "chain/closest.hpp"
#include "chain/downhill.hpp"
#include "dispatch/isa.hpp"

#include <numeric>

namespace pieper {
namespace {

using namespace PIEPER_ISA;

void indefinite_step(int m, double* A, double damping, const double* b, double* x) {
  Bent bent(m);
  bent.m = m;
  std::copy(A, A + m * m, bent.A.begin());
  bent.step(damping, b, x);
}

struct Row {
  std::vector<double> q;
  double way, lean;  // half the square of the way, and 1 - cos of the turn

  double cost(double turn) const { return std::isinf(turn) ? lean : way + turn * lean; }
};
using Rows = std::vector<Row>;

void add(Rows& to, const Rows& more) { to.insert(to.end(), more.begin(), more.end()); }

struct Searched {
  const DownhillChain& chain;
  const Rigid goal;
  const Table& table;
  const Search& how;
  const double* pose;  // 4 x 4, m
  Downhill hill;

  Searched(const DownhillChain& given, const double* T, const Table& looked_at, const Search& as)
      : chain(given), goal(read_rigid(T, given.length)), table(looked_at), how(as), pose(T), hill(given, T) {}

  // Postures of the table that are good where a turn counts so much, and some spread evenly over the others.
  Rows starts(double turn, int count, int spread) const {
    std::vector<double> cost(table.count);
    for (int i = 0; i < table.count; ++i) {
      const Rigid there = read_rigid(table.poses + 16 * i, chain.length);
      const Vec3 gap = goal.t - there.t;
      const double trace = dot(there.x, goal.x) + dot(there.y, goal.y) + dot(there.z, goal.z);
      cost[i] = Row{{}, dot(gap, gap) / 2, (3 - trace) / 2}.cost(turn);
    }
    std::vector<int> order(table.count);
    std::iota(order.begin(), order.end(), 0);
    count = std::min(count, table.count);
    std::partial_sort(order.begin(), order.begin() + count, order.end(),
                      [&](int a, int b) { return cost[a] < cost[b] || (cost[a] == cost[b] && a < b); });
    Rows out;
    for (int i = 0; i < count; ++i) out.push_back(posture(order[i]));
    for (int i = 0; i < spread && count < table.count; ++i)
      out.push_back(posture(order[count + (table.count - count) * i / spread]));
    return out;
  }
  Row posture(int i) const { return {std::vector<double>(table.q + i * chain.n, table.q + (i + 1) * chain.n), 0, 0}; }

  bool side_by_side() const { return !chain.coupling && chain.n <= kDescendingJoints; }

  // Rows through descend(q), which writes them over.
  template <class Descend> void all_at_once(Rows& rows, Descend descend) {
    const long n = chain.n;
    std::vector<double> q;
    for (const Row& row : rows) q.insert(q.end(), row.q.begin(), row.q.end());
    descend(q.data());
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].q.assign(q.data() + i * n, q.data() + (i + 1) * n);
  }

  void down(Rows& rows, double turn, int steps) {
    if (!side_by_side()) {
      for (Row& row : rows) hill.down(turn, steps, row.q.data()), row.way = hill.way, row.lean = hill.lean;
      return;
    }
    std::vector<double> left(2 * rows.size());
    all_at_once(rows, [&](double* q) {
      isa().downhill(chain, pose, turn, steps, indefinite_step, static_cast<long>(rows.size()), q, left.data());
    });
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].way = left[2 * i], rows[i].lean = left[2 * i + 1];
  }
  void towards_place(Rows& rows) {
    if (!side_by_side()) {
      for (Row& row : rows) hill.towards_place(how.crawl, row.q.data()), row.way = hill.way;
      return;
    }
    std::vector<double> left(rows.size());
    all_at_once(
        rows, [&](double* q) { isa().crawl(chain, pose, how.crawl, static_cast<long>(rows.size()), q, left.data()); });
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].way = left[i];
  }

  // The nearest rows where a turn counts so much, of those that are alike the first.
  Rows best(Rows rows, double turn, int count) const {
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) { return a.cost(turn) < b.cost(turn); });
    Rows out;
    const int looked = std::min<int>(rows.size(), how.alike * count);
    for (int i = 0; i < looked && static_cast<int>(out.size()) < count; ++i) {
      bool again = false;
      for (int j = 0; j < i && !again; ++j) again = same(rows[i], rows[j]);
      if (!again) out.push_back(rows[i]);
    }
    return out;
  }
  bool same(const Row& a, const Row& b) const {
    for (int k = 0; k < chain.n; ++k)
      if (!(std::fabs(a.q[k] - b.q[k]) < how.same * chain.unit(k))) return false;
    return true;
  }

  // Postures whose position is nearest of all that are found.
  Rows at_place(const Rows& seeds) {
    const Stage& stage = how.stages[0];
    Rows all = starts(0.0, how.starts, how.spread), rows = seeds, others;
    for (std::size_t i = 0; i < all.size(); ++i) (i % 2 ? others : rows).push_back(all[i]);
    down(rows, 0.0, stage.steps);
    const auto met = std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return row.way < how.reached; });
    if (met < how.in_place) down(others, 0.0, stage.steps), add(rows, others);
    double least = INFINITY;
    for (const Row& row : rows) least = std::fmin(least, row.way);
    const double near = std::sqrt(2 * least) + how.alike_place;
    const auto agree =
        std::count_if(rows.begin(), rows.end(), [&](const Row& r) { return std::sqrt(2 * r.way) < near; });
    const double part = double(agree) / double(rows.size());
    rows = best(rows, 0.0, stage.keep);
    if (least > how.reached && part < how.agreed && !chain.coupling) {
      // nearer than nought there is none; of a position out of reach the nearest place may draw few descents
      Rows more;
      for (int i = 0; i < std::min(how.more, table.count); ++i) more.push_back(posture(i));
      for (const int kept : {how.more_kept, stage.keep}) {
        towards_place(more);
        more = best(more, 0.0, kept);
      }
      down(more, 0.0, how.few_steps);
      add(rows, more);
    }
    down(rows, 0.0, 2 * stage.steps);
    return rows;
  }

  // The rows that may still come to the best place: as a turn counts for less, what it may gain by is all that a way can become less.
  Rows within_reach_of(const Rows& rows, const Rows& places, double turn) const {
    double least = INFINITY;
    for (const Row& row : places) least = std::fmin(least, row.way);
    Rows out;
    for (const Row& row : rows)
      if (row.way <= least + 2 * turn) out.push_back(row);
    return out;
  }

  // The best by orientation that are found at the nearest position among given ones.
  Rows turned(const Rows& seeds, const Rows& at_place) {
    const Stage& first = how.stages[0];
    const double least = how.stages.back().turn;
    Rows rows = starts(first.turn, how.turned, 0);
    add(rows, seeds);
    down(rows, first.turn, first.steps);
    rows = best(rows, how.stages[1].turn, first.keep);
    const Rows places = within_reach_of(at_place, at_place, how.stages[1].turn);
    add(rows, best(places, how.stages[1].turn, static_cast<int>(places.size())));
    const Rows in_place = best(at_place, least, how.in_place);
    for (std::size_t k = 1; k < how.stages.size(); ++k) {
      const Stage& stage = how.stages[k];
      down(rows, stage.turn, stage.steps);
      rows = best(within_reach_of(rows, at_place, stage.turn), least, stage.keep);
      // where a turn counts for more, what is in the best place may be drawn to another
      if (k == 1) add(rows, in_place);
    }
    add(rows, best(at_place, 0.0, 1));
    return rows;
  }
};

}  // namespace

void nearer(const DownhillChain& chain, const double* T, long count, const double* turning, int steps, double* q,
            double* left) {
  Downhill hill(chain, T);
  for (long k = 0; k < count; ++k) left[k] = hill.down(turning[k], steps, q + k * chain.n);
}

std::vector<double> closest(const DownhillChain& chain, const double* T, const Table& table, long count,
                            const double* seeds, const Search& how, bool turning) {
  Searched search(chain, T, table, how);
  Rows given;
  for (long i = 0; i < count; ++i) given.push_back({{seeds + i * chain.n, seeds + (i + 1) * chain.n}, 0, 0});
  Rows rows = search.at_place(given);
  if (turning) {
    rows = search.turned(given, rows);
    // Along a curved valley between limits a descent may take hundreds of steps; from where it is wider it takes few.
    Rows back = search.best(rows, how.stages.back().turn, how.led_back);
    for (const Stage& stage : how.back) search.down(back, stage.turn, stage.steps);
    add(rows, back);
  }
  search.down(rows, 0.0, how.last_steps);
  std::vector<double> out;
  for (const Row& row : rows) out.insert(out.end(), row.q.begin(), row.q.end());
  return out;
}

}  // namespace pieper
