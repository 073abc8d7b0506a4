"""What the C of an export does with poses: a rounded rotation made one again, and a row brought nearest to its pose."""

from __future__ import annotations

from pieper.code.between import STEPS, Between
from pieper.tolerances import CLOSES, HOLDS_TO_ROUNDING, NEWTON_FINITE

#: The kernels' arctangent (kernels/lanes/math.hpp) without a branch: what is not known beforehand is looked up. A
#: library's own takes two or three times as long.
ANGLE = """/* The angle of (x, y) in (-pi, pi]; 0 for (0, 0). NaN in, NaN out. */
static double NAME_angle(double y, double x) {
  static const double turn[] = {0, 0.78539816339744830962, 1.57079632679489661923, 0.78539816339744830962,
                                3.14159265358979323846, 2.35619449019234492885, 1.57079632679489661923,
                                2.35619449019234492885};
  static const double low[] = {0, 3.061616997868383e-17, 6.123233995736766e-17, 3.061616997868383e-17,
                               1.2246467991473532e-16, 9.184850993605148e-17, 6.123233995736766e-17,
                               9.184850993605148e-17};
  static const double sense[] = {1, 1, -1, -1, -1, -1, 1, 1}, half[] = {0, 1};
  const double ay = fabs(y), ax = fabs(x), large = ay > ax ? ay : ax, small = ay > ax ? ax : ay;
  const int middle = small > large * 0.41421356237309503, place = middle + 2 * (ay > ax) + 4 * (x < 0);
  const double z = (small - half[middle] * large) / (large + half[middle] * small + 1e-300), t = z * z, t2 = t * t;
  const double p = -0.33333333333333204 + t * 0.19999999999954846 +
                   t2 * (-0.14285714280310588 + t * 0.11111110788747243);
  const double q = -0.09090897901285451 + t * 0.07692062652872914 +
                   t2 * (-0.06663130696725132 + t * 0.058480766634173724);
  const double s = -0.05040123450359924 + t * 0.03808479461027858 - t2 * 0.01792881487686344;
  const double r = turn[place] + (sense[place] * (z + z * t * (p + t2 * t2 * (q + t2 * t2 * s))) + low[place]);
  const double angle = copysign(r, y + 0.0);
  return angle <= -3.14159265358979323846 ? 3.14159265358979323846 : angle;
}
"""
#: Two steps of Newton's iteration for the polar factor, each of which squares what is off: nothing is left of 1e-5.
RIGID = """
/* The pose that T means: a rotation that was rounded becomes the nearest one; 0 where T is no rigid motion. */
static int NAME_rigid(const double *T, double *X) {
  int k, step, ok = fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1) <= @ACCEPTED@;
  for (k = 0; k < 16; ++k) X[k] = k < 12 ? T[k] : k == 15;
  ok = ok && X[0] * (X[5] * X[10] - X[6] * X[9]) + X[1] * (X[6] * X[8] - X[4] * X[10]) +
                     X[2] * (X[4] * X[9] - X[5] * X[8]) > 0 && fabs(X[3]) + fabs(X[7]) + fabs(X[11]) < HUGE_VAL;
  for (step = 0; step < 2; ++step) {
    const double a = X[0] * X[0] + X[4] * X[4] + X[8] * X[8] - 1, b = X[1] * X[1] + X[5] * X[5] + X[9] * X[9] - 1,
      c = X[2] * X[2] + X[6] * X[6] + X[10] * X[10] - 1, d = X[0] * X[1] + X[4] * X[5] + X[8] * X[9],
      e = X[0] * X[2] + X[4] * X[6] + X[8] * X[10], f = X[1] * X[2] + X[5] * X[6] + X[9] * X[10];
    ok = ok && fabs(a) <= @ACCEPTED@ && fabs(b) <= @ACCEPTED@ && fabs(c) <= @ACCEPTED@ && fabs(d) <= @ACCEPTED@ &&
         fabs(e) <= @ACCEPTED@ && fabs(f) <= @ACCEPTED@;
    for (k = 0; k < 12; k += 4) {
      const double x = X[k], y = X[k + 1], z = X[k + 2];
      X[k] -= 0.5 * (x * a + y * d + z * e);
      X[k + 1] -= 0.5 * (x * d + y * b + z * f);
      X[k + 2] -= 0.5 * (x * e + y * f + z * c);
    }
    if (a * a + b * b + c * c + d * d + e * e + f * f < @ONE_STEP@) break;
  }
  return ok;
}
"""
#: By how many squares of a step (rad, lengths of the arm) what is missed may depart from its straight model, and more:
#: entries of a pose have second derivatives of at most a length of the arm, twelve of them count.
BENDS = 8.0
#: Of arms with filled or linked joints: a row becomes the joint vector whose pose comes nearest to what was asked.
NEAREST = """
/* Least squares: the joint vector whose pose comes nearest to T; its pose, P, and by how much that misses. */
static double NAME_nearest(double *q, const double *T, double *P) {
  static const int tested[] = {@ENTRIES_TESTED@};
  static const double weight[] = {@WEIGHTS@};
  double miss = 0;
  int step, i, j, k;
  for (step = 0;; ++step) {
    double axes[AXES][6], A[N][N1] = {{0}}, g[N], left, size = 0;
@TO_AXES@    NAME_walk(@V@, P, axes);
    for (miss = 0, k = 0; k < @ENTRIES@; ++k) {
      const double r = weight[k] * (T[tested[k]] - P[tested[k]]);
      miss += r * r;
    }
    if (step == @STEPS@ || miss < @SETTLED@) break;
    for (k = 0; k < @ENTRIES@; ++k) {
      const int e = tested[k], c = e % 4, a = (e / 4 + 1) % 3, b = (e / 4 + 2) % 3;
      const double r = weight[k] * (T[e] - P[e]);
      double D[N]@BY@;
      for (j = 0; j < AXES; ++j) {
        const double *z = axes[j], *p = axes[j] + 3, o = c == 3;
        const double turned = z[a] * (P[4 * b + c] - o * p[b]) - z[b] * (P[4 * a + c] - o * p[a]);
        @OF@[j] = weight[k] * (NAME_slides[j] ? o * z[e / 4] : turned);
      }
@BY_JOINTS@@FIXED@      for (i = 0; i < N; ++i) {
        for (j = 0; j < N; ++j) A[i][j] += D[i] * D[j];
        A[i][N] += D[i] * r;
      }
    }
    for (i = 0; i < N; ++i) A[i][i] *= 1 + @DAMPED@, g[i] = A[i][N];
@HOLDING@    for (i = 0; i < N; ++i)
      for (k = i + 1; k < N; ++k) {
        const double by = A[k][i] / A[i][i];
        for (j = i; j <= N; ++j) A[k][j] -= by * A[i][j];
      }
    for (i = N - 1; i >= 0; --i) {
      for (j = i + 1; j < N; ++j) A[i][N] -= A[i][j] * A[j][N];
      A[i][N] /= A[i][i];
      q[i] += A[i][N];
    }
    /* What no step takes away: the least the straight model leaves, but for twice what it bends by on the way. */
    for (left = miss, i = 0; i < N; ++i) {
      left -= g[i] * A[i][N];
      size += fabs(A[i][N]) * (@JOINTS_SLIDE@[i] ? @PER_LENGTH@ : 1);
    }
    size = 2 * @CLOSES@ + @BENDS@ * size * size;
    if (left > size * size) return sqrt(left);
  }
  for (j = 0; j < N; ++j)
    if (!@JOINTS_SLIDE@[j])
      q[j] -= 6.28318530717958647693 * ceil((q[j] - 3.14159265358979323846) / 6.28318530717958647693);
  return sqrt(miss);
}
"""


def nearest_of(own: Between, length: float) -> str:
    """Return the function that brings rows nearest to the pose, of arms with filled or linked joints; else nothing."""
    if not own.weights:
        return ""
    text = NEAREST.replace("@ENTRIES_TESTED@", ", ".join(map(str, own.tested)))
    text = text.replace("@WEIGHTS@", ", ".join(map(repr, own.weights))).replace("@ENTRIES@", str(len(own.tested)))
    text = text.replace("@DAMPED@", repr(NEWTON_FINITE)).replace("@SETTLED@", repr(HOLDS_TO_ROUNDING**2))
    text = (
        text.replace("@PER_LENGTH@", repr(1 / length)).replace("@CLOSES@", repr(CLOSES)).replace("@BENDS@", repr(BENDS))
    )
    by_joints = ""
    if own.linked and own.gears is not None:
        by_joints = "".join(
            f"      D[{j}] = {sum_};\n" for j, sum_ in enumerate(own.sums(own.gears.T, "by[{}]".format))
        )
    said = {
        "STEPS": str(STEPS),
        "TO_AXES": "    double v[AXES];\n    NAME_axes(q, v);\n" if own.linked else "",
        "V": "v" if own.linked else "q",
        "BY": ", by[AXES]" if own.linked else "",
        "OF": "by" if own.linked else "D",
        "BY_JOINTS": by_joints,
        "FIXED": "".join(f"      D[{j}] = 0;\n" for j in own.fixed),
        "HOLDING": "".join(f"    A[{j}][{j}] = 1;\n" for j in own.fixed),
        "JOINTS_SLIDE": "NAME_joint_slides" if own.linked else "NAME_slides",
    }
    for word, what in said.items():
        text = text.replace(f"@{word}@", what)
    return text.removeprefix("\n") + "\n"
