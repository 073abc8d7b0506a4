"""What the C of an export does with poses: a rounded rotation made one again, and a row brought nearest to its pose."""

from __future__ import annotations

from pieper.code.between import Between
from pieper.tolerances import HOLDS_TO_ROUNDING, NEWTON_FINITE

#: Two steps of Newton's iteration for the polar factor, each of which squares what is off: nothing is left of 1e-5.
RIGID = """
/* The pose that T means: a rotation that was rounded becomes the nearest one; 0 where T is no rigid motion. */
static int NAME_rigid(const double *T, double *X) {
  double G[3][3];
  int a, b, k, step, ok = fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1) <= @ACCEPTED@;
  for (k = 0; k < 16; ++k) X[k] = k < 12 ? T[k] : k == 15;
  ok = ok && X[0] * (X[5] * X[10] - X[6] * X[9]) + X[1] * (X[6] * X[8] - X[4] * X[10]) +
                     X[2] * (X[4] * X[9] - X[5] * X[8]) > 0;
  for (step = 0; step < 2; ++step) {
    for (a = 0; a < 3; ++a)
      for (b = 0; b < 3; ++b) {
        G[a][b] = X[a] * X[b] + X[4 + a] * X[4 + b] + X[8 + a] * X[8 + b];
        ok = ok && fabs(G[a][b] - (a == b)) <= @ACCEPTED@ && fabs(X[4 * a + 3]) < HUGE_VAL;
      }
    for (k = 0; k < 12; k += 4) {
      const double x = X[k], y = X[k + 1], z = X[k + 2];
      for (b = 0; b < 3; ++b) X[k + b] = 1.5 * X[k + b] - 0.5 * (x * G[0][b] + y * G[1][b] + z * G[2][b]);
    }
  }
  return ok;
}
"""
#: Of arms with filled joints: a row becomes the joint vector whose pose comes nearest to what was asked.
NEAREST = """
/* Least squares: the joint vector whose pose comes nearest to T; by how much it misses. */
static double NAME_nearest(double *q, const double *T) {
  static const int tested[] = {@ENTRIES_TESTED@};
  static const double weight[] = {@WEIGHTS@};
  int step, i, j, k;
  for (step = 0;; ++step) {
    double P[12], axes[N][6], A[N][N1] = {{0}}, miss = 0;
    NAME_walk(q, P, axes);
    for (k = 0; k < @ENTRIES@; ++k) {
      const double r = weight[k] * (T[tested[k]] - P[tested[k]]);
      miss += r * r;
    }
    if (step == 3 || miss < @SETTLED@) return sqrt(miss);
    for (k = 0; k < @ENTRIES@; ++k) {
      const int e = tested[k], c = e % 4, a = (e / 4 + 1) % 3, b = (e / 4 + 2) % 3;
      const double r = weight[k] * (T[e] - P[e]);
      double D[N];
      for (j = 0; j < N; ++j) {
        const double *z = axes[j], *p = axes[j] + 3, o = c == 3;
        const double turned = z[a] * (P[4 * b + c] - o * p[b]) - z[b] * (P[4 * a + c] - o * p[a]);
        D[j] = weight[k] * (NAME_slides[j] ? o * z[e / 4] : turned);
      }
      for (i = 0; i < N; ++i) {
        for (j = 0; j < N; ++j) A[i][j] += D[i] * D[j];
        A[i][N] += D[i] * r;
      }
    }
    for (i = 0; i < N; ++i) A[i][i] *= 1 + @DAMPED@;
    for (i = 0; i < N; ++i)
      for (k = i + 1; k < N; ++k) {
        const double by = A[k][i] / A[i][i];
        for (j = i; j <= N; ++j) A[k][j] -= by * A[i][j];
      }
    for (i = N - 1; i >= 0; --i) {
      for (j = i + 1; j < N; ++j) A[i][N] -= A[i][j] * A[j][N];
      A[i][N] /= A[i][i];
      q[i] += A[i][N];
    }
  }
}
"""


def nearest_of(own: Between) -> str:
    """Return the function that brings rows nearest to the pose, of arms with filled joints; else nothing."""
    if not own.filled:
        return ""
    text = NEAREST.replace("@ENTRIES_TESTED@", ", ".join(map(str, own.tested)))
    text = text.replace("@WEIGHTS@", ", ".join(map(repr, own.weights))).replace("@ENTRIES@", str(len(own.tested)))
    text = text.replace("@DAMPED@", repr(NEWTON_FINITE)).replace("@SETTLED@", repr(HOLDS_TO_ROUNDING**2))
    return text.removeprefix("\n") + "\n"
