"""Of pictures: sizes below which nothing can be drawn."""

#: A picture shows this much around an arm at least, m.
DRAWN_LEAST = 1e-3
#: A picture of time shows this much at least, s.
DRAWN_TIME = 1e-9
#: Cells of a picture are no smaller, m.
DRAWN_CELL = 1e-6
#: Cosine above which the first axis is upright: 0.08 deg.
UPRIGHT_AXIS = 0.999999
#: Side of a voxel of a drawn map, at least, m: finer ones cannot be told apart on a screen, and are too many.
SMALLEST_VOXEL = 1e-4
#: Part of a limit from which on a curve is drawn as being at it: the rest is less than the width of a line.
DRAWN_AS_BINDING = 0.995
