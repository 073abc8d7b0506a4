"""Of arms as they are written: rows, axes, other people's files."""

#: What a worked example's digits hold where nothing is said (m; rad).
TYPED_DIGITS = 1e-9
#: An axis may depart from unit length by this much (four typed digits); it is normalised.
UNIT_SLACK = 1e-3
#: Axes whose directions differ by less than this (rad) are taken for parallel. A common normal of nearly parallel axes
#: lies far away and costs eps / angle of precision, taking them for parallel costs the angle: they balance here.
PARALLEL_AXES = 1e-8
#: Where a table leads far outside the arm, axes whose directions differ by less (rad) are what makes it do so.
NEARLY_PARALLEL = 0.1
#: A common normal shorter than this (per length of the chain) is taken for an intersection.
MEETING_AXES = 1e-13
#: An angle that misses a multiple of 15 deg by no more (rad) is one: what products of frames leave.
ANGLE_ROUNDED = 8e-15
#: The same of a frame's entries around 0 and 1.
FRAME_ROUNDED = 4e-15
#: Cosines and sines below this are those of a quarter turn, or of several, as a number can write it.
QUARTER_EXACT = 4e-16
#: Rounding is taken relative to the arm's size, and to no less than a millimetre.
SMALLEST_ARM = 1e-3
#: A name, or an end of one, that is this much like what was typed (of 1) may be what was meant.
LEAST_LIKENESS = 0.6
#: A coupling whose inverse is larger than this many times its size says that two joints move the same.
WORST_CONDITION = 1e6
#: A mesh without thickness gets this much, m.
THINNEST = 1e-6
#: Ends whose tools differ by no more than this (m, and per unit of the rotation matrix) are one end.
SAME_TOOL = 1e-9
#: Points that lie in one plane within this part of their extent enclose nothing.
FLAT_SHAPE = 1e-9
#: Limits beyond this (rad or m) are what exporters write for none.
LIMIT_IS_NONE = 1e5
#: Axes that depart by no more than this (of a unit vector; m) are one line.
SAME_AXIS_LINE = 1e-9
#: An angle that is replaced by the round one it was cut off from is remarked upon when it changes by more (rad).
REMARKABLE = 1e-14
#: Joints whose part of a coupling's null direction is larger are named.
MOVES_NOTHING = 1e-3
