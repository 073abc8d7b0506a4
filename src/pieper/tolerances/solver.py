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
#: Below this smallest singular value (per length of the arm; rad) the damped inverse is taken.
DAMPED_INVERSE = 1e-6
#: How far beside a value at which what is left of the arm is solved by no family it is solved instead (rad; lengths).
BESIDE_UNSOLVED = (1e-4, -1e-4, 1e-3)
#: Directions that the pose feels less than this part of the most carry no step onto the pose: the joints stay near.
PULLED_RANK = 1e-7
#: How near to a special arrangement an arm is tried as one, the nearest first, where no elimination is certain (rad;
#: per length): beyond the last of them eliminations are certain again.
NEARLY_SPECIAL = (1e-10, 1e-8, 1e-6, 2e-5)
#: |det J| must stay above this part of its largest value: a path that nearly touches a singularity proves nothing.
CLEAR_OF_SINGULAR = 2e-3
#: Arms that differ by no more (per length; rad) have none where the nominal one has none, neither here nor around.
NO_MORE_THAN_TYPED = 1e-4
#: What a turn counts beside the position, stage by stage, steps, and how many postures are kept.
CLOSEST_STAGES = ((1.0, 12, 24), (1e-3, 24, 10), (1e-8, 30, 6))
#: Positions that are as near as this (per length) are alike, and the orientation decides.
ALIKE_NEAR = 1e-7
#: A bend or an offset smaller than this has no side (per length; sine).
NO_SIDE = 1e-9
#: Step of all joints (rad; per length) to either side of a posture that has no label of its own.
LABEL_STEP = 1e-3
#: Axes that are at a smaller angle (rad) are parallel for the words of a label.
LABELLED_ANGLE = 1e-6
#: A determinant (per length) nearer to zero than this has no sign.
ASPECT_SIGN = 1e-12
#: A nearest posture that misses by less (per length; rad) hits the pose.
TOLD_AS_HIT = 1e-7
#: Positions missed by less (per length) are reached, turns (rad) are right.
TOLD_AS_TURN = 1e-6
