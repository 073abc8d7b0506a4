"""The printer of C (C99, and C++ as it stands)."""

from __future__ import annotations

from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import USUAL, Language, filled, functions

C = Language(
    words=USUAL | functions("") | {"abs": "fabs({0})", "angle": "NAME_angle({0}, {1})", "true": "1", "false": "0"},
    assign=lambda name, truth, expression: f"  const {'int' if truth else 'double'} {name} = {expression};",
    infinity="HUGE_VAL",
    truths=("0", "1"),
    manner=Manner("sin({0})", "cos({0})", "q[{0}]", 0, "  const double {0} = {1};", "NAME_side({0}, {1})"),
    texts='{}"',
    brackets="{}",
    per_row=("{{{}}}", ", "),
)


FRAME = """/*
@HEADER@

int NAME_ik(const double T[16], double q[][N]): the rows inside the limits, at most 8; T row by row, base to tool. A
    revolute joint comes in (-pi, pi], or where its limits exclude that, inside them. Returns how many.
int NAME_ik_all(T, q, &unclear): the rows before limits. unclear is set at and next to singular poses, where a row may
    stand for many and rows may be missing; each row that is given holds all the same.
void NAME_fk(const double q[N], double T[16]); void NAME_jacobian(const double q[N], double J[6][N]), linear rows first.
const char *NAME_label(const double q[N]): the posture's name, such as "front, elbow up, wrist flip"; "" where the
    postures of this arm have none.
int NAME_self_test(void): how many of @TESTS@ stored poses fail: 0. With -DNAME_MAIN a program that runs it.
*/
#include <math.h>

static const double NAME_lower[N] = @LOWER@;
static const double NAME_upper[N] = @UPPER@;
static const int NAME_slides[N] = @SLIDES@;
static const double NAME_links[N1][12] = @LINKS@;

/* An angle that rounds to -pi is said as pi. */
static double NAME_angle(double y, double x) {
  const double r = atan2(y, x);
  return r <= -3.14159265358979323846 ? 3.14159265358979323846 : r;
}

/* A pose (12 numbers, row by row) times a link. */
static void NAME_times(double *T, const double *L) {
  int i, j;
  for (i = 0; i < 3; ++i) {
    double row[4];
    for (j = 0; j < 4; ++j) row[j] = T[4 * i] * L[j] + T[4 * i + 1] * L[4 + j] + T[4 * i + 2] * L[8 + j];
    row[3] += T[4 * i + 3];
    for (j = 0; j < 4; ++j) T[4 * i + j] = row[j];
  }
}

/* To the tool; z and p of each joint's frame into axes where that is not null. */
static void NAME_walk(const double *q, double *T, double (*axes)[6]) {
  int i, k;
  for (k = 0; k < 12; ++k) T[k] = NAME_links[0][k];
  for (i = 0; i < N; ++i) {
    const double c = cos(q[i]), s = sin(q[i]);
    for (k = 0; k < 3; ++k) {
      double *row = T + 4 * k;
      const double x = row[0], y = row[1];
      if (axes) axes[i][k] = row[2], axes[i][3 + k] = row[3];
      if (NAME_slides[i]) row[3] += q[i] * row[2];
      else row[0] = c * x + s * y, row[1] = c * y - s * x;
    }
    NAME_times(T, NAME_links[i + 1]);
  }
}

void NAME_fk(const double q[N], double T[16]) {
  NAME_walk(q, T, 0);
  T[12] = T[13] = T[14] = 0;
  T[15] = 1;
}

void NAME_jacobian(const double q[N], double J[6][N]) {
  double T[12], axes[N][6];
  int i, k;
  NAME_walk(q, T, axes);
  for (i = 0; i < N; ++i)
    for (k = 0; k < 3; ++k) {
      const double *z = axes[i], *p = axes[i] + 3;
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      J[k][i] = NAME_slides[i] ? z[k] : z[a] * (T[4 * b + 3] - p[b]) - z[b] * (T[4 * a + 3] - p[a]);
      J[3 + k][i] = NAME_slides[i] ? 0 : z[k];
    }
}

/* Whole turns apart or not. */
static int NAME_same(const double *a, const double *b, double most) {
  int j;
  for (j = 0; j < N; ++j) {
    double d = fabs(a[j] - b[j]);
    if (!NAME_slides[j]) d = fabs(d - 6.28318530717958647693 * floor(d / 6.28318530717958647693 + 0.5));
    if (!(d < most)) return 0;
  }
  return 1;
}

int NAME_ik_all(const double T[16], double q[][N], int *unclear) {
@PROGRAM@
  const double rows[8][N] = {@ROWS@};
  const int valid[8] = {@VALID@};
  int m, j, k, count = 0;
  *unclear = @UNCLEAR@;
  for (m = 0; m < 8; ++m) {
    int keep = valid[m];
    for (k = 0; keep && k < count; ++k) keep = !NAME_same(rows[m], q[k], 1e-9);
    if (keep && *unclear) {
      double back[12];
      NAME_walk(rows[m], back, 0);
      for (k = 0; k < 12; ++k) keep = keep && fabs(back[k] - T[k]) < @VERIFIED@;
    }
    if (!keep) continue;
    for (j = 0; j < N; ++j) q[count][j] = rows[m][j];
    ++count;
  }
  return count;
}

int NAME_ik(const double T[16], double q[][N]) {
  double all[8][N];
  int unclear, m, j, count = 0;
  const int found = NAME_ik_all(T, all, &unclear);
  for (m = 0; m < found; ++m) {
    int inside = 1;
    for (j = 0; j < N; ++j) {
      double v = all[m][j];
      const double turn = 6.28318530717958647693;
      if (!NAME_slides[j] && v < NAME_lower[j]) v += turn * ceil((NAME_lower[j] - v) / turn);
      else if (!NAME_slides[j] && v > NAME_upper[j]) v -= turn * ceil((v - NAME_upper[j]) / turn);
      inside = inside && v >= NAME_lower[j] && v <= NAME_upper[j];
      q[count][j] = v;
    }
    count += inside;
  }
  return count;
}

/* 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way. */
static inline int NAME_side(double v, double facing) {
  if (facing < 0) v = -v;
  return v > @NO_SIDE@ ? 0 : v < -@NO_SIDE@ ? 1 : 2;
}

const char *NAME_label(const double q[N]) {
  static const char *const names[] = @NAMES@;
@SUMS@
  (void)q;
  return names[@PLACE@];
}

int NAME_self_test(void) {
  static const double q[@TESTS@][N] = @TEST_Q@;
  static const double T[@TESTS@][16] = @TEST_T@;
  static const int counts[@TESTS@] = @COUNTS@;
  int i, k, failed = 0;
  for (i = 0; i < @TESTS@; ++i) {
    double back[16], rows[9][N];
    int found, ok = 1, met = 0;
    NAME_fk(q[i], back);
    for (k = 0; k < 16; ++k) ok = ok && fabs(back[k] - T[i][k]) < @VERIFIED@;
    found = NAME_ik(T[i], rows);
    for (k = 0; k < found; ++k) met = met || NAME_same(rows[k], q[i], 1e-7);
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
"""


def text(export: Export) -> str:
    """Return the file's text."""
    return filled(FRAME, C.parts(export), export)
