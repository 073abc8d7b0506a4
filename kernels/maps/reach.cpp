// The work of `reach`: each thread takes a voxel at a time.
#include "maps/reach.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <system_error>
#include <thread>
#include <vector>

namespace pieper {
namespace {

constexpr long kBlock = 256;  // poses at once
constexpr auto kAskEvery = std::chrono::milliseconds(20);
constexpr double kTurn = 6.28318530717958647693;

void set(std::uint8_t* bits, long i) { bits[i >> 3] |= static_cast<std::uint8_t>(0x80 >> (i & 7)); }

// |det J| of rows of six joints (Yoshikawa's manipulability), by elimination with pivots.
double manipulability(double* J) {
  double product = 1;
  for (int k = 0; k < 6; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 6; ++i)
      if (std::fabs(J[6 * i + k]) > std::fabs(J[6 * pivot + k])) pivot = i;
    if (J[6 * pivot + k] == 0) return 0;
    if (pivot != k) std::swap_ranges(J + 6 * k, J + 6 * k + 6, J + 6 * pivot);
    product *= J[6 * k + k];
    for (int i = k + 1; i < 6; ++i) {
      const double f = J[6 * i + k] / J[6 * k + k];
      for (int j = k + 1; j < 6; ++j) J[6 * i + j] -= f * J[6 * k + j];
    }
  }
  return std::fabs(product);
}

class Worker {
 public:
  Worker(const Solver& solver, const Voxels& asked, const Reached& to)
      : solver_(solver),
        asked_(asked),
        to_(to),
        n_(solver.joints()),
        slots_(solver.slots()),
        each_(asked.sense != 0 ? asked.rolls : 1),
        lower_(solver.lower()),
        upper_(solver.upper()),
        T_(16 * kBlock, 0.0),
        q_(kBlock * slots_ * n_),
        valid_(kBlock * slots_),
        inside_(kBlock * slots_),
        flag_(kBlock),
        outcome_(kBlock),
        last_(each_),
        last_in_(each_),
        one_(each_, 1),
        J_(asked.links ? 6 * n_ * slots_ * kBlock : 0) {
    for (long k = 0; k < kBlock; ++k) T_[16 * k + 15] = 1;
    if (each_ > 1) {
      lower_[n_ - 1] = -std::numeric_limits<double>::infinity();
      upper_[n_ - 1] = -lower_[n_ - 1];
    }
  }

  void voxel(long v) {
    const long bytes = (asked_.orientations + 7) / 8, directions = asked_.orientations / each_;
    bits_ = to_.bits + v * bytes;
    look_ = to_.look + v * bytes;
    std::memset(bits_, 0, bytes);
    std::memset(look_, 0, bytes);
    solutions_ = 0;
    best_ = margin_ = 0;
    const double* p = asked_.centres + 3 * v;
    for (long first = 0; first < directions; first += kBlock) {
      const long here = std::min(kBlock, directions - first);
      for (long k = 0; k < here; ++k) {
        const double* R = asked_.turns + 9 * each_ * (first + k);
        double* T = &T_[16 * k];
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) T[4 * i + j] = R[3 * i + j];
          T[4 * i + 3] = p[i];
        }
      }
      block(first, here);
    }
    to_.solutions[v] = solutions_;
    if (asked_.links) to_.manipulability[v] = best_, to_.margin[v] = margin_;
  }

 private:
  void block(long first, long here) {
    BadPose bad{};
    solver_.solve(T_.data(), here, 1, {q_.data(), valid_.data(), inside_.data(), flag_.data(), outcome_.data()}, {},
                  bad, [](long) { return true; });
    if (each_ > 1)
      solver_.isa_table().limits(q_.data(), valid_.data(), here * slots_, n_, lower_.data(), upper_.data(),
                                 solver_.prismatic().data(), inside_.data());
    for (long k = 0; k < here; ++k) {
      const std::uint8_t* inside = &inside_[k * slots_];
      const bool doubt = flag_[k] & (kDegenerate | kUncertain);
      if (each_ > 1) {
        if (doubt)
          for (int r = 0; r < each_; ++r) set(look_, (first + k) * each_ + r);
        else rolled(first + k, &q_[k * slots_ * n_], inside);
        continue;
      }
      int count = 0;
      for (int m = 0; m < slots_; ++m) count += inside[m];
      solutions_ += count;
      if (count) set(bits_, first + k);
      else if (doubt) set(look_, first + k);
      if (asked_.links && count)
        for (int m = 0; m < slots_; ++m)
          if (inside[m]) margin_ = std::max(margin_, away(&q_[(k * slots_ + m) * n_], n_));
    }
    if (asked_.links) measure(here);
  }

  // All rolls of one direction: the last joint turns along.
  void rolled(long direction, const double* rows, const std::uint8_t* inside) {
    const auto& low = solver_.lower();
    const auto& high = solver_.upper();
    for (int m = 0; m < slots_; ++m) {
      if (!inside[m]) continue;
      for (int r = 0; r < each_; ++r) {
        const double x = rows[m * n_ + n_ - 1] + asked_.sense * kTurn * r / each_;
        last_[r] = x - kTurn * std::ceil(x / kTurn - 0.5);
      }
      const std::uint8_t turning = 0;
      solver_.isa_table().limits(last_.data(), one_.data(), each_, 1, &low[n_ - 1], &high[n_ - 1], &turning,
                                 last_in_.data());
      for (int r = 0; r < each_; ++r) {
        if (!last_in_[r]) continue;
        ++solutions_;
        set(bits_, direction * each_ + r);
        if (asked_.links) margin_ = std::max(margin_, std::min(away(rows + m * n_, n_ - 1), share(last_[r], n_ - 1)));
      }
    }
  }

  double share(double value, int joint) const {
    const double low = solver_.lower()[joint], high = solver_.upper()[joint];
    if (!std::isfinite(low) && !std::isfinite(high)) return 1;
    if (!std::isfinite(low) || !std::isfinite(high) || high <= low) return high <= low ? 0 : 1;
    return std::clamp(2 * std::min(value - low, high - value) / (high - low), 0.0, 1.0);
  }
  double away(const double* row, int joints) const {
    double least = 1;
    for (int j = 0; j < joints; ++j) least = std::min(least, share(row[j], j));
    return least;
  }

  void measure(long here) {
    long count = 0;
    for (long i = 0; i < here * slots_; ++i)
      if (inside_[i]) std::memmove(&q_[n_ * count++], &q_[n_ * i], sizeof(double) * n_);
    solver_.isa_table().jacobian(asked_.links, solver_.prismatic().data(), n_, q_.data(), count, J_.data());
    for (long i = 0; i < count; ++i) best_ = std::max(best_, manipulability(&J_[36 * i]));
  }

  const Solver& solver_;
  const Voxels& asked_;
  const Reached& to_;
  const int n_, slots_, each_;
  std::vector<double> lower_, upper_, T_, q_;
  std::vector<std::uint8_t> valid_, inside_, flag_, outcome_;
  std::vector<double> last_;
  std::vector<std::uint8_t> last_in_, one_;
  std::vector<double> J_;
  std::uint8_t *bits_ = nullptr, *look_ = nullptr;
  std::int64_t solutions_ = 0;
  double best_ = 0, margin_ = 0;
};

}  // namespace

bool reach(const Solver& solver, const Voxels& asked, const Reached& to, int threads,
           const std::function<bool()>& keep_going) {
  std::atomic<long> next{0};
  std::atomic<bool> stop{false};
  auto work = [&](auto after_voxel) {
    Worker worker(solver, asked, to);
    for (long v; !stop.load(std::memory_order_relaxed) && (v = next.fetch_add(1)) < asked.count;) {
      worker.voxel(v);
      after_voxel();
    }
  };
  if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> helpers;
  try {
    for (int i = 1; i < std::min<long>(threads, asked.count); ++i) helpers.emplace_back([&] { work([] {}); });
  } catch (const std::system_error&) {
    // no more threads to be had: the ones we have do the work
  }
  auto asked_at = std::chrono::steady_clock::now();
  work([&] {
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_at < kAskEvery) return;
    asked_at = now;
    if (!keep_going()) stop = true;
  });
  for (auto& helper : helpers) helper.join();
  return !stop;
}

}  // namespace pieper
