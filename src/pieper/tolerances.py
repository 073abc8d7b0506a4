"""Every tolerance, named for why it exists. Lengths are relative to the arm's characteristic length."""

from __future__ import annotations

#: A pose whose rotation part departs from a rotation by more than this (max abs of R^T R - I) is refused;
#: below it, down to `ROTATION_EXACT`, it is replaced by the nearest rotation. float32 rounding gives about 3e-7.
ROTATION_ACCEPTED = 1e-5
#: Departures up to here are the rounding of double arithmetic and are not worth a remark.
ROTATION_EXACT = 1e-12

#: Axes are taken for parallel, and points for one point, when they miss by no more than this (rad; per length).
#: It is the size of rounding in tables that were typed exactly, not of drawing noise.
GEOMETRY_EXACT = 1e-12

#: A solution counts as verified when forward kinematics returns the pose within this (per length; rad).
VERIFIED = 1e-9

#: Solutions closer than this (rad, or per length for a prismatic joint) are one solution.
SAME_SOLUTION = 1e-7

#: A limit is not violated by less than this (rad, or per length for a prismatic joint): rounding at a stop.
LIMIT_SLACK = 1e-9

#: sigma_min / sigma_max of the scaled Jacobian below which a solution is looked at for self-motion and merged roots.
SINGULAR_EXAMINED = 1e-6

#: Divisors are kept at least this far from zero where zero is meant and answered otherwise.
TINY = 1e-300

# ---- solver, kinematics, motion ----
#: Newton steps end where a pose is missed by no more than this (per length; rad): the rounding of forward kinematics.
NEWTON_DONE = 1e-15
#: Below this they end as well once what is missed has not halved for three steps; above it they go on.
NEWTON_STALLS = 1e-13
#: What a solution may miss its pose by after polishing (per length; rad).
CLOSES = 1e-9
#: A point of a self-motion must hold the pose this well (per length; rad). A pose 1e-12 away from a singular one moves
#: farther along its null direction.
ON_CURVE = 2e-13
#: Longest step along a self-motion (rad; per length): joints turn visibly, and chords cut corners by about 2e-3.
CURVE_STEP = 0.12
#: Rows of a kernel closer than this (rad; per length) are one: a double root is known to ten times `SAME_SOLUTION`.
SAME_ROW = 10 * SAME_SOLUTION
#: A filled joint that comes out below this was meant to be zero: the pose is one the arm can reach (rad; per length).
FILLED_ZERO = 1e-6
#: Points that differ in a task's virtual joints alone are one within this (rad; per length): curves end there.
SAME_AFTER_CUT = 1e-6
#: Relative sigma_min above which a pose that a kernel marked is not looked at further: a double root at 1e-12 stays below.
CLEARLY_REGULAR = 1.5e-7
#: Poses on a singularity, or without rows, that `ik_many` looks at one by one in a call: it bounds the work of a call.
MOST_CAREFUL = 500
#: Poses of a redundant arm in a call of `ik_many` whose self-motions are traced because no slice through them was met.
MOST_TRACED = 20
