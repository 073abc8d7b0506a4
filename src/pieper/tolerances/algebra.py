"""Of formulas: numbers that are shown, roots, and derivations that are checked on postures."""

#: By how much rounding may push a sine or cosine past 1.
SINE_SETTLED = 1e-12
#: Imaginary part, relative, that rounding may give to a real root: a double one is known to half its digits.
REAL_ROOT = 1e-7
#: Farther from the axis, up to this (relative), where the polynomial vanishes on it to this part of its terms' size:
#: two roots that meet, with coefficients that lost some digits.
DOUBLE_ROOT_APART, DOUBLE_ROOT_VANISHES = 1e-4, 1e-13
#: A leading coefficient below this part of the largest is none: a root is infinite.
LEADING_NONE = 1e-15
#: An angle is the fraction of a degree that it misses by no more than this, relative.
EXACT_DEGREES = 1e-11
#: How far from the unit circle a root e^(i theta) may lie and still be real before it is polished, which decides: of
#: four roots that nearly meet each is known to the fourth root of what the coefficients lost.
ON_UNIT_CIRCLE = 1e-2
#: Harmonics of a characteristic polynomial below this part of the largest are none. How large the largest is says
#: nothing: a determinant of twelve rows may be 1e-17 throughout and exact to fourteen digits.
POLYNOMIAL_VANISHES = 1e-13
#: What a cut leaves outside the polynomial's degree, relative, below which it is of use.
POLYNOMIAL_CLEAN = 1e-6
#: Singular values of a cut's matrix below this part of the largest are zeros at a root: as many postures share its
#: angle. A double root is known to the root of rounding, 1e-8, and so are they.
SHARED_ANGLE = 1e-6
#: A cut's matrix is of full rank where its smallest singular value is above this part of the largest.
CUT_RANK = 1e-9
#: Step of a difference quotient (rad; m) in polishing a solution, which Newton's method corrects.
QUOTIENT_STEP = 1e-7
#: Polishing ends where the pose is missed by no more (per length),
POLISH_ENOUGH = 1e-13
#: and has failed where it is missed by more.
POLISH_FAILED = 1e-9
#: Postures farther apart (rad) are two.
TWO_POSTURES = 1e-6
#: Leading coefficients below this, relative, are none: the root is at infinity.
POLYNOMIAL_ENDS = 1e-12
#: Rad or m: a branch is the solution; half the digits remain beside a singular pose.
DERIVED_SAME = 1e-6
#: Where a link is a hundred thousandth of the arm, rounding of the pose moves joints farther: up to this (rad; m) a
#: branch that is at the pose to its last digits (per size of its entries) is the solution all the same.
DERIVED_NEAR, DERIVED_AT_POSE = 1e-3, 1e-10
#: Branches of a derivation are two where they are farther apart (rad; m).
MERGED_BRANCHES = 1e-5
#: A chosen joint has the value that was asked for when it misses it by less (rad; m).
CHOSEN_VALUE = 1e-9
#: Stands for a limit that is none (rad; m), where a number is needed.
UNLIMITED = 1e9
#: By how much a side condition may be missed and still hold, per unit of the pose's entries.
SIDE_CONDITION = 1e-6
#: By how much rounding pushes the argument of a root below zero, per square of the pose's entries.
ROOT_ARGUMENT = 1e-14
#: A branch that misses its equation by more (relative) is wrong,
BRANCH_MISSES = 1e-6
#: right ones agree in the angle to this (rad),
BRANCH_SAME_ANGLE = 1e-7
#: and wrong ones depart by more than this.
BRANCH_OTHER_ANGLE = 1e-4
#: Of a difference quotient, rad or m.
DEGENERATE_STEP = 1e-7
#: Of coefficients that follow from a root which vanishes: half the digits are gone.
DEGENERATE_NOISE = 1e-7
#: Rounding; there is nothing left to improve.
DEGENERATE_EXACT = 1e-16
#: Per unit of length: the coefficients are zero.
COEFFICIENT_VANISHES = 1e-8
#: Per unit of length: the pose is reached.
DEGENERATE_CLOSES = 1e-7
#: Directions in which coefficients change by less than this part of the most are not gone along.
DEGENERATE_RANK = 1e-6
#: Part of their usual size below which coefficients may vanish twice over at the place, and what then counts as no
#: change at all: their slope goes with the distance, which comes down to the difference quotient's step.
DEGENERATE_NEAR, DEGENERATE_RANK_NEAR = 1e-7, 1e-12
#: A formula's own condition below this says that the formula degenerates as well; angles agree to it (rad).
DEGENERATE_CLEAR = 1e-6
#: Damping of a step: this part of the square of what is missed,
DAMPING_OF_MISS = 1e-3
#: and never less than this.
DAMPING_LEAST = 1e-13
#: Rad or m; axes closer than this meet or are parallel.
MEETS = 1e-9
#: A formula and the arm that it was written for agree to this (m; rad): typed constants have nine digits.
FORMULA_AGREES = 1e-9
#: Axes closer than this are parallel or meet, rad and m: the numbers of tables have nine digits.
ALIGNED = 1e-9
#: Rad: samples are roots to 1e-12 or so, square roots of that remain.
SAMPLED_ANGLE = 1e-6
#: Singular values below this part of the largest are zero at a sampled posture.
SAMPLED_RANK = 1e-8
#: Joints whose part of a null direction is larger take part.
SAMPLED_MOVES = 1e-6
#: Axes at a sampled posture meet, and points lie in a plane, when they miss by less (per length): roots of 1e-12.
SAMPLED_GEOMETRY = 1e-6
#: Sampled axes are at right angles, and projections lose a direction, below this.
PARALLEL_SAMPLED = 1e-9
#: Grids of postures begin this far (rad) off the round values, at which special arms are singular by chance.
OFF_THE_GRID = 1e-3
#: A branch on which a step degenerates leads back to its pose within this (per size of the pose's entries): the root
#: that vanishes there keeps half the digits, and the angle of two such numbers fewer.
LED_BACK = 1e-5
#: At a degenerate posture formulas give the joints back to this (rad; m): they too follow from vanishing roots.
CASE_SAME = 1e-4
