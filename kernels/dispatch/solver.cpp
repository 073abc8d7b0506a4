// The work of Solver: blocks that fit the cache, dealt to threads.
#include "dispatch/solver.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>

namespace pieper {
namespace {

constexpr long kBlock = 256;         // poses; about 100 kB of answers for eight solutions of six joints
constexpr long kSerialBelow = 2000;  // starting a thread costs as much as this many closed-form poses
constexpr auto kAskEvery = std::chrono::milliseconds(20);

}  // namespace

Solver::Solver(const Geometry& geometry, std::vector<double> lower, std::vector<double> upper,
               std::vector<std::uint8_t> prismatic, double accepted, double exact)
    : isa_(isa()),
      family_(*isa_.families[geometry.family]),
      kernel_(nullptr),
      lower_(std::move(lower)),
      upper_(std::move(upper)),
      prismatic_(std::move(prismatic)),
      accepted_(accepted),
      exact_(exact) {
  const auto size = static_cast<std::size_t>(joints());
  if (lower_.size() != size || upper_.size() != size || prismatic_.size() != size)
    throw std::invalid_argument("lower, upper and prismatic must have one entry a joint, " + std::to_string(size) +
                                " here.");
  kernel_ = family_.make(geometry);
}

bool Solver::check(const double* T, long count, BadPose& bad, bool& exact) const {
  double deviation[kBlock];
  exact = true;
  for (long first = 0; first < count; first += kBlock) {
    const long block = std::min(kBlock, count - first);
    const double largest = isa_.deviation(T + 16 * first, block, deviation);
    exact &= largest <= exact_;
    if (largest <= accepted_) continue;
    for (long i = 0; i < block; ++i)
      if (!(deviation[i] <= accepted_)) {
        bad = {first + i, deviation[i]};
        return false;
      }
  }
  return true;
}

void Solver::solve_block(const double* T, long count, bool exact, double* q, std::uint8_t* valid,
                         std::uint8_t* in_limits, std::uint8_t* flag) const {
  double deviation[kBlock], straight[16 * kBlock];
  const bool rounded = !exact && isa_.deviation(T, count, deviation) > exact_;
  if (rounded) {
    isa_.straighten(T, deviation, exact_, count, straight);
    T = straight;
  }
  family_.solve(kernel_, T, count, q, valid, flag);
  if (!family_.in_order) isa_.put_in_order(q, valid, count, slots(), joints(), prismatic_.data());
  if (rounded)
    for (long i = 0; i < count; ++i) flag[i] |= deviation[i] > exact_ ? kRounded : 0;
  isa_.limits(q, valid, count * slots(), joints(), lower_.data(), upper_.data(), prismatic_.data(), in_limits);
}

bool Solver::solve(const double* T, long count, bool exact, int threads, double* q, std::uint8_t* valid,
                   std::uint8_t* in_limits, std::uint8_t* flag, const std::function<bool()>& keep_going) const {
  std::atomic<long> next{0};
  std::atomic<bool> stop{false};
  auto take_block = [&]() {
    const long first = next.fetch_add(kBlock);
    if (first >= count || stop.load(std::memory_order_relaxed)) return false;
    const long record = static_cast<long>(slots()) * joints();
    solve_block(T + 16 * first, std::min(kBlock, count - first), exact, q + record * first, valid + slots() * first,
                in_limits + slots() * first, flag + first);
    return true;
  };
  if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  threads = static_cast<int>(std::min<long>(threads, (count + kBlock - 1) / kBlock));
  std::vector<std::thread> helpers;
  if (count >= kSerialBelow) {
    try {
      for (int i = 1; i < threads; ++i)
        helpers.emplace_back([&] {
          while (take_block()) {
          }
        });
    } catch (const std::system_error&) {
      // no more threads to be had: the ones we have do the work
    }
  }
  auto asked = std::chrono::steady_clock::now();
  while (take_block()) {
    const auto now = std::chrono::steady_clock::now();
    if (now - asked < kAskEvery) continue;
    asked = now;
    if (!keep_going()) stop = true;
  }
  for (auto& helper : helpers) helper.join();
  return !stop;
}

bool Solver::solve_one(const double* T, double* q, std::uint8_t* valid, std::uint8_t* in_limits, std::uint8_t* flag,
                       BadPose& bad) const {
  double deviation;
  isa_.deviation(T, 1, &deviation);
  if (!(deviation <= accepted_)) {
    bad = {0, deviation};
    return false;
  }
  double straight[16];
  if (deviation > exact_) {
    isa_.straighten(T, &deviation, exact_, 1, straight);
    T = straight;
  }
  family_.solve(kernel_, T, 1, q, valid, flag);
  if (!family_.in_order) isa_.put_in_order(q, valid, 1, slots(), joints(), prismatic_.data());
  if (deviation > exact_) *flag |= kRounded;
  isa_.limits(q, valid, slots(), joints(), lower_.data(), upper_.data(), prismatic_.data(), in_limits);
  return true;
}

}  // namespace pieper
