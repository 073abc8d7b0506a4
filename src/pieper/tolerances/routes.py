"""Of routes: feasible intervals of the turn, what is proved, and how a route is made smooth."""

#: Shortest stretch of a self-motion (of its whole) that is an arc.
SHORTEST_ARC = 1e-12
#: Change of the turn between samples below which they are one point.
ARC_STILL = 1e-12
#: Folds and ends nearer than this, of the whole self-motion, are one.
SAME_FOLD = 1e-9
#: An end within this (rad; m) of a limit, where none is met exactly, ends there.
AT_A_LIMIT = 1e-6
#: A fold is found when the turn's slope is below this
FOLD_FOUND = 1e-13
#: or nothing is left between its bounds.
FOLD_NARROW = 1e-15
#: How far behind a place where a front lost its grip it is taken up again, as a part of the path.
TAKEN_UP_BEHIND = 1e-4
#: What is added to how far an arm reaches, relative: sums of lengths round.
REACH_ROUNDING = 1e-9
#: The outermost ring of a cone lies inside its edge by this part.
CONE_INSIDE = 1e-9
#: How far a posture may be off the pose that it is to begin or end with (per length; rad).
POSTURE_ON_PATH = 1e-6
#: Two poses nearer than this (per length; rad) are one.
ROUTE_SAME_POSE = 1e-12
#: Two points this near (rad; lengths) need no look between them.
NO_LOOK_BETWEEN = 1e-6
#: Part of a cone that is left free at its edge, so that a route at rest there lies inside it.
CONE_KEPT = 1e-5
#: The barrier's weights, one a stage, as parts of the mean cost of a step: the last leaves slopes below 1e-9 where
#: limits are a tenth of a radian away.
BARRIER_WEIGHTS = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-7)
#: Step by which the bending of what a pose leaves free is seen (rad; lengths).
FREEDOM_PROBE = 1e-4
#: A start this far inside all limits (rad; lengths) needs the last stage of the barrier only;
CLEAR_START = 0.1
#: a slope counts where limits are so far.
SLOPE_COUNTS = 1e-3
#: The gradient at which a stage is done.
SMOOTH_FLAT = 1e-9
#: A stage has stalled when a step is shorter than this (rad; lengths)
SMOOTH_STALLED = 1e-7
#: and the cost falls by less than this part;
SMOOTH_NO_GAIN = 1e-15
#: or, where ways are only compared before the best is made short, by less than this part;
SMOOTH_ROUGH = 1e-3
#: steps below this may be taken
SMOOTH_TINY_STEP = 1e-6
#: where the cost rises by no more than this part: rounding.
SMOOTH_MAY_RISE = 1e-14
#: Damping that a step which did not help begins with,
SMOOTH_DAMPING = 1e-4
#: and below which there is none.
SMOOTH_UNDAMPED = 1e-6
#: What bending of the largest change is added, so that changes of zero bend too.
SMOOTH_BEND = 1e-6
#: A stretch of a route is short beside the least singular value of its Jacobian below this part of it: the Jacobian
#: changes by at most some two and a half of itself a radian, so that along the stretch it keeps its rank.
SHORT_BESIDE_RANK = 0.25
#: A stretch so short (rad; lengths) is not halved on for its rank: what passes a singular posture by less passes it.
NO_SWING = 1e-5
#: By how much boxes of joint values, and what is bounded in them, are taken for wider: what double precision rounds.
BOX_ROUNDING = 1e-11
#: Part of the size of J J' that is added to it before a multiplier is worked out: any multiplier does.
MULTIPLIER_DAMPED = 1e-3
#: Points of a path farther apart (per length; rad) are looked between before a route is refused.
POINTS_FAR_APART = 0.05
#: Ways that cost the same but for this part of it are taken for one, told with its wrist flipped.
SAME_COST = 1e-9
