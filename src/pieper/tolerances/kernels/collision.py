"""Of distances between bodies (m, or as said)."""

#: Squared length of a direction (a product of two unit vectors) below which two edges are parallel and say nothing.
TOUCHING_FLAT = 1e-20
#: What a distance between bodies may be off by rounding, per metre of the largest number in it: ten times the seen.
DISTANCE_ROUNDING = 1e-14
#: Squares of lengths below this part of the squares they came from are rounding: two bodies meet.
BODIES_MEET = 1e-28
#: Cosine below which a segment is level with a face, and sine below which it runs along a cylinder's axis.
LEVEL = 1e-9
#: A direction that leans less than this against a cylinder's axis is level: it touches the wall, not the rim.
LEVEL_DIRECTION = 1e-7
#: A direction whose largest entry misses 1 by no more is a face's normal.
FACE_NORMAL = 1e-15
