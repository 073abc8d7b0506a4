// The work of Solver: blocks that fit the cache, dealt to threads.
#include "dispatch/solver.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "dispatch/together.hpp"

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace pieper {
namespace {

// Poses at most, about 200 kB of answers for eight solutions of six joints: what waits for company in vectors meets some in a block.
constexpr long kBlock = 512;
constexpr long kScratch = 24 * 1024;    // bytes of answers that stay in the first cache until they are copied past it
constexpr long kSmallestBlock = 16;     // poses; a multiple of every width of lanes
constexpr long kUsualCache = 8L << 20;  // bytes, where the processor does not tell
constexpr long kMostCache = 32L << 20;  // bytes: a virtual machine may be told of all its host's caches together
constexpr long kShare = 4;              // so many want the cache that all cores share, answers being one of them
constexpr long kSerialBelow = 2000;     // starting a thread costs as much as this many closed-form poses
constexpr double kHalfTurn = 3.14159265358979323846;

// Bytes of the cache that all cores share.
long cache_size() {
#if defined(_SC_LEVEL3_CACHE_SIZE)
  static const long found = sysconf(_SC_LEVEL3_CACHE_SIZE);
  if (found > 0) return std::min(found, kMostCache);
#endif
  return kUsualCache;
}

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
  for (std::size_t j = 0; j < size; ++j) once_ &= prismatic_[j] || (lower_[j] <= kHalfTurn && upper_[j] >= -kHalfTurn);
  kernel_ = family_.make(geometry);
}

long Solver::solve_block(const double* T, long count, double* deviation, double* straight, bool past_cache,
                         const Answers& to) const {
  const auto at_once = [&](const double* poses, double exact) {
    return once_ && family_.solve_inside &&
           family_.solve_inside(kernel_, poses, count, {limits(), exact, past_cache}, to);
  };
  if (at_once(T, exact_)) return count;
  const double largest = isa_.deviation(T, count, deviation);
  if (!(largest <= accepted_))
    return std::find_if(deviation, deviation + count, [&](double d) { return !(d <= accepted_); }) - deviation;
  const bool rounded = largest > exact_;
  if (rounded) {
    isa_.straighten(T, deviation, exact_, count, straight);
    T = straight;
  }
  // by the same road: what a pose comes to is not to hang on the others of its block
  const bool done = at_once(T, std::numeric_limits<double>::infinity());
  if (!done) {
    family_.solve(kernel_, T, count, to.q, to.valid, to.flag);
    if (!family_.in_order) isa_.put_in_order(to.q, to.valid, count, slots(), joints(), prismatic_.data());
  }
  if (rounded)
    for (long i = 0; i < count; ++i) to.flag[i] |= deviation[i] > exact_ ? kRounded : 0;
  if (!done) {
    isa_.limits(to.q, to.valid, count * slots(), joints(), lower_.data(), upper_.data(), prismatic_.data(),
                to.in_limits);
    isa_.outcomes(to.valid, to.in_limits, count, slots(), to.outcome);
  }
  return count;
}

Outcome Solver::solve(const double* T, long count, int threads, const Answers& to, const Chosen& chosen, BadPose& bad,
                      const std::function<bool(long)>& keep_going) const {
  const long record = static_cast<long>(slots()) * joints(), bytes = record * static_cast<long>(sizeof(double));
  // Large answers go past the cache: at once, which spares reading lines that are only written, or where they are read again or the
  // family knows no such way from a scratch that stays in it.
  const bool at_once = once_ && family_.solve_inside && !chosen.by,
             past_cache = count * bytes > (at_once ? cache_size() / kShare : cache_size()),
             streams = past_cache && !at_once;
  const long block =
      streams ? std::clamp(kScratch / bytes / kSmallestBlock * kSmallestBlock, kSmallestBlock, kBlock) : kBlock;
  std::atomic<long> next{0}, done{0}, first_bad{count};
  std::atomic<bool> stop{false};
  std::mutex of_bad;
  auto work = [&](auto after_block) {
    double deviation[kBlock], straight[16 * kBlock];
    const std::unique_ptr<double[]> scratch(streams ? new double[record * block] : nullptr);
    for (;;) {
      const long first = next.fetch_add(block);
      if (first >= count || stop.load(std::memory_order_relaxed) || first > first_bad.load()) return;
      const long here = std::min(block, count - first);
      double* const q = to.q + record * first;
      const Answers part = {streams ? scratch.get() : q, to.valid + slots() * first, to.in_limits + slots() * first,
                            to.flag + first, to.outcome + first};
      const long good = solve_block(T + 16 * first, here, deviation, straight, past_cache && at_once, part);
      if (good < here) {
        // blocks are handed out in order: those before this one are being looked at, and may hold an earlier one
        const std::lock_guard lock(of_bad);
        if (first + good < first_bad) {
          first_bad = first + good;
          bad = {first + good, deviation[good]};
        }
        return;
      }
      if (chosen.by)
        isa_.choose(*chosen.by, part.q, part.in_limits, here, slots(), chosen.near + first * chosen.stride,
                    chosen.stride, chosen.chosen + first * joints(), chosen.has + first);
      if (streams) isa_.stream(q, scratch.get(), record * here);
      done.fetch_add(here, std::memory_order_relaxed);
      after_block();
    }
  };
  work_together(
      count < kSerialBelow ? 1 : threads_for(threads, (count + block - 1) / block), work,
      [&] { return keep_going(done.load(std::memory_order_relaxed)); }, stop);
  return stop ? Outcome::STOPPED : first_bad < count ? Outcome::BAD_POSE : Outcome::FINISHED;
}

bool Solver::solve_one(const double* T, double* q, std::uint8_t* valid, std::uint8_t* in_limits, std::uint8_t* flag,
                       BadPose& bad) const {
  double deviation, straight[16];
  std::uint8_t outcome;
  if (solve_block(T, 1, &deviation, straight, false, {q, valid, in_limits, flag, &outcome}) == 1) return true;
  bad = {0, deviation};
  return false;
}

}  // namespace pieper
