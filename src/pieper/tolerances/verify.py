"""Of comparisons with other programs."""

#: Two programs that agree differ by rounding alone (per length; rad): hundreds of operations leave 1e-13, as files do.
VERIFY_AGREES = 1e-10
#: What a toolbox calls a solution misses its pose by no more than this (per length; rad).
VERIFY_SETTLED = 1e-10
#: A solution of a toolbox is one of ours when the joints depart by no more than this (rad; per length),
VERIFY_KNOWN = 1e-6
#: and by this over the smallest singular value, since a pose that is met so well says no more about the joints.
VERIFY_PER_SIGMA = 1e-9
#: A self-motion's samples are met within this, rad or lengths.
VERIFY_ON_CURVE = 1e-4
#: Directions that the pose feels less than this part of the most are not gone along when a solution is settled.
VERIFY_SHORTEST = 1e-9
