"""Of quartics, pairs of equations, wrists and planes (relative to the size of their coefficients)."""

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
#: It is not clear either that it has no root, at poses beside too, when that lies above minus this.
ROOTS_GONE = 1e-6
#: Determinant under which a 2x2 is taken for rank one; pairs are polished, so the place does not matter.
PAIR_RANK_ONE = 1e-6
#: A discriminant this little below zero is a double root.
PAIR_TOUCHING = 1e-10
#: A leading coefficient this small is none: the quadratic is linear, the step is done.
PAIR_LINEAR = 1e-13
#: Squares of what has vanished.
PAIR_VANISHED = 1e-24
#: Squares of coefficients that are rounding alone: of a turn by half a circle or a quarter as it is typed, for one.
PAIR_NOISE = 1e-30
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
#: Below this it is also put where the others reach, beside where its equations put it.
NEAR_MIDDLE_AXIS = 1e-12
#: A wrist reaches directions that its twists miss by this much.
WRIST_REACH = 1e-9
#: Sine between outer wrist axes below which they line up.
WRIST_LINED_UP = 1e-12
#: Cosine of a twist that is a right angle.
WRIST_SQUARE = 1e-15
#: A triangle, or a circle and a line, that fail to meet by this much (relative, squared) touch.
PLANE_REACH = 1e-6
#: The same, absolute.
PLANE_ZERO = 1e-15
#: Two slides whose directions are nearer than this are one.
PLANE_PARALLEL = 1e-14
#: What two slides along one line may leave missing across it: rounding, made good by what is verified.
PLANE_MISSED = 1e-12
#: In lanes a link of a plane shorter than this is left to the careful road,
PLANE_SHORT = 1e-9
#: and slides nearer to parallel than this,
PLANE_LANES_PARALLEL = 1e-6
#: and a slide along the plane that a pose leaves so little room.
PLANE_UNCLEAR = 1e-4
#: In lanes a plane's normal that comes out this far from where it belongs is its mirror image, no rounding.
PLANE_MIRRORED = 1e-6
