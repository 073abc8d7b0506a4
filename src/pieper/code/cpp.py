"""The printer of C++: the kernel itself, its headers joined into one, with the arm's prepared numbers."""

from __future__ import annotations

import hashlib
import re
from typing import Any, cast

import numpy as np

from pieper import _kernel
from pieper.code import c
from pieper.code.c import own_parts
from pieper.code.c_pose import RIGID
from pieper.code.export import Export
from pieper.code.kernel_source import fingerprint, header_of, joined
from pieper.code.labels import Manner
from pieper.code.language import Notation, filled

FLAGS = "-std=c++20 -O3 -ffp-contract=fast -fno-math-errno -fno-trapping-math"

FRAME = """/*
@HEADER@

The kernel as the library has it, all in one header for g++ or clang++; any number of arms in any number of units.
Compile with @FLAGS@
and what your processor has (-march=native); do not use -ffast-math, which forgets what NaN is.

std::vector<std::array<double, N>> NAME_ik(T): the rows inside the limits; T 16 numbers row by row, base to tool. A
    revolute joint comes in (-pi, pi], or where its limits exclude that, inside them. Throws std::invalid_argument where
    T is no rigid motion.
@SAID@int NAME_ik(const double T[16], @VALUE@double q[][N]): the same into room for @SLOTS@ rows; returns how
    many, -1 where T is no rigid motion.
int NAME_ik_all(T, @VALUE_SAID@q, &unclear): the rows before limits. unclear is set at and next to singular
    poses, where a row may stand for many, and where the family cannot vouch that nothing is missing.
long NAME_ik_many(T, count, @VALUE_SAID@q, valid, in_limits, flag): many poses at once, the fastest way: q
    count x @SLOTS@ x N, valid and in_limits count x @SLOTS@, flag count. Returns the first pose
    that is no rigid motion, or count.
void NAME_fk(const double q[N], double T[16]); void NAME_jacobian(const double q[N], double J[6][N]), linear rows first.
const char* NAME_label(const double q[N]): the posture's name, such as "front, elbow up, wrist flip"; "" where the
    postures of this arm have none.
int NAME_self_test(): how many of @TESTS@ stored poses fail: 0. With -DNAME_MAIN a program that runs it.
*/
#pragma once
#ifndef NAME_PLAIN
#include <array>
#include <stdexcept>
#include <vector>
#endif
#ifndef __GNUC__
#error "the kernels use vector types that g++ and clang++ have"
#endif
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi" /* said at the end of a unit, so it is not taken back */
#endif
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wparentheses"
#if defined(__AVX512DQ__) && defined(__AVX512VL__)
#define PIEPER_ISA taken8
#define PIEPER_LANES 8
#elif defined(__AVX2__)
#define PIEPER_ISA taken4
#define PIEPER_LANES 4
#else
#define PIEPER_ISA taken2
#define PIEPER_LANES 2
#endif
@KERNEL@
/* What tells this arm from another of the same name, in another library of the same program. */
inline namespace NAME_@ARM@ {
using NAME_arm_type = @MARK@::PIEPER_ISA::Taken<@MARK@::@OWN@, @MARK@::PIEPER_ISA::@OWN@Kernel>;
#undef PIEPER_ISA
#undef PIEPER_LANES
#pragma GCC diagnostic pop

inline const NAME_arm_type& NAME_arm() {
  static const double numbers[] = @NUMBERS@;
  static const double general[] = @GENERAL@;
  static const double links[] = @SIX_LINKS@;
  static const double lower[] = @SIX_LOWER@;
  static const double upper[] = @SIX_UPPER@;
  static const unsigned char slides[] = @SIX_SLIDES@;
  static const NAME_arm_type arm(numbers, sizeof general > sizeof(double) ? general : nullptr,
                                 {links, lower, upper, slides});
  return arm;
}

@OWN_PART@@HANDY@@TEST@}

#ifdef NAME_MAIN
#include <cstdio>
int main() {
  const int failed = NAME_self_test();
  std::printf("%d of @TESTS@ poses failed\\n", failed);
  return failed != 0;
}
#endif
"""


#: Of an arm whose six joints are its own: the kernel's rows are its rows.
DIRECT = """\
inline long NAME_ik_many(const double* T, long count, double* q, unsigned char* valid, unsigned char* in_limits,
                         unsigned char* flag) {
  return NAME_arm().solve(T, count, q, valid, in_limits, flag);
}

/* The rows that a mask has, to the front of q; how many. */
inline int NAME_chosen(const double* rows, const unsigned char* mask, double (*q)[N]) {
  int count = 0;
  for (int m = 0; m < @SLOTS@; ++m) {
    if (!mask[m]) continue;
    for (int j = 0; j < N; ++j) q[count][j] = rows[N * m + j];
    ++count;
  }
  return count;
}

inline int NAME_ik_all(const double T[16], double (*q)[N], int* unclear) {
  double rows[@SLOTS@ * N];
  unsigned char valid[@SLOTS@], inside[@SLOTS@], flag = 0;
  if (NAME_arm().solve(T, 1, rows, valid, inside, &flag) == 0) return -1;
  *unclear = (flag & 3) != 0;
  return NAME_chosen(rows, valid, q);
}

inline int NAME_ik(const double T[16], double (*q)[N]) {
  double rows[@SLOTS@ * N];
  unsigned char valid[@SLOTS@], inside[@SLOTS@], flag = 0;
  if (NAME_arm().solve(T, 1, rows, valid, inside, &flag) == 0) return -1;
  return NAME_chosen(rows, inside, q);
}

inline void NAME_fk(const double q[N], double T[16]) { NAME_arm().fk(q, 1, T); }
inline void NAME_jacobian(const double q[N], double (*J)[N]) { NAME_arm().jacobian(q, 1, J[0]); }

/* 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way. */
inline int NAME_side(double v, double facing) {
  if (facing < 0) v = -v;
  return v > @NO_SIDE@ ? 0 : v < -@NO_SIDE@ ? 1 : 2;
}

inline const char* NAME_label(const double q[N]) {
  static const char* const names[] = @NAMES@;
@SUMS@
  (void)q;
  return names[@PLACE@];
}

"""

HANDY = """#ifndef NAME_PLAIN
inline std::vector<std::array<double, N>> NAME_ik(const double T[16]@VALUE_LAST@) {
  double q[@SLOTS@][N];
  const int count = NAME_ik(T, @VALUE_SAID@q);
  if (count < 0) throw std::invalid_argument("NAME_ik: T is no rigid motion.");
  std::vector<std::array<double, N>> rows(count);
  for (int m = 0; m < count; ++m)
    for (int j = 0; j < N; ++j) rows[m][j] = q[m][j];
  return rows;
}
inline std::vector<std::array<double, N>> NAME_ik(const std::array<double, 16>& T@VALUE_LAST@) {
  return NAME_ik(T.data()@LAST@);
}
inline std::array<double, 16> NAME_fk(const std::array<double, N>& q) {
  std::array<double, 16> T;
  NAME_fk(q.data(), T.data());
  return T;
}
#endif

"""

TEST = (
    re.sub(r"^static int", "inline int", RIGID, flags=re.MULTILINE)
    .replace("fabs", "__builtin_fabs")
    .replace("HUGE_VAL", "__builtin_inf()")
    + """
constexpr bool NAME_slides(int joint) { return (@SLIDE_BITS@ >> joint) & 1; }

inline int NAME_self_test() {
  static const double q[@TESTS@][N] = @TEST_Q@;
  static const double T[@TESTS@][16] = @TEST_T@;
  static const int counts[@TESTS@] = @COUNTS@;
  int failed = 0;
  for (int i = 0; i < @TESTS@; ++i) {
    double back[16], pose[16], rows[@SLOTS@][N];
    NAME_fk(q[i], back);
    bool ok = NAME_rigid(T[i], pose), met = false;
    for (int k = 0; k < 16; ++k) ok = ok && __builtin_fabs(back[k] - pose[k]) < @VERIFIED@;
    const int found = NAME_ik(T[i], rows);
    for (int m = 0; m < found && !met; ++m) {
      double reached[16], worst = 0;
      NAME_fk(rows[m], reached);
      for (int k = 0; k < 16; ++k) worst = __builtin_fmax(worst, __builtin_fabs(reached[k] - pose[k]));
      ok = ok && worst < @VERIFIED@;
      met = true;
      for (int j = 0; j < N; ++j) {
        const double d = rows[m][j] - q[i][j], turn = 6.28318530717958647693;
        met = met && __builtin_fabs(NAME_slides(j) ? d : d - turn * __builtin_floor(d / turn + 0.5)) < 1e-7;
      }
    }
    failed += !(ok && met && found == counts[i]);
  }
  return failed;
}
"""
)


def numbers_of(geometry: Any) -> tuple[list[float], list[float]]:
    """Return a geometry's numbers in the order of its fields, and those of the general solver that helps it."""
    out: list[float] = []
    general: list[float] = []
    for value in geometry.__getstate__().values():
        if isinstance(value, _kernel.General):
            general, _ = numbers_of(value)
        elif isinstance(value, list):  # a choice of up to six whole numbers
            chosen = cast("list[int]", value)
            out += [float(len(chosen)), *map(float, chosen), *[0.0] * (6 - len(chosen))]
        elif value is not None:
            out += [float(x) for x in np.asarray(value, dtype=np.float64).ravel()]
    return out, general


CPP = Notation(
    infinity="__builtin_inf()",
    truths=("0", "1"),
    manner=Manner(
        "__builtin_sin({0})", "__builtin_cos({0})", "q[{0}]", 0, "  const double {0} = {1};", "NAME_side({0}, {1})"
    ),
    brackets="{}",
    texts='{}"',
)


#: Of any other arm beside C's own: one pose after the other.
MANY = """inline long NAME_ik_many(const double* T, long count, @VALUE@double* q, unsigned char* valid,
                         unsigned char* in_limits, unsigned char* flag) {
  for (long i = 0; i < count; ++i, T += 16, q += N * @SLOTS@, valid += @SLOTS@, in_limits += @SLOTS@) {
    int unclear = 0;
    const int found = NAME_ik_all(T, @VALUE_SAID@reinterpret_cast<double (*)[N]>(q), &unclear);
    if (found < 0) return i;
    for (int m = 0; m < @SLOTS@; ++m) {
      valid[m] = m < found;
      for (int j = 0; m >= found && j < N; ++j) q[N * m + j] = 0;
      in_limits[m] = m < found && NAME_inside(q + N * m);
    }
    flag[i] = static_cast<unsigned char>(unclear);
  }
  return count;
}

"""
SOLVED = """  unsigned char held[@SLOTS@], inside_six[@SLOTS@], flag = 0;
  if (NAME_arm().solve(T, 1, rows[0], held, inside_six, &flag) == 0) return -1;
  for (m = 0; m < @SLOTS@; ++m) valid[m] = held[m];
  doubt = (flag & 3) != 0;
"""


def _between(parts: dict[str, str]) -> str:
    """Return what C says of joints that are not the six, around the kernel's rows, as a header says it."""
    own = c.FRAME[c.FRAME.index("@LIMITS@") : c.FRAME.index("#ifdef NAME_MAIN")]
    first, last = own.index(c.ANGLE), own.index("/* The pose that T means")
    own = own[:first] + own[last:]
    own = re.sub(r"^(int|void|const char \*)(?= ?NAME_)", r"inline \1", own, flags=re.MULTILINE)
    own = re.sub(r"^static (int|void|double) (?=NAME_\w+\()", r"static inline \1 ", own, flags=re.MULTILINE)
    for name in ("AXES_AT", "COUPLED", "NEAREST", "WALK", "TURNS"):
        parts[name] = re.sub(r"^static (int|void|double) ", r"static inline \1 ", parts[name], flags=re.MULTILINE)
    at = own.index("/* 0 where v is positive")
    return "#include <math.h>\n" + own[:at] + MANY + own[at:]


def text(export: Export) -> str:
    """Return the file's text."""
    plan, own = export.solved, export.between
    family, header = header_of(plan.family)
    numbers, general = numbers_of(plan.spec.geometry)
    six = plan.reduction.six(plan.defaults)
    direct = own.plain and own.held is None
    ends = np.tile([-np.inf, np.inf], (6, 1))
    lower, upper = (export.lower, export.upper) if direct else ends.T
    slots = str(plan.spec.max_solutions)
    parts = CPP.parts(export) | own_parts(export)
    parts |= {
        "FLAGS": FLAGS,
        "KERNEL": joined("code/taken.hpp", *(("elimination/general.hpp",) if general else ()), header),
        "ARM": hashlib.sha256(repr((numbers, general, export.header, sorted(parts.items()))).encode()).hexdigest()[:12],
        "MARK": f"pieper_{fingerprint()}",
        "OWN": family,
        "SLOTS": slots,
        "NUMBERS": CPP.numbers(numbers),
        "GENERAL": CPP.numbers(general or [0.0]),
        "SIX_LINKS": CPP.numbers(six.links.ravel()),
        "SIX_LOWER": CPP.numbers(lower),
        "SIX_UPPER": CPP.numbers(upper),
        "SIX_SLIDES": CPP.listed(CPP.truths[int(s)] for s in six.sliding),
        "SLIDE_BITS": str(sum(1 << j for j, s in enumerate(export.joints_slide) if s)),
        "VALUE_LAST": "" if own.held is None else ", double value",
        "LAST": "" if own.held is None else ", value",
        "PROGRAM": SOLVED.replace("@SLOTS@", slots).rstrip("\n"),
    }
    body = DIRECT + HANDY + TEST if direct else _between(parts) + HANDY
    return filled(FRAME.replace("@OWN_PART@@HANDY@@TEST@", body), parts, export)
