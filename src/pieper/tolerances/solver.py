"""Of the solver in Python: self-motions, rows that are one, which arms the families take."""

from .kernels.everywhere import SAME_SOLUTION

#: What a solution may miss its pose by after polishing (per length; rad).
CLOSES = 1e-9
#: Rows of a kernel closer than this (rad; per length) are one: a double root is known to ten times `SAME_SOLUTION`.
SAME_ROW = 10 * SAME_SOLUTION
#: Postures whose axes are this near (rad; per length) to where their linkage holds them are moved onto it; they count
#: where they close then. Rows of a double root, which are known to half the digits, lie within it.
LINKAGE_STARTS = 1e-4
#: Rows of a double root may lie this far (rad; per length) from where they belong, in joints nearly in line too.
BLURRED_TO = 0.1
#: Rows whose filled joints come out below this are moved onto zero, and count where they close: where a filled joint is
#: nearly free, rounding alone moves it far.
FILLED_STARTS = 1e-4
#: Entries of R^T R - I whose squares add up to less are nothing to rounding after one step to the nearest rotation.
POLAR_SETTLES = 1e-18
#: One below this may have been meant to be zero: double roots are known to half the digits, fourfold ones to a quarter.
NEARLY_ZERO = 1e-3
#: Two postures merge beyond a miss of their squared relative singular value over a few: below this part of it a posture
#: that misses has no solution near it.
PLAIN_MISS = 5e-2
#: Points that differ in a task's virtual joints alone are one within this (rad; per length): curves end there.
SAME_AFTER_CUT = 1e-6

#: Singular values below this part of the largest do not count for a rank.
RANK = 1e-7
#: Nor do those below this part for anything: they are zero, and rounding made them.
RANK_ROUNDING = 1e-13
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
#: An elimination noisier than this on test poses, relative, finds what made sixteen of them or not as rounding has it:
#: where the arm is nearly a special one, it is solved through that.
BELIEVED_NOISE = 1e-10
#: Below this smallest singular value (per length of the arm; rad) the damped inverse is taken.
DAMPED_INVERSE = 1e-6
#: How far beside a value at which what is left of the arm is solved by no family it is solved instead (rad; lengths).
BESIDE_UNSOLVED = (1e-4, -1e-4, 1e-3)
#: Directions that the pose feels less than this part of the most carry no step onto the pose: the joints stay near.
PULLED_RANK = 1e-7
#: How near to a special arrangement an arm is tried as one, the nearest first, where no elimination is certain (rad;
#: per length): beyond the last of them eliminations are certain again.
NEARLY_SPECIAL = (1e-10, 1e-8, 1e-6, 2e-5)
#: |det J| must stay above this part of its largest value: a path that nearly touches a singularity proves nothing.
CLEAR_OF_SINGULAR = 2e-3
#: Rows of two arms are one to one where the square of sigma (relative) is above so many times what the arms differ by.
PAIRED = 10.0
#: Arms that differ by no more (per length; rad) have none where the nominal one has none, neither here nor around.
NO_MORE_THAN_TYPED = 1e-4
#: What a turn counts beside the position, stage by stage, steps, and how many postures are kept.
CLOSEST_STAGES = ((1.0, 12, 8), (1e-3, 24, 8), (1e-5, 40, 6), (1e-8, 30, 6))
#: The same for the best of all, led away from the best position and back to it: turns and steps.
CLOSEST_BACK = ((1e-2, 60, 2), (1e-4, 40, 2), (1e-6, 30, 2), (1e-8, 30, 2))
#: Damping of the crawl towards a position at first (lengths squared), its factors where a step helped and where not.
CLOSEST_CRAWL = (1e-3, 0.2, 6.0)
#: Descents that end so near each other (rad; per length) are at the same minimum.
SAME_DESCENT = 1e-3
#: Positions that are as near as this (per length) are alike, and the orientation decides: more than rounding leaves.
ALIKE_NEAR = 1e-11
#: Decimals (m) of a position that were typed, at most; it is one where it is off by no more of its size.
MOST_TYPED, LAST_BITS = 13, 4e-16
#: A typed position is open by half of its last decimal, at most by so much of the arm's length;
MOST_OPEN = 1e-4
#: within that a posture that misses it is nearer where it is turned less by so many times (rad) what it misses.
TURN_FOR_PLACE = 1e3
#: Part of a turn's weight to which its chord counts as its angle does; sine over the angle where that is half a turn.
COUNTED_IN_RADIANS, HALF_A_TURN = 1e-9, 1e-9
#: Half the square of a distance (per length) that a few more steps take to rounding.
REACHED_PLACE = 1e-12
#: Distances (per length) of two descents that have come to the same place, or will.
ALIKE_PLACE = 1e-5
#: Longest step (rad; lengths) of the last ones onto the position: orientation was good before.
ALIKE_TURN = 1e-2
#: A bend or an offset smaller than this has no side (per length; sine).
NO_SIDE = 1e-9
#: A term of the sum behind a label's word that is smaller is rounding (per length; sine): a thousandth of NO_SIDE.
LABEL_TERM = 1e-12
#: Step of all joints (rad; per length) to either side of a posture that has no label of its own.
LABEL_STEP = 1e-3
#: Axes that are at a smaller angle (rad) are parallel for the words of a label.
LABELLED_ANGLE = 1e-6
#: A determinant (per length) nearer to zero than this has no sign.
ASPECT_SIGN = 1e-12
#: Positions missed by less (per length) are reached, turns (rad) are right.
TOLD_AS_TURN = 1e-6
#: The same where a row is pulled from the side, and must not wander off along what is free.
SLOW_RANK = 1e-9
#: Damping of the descent to self-motions: at first, its factor where a step helped and where not, and where a row
#: rests.
APPROACH_DAMPING = (1e-1, 0.2, 5.0, 1e3)
#: The damping of Newton's steps onto the pose at its end.
APPROACH_LEAST_DAMPING = 1e-14
#: Rows worse than this after the closed form are polished (per length; rad).
ARM_ANGLE_POLISH = 1e-13
#: A circle that a sine or a quadratic's root misses by no more (relative) touches.
ARM_ANGLE_TOUCHING = 1e-13
#: What is added to the matrix of a polishing step, so that a singular one can be solved.
ARM_ANGLE_DAMPING = 1e-12
#: A row of the chosen value is the point it was chosen for when it is this near (rad; per length).
CHOSEN_POINT = 1e-6
#: A seed this near to a traced curve is on it; between the two it is slid onto the curve to see.
SEED_ON_POLYLINE, SEED_DOUBTFUL = 5e-3, 5e-2
#: A seed that was slid lies on the curve when it comes this near (rad; per length).
SEED_ON_CURVE = 1e-5
#: The same where one direction is free and no more, of seeds that hold the pose to rounding: curves may pass each other
#: as near as a few times this.
SEED_IS_ON = 1e-6
#: Where a curve crosses another it is gone on by steps shorter than this (rad; lengths).
CROSSED_BY = 1e-3
#: Jacobians with a curve's way beneath whose determinant is above this have no two directions so weak that a curve that
#: passes may have turned both round.
BOTH_WEAK = 1e-2
#: A step (rad; lengths) of a point that holds the pose already, beyond which it is made of rounding.
LED_AWAY = 1e-5
#: Seeds whose weakest direction is below this part of the strongest are traced last.
SEED_CROSSED = 1e-5
#: Steps to either side of a pose (per length; rad), and how many pairs of each.
SIDE_STEPS = ((1e-2, 4), (1e-3, 2))
#: Stretches of a swept joint shorter than this (rad; m) are not halved.
SWEEP_FINEST = 1e-6
#: A pose is approached from this far to the side (per length; rad) where a row on it is not clear.
CAREFUL_ASIDE = 1e-9
#: Poses this far to the side (per length; rad) vouch for one whose own certificate fails, the nearest that are certain
#: first: far enough that what meets at a special pose has parted, near enough that regular solutions are led back.
SURE_ASIDE = (1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 4e-2)
#: A solution led back onto the pose is one of its rows within this (rad; per length): of merged roots it ends
#: in the blur.
SAME_VOUCHED = 1e-4
#: By how much links of arms beside one are turned and moved (rad; per length), where every elimination of its own
#: vanishes: enough that theirs keep ten digits, little enough that nearly every pose keeps its count.
ARM_BESIDE = 3e-4
#: Sizes of the side steps (per length; rad) from which a singular pose is approached.
APPROACH_SIZES = (1e-4, 1e-7)
#: A point this near a traced curve is on it; samples lie 0.12 apart, so the polyline cuts corners by about 2e-3.
ON_POLYLINE = 5e-3
#: Turns that move less than this along a free direction (rad) stand still: a self-motion of slides alone is a straight
#: line. At points of it that are far away the direction itself is no more exact.
LINE_OF_SLIDES = 1e-6
#: Of a line of slides without limits so much is shown to either side of where their ways are shortest (lengths),
SLIDES_SHOWN = 3.0
#: and two slides move alike whose ways differ by rounding alone.
SLIDES_ALIKE = 1e-9
#: A curve that does not close is a self-motion without ends where a slide moves farther along it than this (per
#: length); shorter ones come near the pose where it is nearly singular.
NO_END = 1.0
#: The same for curves that nearly hold the pose, whose samples lie 0.2 apart and whose points are less exact.
ON_NEAR_POLYLINE = 3e-2
#: Of unit steps along null directions, pulled back onto the pose, singular values above this are ways that solutions
#: go: one along them keeps its length, one across them loses it.
INDEPENDENT_STEPS = 0.5
#: Relative singular value below which a second direction stays open: the solutions form a surface.
OPEN_DIRECTION = 1e-7
#: A solution must hold the pose this well (per length; rad). At a double root this fixes q to its square root only.
HOLDS = 1e-11
#: A solution that the kernel did not give must hold it this well, so that poses just out of reach get none.
HOLDS_EXACTLY = 2e-15
#: A posture with two axes in one line must hold it this well: a stretched elbow misses by the square of its angle.
COAXIAL_HOLDS = 1e-13
#: An end of a look lies on a traced curve when it is this near (rad; per length): chords cut corners by as much.
ENDS_ON_CURVE = 2e-3
#: Singular starts farther apart (rad; per length) are looked at each.
APART_SINGULAR = 1e-3
#: What a point on a curve that nearly holds the pose may miss otherwise (per length; rad).
FLAT_REST = 1e-9
#: Isolated solutions are farther than this from every curve (rad; per length).
ISOLATED_FROM_CURVE = 1e-5
#: Along a curve what is missed otherwise stays below this part of what is missed along it.
PROBE_REST = 1e-2
#: Angles this near to minus half a turn (rad) are half a turn.
HALF_TURN_EDGE = 1e-9
#: A self-motion contains a posture that is this near to it, where nothing else is said (rad; per length).
CONTAINS = 1e-6
#: What a curve may miss the pose by at most (per length; rad),
CURVE_FAR = 1e-4
#: and the relative sigma_min up to which it is followed.
CURVE_STEEP = 1e-2
#: The five equations must hold this well (per length; rad) relative to what the sixth is missed by.
NEAR_CURVE_HOLDS = 1e-3
#: Below this they hold whatever is missed.
NEAR_CURVE_ROUNDING = 1e-10
#: A joint turns along a self-motion when it moves by more (rad; per length).
JOINT_TURNS = 1e-6
#: Points of one value that are nearer than this (rad; m) are one.
ONE_OF_MANY = 1e-7
#: A step along a curve that is shorter than this (rad; per length) leads nowhere.
SLIDE_SHORTEST = 1e-10
#: A curve along which a joint's angle changes by less (rad) does not turn it.
CLOSED_TURN = 1e-9
#: Singular values below this part of the largest leave their direction open.
OPEN_WAYS = 1e-7
#: A curve of folds ends where a step shorter than this (rad; per length) does not go on.
FOLDS_STEP = 1e-3
#: A second singular value is smallest where its neighbours are larger by more than this.
CROSSING_CHANGE = 1e-9
#: Curves cross where the second singular value comes below this.
CROSSING_FOUND = 1e-5
#: A pose that descents inside the limits leave farther away (per length; rad) is not searched for small self-motions.
NEAR_INSIDE = 3e-2
#: Where a descent rests and misses the pose by less than this (per length; rad), it is looked for beside.
ALL_BUT_HELD = 1e-4
#: Places at which descents rest that are this near to each other (rad; lengths) are one.
SAME_REST = 1e-3
#: So far around it (rad; lengths): the root of what is missed, by how the weakest way bends.
ROUND_A_REST = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2)
#: Positions that miss the first axis by less, of how far they are along it, lie on it: a few last digits.
ALONG_FIRST_AXIS = 1e-14
#: Poses farther away than so many of the arm's lengths are solved with their distance as its length.
FAR_OUT = 1e3
#: A point this near to the polyline of a curve may lie on the curve, and is slid onto it to see.
NEAR_POLYLINE = 2e-2
#: How near to a curve inside limits a posture must come to lie on it (rad; per length).
BOUNDED_ON_CURVE = 1e-6
#: How precisely the nearest point of a curve is found before it is polished (rad).
BOUNDED_PRECISE = 1e-4
#: Damping inside limits at first, its factors where a step helped and where not, and where a row rests.
BOX_DAMPING = (1e-4, 0.1, 10.0, 1e4)
#: Least damping: directions that the joints hardly move (1e-7 of the others) carry no step.
BOX_LEAST_DAMPING = 1e-14
#: What is missed (per length; rad) below which a row goes on no longer.
BOX_ON_POSE = 1e-12
#: Parts of the box's width that are kept free on either side, the widest first, in looking for a point well inside.
BOX_ROOM = (0.1, 0.01, 1e-4)
#: The step (rad; per length) at which the nearest point inside limits is reached.
BOX_SETTLED = 1e-10
#: A step is taken where the square of the distance falls by more: rounding.
BOX_NEARER = 1e-14
#: What keeps the shares of free directions apart, of the largest weight: far below any that counts.
BOX_REGULAR = 1e-12
#: Step of a tangent's difference quotient, of the whole course: neither its cube nor rounding over it counts.
COURSE_STEP = 1e-5
#: A sum of joints in a self-motion's words that is smaller is rounding (deg; mm).
SAID_AS_ZERO = 1e-9
#: Relative sigma_min below which a regular row stands near a fold: its twin is about as far away as the steps by which
#: poses beside a singular one are taken lead.
NEAR_A_FOLD = 1e-4
#: Steps aside (per length; rad) at which it is counted whether a pose beside a fold has more solutions than were told.
BESIDE_A_FOLD = (1e-8, 1e-7)
#: Rows whose smallest singular value is below this part of the largest are singular to rounding: no simple root is.
SINGULAR_TO_ROUNDING = 1e-12
#: A pose that descents come this near (per length; rad) may be held beside a posture where two directions are free:
#: squares tell no nearer than half the digits.
NEARLY_HELD = 3e-8
