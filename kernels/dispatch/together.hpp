// Threads that take part after part of some work, and a caller that is asked now and then whether to go on.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <system_error>
#include <thread>
#include <vector>

namespace pieper {

inline constexpr auto kAskEvery = std::chrono::milliseconds(20);

// How many threads take parts: as many as asked for, or the machine has where none were, but no more than there are parts.
inline int threads_for(int threads, long parts) {
  if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return static_cast<int>(std::min<long>(threads, parts));
}

// Calls work(after_part) in so many threads, the caller's own among them; work takes parts until there are none or `stop` is
// set, and calls after_part() after each. Only the caller's thread asks keep_going(), and not more often than every kAskEvery.
template <class Work, class KeepGoing>
void work_together(int threads, const Work& work, const KeepGoing& keep_going, std::atomic<bool>& stop) {
  std::vector<std::thread> helpers;
  try {
    for (int i = 1; i < threads; ++i) helpers.emplace_back([&] { work([] {}); });
  } catch (const std::system_error&) {
    // no more threads to be had: the ones we have do the work
  }
  auto asked = std::chrono::steady_clock::now();
  work([&] {
    const auto now = std::chrono::steady_clock::now();
    if (now - asked < kAskEvery) return;
    asked = now;
    if (!keep_going()) stop = true;
  });
  for (auto& helper : helpers) helper.join();
}

}  // namespace pieper
