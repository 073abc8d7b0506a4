// Every piece of what four joints that close on themselves can do: the whole of a fibre of a pose. Scalar.
#pragma once

#include <variant>
#include <vector>

#include "singular/motions.hpp"

namespace pieper::PIEPER_ISA {

using SelfMotionRead = std::variant<LineSelfMotion, LinkageSelfMotion>;

inline LineSelfMotion line_of(const double* q, const Standing& at, int i, int j) {
  LineSelfMotion line{{}, std::min(i, j), std::max(i, j), dot(at.z[i], at.z[j]) > 0 ? 1.0 : -1.0};
  std::copy(q, q + kSix, line.through);
  return line;
}

// What the leading joint of a four-bar can do: mine(x) = other(y) asks for a cosine of x - phase in [bottom, top].
struct Reach {
  bool some;           // neither side is constant
  bool high, low;      // the sides' highest values, or their lowest, are equal: courses cross there
  bool stuck;          // a highest is the other's lowest: only there the linkage closes
  double least, most;  // how far from its phase it can go, rad
  bool round() const { return least == 0 && most == kPi; }

  Reach(const Harmonic& mine, const Harmonic& other) {
    some = std::fmin(mine.size, other.size) > kLoopCritical;
    high = low = stuck = false, least = most = 0;
    if (!some) return;
    const double top = (other.middle + other.size - mine.middle) / mine.size,
                 bottom = (other.middle - other.size - mine.middle) / mine.size,
                 blur = kLoopTouches * (1 + std::fabs(mine.middle) + mine.size + other.size) / mine.size;
    high = std::fabs(top - 1) < blur, low = std::fabs(bottom + 1) < blur;
    stuck = std::fabs(top + 1) < blur || std::fabs(bottom - 1) < blur;
    least = high || top >= 1 ? 0 : std::acos(std::fmax(top, -1.0));
    most = low || bottom <= -1 ? kPi : std::acos(std::fmin(bottom, 1.0));
  }
};

// The pieces of a four-bar that stands at q, lines among them; none where it is stuck. False where the solutions are a surface, or
// none of the joints can lead.
inline bool pieces_of(const double* q, const Standing& at, FourBar& bar, std::vector<SelfMotionRead>& out) {
  bar.prepare();
  int together[2] = {-1, -1}, twice = -1, plain = -1, critical = 0;
  Reach plainly(bar.side[0][0], bar.side[0][1]);
  for (int lead = 0; lead < 4; ++lead) {
    const Reach reach(bar.side[lead][0], bar.side[lead][1]);
    if (!reach.some) continue;
    if (reach.stuck) return true;
    critical += reach.high || reach.low;
    if (reach.high && reach.low) together[lead % 2] = together[lead % 2] < 0 ? lead : together[lead % 2];
    else if ((reach.high || reach.low) && reach.round()) twice = twice < 0 ? lead : twice;
    else if (plain < 0 || (reach.round() && !plainly.round())) plain = lead, plainly = reach;
  }
  auto piece = [&](int lead, double low, double high, Course course) {
    LinkageSelfMotion whole{{}, bar, lead, low, high, course};
    std::copy(q, q + kSix, whole.through);
    return whole;
  };
  for (
      int lead :
      together) {  // two joints may stand still while one pair of opposite ones moves, and the other pair cannot tell that
    if (lead < 0) continue;
    const int i2 = (lead + 1) % 4, i4 = (lead + 3) % 4;
    for (Course course : {Course::ALIKE, Course::AGAINST}) {
      const LinkageSelfMotion whole = piece(lead, -kPi, kPi, course);
      double a[6], b[6];
      whole.point(0.1, a), whole.point(0.35, b);
      const double still = std::fabs(short_way(a[bar.joint[i2]] - b[bar.joint[i2]])) +
                           std::fabs(short_way(a[bar.joint[i4]] - b[bar.joint[i4]]));
      if (still > kLinkageTogether) {
        out.emplace_back(whole);
        continue;
      }
      LineSelfMotion line = line_of(a, at, bar.joint[lead], bar.joint[(lead + 2) % 4]);
      const double sum = short_way(a[line.i] + a[line.j] - b[line.i] - b[line.j]);
      line.sense = std::fabs(sum) < kLinkageTogether ? 1 : -1;
      out.emplace_back(line);
    }
  }
  if (together[0] >= 0 || together[1] >= 0) return true;
  if (twice >= 0) {
    const Harmonic& mine = bar.side[twice][0];
    const double crosses = Reach(mine, bar.side[twice][1]).high ? mine.phase : mine.phase + kPi;
    out.emplace_back(piece(twice, crosses, crosses, Course::ROUND_TWICE));
    return true;
  }
  if (critical) return false;
  if (plain >= 0) {
    const double phase = bar.side[plain][0].phase, least = plainly.least, most = plainly.most;
    if (plainly.round()) {
      const bool above = short_way(-bar.opposite(plain).phase) >= 0;  // the solution's own piece first
      out.emplace_back(piece(plain, phase - kPi, phase + kPi, above ? Course::ABOVE : Course::BELOW));
      out.emplace_back(piece(plain, phase - kPi, phase + kPi, above ? Course::BELOW : Course::ABOVE));
    } else if (least == 0) {
      out.emplace_back(piece(plain, phase - most, phase + most, Course::BACK));
    } else if (most == kPi) {
      out.emplace_back(piece(plain, phase + least, phase + kTwoPi - least, Course::BACK));
    } else {
      const double sign = short_way(-phase) > 0 ? 1 : -1;
      for (double s : {sign, -sign}) {
        const double a = phase + s * least, b = phase + s * most;
        out.emplace_back(piece(plain, std::fmin(a, b), std::fmax(a, b), Course::BACK));
      }
    }
    return true;
  }
  // two neighbours in one line, and the others a triangle with it
  int pairs = 0, first = -1;
  for (int k = 0; k < 4; ++k)
    if (line_gap(at, bar.joint[k], bar.joint[(k + 1) % 4]) <= kNextToLinkage) ++pairs, first = k;
  if (pairs != 1) return false;
  out.emplace_back(line_of(q, at, bar.joint[first], bar.joint[(first + 1) % 4]));
  return true;
}

}  // namespace pieper::PIEPER_ISA
