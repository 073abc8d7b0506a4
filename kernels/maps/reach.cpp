// The work of `reach`: each thread takes a voxel at a time.
#include "maps/reach.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "dispatch/together.hpp"

namespace pieper {
namespace {

constexpr long kBlock = 64;  // poses at once: their answers stay in the first cache
constexpr double kTurn = 6.28318530717958647693;

void set(std::uint8_t* bits, long i) { bits[i >> 3] |= static_cast<std::uint8_t>(0x80 >> (i & 7)); }

class Worker {
 public:
  Worker(const Solver& solver, const Voxels& asked, const Reached& to)
      : solver_(solver),
        asked_(asked),
        to_(to),
        n_(solver.joints()),
        slots_(solver.slots()),
        each_(asked.sense != 0 ? asked.rolls : 1),
        fold_(asked.fold),
        directions_(asked.orientations / each_),
        bytes_((asked.orientations + 7) / 8),
        lower_(solver.lower()),
        upper_(solver.upper()),
        T_(16 * kBlock, 0.0),
        q_(kBlock * slots_ * n_),
        valid_(kBlock * slots_),
        inside_(kBlock * slots_),
        flag_(kBlock),
        outcome_(kBlock),
        turned_(std::max(each_, fold_)),
        last_in_(each_),
        first_in_(fold_),
        one_(std::max(each_, fold_), 1),
        packed_((each_ + 7) / 8),
        all_((each_ + 7) / 8),
        every_roll_(!asked.links && solver.upper()[n_ - 1] - solver.lower()[n_ - 1] >= kTurn),
        here_(asked.links ? n_ * slots_ * kBlock : 0),
        J_(asked.links ? 6 * n_ * slots_ * kBlock : 0),
        shapes_(asked.links ? slots_ * kBlock : 0),
        place_(asked.links ? slots_ * kBlock : 0) {
    for (long k = 0; k < kBlock; ++k) T_[16 * k + 15] = 1;
    for (int r = 0; r < each_; ++r) set(all_.data(), r);
    if (each_ > 1) free(n_ - 1);
    if (fold_ > 1) free(0);
  }

  void voxel(long v) {
    images_ = asked_.images + v * fold_;
    for (int i = 0; i < fold_; ++i) {
      if (images_[i] < 0) continue;
      std::memset(bits(i), 0, bytes_);
      std::memset(look(i), 0, bytes_);
      to_.solutions[images_[i]] = 0;
      if (asked_.links) std::fill_n(measures(i), kMeasures, 0.0);
    }
    const double* p = asked_.centres + 3 * v;
    for (long first = 0; first < directions_; first += kBlock) {
      const long here = std::min(kBlock, directions_ - first);
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
  }

 private:
  // What is known of a posture's Jacobian, as IsaTable::posture_measures gives it.
  struct Shape {
    double determinant, smallest;
  };

  std::uint8_t* bits(int image) const { return to_.bits + images_[image] * bytes_; }
  std::uint8_t* look(int image) const { return to_.look + images_[image] * bytes_; }
  double* measures(int image) const { return to_.measures + images_[image] * kMeasures; }
  // The number of the direction that takes a direction's place at an image.
  long direction(long solved, int image) const { return (solved + image * (directions_ / fold_)) % directions_; }

  void free(int joint) {
    upper_[joint] = std::numeric_limits<double>::infinity();
    lower_[joint] = -upper_[joint];
  }

  void block(long first, long here) {
    BadPose bad{};
    solver_.solve(T_.data(), here, 1, {q_.data(), valid_.data(), inside_.data(), flag_.data(), outcome_.data()}, {},
                  bad, [](long) { return true; });
    const bool spread = each_ > 1 || fold_ > 1;
    if (spread)
      solver_.isa_table().limits(q_.data(), valid_.data(), here * slots_, n_, lower_.data(), upper_.data(),
                                 solver_.prismatic().data(), inside_.data());
    if (asked_.links) measure(here * slots_);
    for (long k = 0; k < here; ++k) {
      const std::uint8_t* inside = &inside_[k * slots_];
      const bool doubt = flag_[k] & (kDegenerate | kUncertain);
      if (spread) {
        if (doubt) look_all(first + k);
        else
          for (int m = 0; m < slots_; ++m)
            if (inside[m]) everywhere(first + k, k * slots_ + m);
        continue;
      }
      int count = 0;
      for (int m = 0; m < slots_; ++m) count += inside[m];
      to_.solutions[images_[0]] += count;
      if (count) set(bits(0), first + k);
      else if (doubt) set(look(0), first + k);
      if (asked_.links)
        for (int m = 0; m < slots_; ++m)
          if (inside[m]) {
            const double* row = &q_[(k * slots_ + m) * n_];
            add(0, shapes_[place_[k * slots_ + m]], away(row, 0, n_), 1);
          }
    }
  }

  void look_all(long solved) {
    for (int i = 0; i < fold_; ++i)
      if (images_[i] >= 0)
        for (int r = 0; r < each_; ++r) set(look(i), direction(solved, i) * each_ + r);
  }

  // Which of `count` equal parts of a whole turn a joint may be turned on by from a value; the values go to turned_ where they are
  // measured.
  void turned(double from, int joint, double sense, int count, std::vector<std::uint8_t>& in) {
    if (!asked_.links && solver_.upper()[joint] - solver_.lower()[joint] >= kTurn) {
      // every angle has its place inside
      std::fill(in.begin(), in.end(), 1);
      return;
    }
    const std::uint8_t turning = 0;
    for (int i = 0; i < count; ++i) {
      const double x = from + sense * kTurn * i / count;
      turned_[i] = x - kTurn * std::ceil(x / kTurn - 0.5);
    }
    solver_.isa_table().limits(turned_.data(), one_.data(), count, 1, &solver_.lower()[joint], &solver_.upper()[joint],
                               &turning, in.data());
  }

  // One row at all rolls, where the last joint turns along, and at all images, where the first one does.
  void everywhere(long solved, long number) {
    const double* row = &q_[number * n_];
    int hits = 1;
    double least_away = 1, best_last = 0;
    packed_[0] = 0x80;
    if (each_ > 1 && every_roll_) {
      hits = each_;
      packed_ = all_;
    } else if (each_ > 1) {
      turned(row[n_ - 1], n_ - 1, asked_.sense, each_, last_in_);
      std::fill(packed_.begin(), packed_.end(), 0);
      hits = 0;
      for (int r = 0; r < each_; ++r) {
        if (!last_in_[r]) continue;
        ++hits;
        set(packed_.data(), r);
        if (asked_.links) best_last = std::max(best_last, share(turned_[r], n_ - 1));
      }
      if (!hits) return;
    } else if (asked_.links) {
      best_last = share(row[n_ - 1], n_ - 1);
    }
    Shape own{};
    if (asked_.links) {
      own = shapes_[place_[number]];
      least_away = std::min(best_last, away(row, fold_ > 1, n_ - 1));
    }
    if (fold_ > 1) turned(row[0], 0, asked_.first_sense, fold_, first_in_);
    else first_in_[0] = 1;
    for (int i = 0; i < fold_; ++i) {
      if (images_[i] < 0 || !first_in_[i]) continue;
      to_.solutions[images_[i]] += hits;
      set_all(bits(i), direction(solved, i) * each_);
      if (asked_.links) add(i, own, fold_ > 1 ? std::min(least_away, share(turned_[i], 0)) : least_away, hits);
    }
  }

  // The rolls that are packed_, from one orientation on.
  void set_all(std::uint8_t* to, long first) const {
    if (first % 8 == 0)
      for (std::size_t b = 0; b < packed_.size(); ++b) to[first / 8 + b] |= packed_[b];
    else
      for (int r = 0; r < each_; ++r)
        if (packed_[r >> 3] & (0x80 >> (r & 7))) set(to, first + r);
  }

  double share(double value, int joint) const {
    const double low = solver_.lower()[joint], high = solver_.upper()[joint];
    if (!std::isfinite(low) && !std::isfinite(high)) return 1;
    if (!std::isfinite(low) || !std::isfinite(high) || high <= low) return high <= low ? 0 : 1;
    return std::clamp(2 * std::min(value - low, high - value) / (high - low), 0.0, 1.0);
  }
  double away(const double* row, int from, int to) const {
    double least = 1;
    for (int j = from; j < to; ++j) least = std::min(least, share(row[j], j));
    return least;
  }

  // The shapes of a block's rows that are inside, beside each other; place_ says where each is.
  void measure(long rows) {
    long count = 0;
    for (long number = 0; number < rows; ++number)
      if (inside_[number]) {
        std::copy_n(&q_[number * n_], n_, &here_[count * n_]);
        place_[number] = static_cast<int>(count++);
      }
    const IsaTable& isa = solver_.isa_table();
    isa.jacobian(asked_.links, solver_.prismatic().data(), n_, here_.data(), count, J_.data());
    isa.posture_measures(J_.data(), count, asked_.length, &shapes_.data()->determinant);
  }

  void add(int image, const Shape& own, double margin, int hits) const {
    double* to = measures(image);
    to[kManipulability] = std::max(to[kManipulability], std::fabs(own.determinant));
    to[kMargin] = std::max(to[kMargin], margin);
    const bool begun = to[kNegative] + to[kPositive] > 0;
    to[own.determinant < 0 ? kNegative : kPositive] += hits;
    to[kLeast] = begun ? std::min(to[kLeast], own.smallest) : own.smallest;
    to[kMost] = std::max(to[kMost], own.smallest);
  }

  const Solver& solver_;
  const Voxels& asked_;
  const Reached& to_;
  const int n_, slots_, each_, fold_;
  const long directions_, bytes_;
  std::vector<double> lower_, upper_, T_, q_;
  std::vector<std::uint8_t> valid_, inside_, flag_, outcome_;
  std::vector<double> turned_;
  std::vector<std::uint8_t> last_in_, first_in_, one_, packed_, all_;
  const bool every_roll_;
  std::vector<double> here_, J_;
  std::vector<Shape> shapes_;
  std::vector<int> place_;
  const std::int64_t* images_ = nullptr;
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
  work_together(threads_for(threads, asked.count), work, keep_going, stop);
  return !stop;
}

}  // namespace pieper
