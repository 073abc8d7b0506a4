"""Of self-motions that are followed (relative to the strongest direction; rad; lengths of the arm)."""

#: Directions weaker than this are not corrected in,
FOLLOW_WEAKEST = 1e-9
#: and below this their direction is free.
FOLLOW_FREE = 1e-7
#: A curve ends where a step shorter than this does not go on.
FOLLOW_SHORTEST = 1e-5
#: A curve that comes this near to where it began is home, whichever way it goes.
FOLLOW_HOME = 1e-9
#: Singular values that differ by no more than this part are one: the weakest direction of a short arm is the curve's.
FOLLOW_ALIKE = 1e-7
#: What is left of the way along a curve, below which the way itself is kept.
FOLLOW_LOST = 1e-6
#: Steps (rad; lengths) so short go straight on where another curve passes or crosses; longer ones are halved there.
FOLLOW_CROSSING = 4e-5
