"""What rounding leaves, whatever is computed: of turns, directions, lengths and sums."""

#: A vector shorter than this (m, or of numbers meant as one) has no direction.
NO_DIRECTION = 1e-9
#: A range that misses a whole turn by less (rad) is one: angles are typed with nine digits at most.
WHOLE_TURN = 1e-9
#: Sizes are kept above this (m; s) before something is divided by them: smaller ones are none.
NO_LENGTH = 1e-12
#: Numbers of the size of one that differ by no more are one number: hundreds of operations leave 1e-13.
ROUNDING = 1e-12
#: Sines, cosines and sums of products that come out below this are zeros.
ALL_BUT_ZERO = 1e-15
#: Divisors that are squared afterwards stay above this: their squares are still numbers.
SQUARES_LEAST = 1e-150
#: Step of a central difference (rad; per length): error and rounding of it balance near 1e-10.
CENTRAL_STEP = 1e-6
#: Relative: by so much a count or a size may miss its edge and still lie on it.
RELATIVE_ROUNDING = 1e-9
