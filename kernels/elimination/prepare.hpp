// Making the model of an arm: which variants of the elimination exist, and how well each does on test poses.
//
// Special geometry (parallel or meeting axes) makes some variants vanish identically and others ill-conditioned, while another hidden
// joint is at ease: so all are tried when the arm is made. Two things are measured on random poses: the determinant in the hidden
// angle must be a trigonometric polynomial of degree 8 (or 4), so what lies above is noise; and the joint vector that made the pose,
// and every solution that some other variant found, must be found. Scalar, but for the solver it tries.
#pragma once

#include "elimination/by_signs.hpp"
#include "elimination/slides.hpp"

namespace pieper::PIEPER_ISA::general {

struct Random {  // Steele, Lea and Flood's splitmix64 (2014)
  std::uint64_t state;
  double uniform() {
    state += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
};

// The pose of a scaled joint vector.
inline Rigid forward(const Model& model, const double* q) {
  const Rigid end = walk(
      6, model.link[0][0], [&](int k) -> const Rigid& { return model.link[0][k + 1]; },
      [&](int k) { return motion_of(q[k], model.prismatic[k]); }, model.prismatic, [](int, const Rigid&) {});
  return in_lengths(end, 1 / model.scale);
}

// A pose turned and moved a little.
inline Rigid perturbed(const Rigid& pose, double size, double length, Random& random) {
  double w[3];
  for (double& x : w) x = size * (2 * random.uniform() - 1);
  Rigid out = pose;
  for (int j = 0; j < 3; ++j) {  // exact rotation by the quaternion (1, w / 2)
    const double x = pose.r(0, j), y = pose.r(1, j), z = pose.r(2, j);
    const double a = 0.5 * w[0], b = 0.5 * w[1], c = 0.5 * w[2], s = 2 / (1 + a * a + b * b + c * c);
    const double u = b * z - c * y, v = c * x - a * z, t = a * y - b * x;
    out.r(0, j) = x + s * (u + b * t - c * v);
    out.r(1, j) = y + s * (v + c * u - a * t);
    out.r(2, j) = z + s * (t + a * v - b * u);
  }
  for (int i = 0; i < 3; ++i) out.p(i) += size * length * (2 * random.uniform() - 1);
  return out;
}

// Can this hand-out of roles be eliminated at all, and with which layout?
inline bool layout_of(const Roles& roles, int& layout) {
  const bool* p = roles.prismatic;
  if (p[1] || p[2] || p[5]) return false;
  const int n = p[0] + p[3] + p[4];
  if (n > 2) return false;
  layout = n < 2 ? kTwelve : p[0] ? kTwoApart : kTwoInPair;
  return true;
}

inline void fill_constants(const Model& model, Variant& v) {
  Rigid link[6];
  role_links(model, v.arm, v.roles, kNoMotion, link);
  left_side(link, v.roles, v.chart, v.swap, v.left);
  if (v.layout == kTwelve) {
    row_space<double, 12>(v.left, v.layout, v.basis);
    products_of(v.basis, v.between);
  } else {
    row_space<double, 6>(v.left, v.layout, v.basis6);
    products_of(v.basis6, v.between6);
  }
}

// What of the determinant lies above its degree, relative to all of it; 1 when it vanishes.
inline double determinant_noise(const Model& model, const Variant& v, const Rigid& pose) {
  constexpr int K = 24;
  const int degree = v.layout == kTwelve ? 8 : 4;
  Rigid link[6];
  role_links(model, v.arm, v.roles, pose, link);
  RightSide<double> right;
  right_side(link, v.roles, right);
  Equations<double> eq;
  const bool yp = v.roles.prismatic[v.swap ? 4 : 3], xp = v.roles.prismatic[v.swap ? 3 : 4];
  if (v.pose_free()) eliminate(v.left, right, v.layout, yp, xp, eq);
  else {
    LeftSide<double> left;
    left_side(link, v.roles, v.chart, v.swap, left);
    eliminate(left, right, v.layout, yp, xp, eq);
  }
  double value[K], c[K], s[K];
  using G = Lanes<PIEPER_LANES>;
  Equations<G> wide;
  for (int r = 0; r < 6; ++r)
    for (int j = 0; j < 27; ++j) wide.e[r][j] = G(eq.e[r][j]);
  double scale = 0;
  for (int r = 0; r < 6; ++r)
    for (int j = 0; j < 27; ++j) scale += eq.e[r][j] * eq.e[r][j];
  for (int i = 0; i < K; ++i) {
    c[i] = __builtin_cos(kTwoPi * i / K);
    s[i] = __builtin_sin(kTwoPi * i / K);
  }
  for (int i = 0; i < K; i += PIEPER_LANES) {
    const G d = v.layout == kTwelve ? determinant<G, 12>(wide, v.layout, load<G>(c + i), load<G>(s + i))
                                    : determinant<G, 6>(wide, v.layout, load<G>(c + i), load<G>(s + i));
    store(value + i, d);
  }
  double low = 0, high = 0;
  for (int k = 0; k <= K / 2; ++k) {
    double a = 0, b = 0;
    for (int i = 0; i < K; ++i) {
      const int at = (i * k) % K;
      a += value[i] * c[at];
      b += value[i] * s[at];
    }
    const double size = __builtin_sqrt(a * a + b * b);
    if (k <= degree) low = size > low ? size : low;
    else high = size > high ? size : high;
  }
  return low > 0 ? high / low : 1.0;
}

inline double median(double* x, int n) {
  for (int i = 1; i < n; ++i)
    for (int j = i; j > 0 && x[j] < x[j - 1]; --j) {
      const double t = x[j];
      x[j] = x[j - 1];
      x[j - 1] = t;
    }
  return x[n / 2];
}

struct Trial {
  int rank, missed, open;  // rank 1 is the best way, 0 of no use
  double noise;
};

inline constexpr int kTestPoses = 16;
inline constexpr int kTried = 24;

// The test poses, and what the variants found for them.
struct SelfTest {
  static constexpr int groups = (kTestPoses + PIEPER_LANES - 1) / PIEPER_LANES, poses = groups * PIEPER_LANES;
  Rigid pose[poses];
  Found known[poses];  // by whoever
  Found own[3 * kTried][poses];
  Variant variant[3 * kTried];
  Trial trial[3 * kTried];
  double score[3 * kTried];
};

inline void make_test_poses(const Model& model, SelfTest& test) {
  Random random{2026};
  for (int i = 0; i < SelfTest::poses; ++i) {
    double made[6];
    for (int k = 0; k < 6; ++k)
      made[k] = model.prismatic[k] ? 2 * random.uniform() - 1 : kTwoPi * random.uniform() - kPi;
    test.pose[i] = forward(model, made);
    test.known[i].count = 0;
    insert(test.known[i], made, 1, 0, model.prismatic);
  }
}

// Variant t of one arm (itself or a nearby one) on all test poses.
inline void try_variant(const Model& model, SelfTest& test, int arm, int t) {
  using G = Lanes<PIEPER_LANES>;
  constexpr int W = PIEPER_LANES;
  const int at = arm * kTried + t;
  Variant& v = test.variant[at];
  Trial& trial = test.trial[at];
  trial = {0, kTestPoses * 16, 0, 1.0};
  v.roles.assign(t / 4, (t / 2) % 2, model.prismatic);
  v.swap = t % 2;
  v.arm = arm;
  v.chart = {__builtin_cos(0.7), __builtin_sin(0.7), __builtin_cos(0.4), __builtin_sin(0.4)};
  if (!layout_of(v.roles, v.layout)) return;
  const bool one_in_pair = v.roles.prismatic[3] != v.roles.prismatic[4];
  if (v.layout == kTwoApart && !v.roles.prismatic[v.swap ? 4 : 3]) return;
  if (!one_in_pair && v.swap) return;
  fill_constants(model, v);
  double noise[8];
  for (int i = 0; i < 8; ++i) noise[i] = determinant_noise(model, v, test.pose[i]);
  v.noise = trial.noise = median(noise, 8);
  if (!(trial.noise < kGeneralNoisiest)) return;
  trial.rank = kTried;
  trial.missed = 0;
  v.typical = 0;
  double size[SelfTest::poses];
  for (int g = 0; g < SelfTest::groups; ++g) {
    RigidT<G> wide;
    for (int i = 0; i < W; ++i) {
      copy_lanes<G, double>(wide, i, test.pose[g * W + i], 0);
      test.own[at][g * W + i].count = 0;
    }
    Report report[W];
    solve_variant(model, v, wide, W, test.own[at] + g * W, report);
    for (int i = 0; i < W; ++i) {
      size[g * W + i] = report[i].size;
      trial.open += report[i].unresolved + 100 * report[i].doubtful;
      const Found& f = test.own[at][g * W + i];
      for (int k = 0; k < f.count; ++k)
        insert(test.known[g * W + i], f.q[k], f.sigma[k], f.residual[k], model.prismatic);
    }
  }
  v.typical = median(size, SelfTest::poses);
}

// Losses first, then noise by orders of magnitude, then open ends, then what costs time. kEndless where of no use.
inline void rate(const Model& model, SelfTest& test, int at) {
  Trial& trial = test.trial[at];
  test.score[at] = kEndless;
  if (trial.rank == 0) return;
  trial.missed = 0;
  for (int i = 0; i < SelfTest::poses; ++i) {
    Found f = test.own[at][i];
    const int before = f.count;
    for (int k = 0; k < test.known[i].count; ++k) insert(f, test.known[i].q[k], 1, 0, model.prismatic);
    trial.missed += f.count - before;
  }
  if (trial.missed > kTestPoses) return;  // of no use even as a second opinion
  const double noise = trial.noise > kGeneralPerfect ? __builtin_log10(trial.noise / kGeneralPerfect) : 0;
  const Variant& v = test.variant[at];
  test.score[at] = 1000.0 * trial.missed + 3 * noise + 0.5 * trial.open + (v.pose_free() ? 0 : 2) + (v.arm ? 100 : 0);
}

// Whether most test poses are settled by the signs of the best way's determinant, and none lacks a solution that any way found.
inline bool signs_work(const Model& model, const SelfTest& test) {
  using G = Lanes<PIEPER_LANES>;
  constexpr int W = PIEPER_LANES;
  const Variant& v = model.variant[0];
  if (v.arm || !(v.noise < kGeneralQuiet)) return false;
  int open = 0;
  for (int g = 0; g < SelfTest::groups; ++g) {
    RigidT<G> wide;
    for (int i = 0; i < W; ++i) copy_lanes<G, double>(wide, i, test.pose[g * W + i], 0);
    Found found[W];
    const unsigned unclear = solve_by_signs(model, wide, W, found);
    for (int i = 0; i < W; ++i) {
      if ((unclear >> i) & 1u) ++open;
      else if (found[i].count != test.known[g * W + i].count) return false;
    }
  }
  return open < SelfTest::poses / 4;
}

// Fills model.variant, best first. `trials` (kTried) is told about every hand-out in the order shift, direction, swap.
inline void choose_variants(Model& model, Trial* trials) {
  SelfTest& test = *static_cast<SelfTest*>(__builtin_malloc(sizeof(SelfTest)));
  make_test_poses(model, test);
  int tried = 0, clean = 0;
  // nearby arms only where the arm itself leaves fewer than two ways that lose nothing
  for (int arm = 0; arm < 3 && clean < 2; ++arm) {
    for (int t = 0; t < kTried; ++t) try_variant(model, test, arm, t);
    tried += kTried;
    for (int t = 0; t < tried; ++t) rate(model, test, t);
    clean = 0;
    for (int t = 0; t < tried; ++t)
      clean += test.score[t] < kNearlyEndless && test.trial[t].missed == 0 && test.variant[t].arm == 0;
  }
  model.variants = 0;
  int taken[3] = {0, 0, 0};
  while (model.variants < kMaxVariants) {
    int best = 0;
    for (int t = 1; t < tried; ++t)
      if (test.score[t] < test.score[best]) best = t;
    if (!(test.score[best] < kNearlyEndless)) break;
    test.score[best] = kEndless;
    const int arm = test.variant[best].arm;
    if (arm && ++taken[arm] > 3) continue;  // a few opinions from elsewhere are enough
    test.variant[best].open = static_cast<double>(test.trial[best].open) / kTestPoses;
    if (test.variant[best].arm) test.variant[best].open += 1;
    model.variant[model.variants++] = test.variant[best];
    test.trial[best].rank = model.variants;
  }
  model.by_signs = model.variants > 0 && signs_work(model, test);
  for (int t = 0; t < kTried; ++t) {
    trials[t] = test.trial[t];
    if (trials[t].rank > model.variants) trials[t].rank = 0;
  }
  __builtin_free(&test);
}

// Two arms whose links are turned and moved by about a thousandth: special geometry is gone, and with it what vanished.
inline void make_nearby(Model& model) {
  Random random{11};
  for (int arm = 1; arm < 3; ++arm)
    for (int k = 0; k < 7; ++k) {
      model.link[arm][k] = model.link[0][k];
      if (k == 0 || k == 6) continue;
      model.link[arm][k] = perturbed(model.link[0][k], arm == 1 ? kGeneralNearby : kGeneralNearbyToo, 1.0, random);
    }
}

// Whether the closed form for three slides returns the joints that made a pose.
inline bool slides_work(const Model& model) {
  Random random{2026};
  int hits = 0;
  for (int i = 0; i < kTestPoses; ++i) {
    double made[6];
    for (int k = 0; k < 6; ++k)
      made[k] = model.prismatic[k] ? 2 * random.uniform() - 1 : kTwoPi * random.uniform() - kPi;
    Found found;
    found.count = 0;
    if (!solve_slides(model, forward(model, made), found)) continue;
    const int before = found.count;
    insert(found, made, 1, 0, model.prismatic);
    hits += before > 0 && found.count == before;
  }
  return hits >= kTestPoses - 1;
}

// False when no variant is of use.
inline bool make_model(const General& arm, Model& model, Trial* trials) {
  __builtin_memset(static_cast<void*>(&model), 0, sizeof(Model));
  model.scale = arm.scale;
  for (int k = 0; k < 7; ++k) model.link[0][k] = read_rigid(arm.links[k][0], arm.scale);
  make_nearby(model);
  for (int k = 0; k < 6; ++k) {
    model.prismatic[k] = arm.slides[k];
    model.prismatic_count += model.prismatic[k];
  }
  model.farthest = model.prismatic_count ? __builtin_inf() : 0;
  for (int k = 1; k < 7; ++k)
    model.farthest += __builtin_sqrt(dot(model.link[0][k].t, model.link[0][k].t)) * (1 + kBeyondReach);
  if (model.prismatic_count == 3) {
    for (int t = 0; t < kTried; ++t) trials[t] = {0, 0, 0, 1.0};
    model.variants = slides_work(model);
  } else {
    choose_variants(model, trials);
    for (int t = 0; t < kTried; ++t)
      if (trials[t].rank > model.variants) trials[t].rank = 0;
  }
  return model.variants > 0;
}

}  // namespace pieper::PIEPER_ISA::general
