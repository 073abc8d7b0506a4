"""The printer of C (C99, and C++ as it stands)."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from pieper.code.between import ASKED, held_words
from pieper.code.c_linked import lines, linked, own_row
from pieper.code.c_pose import ANGLE, RIGID, nearest_of
from pieper.code.c_walk import walk
from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import USUAL, Language, Notation, counted, filled, functions
from pieper.code.staged import assign, loop_lines, staged
from pieper.tolerances import CLOSES, FILLED_STARTS, POLAR_SETTLES

C = Language(
    words=USUAL
    | functions("")
    | {"abs": "fabs({0})", "angle": "NAME_angle({0}, {1})", "atan2": "NAME_angle({0}, {1})", "true": "1", "false": "0"},
    assign=assign,
    loop=loop_lines,
    infinity="HUGE_VAL",
    truths=("0", "1"),
    manner=Manner("sin({0})", "cos({0})", "q[{0}]", 0, "  const double {0} = {1};", "NAME_side({0}, {1})"),
    texts='{}"',
    brackets="{}",
)


FRAME = """/*
@HEADER@

int NAME_ik(const double T[16], @VALUE@double q[][N]): the rows inside the limits, at most @SLOTS@; T row by
    row, base to tool; a rotation that was rounded is taken as the nearest one. A revolute joint comes in (-pi, pi],
    or where its limits exclude that, inside them. Returns how many, -1 where T is no rigid motion.
@SAID@int NAME_ik_all(T, @VALUE_SAID@q, &unclear): the rows before limits. unclear is set at and next to
    singular poses, where a row may stand for many and rows may be missing; each row that is given holds all the same.
void NAME_fk(const double q[N], double T[16]); void NAME_jacobian(const double q[N], double J[6][N]), linear rows first.
const char *NAME_label(const double q[N]): the posture's name, such as "front, elbow up, wrist flip"; "" where the
    postures of this arm have none.
int NAME_self_test(void): how many of @TESTS@ stored poses fail: 0. With -DNAME_MAIN a program that runs it.
*/
#include <math.h>

@LIMITS@static const int NAME_slides[AXES] = @SLIDES@;
@JOINT_SLIDES@static const double NAME_base[3][4] = @BASE@;

@ANGLE@@RIGID@
@WALK@
@AXES_AT@@NEAREST@@COUPLED@void NAME_fk(const double q[N], double T[16]) {
@TO_AXES@  NAME_walk(@V@, T, 0);
  T[12] = T[13] = T[14] = 0;
  T[15] = 1;
}

void NAME_jacobian(const double q[N], double J[6][N]) {
  double T[12], axes[AXES][6]@BY_AXES@;
  int i, k;
@TO_AXES@  NAME_walk(@V@, T, axes);
  for (i = 0; i < AXES; ++i)
    for (k = 0; k < 3; ++k) {
      const double *z = axes[i], *p = axes[i] + 3;
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      @OF_AXES@[k][i] = NAME_slides[i] ? z[k] : z[a] * (T[4 * b + 3] - p[b]) - z[b] * (T[4 * a + 3] - p[a]);
      @OF_AXES@[3 + k][i] = NAME_slides[i] ? 0 : z[k];
    }
@GEARED@}

/* Whole turns apart or not. */
static int NAME_same(const double *a, const double *b, double most) {
  int j;
  for (j = 0; j < N; ++j) {
    double d = fabs(a[j] - b[j]);
    if (!@JOINTS_SLIDE@[j]) d = fabs(d - 6.28318530717958647693 * floor(d / 6.28318530717958647693 + 0.5));
    if (!(d < most)) return 0;
  }
  return 1;
}

int NAME_ik_all(const double asked[16], @VALUE@double q[][N], int *unclear) {
  double @POSE@[16], rows[@ROOM@][6];
  int valid[@ROOM@] = {0}, doubt = 0, m, j, k, count = 0;
  if (!NAME_rigid(asked, @POSE@)) return -1;
@MOVED@@PROGRAM@
  *unclear = doubt;
  for (m = 0; m < @SLOTS@; ++m) {
    double own[N]@BACK@;
    int keep = 1;
    if (!valid[m]) continue;
@OWN_ROW@@FILLED@    for (k = 0; keep@TWINS@ && k < count; ++k) keep = !NAME_same(own, q[k], 1e-9);
    if (keep@DOUBT@) {
@TESTED@@WALKED@      for (k = 0; k < @ENTRIES@; ++k) keep = keep && fabs(back[@ENTRY@] - @POSE@[@ENTRY@]) < @VERIFIED@;
    }
    if (!keep) continue;
    for (j = 0; j < N; ++j) q[count][j] = own[j];
    ++count;
  }
@FROM_AXES@  return count;
}

@TURNS@/* Whole turns where only they lie inside the limits; whether all joints do then. */
static int NAME_inside(double *q) {
@TIED@@TURNED@  return @INSIDE@;
}

int NAME_ik(const double T[16], @VALUE@double q[][N]) {
  double all[@SLOTS@][N];
  int unclear, m, j, count = 0;
  const int found = NAME_ik_all(T, @VALUE_SAID@all, &unclear);
  if (found < 0) return found;
  for (m = 0; m < found; ++m) {
    for (j = 0; j < N; ++j) q[count][j] = all[m][j];
    count += NAME_inside(q[count]);
  }
  return count;
}

/* 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way. */
static inline int NAME_side(double v, double facing) {
  if (facing < 0) v = -v;
  return v > @NO_SIDE@ ? 0 : v < -@NO_SIDE@ ? 1 : 2;
}

const char *NAME_label(const double @LABELLED@[N]) {
  static const char *const names[] = @NAMES@;
@LABEL_AXES@@SUMS@
  (void)q;
  return names[@PLACE@];
}

int NAME_self_test(void) {
  static const double q[@TESTS@][N] = @TEST_Q@;
  static const double T[@TESTS@][16] = @TEST_T@;
  static const int counts[@TESTS@] = @COUNTS@;
  int i, k, failed = 0;
  for (i = 0; i < @TESTS@; ++i) {
    double back[16], pose[16], rows[@SLOTS@ + 1][N];
    int found, met = 0, ok = NAME_rigid(T[i], pose);
    NAME_fk(q[i], back);
    for (k = 0; k < 16; ++k) ok = ok && fabs(back[k] - pose[k]) < @VERIFIED@;
    found = NAME_ik(T[i], @TEST_VALUE@rows);
    for (k = 0; k < found; ++k) {
@FOUND_AXES@      met = met || NAME_same(@FOUND_ROW@, 1e-7);
    }
    failed += !(ok && met && found == counts[i]);
  }
  return failed;
}

#ifdef NAME_MAIN
#include <stdio.h>
int main(void) {
  const int failed = NAME_self_test();
  printf("%d of @TESTS@ poses failed\\n", failed);
  return failed != 0;
}
#endif
""".replace("@RIGID@", RIGID).replace("@ANGLE@", ANGLE)


def own_parts(export: Export) -> dict[str, str]:
    """Return what C says of what lies between the arm's joints and the six that are solved; C++ says it so too."""
    return {name: counted(text, export) for name, text in _own_parts(export).items()}


def _own_parts(export: Export) -> dict[str, str]:
    own = export.between
    held = own.held is not None
    parts = {
        "SLOTS": str(export.solved.spec.max_solutions),
        "ROOM": str(max(8, export.solved.spec.max_solutions)),
        "LIMITS": ""
        if own.tied is None
        else f"static const double NAME_lower[N] = {C.numbers(export.lower)};\n"
        f"static const double NAME_upper[N] = {C.numbers(export.upper)};\n",
        "BASE": C.numbers(export.links[0]),
        "WALK": walk(export),
        "ONE_STEP": repr(POLAR_SETTLES),
        **_inside(export),
        "VALUE": "double value, " if held else "",
        "VALUE_SAID": "value, " if held else "",
        "SAID": f"    value: where joint {own.held + 1} is held, rad or m; it has one to spare.\n"
        if own.held is not None
        else f"    {held_words(own)}" * bool(own.fixed),
        "POSE": "given" if held else "T",
        "MOVED": _moved(export) if held else "",
        "OWN_ROW": own_row(own),
        "NEAREST": nearest_of(own, export.solved.chain.length),
        "BACK": ", back[12]" if own.weights else "",
        "WALKED": "" if own.weights else "      double back[12];\n      NAME_walk(own, back, 0);\n",
        "FILLED": "".join(
            f"    keep = keep && fabs(rows[m][{column}]) < {FILLED_STARTS * unit!r};\n" for column, unit in own.filled
        )
        + (
            f"    keep = keep && NAME_nearest(own, {'given' if held else 'T'}, back) < {CLOSES!r};\n"
            if own.weights
            else ""
        ),
        # two slots may say one row where a joint is filled or slides, and else where roots merge, which is a doubt
        "TWINS": "" if own.always or any(export.slides) else " && doubt",
        "DOUBT": "" if own.always else " && doubt",
        "ENTRIES": str(len(own.tested)),
        "ENTRY": "k" if len(own.tested) == len(ASKED["pose"]) else "tested[k]",
        "TESTED": ""
        if len(own.tested) == len(ASKED["pose"])
        else f"      static const int tested[] = {{{', '.join(map(str, own.tested))}}};\n",
        "TEST_VALUE": f"q[i][{own.held}], " if held else "",
        **dict.fromkeys(("AXES_AT", "COUPLED", "TO_AXES", "GEARED", "FROM_AXES", "TIED", "LABEL_AXES"), ""),
        "V": "q",
        "LABELLED": "q",
        "FOUND_AXES": "",
        "FOUND_ROW": "rows[k], q[i]",
        "BY_AXES": ", by[6][AXES]" if own.linked else "",
        "OF_AXES": "by" if own.linked else "J",
        "JOINT_SLIDES": f"static const int NAME_joint_slides[N] = {_slides(export.joints_slide)};\n" * own.linked,
        "JOINTS_SLIDE": "NAME_joint_slides" if own.linked else "NAME_slides",
    }
    if own.gears is None or own.back is None:
        return parts
    if own.linked:
        return parts | linked(own.gears, own.back, own)
    wrap = (
        "  for (j = 0; j < N; ++j)\n    if (!NAME_slides[j]) q[j] -= 6.28318530717958647693 * "
        "ceil((q[j] - 3.14159265358979323846) / 6.28318530717958647693);\n"
    )
    parts |= {
        "COUPLED": "/* The joints are coupled: where the axes are at joint vectors q. */\n"
        "static void NAME_axes(const double *q, double *v) {\n"
        + lines(own.sums(own.gears, "q[{}]".format), "v")
        + "}\n\n/* The joints' numbers in place of the values of the axes. */\nstatic void NAME_joints(double *q) {\n"
        "  double v[N];\n  int j;\n  for (j = 0; j < N; ++j) v[j] = q[j];\n"
        + lines(own.sums(own.back, "v[{}]".format), "q")
        + (wrap if own.wraps else "")
        + "}\n\n",
        "TO_AXES": "  double v[N];\n  NAME_axes(q, v);\n",
        "V": "v",
        "FOUND_AXES": "      double a[N], b[N];\n      NAME_axes(rows[k], a);\n      NAME_axes(q[i], b);\n",
        "FOUND_ROW": "a, b",
        "GEARED": "  for (k = 0; k < 6; ++k) {\n    double row[N];\n    for (i = 0; i < N; ++i) row[i] = J[k][i];\n"
        + lines(own.sums(own.gears.T, "row[{}]".format), "J[k]", "    ")
        + "  }\n",
        "FROM_AXES": "  for (m = 0; m < count; ++m) NAME_joints(q[m]);\n",
        "LABELLED": "given",
        "LABEL_AXES": "  double q[N];\n  NAME_axes(given, q);\n",
    }
    if own.tied is None or own.moves is None or own.weight is None:
        return parts
    tied_joints = [int(j) for j in np.flatnonzero(own.tied)]
    rows = ", ".join("{" + ", ".join(repr(float(move[j])) for j in tied_joints) + "}" for move in own.moves)
    parts["COUPLED"] += (
        "/* Joints whose numbers whole turns of the axes move together, and how. */\n"
        f"static const int NAME_together[{len(tied_joints)}] = {{{', '.join(map(str, tied_joints))}}};\n"
        f"static const double NAME_weight[N] = {{{', '.join(repr(float(w)) for w in own.weight)}}};\n"
        f"static const double NAME_moves[{len(own.moves)}][{len(tied_joints)}] = {{{rows}}};\n\n"
        "/* The shortest move that brings them inside, where one does. */\nstatic void NAME_move(double *q) {\n"
        "  double least = HUGE_VAL;\n  int best = -1, i, k, inside = 1;\n"
        f"  for (i = 0; i < {len(tied_joints)}; ++i) {{\n    const int j = NAME_together[i];\n"
        "    inside = inside && q[j] >= NAME_lower[j] && q[j] <= NAME_upper[j];\n  }\n  if (inside) return;\n"
        f"  for (k = 0; k < {len(own.moves)}; ++k) {{\n    double away = 0;\n    inside = 1;\n"
        f"    for (i = 0; i < {len(tied_joints)}; ++i) {{\n      const int j = NAME_together[i];\n"
        "      const double v = q[j] + NAME_moves[k][i];\n"
        "      inside = inside && v >= NAME_lower[j] && v <= NAME_upper[j];\n"
        "      away += NAME_weight[j] * NAME_moves[k][i] * NAME_moves[k][i];\n    }\n"
        "    if (inside && away < least) least = away, best = k;\n  }\n  if (best < 0) return;\n"
        f"  for (i = 0; i < {len(tied_joints)}; ++i) q[NAME_together[i]] += NAME_moves[best][i];\n}}\n\n"
    )
    parts["TIED"] = "  NAME_move(q);\n"
    return parts


def _slides(slides: Sequence[bool]) -> str:
    return C.listed(C.truths[int(s)] for s in slides)


def _moved(export: Export) -> str:
    """Return the lines that take the held joint off a pose."""
    own = export.between
    assert own.taken_off is not None and own.held is not None
    K, slides = own.taken_off, export.slides[own.held]
    out = "  double T[16], moved[16];\n"
    out += "" if slides else "  const double turn_c = cos(value), turn_s = sin(value);\n"
    for i in range(4):
        for j in range(4):
            pairs = [
                (K[i, k], f"given[{4 * k + j}]") if own.at_base else (K[k, j], f"given[{4 * i + k}]") for k in range(4)
            ]
            text = " + ".join(f"({float(x)!r}) * {entry}" for x, entry in pairs if x != 0) or "0"
            out += f"  moved[{4 * i + j}] = {text};\n"
    for i in range(4):
        for j in range(4):
            a, b = (f"moved[{j}]", f"moved[{4 + j}]") if own.at_base else (f"moved[{4 * i}]", f"moved[{4 * i + 1}]")
            row_or_column = i if own.at_base else j
            plain = f"moved[{4 * i + j}]"
            text = plain
            if slides:
                if own.at_base and i == 2:
                    text = f"{plain} - value * moved[{12 + j}]"
                elif not own.at_base and j == 3:
                    text = f"{plain} - value * moved[{4 * i + 2}]"
            elif row_or_column < 2:
                # seen from the base the turn is taken back from rows, seen from the tool from columns
                first, sign = ("turn_c", "turn_s"), (1 if own.at_base else -1)
                plus, minus = ("+", "-") if sign > 0 else ("-", "+")
                text = (
                    f"{first[0]} * {a} {plus} {first[1]} * {b}"
                    if row_or_column == 0
                    else f"{first[0]} * {b} {minus} {first[1]} * {a}"
                )
            out += f"  T[{4 * i + j}] = {text};\n"
    return out


def _inside(export: Export) -> dict[str, str]:
    """Return the lines that turn joints inside their limits by whole turns where one can, and what says so."""
    own, turned, truths = export.between, "", []
    for j, (low, high, slides) in enumerate(zip(export.lower, export.upper, export.joints_slide, strict=True)):
        whole = own.gears is None and not slides  # comes in (-pi, pi]
        kept = slides or (own.tied is not None and bool(own.tied[j]))
        if whole and low <= -np.pi and high >= np.pi:
            continue
        below, above = (f"({limit!r})" if limit < 0 else repr(limit) for limit in (float(low), float(high)))
        ends = [f"(q[{j}] >= {below})"] * bool(np.isfinite(low)) + [f"(q[{j}] <= {above})"] * bool(np.isfinite(high))
        truths += [" & ".join(ends)] if ends else []
        if kept or (whole and low > -np.pi and high < np.pi):
            continue
        turned += f"  if (q[{j}] < {below}) q[{j}] += NAME_turns({below} - q[{j}]);\n" * bool(np.isfinite(low))
        turned += f"  if (q[{j}] > {above}) q[{j}] -= NAME_turns(q[{j}] - {above});\n" * bool(np.isfinite(high))
    counted = (
        "static double NAME_turns(double v) { return 6.28318530717958647693 * ceil(v / 6.28318530717958647693); }\n\n"
    )
    return {
        "TURNS": "/* Whole turns that are no less. */\n" + counted if turned else "",
        "TURNED": turned,
        "INSIDE": " &\n         ".join(truths) or "q[0] == q[0]",
    }


def text(export: Export) -> str:
    """Return the file's text."""
    program = staged(export.program, C.words, C.entry)
    parts = own_parts(export) | Notation.parts(C, export)
    parts |= {"PROGRAM": program}
    for name in ("TEST_Q", "TEST_T"):
        short = parts[name].replace(", ", ",").replace(".0,", ",").replace(".0}", "}")
        parts[name] = re.sub(r"(?<![0-9.])0\.", ".", short)
    return filled(FRAME, parts, export)
