// A number type that records: a kernel run with it does no arithmetic but writes down what it would do, operation by operation.
//
// Nodes are kept once (hash consing), constants are folded, and both ways of every `any` are taken: a kernel has no other
// branch on a value, and a loop that values end is `repeat`. Included before the kernels, after lanes.hpp; `recording_math.hpp` follows math.hpp.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "lanes/lanes.hpp"

namespace pieper::PIEPER_ISA {

struct Node {
  std::string op;
  int a, b, c;
  double value;
};

// A step that is taken again and again: what goes in, what one step makes of it, and whether anything still moves (nodes). Inside,
// the state is "carry" (loop, place); behind it, "after" (loop, place).
struct Loop {
  int steps;
  std::vector<int> start, next;
  int moving;
};

struct Tape {
  std::vector<Node> nodes;
  std::vector<Loop> loops;
  std::map<std::tuple<std::string, int, int, int, double>, int> known;

  int add(const std::string& op, int a = -1, int b = -1, int c = -1, double value = 0) {
    const auto key = std::make_tuple(op, a, b, c, value);
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    nodes.push_back({op, a, b, c, value});
    return known[key] = static_cast<int>(nodes.size()) - 1;
  }
  bool constant(int i) const { return nodes[i].op == "const"; }
  bool is(int i, double value) const { return constant(i) && nodes[i].value == value; }
  bool is(int i, const char* op) const { return nodes[i].op == op; }
  double value(int i) const { return nodes[i].value; }
};
// The tape that is written to; one at a time, under the interpreter's lock.
inline Tape* tape = nullptr;

struct Recorded {
  int i = -1;
  Recorded() = default;
  Recorded(double value) : i(tape->add("const", -1, -1, -1, value == 0 ? 0.0 : value)) {}
  static Recorded of(int i) {
    Recorded r;
    r.i = i;
    return r;
  }
};
struct RecordedMask {
  int i = -1;
  RecordedMask() = default;
  RecordedMask(bool value) : i(tape->add(value ? "true" : "false")) {}
  static RecordedMask of(int i) {
    RecordedMask m;
    m.i = i;
    return m;
  }
};
template <> struct NumberTraits<Recorded> {
  static constexpr int width = 1;
  using Mask = RecordedMask;
};

inline Recorded operator-(Recorded a) {
  if (tape->constant(a.i)) return Recorded(-tape->value(a.i));
  if (tape->is(a.i, "neg")) return Recorded::of(tape->nodes[a.i].a);
  return Recorded::of(tape->add("neg", a.i));
}

#define PIEPER_RECORD(op, name, ...)                                                                       \
  inline Recorded operator op(Recorded a, Recorded b) {                                                    \
    if (tape->constant(a.i) && tape->constant(b.i)) return Recorded(tape->value(a.i) op tape->value(b.i)); \
    __VA_ARGS__                                                                                            \
    return Recorded::of(tape->add(name, a.i, b.i));                                                        \
  }                                                                                                        \
  inline Recorded operator op(Recorded a, double b) { return a op Recorded(b); }                           \
  inline Recorded operator op(double a, Recorded b) { return Recorded(a) op b; }                           \
  inline Recorded& operator op## = (Recorded & a, Recorded b) { return a = a op b; }                       \
  inline Recorded& operator op## = (Recorded & a, double b) { return a = a op Recorded(b); }
PIEPER_RECORD(+, "add", if (tape->is(a.i, 0.0)) return b; if (tape->is(b.i, 0.0)) return a;)
PIEPER_RECORD(-, "sub", if (tape->is(a.i, 0.0)) return -b; if (tape->is(b.i, 0.0)) return a;)
PIEPER_RECORD(*, "mul", if (tape->is(a.i, 0.0) || tape->is(b.i, 0.0)) return Recorded(0.0);
              if (tape->is(a.i, 1.0)) return b; if (tape->is(b.i, 1.0)) return a; if (tape->is(a.i, -1.0)) return -b;
              if (tape->is(b.i, -1.0)) return -a;)
PIEPER_RECORD(/, "div", if (tape->is(b.i, 1.0)) return a;)
#undef PIEPER_RECORD

#define PIEPER_RECORD(op, name)                                                                                \
  inline RecordedMask operator op(Recorded a, Recorded b) {                                                    \
    if (tape->constant(a.i) && tape->constant(b.i)) return RecordedMask(tape->value(a.i) op tape->value(b.i)); \
    return RecordedMask::of(tape->add(name, a.i, b.i));                                                        \
  }                                                                                                            \
  inline RecordedMask operator op(Recorded a, double b) { return a op Recorded(b); }                           \
  inline RecordedMask operator op(double a, Recorded b) { return Recorded(a) op b; }
PIEPER_RECORD(<, "lt")
PIEPER_RECORD(<=, "le")
PIEPER_RECORD(>, "gt")
PIEPER_RECORD(>=, "ge")
PIEPER_RECORD(==, "eq")
PIEPER_RECORD(!=, "ne")
#undef PIEPER_RECORD

inline RecordedMask operator&(RecordedMask a, RecordedMask b) {
  if (tape->is(a.i, "false") || tape->is(b.i, "true") || a.i == b.i) return a;
  if (tape->is(b.i, "false") || tape->is(a.i, "true")) return b;
  return RecordedMask::of(tape->add("and", a.i, b.i));
}
inline RecordedMask operator|(RecordedMask a, RecordedMask b) {
  if (tape->is(a.i, "true") || tape->is(b.i, "false") || a.i == b.i) return a;
  if (tape->is(b.i, "true") || tape->is(a.i, "false")) return b;
  return RecordedMask::of(tape->add("or", a.i, b.i));
}
inline RecordedMask operator!(RecordedMask a) {
  if (tape->is(a.i, "true")) return RecordedMask(false);
  if (tape->is(a.i, "false")) return RecordedMask(true);
  return RecordedMask::of(tape->add("not", a.i));
}
// What may be asked is taken to be so, unless it never is; what must hold for all is taken not to, unless it always does.
inline bool any(RecordedMask m) { return !tape->is(m.i, "false"); }
inline bool all(RecordedMask m) { return tape->is(m.i, "true"); }

inline Recorded select(RecordedMask m, Recorded a, Recorded b) {
  if (tape->is(m.i, "true") || a.i == b.i) return a;
  if (tape->is(m.i, "false")) return b;
  return Recorded::of(tape->add("select", m.i, a.i, b.i));
}
inline Recorded select(RecordedMask m, Recorded a, double b) { return select(m, a, Recorded(b)); }
inline Recorded select(RecordedMask m, double a, Recorded b) { return select(m, Recorded(a), b); }
inline Recorded select(RecordedMask m, double a, double b) { return select(m, Recorded(a), Recorded(b)); }

inline Recorded one_argument(const char* name, Recorded a, double (*fold)(double)) {
  if (tape->constant(a.i)) return Recorded(fold(tape->value(a.i)));
  return Recorded::of(tape->add(name, a.i));
}
inline Recorded abs(Recorded a) { return one_argument("abs", a, std::fabs); }
inline Recorded sqrt(Recorded a) { return one_argument("sqrt", a, std::sqrt); }
inline Recorded max(Recorded a, Recorded b) { return select(a > b, a, b); }
inline Recorded min(Recorded a, Recorded b) { return select(a < b, a, b); }
// One step is written down.
template <int Count, class Step> void repeat(int steps, Recorded (&state)[Count], Step step) {
  const int own = static_cast<int>(tape->loops.size());
  tape->loops.push_back({steps, {}, {}, -1});
  std::vector<int> start, next;
  for (int k = 0; k < Count; ++k) {
    start.push_back(state[k].i);
    state[k] = Recorded::of(tape->add("carry", own, k));
  }
  const RecordedMask moving = step();
  for (int k = 0; k < Count; ++k) {
    next.push_back(state[k].i);
    state[k] = Recorded::of(tape->add("after", own, k));
  }
  tape->loops[own] = {steps, start, next, moving.i};
}
inline double lane(Recorded, int) { return 0; }
inline void set_lane(Recorded&, int, double) {}

}  // namespace pieper::PIEPER_ISA

#include "lanes/math.hpp"

// Angles by the target language's own functions: every one of them is good to an ulp or two.
namespace pieper::PIEPER_ISA {

inline Recorded atan2(Recorded y, Recorded x) { return Recorded::of(tape->add("angle", y.i, x.i)); }
inline Recorded atan2_closed(Recorded y, Recorded x) { return Recorded::of(tape->add("atan2", y.i, x.i)); }
inline void sincos(Recorded x, Recorded& s, Recorded& c) {
  s = one_argument("sin", x, std::sin);
  c = one_argument("cos", x, std::cos);
}
inline void sincos_of_turns(Recorded x, Recorded& s, Recorded& c) { sincos(x, s, c); }

}  // namespace pieper::PIEPER_ISA
