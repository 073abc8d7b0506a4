"""Of poses, turns, couplings and Newton's method in Python."""

#: The line from shoulder to wrist may come this near to the pole of the reference, rad, and
ARM_ANGLE_POLE = 1e-6
#: the elbow this near to the line, per length; nearer the angle is undefined. It is then known to 1e-10 rad at worst.
ARM_STRETCHED = 1e-7
#: An arm angle that a self-motion changes by less (rad) says nothing of it.
ARM_ANGLE_MOVES = 1e-6
#: Directions in which the pose moves by less than this part of the most carry no Newton step.
NEWTON_CUTOFF = 1e-12
#: The same where a joint is held.
NEWTON_HELD_RANK = 1e-9
#: Least damping of a careful descent,
NEWTON_DAMPING = 1e-12
#: the square of a miss below which it ends,
NEWTON_SQUARE = 1e-24
#: and what is added so that a singular posture has a step.
NEWTON_FINITE = 1e-15
#: A quaternion may depart from unit length by this much (typed with four or more digits); it is normalised.
QUATERNION_SLACK = 1e-3
#: Where the first column of R is closer to z than this, roll and yaw turn about one axis and yaw says it all.
ROLL_IS_YAW = 1e-13
#: Positions beyond this, m, are refused: their squares would leave the range of doubles' precision.
FARTHEST = 1e12
#: Sine of a turn below which its axis is read from the series.
SMALL_TURN = 1e-7
#: Sine of a turn beyond a quarter below which its axis is read from the symmetric part: divided by it, rounding grows.
NEAR_HALF_TURN = 0.1
#: A pose without a solution this many reaches away was probably said in millimetres.
FAR_AWAY = 100.0
#: A body this many reaches across was too: floors and halls are less, the smallest tables in millimetres are more.
LARGE_BODY = 200.0
#: A box that holds an arm's place this deep, in its reaches, is no floor drawn about it: a slab's half is less.
DEEP_INSIDE = 0.1
#: Joints that turn faster (rad/s) than the fastest wrists do were probably said in degrees,
FAST_JOINT = 60.0
#: tools that are faster (m/s) than the fastest pickers in millimetres,
FAST_TOOL = 20.0
#: and a number from here on stands for no limit.
NO_LIMIT = 1000.0
#: Metres: an arm, or a tool, that is longer was probably said in millimetres; the longest that are built are some 20 m.
LONGEST_ARM = 50.0
#: Radians of an angle of a pose, which needs no more than half a turn: more than two turns were probably degrees.
MOST_TURNED = 13.0
