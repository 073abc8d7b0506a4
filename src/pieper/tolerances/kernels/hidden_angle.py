"""Of the families that hide an angle."""

#: What rounding leaves of the polynomial is below this, relative to the sum of its coefficients.
HIDDEN_NOISE = 3e-14
#: Above its degree the polynomial must vanish to this.
HIDDEN_DEGREE = 1e-12
#: Solutions of two ways that are one (rad; lengths), where a pose is not clear.
HIDDEN_SAME = 1e-5
#: A root is found when Halley's method moves it by less: its error is of the order of the cube then, and another step
#: is taken on the arm's own condition, which says when it is longer than it should be:
HIDDEN_ROOT_STEP = 1e-4
#: a step of Newton's shorter than this leaves nothing for another.
HIDDEN_NEAR_ROOT = 1e-10
#: One side of a root is believed when the other misses a hundred times more,
HIDDEN_SIDE = 1e-2
#: the first Newton step is no longer than this,
HIDDEN_FIRST_STEP = 1e-3
#: the last one than this,
HIDDEN_LAST_STEP = 1e-6
#: and slopes are at least this steep.
HIDDEN_SLOPE = 1e-6
#: What a square root is taken of, relative, below which two solutions are about to merge.
HIDDEN_ROOM = 1e-8
#: How far P must stand aside of the plane through axis 1 (lengths).
HIDDEN_ASIDE = 1e-4
#: Squared sine between two slides below which they are parallel.
HIDDEN_PARALLEL = 1e-10
#: Squared distance from axis 1 that a reciprocal is kept above.
HIDDEN_ON_AXIS = 1e-30
#: A polynomial that stays farther from zero than this, relative to the sum of its coefficients, has no root at poses
#: beside either: those that the careful look asks lie 1e-9 aside.
HIDDEN_EDGE = 1e-7
