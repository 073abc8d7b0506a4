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
#: What is missed to rounding (per length; rad), a hundred times: points at which curves cross are known to the root of
#: this by how much the weakest direction grows a length beside them.
FOLLOW_BLUR = 1e-14
#: So many times the square of that way is gone straight across where another curve passes or crosses; longer steps are
#: halved there.
FOLLOW_ACROSS = 16.0
#: Where one direction is free and no more those below this part of the strongest are rounding,
FOLLOW_NONE = 1e-12
#: a pose missed by less (per length; rad) is held to rounding,
FOLLOW_EXACT = 1e-15
#: which directions weaker than this part of the strongest need, that points are known to ten digits,
FOLLOW_WEAK = 1e-3
#: a step between whose ends the tangent turns less than this cosine says is as good as straight,
FOLLOW_STRAIGHT = 0.9998
#: no step shorter than this (rad; lengths) is tried,
FOLLOW_FINEST = 1e-8
#: and a point this near (rad; lengths) to the beginning is the beginning.
FOLLOW_SAME = 2e-7
