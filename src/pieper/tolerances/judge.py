"""Of other people's formulas: what is one value, what counts as zero, how near to a border nothing is judged."""

#: A posture that was found is the one it was looked for when it is this near (rad; per length),
EVIDENCE_SAME = 1e-4
#: and its pose is the pose (per length).
EVIDENCE_BACK = 1e-6
#: An entry changes with a symbol when its value changes by more (m; rad).
ENTRY_MATTERS = 1e-9
#: Formulas are compared relative to their size, and to no less than this (per length).
FLOOR_OF_SEARCH = 1e-3
#: Numbers below this are shown as zero.
SHOWN_ZERO = 1e-11
#: Rad: solutions of one pose are further apart, but for merged ones.
JUDGED_SAME_JOINTS = 1e-5
#: A judged length (per length of the arm), slope or determinant (relative) below this is zero but for rounding.
JUDGED_ZERO = 1e-9
#: A condition said to leave no solution is met by a reachable pose when its sides differ by more than this (times one
#: and the longest length squared): at the edge of reach both are equal but for rounding.
CONDITION_MET = 1e-9
#: The least step (rad; per length), of steps that begin at one, by which a condition is approached: squares of it are
#: rounding.
CONDITION_STEP = 1e-6
#: An equation holds at a posture found for it, and values are one, within this (rad; per length): roots halve the
#: digits.
JUDGED_HOLDS = 1e-6
#: Rad or length: half the width of a difference that gives a formula's slope; exact for the squares it is used on.
SLOPE_WIDTH = 1e-5
#: Relative; singular values below are zero.
JUDGED_RANK = 1e-7
#: A joint takes part in a freedom when its part of the null direction is larger.
PART_OF_FREEDOM = 1e-4
#: Damping of the search for a posture: this part of the square of what is missed,
DAMPED_BY_MISS = 1e-3
#: and never less than this.
DAMPED_AT_LEAST = 1e-12
#: A point of the border is found to this (per length), far below a printed digit,
LIMIT_FOUND = 1e-4
#: and the arm reaches a point that it comes this near to (per length).
LIMIT_REACHED = 1e-6
#: Least damping of the descent to a point (squared lengths): it keeps stretched postures finite.
LIMIT_DAMPING = 1e-9
#: Entries of two matrices are one value within this, relative to the largest.
MATRIX_ENTRY = 1e-9
#: Printed 6.1E-17 stands for zero.
ROUND_OFF = 1e-12
#: Of a length or an angle; squares of larger numbers leave no digits for a comparison.
MAX_SIZE = 1e12
#: Relative; lengths closer than this count as equal.
EQUAL_LENGTHS = 1e-9
#: Entries of a constant frame that miss a whole number by less are whole.
UNROUNDED = 1e-13
#: Of a sine, say; so close to the border a formula has no digits left to be judged by.
BORDER_OF_REGION = 1e-3
#: Of a number: what is closer was not rounded.
EXACT_ENOUGH = 1e-10
#: Slopes by a number's rounding are taken over this part of it.
SLOPE_STEP = 1e-3
#: Rounding is explained when the numbers of the source need not change by more.
NO_CHANGE = 1e-11
#: Numbers whose effect is below this part of the largest are not changed.
EXPLAINED_RANK = 1e-9
#: Relative; values closer than this are equal.
SEARCH_SAME = 1e-8
#: Two angles differ by a constant when cosine and sine of what is between them vary by less.
CONSTANT_GAP = 1e-9
#: An angle of the arm, or a constant gap, is met within this (rad): acos loses half the digits near its ends.
SEARCH_ARC = 1e-7
#: Relative to the size of the numbers compared.
VALUE_TOLERANCE = 1e-9
#: A value is the one that is needed within this, relative to both.
NEED_MET = 1e-6
#: Of the interval of a printed number: joints found in theirs give a pose in its own but for this, the rounding of the
#: search.
BEYOND_DIGITS = 1e-3
#: Of the tolerance of values: a right formula misses by the rounding of doubles, a millionth of the tolerance; one that
#: misses by more than this in the middle of the joint vectors is wrong, if only just.
NEARLY = 1e-3
#: The same where the arm or the formula has numbers that are rounded to a dozen digits.
NEARLY_ROUNDED = 1e-2
