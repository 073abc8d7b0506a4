"""Of the look at singular rows, and of Newton's method there."""

#: A point of a self-motion must hold the pose this well (per length; rad). A pose 1e-12 away from a singular one moves
#: farther along its null direction.
ON_CURVE = 2e-13
#: Two axes are one line, four are parallel or meet, when they miss by no more than this (rad; per length): what turning
#: about them would move the pose by, as `ON_CURVE`.
IN_ONE_LINE = 2e-13
#: Parts of a unit null direction below this stand still, or would on the self-motion next to the pose.
LOOP_MOVES = 1e-4
#: Axes that miss being a linkage by less than this are next to a self-motion.
NEXT_TO_LINKAGE = 1e-5
#: A side of a linkage smaller than this is constant: its joint can neither lead nor follow.
LOOP_CRITICAL = 1e-9
#: Two ends of what the sides of a linkage can be are one within this (of their sizes): rounding.
LOOP_TOUCHES = 1e-14
#: Two angles of a linkage that go round together differ by rounding alone (rad).
LINKAGE_TOGETHER = 1e-7
#: Three neighbouring axes are parallel or meet in one point within this (rad; per length): what families take them for.
GROUP_EXACT = 6e-12
#: Directions weaker than this (relative) are left alone where the last digits of a row are fetched.
HELD_FIRMLY = 1e-9
#: Step aside from a double root (rad; per length) over which its fold is taken for straight.
FOLD_STEP = 1e-5
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
#: A shorter step (rad; lengths) moves rounding alone, so that nothing more is to come: what is still missed then, the
#: arm cannot take from there.
NEWTON_STILL = 1e-14
#: Where no direction is weaker than this part of the strongest a step takes no singular values.
NEWTON_REGULAR = 1e-6
#: Columns whose cosine is no more than this are at right angles (and two angles, rad, are one): rounding of their sums.
ORTHOGONAL = 1e-15
#: A row this near a self-motion is a point of it (rad; per length).
ON_SELF_MOTION = 1e-9
#: Relative singular values below which kernels may give one point for two solutions beside a self-motion.
ROOTS_APART = 2e-13
#: The same below which both roots beside a line are found anew, which costs little.
LINE_ROOTS_APART = 1e-11
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
#: Roots that rounding parts by more than this (rad; per length) are no merged root, but the self-motion of something.
UNFOLDING_WIDEST = 2e-2
#: A solution is one of several in which a root has come apart up to so many times as far from it as rounding parts
#: them: they lie at the corners of a polygon about it.
UNFOLDING_REACH = 8.0
#: The place of a merged root is found when it moves by less than this (rad; per length).
UNFOLDING_FOUND = 1e-14
#: Where roots are one, lower orders of what is missed come to no more than this part of what is rounded: of two roots
#: that rounding just tells apart it is more.
UNFOLDING_ROUNDING = 0.5
#: Beside a root with several free directions (rad; lengths), where its Jacobian is compared.
UNFOLDING_ACROSS = 1e-4
#: What the Jacobian does along free directions that changes by less than this (per rad; length) does not bend.
UNFOLDING_NO_BEND = 1e-5
#: Squared sine between neighbouring axes above which they are clearly not parallel: their point is where they meet.
CLEARLY_CROSSING = 1e-6
#: A joint of a four-bar linkage reaches a dead centre that its range misses by this part.
DEAD_CENTRE = 1e-14
#: Pivots below this (squared lengths) leave their direction free.
LINKAGE_PIVOT = 1e-9
#: Step (rad; lengths) of the difference quotient by which axes are brought into place,
INTO_PLACE_STEP = 1e-7
#: and relative singular value below which a direction is not corrected in there.
INTO_PLACE_RANK = 1e-14
#: Rows that differ by rounding alone are told apart in their order no finer than this (rad; lengths).
ROW_ORDER_GRID = 1e-6
#: Square of the second null direction's part below which one direction is free: a hundred times what is looked at.
SECOND_FREE = 1e-8
#: Stands for the distance of two roots of a polynomial that coincide, so that they part.
ROOTS_COINCIDE = 1e-30
#: Roots of a polynomial are found when none moves by more; coefficients below it are none.
ROOTS_FOUND = 1e-15
#: Angles this near to minus half a turn (rad) are half a turn.
EDGE_OF_TURN = 1e-9
#: A row is nearer to a posture than another by more than this (rad; lengths): ties go to the first.
NEARER_ROW = 1e-9
#: An angle lies on a course whose half it exceeds by no more than this part,
ON_COURSE = 1e-9
#: or by this (rad).
ON_COURSE_TURN = 1e-12
#: What is left of a direction below this part of the strongest is rounding: any other may take its place,
ACROSS_ROUNDING = 1e-9
#: the one of which more is left by this.
ACROSS_MORE = 1e-6
#: Size of the generic steps to the poses beside a singular one (per length; rad): double roots part there by 3e-4.
ASIDE_STEP = 1e-7
#: A solution of a pose beside is a row that has moved when it departs from where the row leads by less than this part.
ASIDE_ASTRAY = 0.25
#: Across the weakest direction it may depart by this many squares of the way along it, and of the step itself.
ASIDE_ACROSS = 3.0
#: What a fold misses to second order (per rad^2) times this is how far along it (rad) third orders count little.
FOLD_REACHES = 0.5
#: Square of the last pivot's part above which a row is regular beyond doubt.
PLAINLY_REGULAR = 1e-3
#: Directions that a singular pose feels less than this part of the most carry no step onto it.
PRECISE_RANK = 1e-13
#: Newton's method is on a curve when a step across it is shorter (rad; per length).
CURVE_SETTLED = 1e-9
#: What is missed along a curve is followed up to here (per length; rad): a hundred times what poses beside it are away.
CURVE_MISSES = 1e-5
#: A curve ends where what is missed changes faster than this along it.
CURVE_STEEPENS = 1e-2
#: Between points of a curve its cubic says what is missed to this part of a step aside.
CURVE_TOLD = 0.02
#: and which direction is missed, to this part of it.
CURVE_LEANS = 0.02
#: Another self-motion may cross where the bordered determinant falls below this part of its largest.
CURVES_CROSS = 1e-4
#: Longest step along a self-motion (rad; per length): joints turn visibly, and chords cut corners by about 2e-3.
CURVE_STEP = 0.12
#: Directions that the pose feels less than this part of the most carry no step onto a curve: it is moved along freely.
CURVE_RANK = 1e-7
#: Double roots, whose place is known to half the digits, are farther than this from every self-motion.
DOUBLES_FROM_CURVE = 1e-4
#: Solutions of poses beside lie this near to a curve (rad; per length): their step over the weakest direction but one.
CURVE_BESIDE = 1e-3
#: A piece of a curve reaches this part beyond its ends.
CURVE_OVER = 0.1
#: Relative sigma_min below which a point may lie on a curve that nearly holds the pose.
NEARLY_SINGULAR = 1e-3
#: A curve ends where a step shorter than this (rad; per length) does not go on.
NEAR_CURVE_SHORTEST = 1e-3
#: Newton's method from anywhere: its damping beside the square of what is missed, at the least, and what a point may
#: miss that it has come to (per length; rad).
ALL_OVER_DAMPING, ALL_OVER_LEAST = 1e-3, 1e-13
ALL_OVER_HOLDS = 1e-11
#: Of mixtures of two free directions the least that is missed to second order, as a part of the most, where none leads
#: away: a mixture that does is met within half a step of their fan, where an eighth is missed.
MIXTURE_MISSES = 0.15
