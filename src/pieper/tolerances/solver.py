"""Of the solver in Python: self-motions, rows that are one, which arms the families take."""

from .kernels.everywhere import SAME_SOLUTION

#: What a solution may miss its pose by after polishing (per length; rad).
CLOSES = 1e-9
#: Longest step along a self-motion (rad; per length): joints turn visibly, and chords cut corners by about 2e-3.
CURVE_STEP = 0.12
#: Rows of a kernel closer than this (rad; per length) are one: a double root is known to ten times `SAME_SOLUTION`.
SAME_ROW = 10 * SAME_SOLUTION
#: A filled joint that comes out below this was meant to be zero: the pose is one the arm can reach (rad; per length).
FILLED_ZERO = 1e-6
#: Points that differ in a task's virtual joints alone are one within this (rad; per length): curves end there.
SAME_AFTER_CUT = 1e-6

#: Singular values below this part of the largest do not count for a rank.
RANK = 1e-7
#: Offsets and twists (per length; rad) up to which the two sides of an offset wrist are taken for alike, and from which
#: they are taken for different. Between the two every root is nearly double: such an arm goes to the general solver.
SIDES_ALIKE = 1e-13
SIDES_DIFFERENT = 2e-3
#: Shortest link (per length) and smallest sine between neighbouring axes that the offset wrist can stand on.
SHORTEST_LINK = 1e-3
#: A test pose's own joints are found when a solution comes this near (rad; per length).
HIDDEN_FOUND = 1e-6
#: Relative determinant up to which a pair's 2x2 is of rank one by the arm's geometry rather than by chance.
PAIR_ALWAYS_RANK_ONE = 1e-11
#: Numbers this small beside one, or beside the arm's size, are what rounding left of a zero.
SWP_ZERO = 1e-16
#: Upper arm and forearm are longer than this (per length).
SWP_SHORTEST = 1e-6
#: Axis 4 is tilted out of the arm's plane when it leans more than this (rad);
SWP_TILTED = 1e-12
#: across the plane, it has no direction in it when less than this is left.
SWP_IN_PLANE = 1e-9
#: Inner links that are together shorter than this part of the largest are no measure of length.
LENGTHLESS = 1e-9
