"""Every tolerance, named for why it exists. Lengths are relative to the arm's characteristic length.

This is the one page for Python and C++: the build writes a header for the kernels from what stands before the first
section and from the sections named kernels, NAME becoming kName.
"""

from __future__ import annotations

#: A pose whose rotation part departs from a rotation by more than this (max abs of R^T R - I) is refused;
#: below it, down to `ROTATION_EXACT`, it is replaced by the nearest rotation. float32 rounding gives about 3e-7.
ROTATION_ACCEPTED = 1e-5
#: Departures up to here are the rounding of double arithmetic and are not worth a remark.
ROTATION_EXACT = 1e-12

#: Axes are parallel, and points one point, when they miss by no more than this (rad; per length): rounding alone.
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
#: What a solution may miss its pose by after polishing (per length; rad).
CLOSES = 1e-9
#: Longest step along a self-motion (rad; per length): joints turn visibly, and chords cut corners by about 2e-3.
CURVE_STEP = 0.12
#: Rows of a kernel closer than this (rad; per length) are one: a double root is known to ten times `SAME_SOLUTION`.
SAME_ROW = 10 * SAME_SOLUTION
#: A filled joint that comes out below this was meant to be zero: the pose is one the arm can reach (rad; per length).
FILLED_ZERO = 1e-6
#: Points that differ in a task's virtual joints alone are one within this (rad; per length): curves end there.
SAME_AFTER_CUT = 1e-6

# ---- kernels: of the look at singular rows, and Newton's method there ----
#: A point of a self-motion must hold the pose this well (per length; rad): poses 1e-12 from a singular one move farther.
ON_CURVE = 2e-13
#: Two axes are one line, four are parallel or meet, when they miss by no more (rad; per length): as `ON_CURVE`.
IN_ONE_LINE = 2e-13
#: Parts of a unit null direction below this stand still, or would on the self-motion next to the pose.
LOOP_MOVES = 1e-4
#: Axes that miss being a linkage by less than this are next to a self-motion.
NEXT_TO_LINKAGE = 1e-5
#: A side of a linkage smaller than this is constant: its joint can neither lead nor follow.
LOOP_CRITICAL = 1e-9
#: Two ends of what the sides of a linkage can be are one within this (of their sizes): rounding.
LOOP_TOUCHES = 1e-14
#: Three neighbouring axes are parallel or meet in one point within this (rad; per length): what families take them for.
GROUP_EXACT = 2e-12
#: Relative size of the second smallest singular value above which a singular row has one null direction only.
ONE_WAY_FREE = 1e-5
#: A row beside a self-motion is isolated where its singular value is at least this part of what its axes miss by.
NEARLY_IN_LINE = 0.03
#: Axes that a motion of the other joints brings into place, at the cost of less than this to the pose, are in place.
UNNOTICED = 2e-14
#: What a merged root misses to second order (per rad^2) above which higher orders do not count.
CLEAR_FOLD = 1e-3
#: Relative sigma_min above which a marked pose is not looked at further: kernels tell twins of a root apart above 1e-8.
CLEARLY_REGULAR = 1.5e-7
#: Newton steps end where a pose is missed by no more than this (per length; rad): the rounding of forward kinematics.
NEWTON_DONE = 1e-15
#: Below this they end as well once what is missed has not halved for three steps; above it they go on.
NEWTON_STALLS = 1e-13
#: Columns whose cosine is no more than this are at right angles (and two angles, rad, are one): rounding of their sums.
ORTHOGONAL = 1e-15
#: A row this near a self-motion is a point of it (rad; per length).
ON_SELF_MOTION = 1e-9
#: Relative singular values below which kernels may give one point for two solutions beside a self-motion.
ROOTS_APART = 1e-11
#: Solutions beside a self-motion are known to rounding over the singular value: nearer than this they are one (rad).
SAME_ALONG = 0.03
#: What such solutions may miss the pose by (per length; rad).
HOLDS_TO_ROUNDING = 1e-14
#: Directions weaker than this (relative) are not corrected in when a curve is followed that nearly holds the pose.
CURVE_WEAK = 1e-6
#: Merged roots closer than this (rad; per length) are one.
MERGED_SAME = 1e-7
#: What forward kinematics cannot tell from the pose (per length; rad), in the one direction that counts,
MERGED_ALONG = 6e-16
#: and in all.
MERGED_ROUNDING = 2e-15
#: Rows farther apart than this (rad; per length) are never called one.
MERGED_BLUR = 5e-3
#: Rows on two sides of a singularity (neighbouring roots of a curve) are called one up to here only (rad; per length).
MERGED_TWINS = 2e-6
#: Step for the derivatives of what is missed along the null direction (rad; per length).
MERGED_STEP = 2e-2

# ---- kernels: of all kernels ----
#: Joint values this close (rad, m) are rounding and do not order rows.
KERNEL_ROW_ORDER = 1e-6

# ---- kernels: of the careful closed forms (lengths of the arm; rad) ----
#: Forward kinematics misses the pose by no more where a candidate is a solution.
CLOSED_VERIFIED = 1e-12
#: A candidate that misses by less than this makes a pose without solutions uncertain.
CLOSED_NEAR_MISS = 1e-9
#: Candidates that miss by more before polishing belong to a wrong branch.
CLOSED_HOPELESS = 2e-2
#: Joint values beyond this (rad; lengths of the arm) are no candidate.
CLOSED_ENDLESS = 1e6
#: Solutions closer than this are one.
CLOSED_SAME = 3e-8
#: In a flat valley two candidates up to this far apart are one answer.
CLOSED_VALLEY = 0.05
#: Smallest over largest singular value of the scaled Jacobian under which a row is looked at closely.
CLOSED_SINGULAR = 2.5e-7
#: Polishing ends here: the rounding of forward kinematics.
CLOSED_POLISHED = 4e-15
#: A step that halves no more and has come below this was the last one.
CLOSED_STALLED = 1e-14
#: Where a step does not help and less than this is missed, polishing ends.
CLOSED_GOOD_ENOUGH = 5e-14
#: Least damping of a step, of the trace of J^T J: a little above rounding it keeps singular poses finite.
CLOSED_DAMPING = 1e-15
#: Longest step of a joint in polishing (rad; lengths): a tenth of a turn is still the same branch.
CLOSED_LONGEST_STEP = 0.3
#: Damping of the steps along a null direction, where what is left is well conditioned.
ALONE_DAMPING = 1e-16
#: A correction along a null direction has settled when its step is below this.
ALONE_SETTLED = 1e-13
#: Twins at least this far apart are two solutions.
ALONE_TWINS = 1.2e-7
#: Between twins the pose must be missed by more than this: a ridge that rounding cannot hide.
ALONE_RIDGE = 1.2e-13
#: A pose missed by more along a null direction is not held; twice ON_CURVE: what is cleared cannot be traced.
ALONE_HELD = 4e-13
#: Smallest relative singular value that a row may have to stand alone.
ALONE_SIGMA = 1e-14
#: The second smallest one must be at least this: more than one null direction is beyond this look.
ALONE_SECOND = 3e-4
#: Step ahead and behind along a null direction that tells a line from a fold (rad; lengths).
ALONE_STEP = 1e-2
#: A second look farther along where the first was held.
ALONE_FARTHER = 0.3
#: Curvature of a fold, relative, below which its twin is not believed.
ALONE_BENT = 1e-6

# ---- kernels: of quartics and pairs of equations (relative to the size of their coefficients) ----
#: An extremum this near zero is offered as a double root; offers are checked, so this may be generous.
ROOT_TOUCHING = 3e-11
#: The same of the derivative, whose roots only split the line.
ROOT_TOUCHING_SLOPE = 1e-7
#: A touch this near a crossing is that crossing.
ROOT_TWICE = 1e-12
#: A discriminant of the second derivative this little below zero is one inflection.
ROOT_FLAT = 1e-9
#: A root is found when Newton moves it by less than this, relative.
ROOT_STEP = 1e-16
#: In lanes an extremum nearer to zero than this is handed to the careful road.
ROOT_UNCLEAR = 1e-7
#: So is a critical point whose slope is no better than this,
ROOT_SLOPE_UNCLEAR = 1e-4
#: and a curve whose value and slope at an inflection both lie below this.
ROOT_INFLECTION_UNCLEAR = 1e-5
#: Precision of critical points in lanes,
ROOT_CRITICAL_PRECISION = 1e-6
#: and of roots.
ROOT_PRECISION = 2e-15
#: Ties in the choice of a chart, common by symmetry, go to the first.
ROOT_TIE = 1e-9
#: In lanes a root is not clear when what it is the square root of falls below this: two are about to merge.
ROOTS_MERGE = 1e-8
#: Determinant under which a 2x2 is taken for rank one; pairs are polished, so the place does not matter.
PAIR_RANK_ONE = 1e-6
#: A discriminant this little below zero is a double root.
PAIR_TOUCHING = 1e-10
#: A leading coefficient this small is none: the quadratic is linear, the step is done.
PAIR_LINEAR = 1e-13
#: Squares of what has vanished.
PAIR_VANISHED = 1e-24
#: A quartic form below this vanishes: its joint is free.
PAIR_FREE = 1e-14
#: In lanes it is unclear below this.
PAIR_FREE_UNCLEAR = 1e-12
#: A slide so far away is no solution.
PAIR_FAR = 1e-6
#: An equation that holds one joint alone is a good one when it is at least this.
PAIR_ALONE = 1e-4
#: What a null row leaves of its matrix where that is not of rank one.
PAIR_NOT_RANK_ONE = 1e-10
#: Determinant below which a Newton step in lanes is not believed,
PAIR_SHARP = 1e-6
#: and the longest step it may take.
PAIR_SHARP_STEP = 1e-4
#: Rounding: a residual below this is none.
PAIR_ROUNDING = 1e-16
#: Squares of coefficients below this say nothing in lanes.
PAIR_NOTHING = 1e-20
#: Triples of joints that agree to this are offered once.
ONE_POINT = 1e-13
#: Squared distance from the middle axis below which its joint is free.
ON_MIDDLE_AXIS = 1e-26
#: A wrist reaches directions that its twists miss by this much.
WRIST_REACH = 1e-9
#: Sine between outer wrist axes below which they line up.
WRIST_LINED_UP = 1e-12
#: Cosine of a twist that is a right angle.
WRIST_SQUARE = 1e-15
#: A triangle, or a circle and a line, that fail to meet by this much (relative, squared) touch.
PLANE_REACH = 1e-9
#: The same, absolute.
PLANE_ZERO = 1e-15
#: Two slides whose directions are nearer than this are one.
PLANE_PARALLEL = 1e-14
#: In lanes a link of a plane shorter than this is left to the careful road,
PLANE_SHORT = 1e-9
#: and slides nearer to parallel than this,
PLANE_LANES_PARALLEL = 1e-6
#: and a slide along the plane that a pose leaves so little room.
PLANE_UNCLEAR = 1e-4

# ---- kernels: of the spherical wrist behind parallel axes (relative to its scale; rad) ----
#: Closer: one representative stands for the self-motion.
SWP_ON_SINGULARITY = 1e-13
#: Closer: flagged, so that the careful look takes place.
SWP_NEAR_SINGULARITY = 1e-7
#: A distance from the edge of reach that is nothing but rounding.
SWP_ROUNDING = 8 * 2.2e-16
#: Half the angle between two roots below which they are flagged.
SWP_NEAR_DOUBLE = 1e-6
#: A reach exceeded by no more than this is the edge of reach.
SWP_OVERSHOOT = 5e-13
#: Squared sine of joint 3 below which cancellation is avoided.
SWP_EDGE_OF_ELBOW = 1e-3
#: Forward kinematics must return the pose this closely.
SWP_VERIFIED = 1e-11

# ---- kernels: of the families that hide an angle ----
#: What rounding leaves of the polynomial is below this, relative to the sum of its coefficients.
HIDDEN_NOISE = 3e-14
#: Above its degree the polynomial must vanish to this.
HIDDEN_DEGREE = 1e-12
#: Solutions of two ways that are one (rad; lengths), where a pose is not clear.
HIDDEN_SAME = 1e-5
#: A root is found when Newton moves it by less.
HIDDEN_ROOT_STEP = 1e-9
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

# ---- kernels: of collision (m, or as said) ----
#: Squared length of a direction (a product of two unit vectors) below which two edges are parallel and say nothing.
TOUCHING_FLAT = 1e-20
#: What a distance between bodies may be off by rounding, per metre of the largest number in it: ten times the seen.
DISTANCE_ROUNDING = 1e-14

# ---- kernels: of the elimination (scaled lengths; rad) ----
#: What polishing must leave of the miss: 1e-15 unless singular.
GENERAL_VERIFIED = 1e-11
#: Solutions closer than this are one;
GENERAL_SAME = 1e-7
#: near a singular pose those closer than rounding over sigma, at most this.
GENERAL_SAME_MOST = 4e-7
#: The rounding that is meant there.
GENERAL_RESOLVED = 3e-15
#: Singular values are not told apart below this.
GENERAL_LEAST_SIGMA = 1e-12
#: Imaginary part below which a complex pair is tried as a double root,
GENERAL_NEARLY_REAL = 2e-3
#: and below which it is tried again, with time.
GENERAL_TRY_AGAIN = 2e-4
#: A determinant this much smaller than usual at all angles: the elimination is singular at the pose.
GENERAL_VANISHING = 1e-13
#: One this much smaller than usual marks the pose for a second look.
GENERAL_MARKED = 1e-12
#: Noise of an elimination, relative, below which no second opinion is asked for.
GENERAL_QUIET = 1e-13
#: An eigenvalue farther from its root than this was computed badly.
GENERAL_ACCURATE = 1e-5
#: Smallest singular value under which a solution is flagged,
GENERAL_DEGENERATE = 1e-6
#: and under which multiplicities are beyond counting.
GENERAL_UNCOUNTED = 1e-7
#: Real eigenvalues this close are one root twice,
GENERAL_ONE_ROOT = 1e-5
#: where the singular value is below this.
GENERAL_MERGED = 1e-3
#: A way of elimination noisier than this on test poses is of no use.
GENERAL_NOISIEST = 1e-6
#: Noise below this is as good as none.
GENERAL_PERFECT = 1e-15
#: By how much the first nearby arm is another one; big enough that special geometry is gone,
GENERAL_NEARBY = 1e-3
#: and the second.
GENERAL_NEARBY_TOO = 3e-4
#: Polishing ends at this miss,
POLISH_DONE = 3e-16
#: at this one where the pose is regular,
POLISH_DONE_REGULAR = 2e-15
#: by its smallest pivot,
POLISH_REGULAR = 1e-3
#: and at this one when steps halve it no more.
POLISH_STALLED = 1e-14
#: A lane that misses by more after eight steps is lost.
POLISH_LOST = 0.05
#: Longest step of a joint.
POLISH_LONGEST_STEP = 0.4
#: Pivots are kept above this, so that a step at a singular pose stays finite,
POLISH_PIVOT = 1e-15
#: and above this when the smallest singular value is estimated.
POLISH_SIGMA_PIVOT = 1e-30
#: Pivots of a null vector are kept above this part of the largest.
NULL_PIVOT = 1e-17
#: Relative determinant above which a sliding role is solved for with its square.
SLIDE_ROLE = 1e-12
#: Determinant of three slides below which they depend on each other.
THREE_SLIDES_DEPEND = 1e-10
#: By how much their turns may fail to reach an orientation.
THREE_SLIDES_REACH = 1e-12
#: Squared sine between the outer turning axes below which they are in line.
THREE_SLIDES_IN_LINE = 1e-20
#: Squares below this are no column to reflect; larger ones can be divided by.
HOUSEHOLDER_ZERO = 1e-290
#: Pivots of the companion matrix are kept above this.
PENCIL_PIVOT = 1e-280
#: A slide's ratio is kept from a divisor below this.
INFINITE_LENGTH = 1e-200
#: A matrix of this norm has no eigenvalues worth having.
EIGENVALUE_OVERFLOW = 1e290

# ---- solver/families: which arms they take ----
#: Singular values below this part of the largest do not count for a rank.
RANK = 1e-7
#: Offsets and twists (per length; rad) up to which the two sides of an offset wrist are taken for alike, and from which
#: they are taken for different. Between the two every root is nearly double: such an arm goes to the general solver.
SIDES_ALIKE = 1e-13
SIDES_DIFFERENT = 2e-3
#: Shortest link (per length) and smallest sine between neighbouring axes that the offset wrist can stand on.
SHORTEST_LINK = 1e-3
#: A test pose's own joints are found when a solution comes this near (rad; per length).
HIDDEN_FOUND = 1e-6
#: Relative determinant up to which a pair's 2x2 is of rank one by the arm's geometry rather than by chance.
PAIR_ALWAYS_RANK_ONE = 1e-11
#: Numbers this small beside one, or beside the arm's size, are what rounding left of a zero.
SWP_ZERO = 1e-16
#: Upper arm and forearm are longer than this (per length).
SWP_SHORTEST = 1e-6
#: Axis 4 is tilted out of the arm's plane when it leans more than this (rad);
SWP_TILTED = 1e-12
#: across the plane, it has no direction in it when less than this is left.
SWP_IN_PLANE = 1e-9
#: Inner links that are together shorter than this part of the largest are no measure of length.
LENGTHLESS = 1e-9

# ---- collision ----
#: How near to the margin a distance may stay undecided in a look at a whole path, m, where nothing else is said.
CLEARANCE_GAP = 1e-6
#: What coal is told to stop at, m, and how far off what it says is taken to be: ten times what was seen of hulls.
HULL_STEP, HULL_ROUNDING = 1e-10, 1e-8

# ---- calibration ----
#: By how much an axis of a built arm plausibly departs from the nominal one (rad; per length of the arm): a few
#: millimetres a metre. What, so large, changes all measurements together by less than their noise, is not seen.
PLAUSIBLE_DEPARTURE = 2e-3
#: The same of a gear's ratio and of what couples two joints.
PLAUSIBLE_GEAR = 1e-3
#: A measurement this many times its noise off is no noise: of 1e8 Gaussian ones not one is.
OUTLIER = 6.0
#: Huber's threshold, in noises: 95 % efficient where there are no outliers (Huber, 1981).
HUBER = 1.345
#: A fit is done when no number moves by more than this part of its plausible size,
CALIBRATED = 1e-9
#: or after so many steps; from millimetres away three to five are usual.
CALIBRATION_STEPS = 60
#: A wrong reading of the data (degrees, millimetres, a joint's sense) is named when it leaves this part of the misfit.
MISREAD = 0.2
#: Data that miss the nominal arm by less than this part of its length are not suspected of a wrong reading.
SUSPICIOUS = 0.03

# ---- verify ----
#: Two programs that agree differ by rounding alone (per length; rad): hundreds of operations leave 1e-13, as files do.
VERIFY_AGREES = 1e-10
#: What a toolbox calls a solution misses its pose by no more than this (per length; rad).
VERIFY_SETTLED = 1e-10
#: A solution of a toolbox is one of ours when the joints depart by no more than this (rad; per length),
VERIFY_KNOWN = 1e-6
#: and by this over the smallest singular value, since a pose that is met so well says no more about the joints.
VERIFY_PER_SIGMA = 1e-9
