// The work of CarefulLook. Compiled once, for the plainest processor: these poses are few.
#include "singular/careful.hpp"

#include "chain/posecheck.hpp"
#include "singular/from_aside.hpp"
#include "singular/look.hpp"

namespace pieper {

using namespace PIEPER_ISA;

struct CarefulLook::Own {
  const Solver& solver;
  SixJoints arm;
  Limits limits;
  double exact;
  bool closed_form;
  Look look;
  FromAside from_aside;

  // What there is at a pose by the poses beside it that are solved for certain; false where those are too few.
  bool by_poses_beside(const Rigid& T, const double* rows, int count, Read& out) const {
    std::vector<SolvedBeside> beside;
    bool both_ways = false;
    auto enough = [&] { return both_ways && static_cast<int>(beside.size()) >= FromAside::kPoses; };
    for (int bunch = 0; bunch < FromAside::kBunches && !enough(); ++bunch)
      if (!solved_beside(T, bunch, beside, both_ways)) return false;
    return enough() && from_aside(T, rows, count, beside, out);
  }
  // Adds those of a bunch of poses beside that are solved for certain, and tells whether two of them lie opposite each
  // other; false where it was stopped.
  bool solved_beside(const Rigid& T, int bunch, std::vector<SolvedBeside>& beside, bool& both_ways) const {
    constexpr int kPoses = FromAside::kBunch;
    const int slots = solver.slots();
    Rigid aside[kPoses];
    double poses[16 * kPoses];
    static thread_local std::vector<double> q;
    static thread_local std::vector<std::uint8_t> valid, inside;
    std::uint8_t flag[kPoses], outcome[kPoses];
    q.resize(6 * slots * kPoses), valid.resize(slots * kPoses), inside.resize(slots * kPoses);
    for (int k = 0; k < kPoses; ++k) {
      aside[k] = FromAside::aside(T, bunch, k);
      double* m = poses + 16 * k;
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) m[4 * r + c] = aside[k].r(r, c);
        m[4 * c + 3] = aside[k].p(c) * arm.length, m[12 + c] = 0;
      }
      m[15] = 1;
    }
    BadPose bad{};
    const Answers to = {q.data(), valid.data(), inside.data(), flag, outcome};
    if (solver.solve(poses, kPoses, 1, to, {}, bad, [](long) { return true; }) != Outcome::FINISHED) return false;
    for (int k = 0; k < FromAside::kBack; ++k)
      both_ways = both_ways || !((flag[k] | flag[FromAside::kPoses + k]) & kUncertain);
    for (int k = 0; k < kPoses; ++k) {
      if (flag[k] & kUncertain) continue;
      SolvedBeside one{aside[k], {}, 0};
      for (int s = slots * k; s < slots * (k + 1); ++s) {
        if (!valid[s]) continue;
        for (int i = 0; i < 6; ++i) one.rows.push_back(q[6 * s + i] / unit(i));
        ++one.count;
      }
      beside.push_back(std::move(one));
    }
    return true;
  }
  double unit(int i) const { return arm.slides[i] ? arm.length : 1.0; }
};

namespace {

constexpr int kMostRows = 256;

SixJoints joints_of(const std::uint8_t* prismatic, double length) {
  SixJoints arm{};
  arm.length = length;
  for (int k = 0; k < 6; ++k) arm.slides[k] = prismatic[k];
  return arm;
}

SixJoints arm_of(const double* links, const std::uint8_t* prismatic, double length) {
  SixJoints arm = joints_of(prismatic, length);
  for (int k = 0; k < 7; ++k) arm.links[k] = read_rigid(links + 16 * k, length);
  return arm;
}

SelfMotionSaid said_of(const SelfMotionRead& motion) {
  SelfMotionSaid said{};
  if (const auto* line = std::get_if<LineSelfMotion>(&motion)) {
    said.line = true, said.joints[0] = line->i, said.joints[1] = line->j, said.sense = line->sense;
    std::copy(line->through, line->through + 6, said.through);
    return said;
  }
  const auto& linkage = std::get<LinkageSelfMotion>(motion);
  said.flat = linkage.bar.flat, said.lead = linkage.lead, said.low = linkage.low, said.high = linkage.high,
  said.course = static_cast<int>(linkage.course);
  for (int k = 0; k < 4; ++k) {
    const Vec3 z = linkage.bar.axis[k];
    said.joints[k] = linkage.bar.joint[k], said.senses[k] = linkage.bar.sense[k];
    said.axes[k][0] = z.x, said.axes[k][1] = z.y, said.axes[k][2] = z.z;
    if (said.flat) said.spots[k][0] = linkage.bar.spot[k].real(), said.spots[k][1] = linkage.bar.spot[k].imag();
  }
  std::copy(linkage.through, linkage.through + 6, said.through);
  return said;
}

LinkageSelfMotion linkage_of(const SelfMotionSaid& said) {
  LinkageSelfMotion linkage{};
  linkage.lead = said.lead, linkage.low = said.low, linkage.high = said.high,
  linkage.course = static_cast<Course>(said.course), linkage.bar.flat = said.flat;
  for (int k = 0; k < 4; ++k) {
    linkage.bar.joint[k] = said.joints[k], linkage.bar.sense[k] = said.senses[k];
    linkage.bar.axis[k] = {said.axes[k][0], said.axes[k][1], said.axes[k][2]};
    linkage.bar.spot[k] = {said.spots[k][0], said.spots[k][1]};
  }
  linkage.bar.prepare();
  std::copy(said.through, said.through + 6, linkage.through);
  return linkage;
}

Limits limits_of(const SixJoints& arm, const double* lower, const double* upper) {
  Limits limits{};
  for (int k = 0; k < 6; ++k) {
    const double unit = arm.slides[k] ? arm.length : 1.0;
    limits.lower[k] = lower[k] / unit, limits.upper[k] = upper[k] / unit;
  }
  return limits;
}

}  // namespace

struct Linkage::Own {
  SixJoints arm;
  LinkageSelfMotion linkage;
};

Linkage::Linkage(const SelfMotionSaid& said, const std::uint8_t* prismatic, double length)
    : own_(new Own{joints_of(prismatic, length), linkage_of(said)}) {}
Linkage::~Linkage() = default;

void Linkage::point(double u, double* q) const { own_->linkage.point(u, q); }

double Linkage::place(const double* q) const {
  const LinkageSelfMotion& linkage = own_->linkage;
  double turned[4], u;
  for (int k = 0; k < 4; ++k) {
    const int joint = linkage.bar.joint[k];
    turned[k] = short_way(q[joint] - linkage.through[joint]);
  }
  return linkage.place(turned, u) ? u : NAN;
}

std::vector<double> Linkage::inside(const double* lower, const double* upper) const {
  const SixJoints& arm = own_->arm;
  LinkageSelfMotion per_length = own_->linkage;
  for (int i = 0; i < 6; ++i)
    if (arm.slides[i]) per_length.through[i] /= arm.length;
  std::vector<double> ends;
  for (const auto& stretch : per_length.inside(arm, limits_of(arm, lower, upper)))
    ends.push_back(stretch.from), ends.push_back(stretch.to);
  return ends;
}

CarefulLook::CarefulLook(const Solver& solver, const double* links, const std::uint8_t* prismatic, double length,
                         const double* lower, const double* upper, double exact, bool closed_form) {
  const SixJoints arm = arm_of(links, prismatic, length);
  const Limits limits = limits_of(arm, lower, upper);
  own_.reset(
      new Own{solver, arm, limits, exact, closed_form, Look(arm, limits), FromAside(arm, limits, solver.slots())});
}

CarefulLook::~CarefulLook() = default;

bool CarefulLook::look(const double* T, const double* q, int count, std::uint8_t flag, CarefulPose& out) const {
  const Own& own = *own_;
  double rows[kMostRows * 6], deviation, straight[16];
  if (count > kMostRows || (!own.closed_form && !(flag & kDegenerate))) return false;
  isa().deviation(T, 1, &deviation);
  if (deviation > own.exact) {
    isa().straighten(T, &deviation, own.exact, 1, straight);
    T = straight;
  }
  for (int k = 0; k < 6 * count; ++k) rows[k] = q[k] / own.unit(k % 6);
  static thread_local Read read;
  const Rigid pose = read_rigid(T, own.arm.length);
  if (!(own.closed_form ? own.look(pose, rows, count, read) : own.by_poses_beside(pose, rows, count, read)))
    return false;
  if (!own.closed_form && read.rows.empty()) return false;
  out.motions.clear();
  // of poses beside that are certain all solutions were seen to follow from these
  out.flag = own.closed_form ? flag : flag & ~(kUncertain | kOutOfReach);
  out.count = static_cast<int>(read.rows.size());
  out.q.clear(), out.inside.clear(), out.singular.clear(), out.branches.clear(), out.motion.clear();
  for (const Read::Row& row : read.rows) {
    bool ok = true;
    for (int i = 0; i < 6; ++i) {
      double value = row.q[i];
      ok &= turned_inside(value, own.arm.slides[i], own.limits.lower[i], own.limits.upper[i]);
      out.q.push_back(value * own.unit(i));
    }
    out.inside.push_back(ok), out.singular.push_back(row.singular);
    out.branches.push_back(row.branches), out.motion.push_back(row.motion);
  }
  for (const SelfMotionRead& motion : read.motions) {
    SelfMotionSaid said = said_of(motion);
    for (int i = 0; i < 6; ++i) said.through[i] *= own.unit(i);
    out.motions.push_back(said);
  }
  for (const NearCurve& curve : read.curves) {
    SelfMotionSaid said{};
    said.closed = curve.closed;
    for (const CurvePoint& p : curve.points)
      for (int i = 0; i < 6; ++i) said.points.push_back(p.q[i] * own.unit(i));
    out.motions.push_back(std::move(said));
  }
  return true;
}

}  // namespace pieper
