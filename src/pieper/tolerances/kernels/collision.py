"""Of distances between bodies (m, or as said)."""

#: Squared length of a direction (a product of two unit vectors) below which two edges are parallel and say nothing.
TOUCHING_FLAT = 1e-20
#: What a distance between bodies may be off by rounding, per metre of the largest number in it: ten times the seen.
DISTANCE_ROUNDING = 1e-14
