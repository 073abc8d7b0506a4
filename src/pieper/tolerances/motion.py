"""Of lines, splines, blends, branches that are followed, and what is driven in time."""

#: Remarks are not made of less than this part of the radius.
BLEND_SHRUNK = 1e-3
#: A blend shorter than this (m) is none.
NO_BLEND = 1e-9
#: The point at which a blend begins is looked for with this much less, relative: rounding.
LAST_BLENDED = 1e-12
#: A reading at a singular point may lie this far (rad, or per length) from where the branch was just before it.
READING = 5e-2
#: Sine of the angle at the via point under which three points are in line.
THREE_IN_LINE = 1e-6
#: How much the two radii of a circle said by its centre may differ, relative: half a unit of four printed digits.
OFF_CENTRE = 5e-4
#: The speed in a section departs from the one asked for by no more than this, relative, between the grid's points.
EVEN_SPEED = 2e-7
#: A tool that moves less than this (m a unit of s) stands still and turns: it has no speed to keep.
TOOL_STANDS = 1e-9
#: The constant speed of a section is found when what is left between bounds is this part of it.
SPEED_SETTLED = 1e-12
#: A speed that had to be lowered by more than this part is said.
SPEED_LOWERED = 1e-3
#: The time law is asked for this much more than the speed that is wanted, so that it is reached.
SPEED_ABOVE = 1e-6
#: Departures below this (rad, or per length) are the rounding of solutions close to a singularity.
BRANCH_ROUNDING = 1e-6
#: Two solutions this close (rad, or per length) at the smallest step have met: 2^-18 under a square root is 2^-9.
BRANCHES_MET = 5e-3
#: sigma_min / sigma_max of the scaled Jacobian below which a solution counts as singular itself.
SINGULAR_POINT = 1e-7
#: A singular point is bridged from this far before it, as a fraction of the spacing.
BRIDGE = 1e-3
#: Directions that the task feels less than this part of the most carry no step along a branch,
FOLLOWED_RANK = 1e-7
#: and none of the rates to it.
TASK_RANK = 1e-10
#: A wrist centre this near to axis 1 at zero (lengths of the arm) stands over it.
WRIST_OVER_AXIS = 1e-3
#: Axes are at right angles where their cosine is below this: tables have nine digits.
AXES_ACROSS = 1e-9
#: A limit binds where its value comes this near to it, relative: a little more than the tool's polygon takes away.
LIMIT_BINDS = 2e-3
#: Bounds of what the tool does within a jerk lie this near above a value that is there, relative to the largest.
BOUND_NEAR = 1e-5
#: What is passed by rounding is taken back with this much more, relative.
TAKEN_BACK = 1e-13
#: Points this near to the chord from end to end, of the largest joint value, are on a straight line: rounding.
ON_A_LINE = 1e-14
#: A round that gains less than this, relative, was the last but one.
JERK_GAIN = 1e-3
#: Beside a section of constant speed limits are aimed at with this much room, relative: rounds end inside them.
EASED_MORE = 8e-3
#: Moments nearer than this, of the whole duration, are one.
ONE_MOMENT = 1e-12
#: Limits of a joint move are kept by this much, relative, so that rounding does not pass them.
LIMIT_KEPT = 1e-13
#: A speed below the top one by more than this, relative, does not reach it.
TOP_REACHED = 1e-9
#: A sample this near to the end, of a sample's length, is the end.
LAST_SAMPLE = 1e-6
#: Rotations closer than this (rad) to a half turn have two equally short ways; the axis is then chosen by rule.
HALF_TURN_MARGIN = 1e-9
#: How far the tool may be from its line or circle between the points of the spline, m and rad.
STRAYS = 1e-5
#: A move begins where the one before it ended, when the joints depart by no more (rad; m).
PROGRAM_FOLLOWS_ON = 1e-6
#: A tool or place read from a controller's file is one known when nothing departs by more (m; rad): files say 1e-3 mm
#: and 1e-3 degrees.
SAME_TOOL_IN_FILE = 2e-5
#: How far a joint may be from where a configuration word changes and have either word (rad): poses of files are
#: rounded, and a joint at just a quarter of a turn is a rounding error this side of it or that.
EITHER_WORD = 1e-4
#: A move to a pose that the tool misses by less (m; rad) is none.
PROGRAM_STANDS = 1e-9
#: Poses nearer than this (m, and rad) are one.
ONE_POSE = 1e-9
#: A crossing this near to a point of the path, in spacings, is read at the point.
AT_A_POINT = 1e-2
#: Points of the grid nearer than this in s are one.
ONE_POINT_OF_PATH = 1e-9
#: Two strands that end this near (spacings)
STRANDS_END = 1e-3
#: and whose joints there are this near (rad; per length) end in one point.
STRANDS_MEET = 5e-2
#: A nearer row is nearer by more than this (rad; per length): ties go to the first.
NEARER_BY = 1e-9
#: Cosine between the ways (in the joints) under which the corner is a reversal, which no curve rounds.
REVERSES = -0.9999
#: sigma_min / sigma_max where a branch passed a singularity: its place is known to 2^-18 of a step, under a root.
BRANCH_PASSED = 2e-3
#: A stop this near to a point of the path, in spacings, is said to lie at it.
SAID_AT_POINT = 1e-4
#: A distance (m) or turn (rad) off the line that nobody would hear of is not said.
WORTH_SAYING = 1e-6
#: How near (rad; per length) to a special arrangement a posture is that a branch ends in: half the digits of a double
#: root are lost, and a branch is carried to 2^-18 of the spacing of the points.
NEAR_ARRANGEMENT = 2e-2
#: A point this near to axis 1 (per length) lies on it.
ON_FIRST_AXIS = 1e-6
#: Slopes of a step (rad; m) below this are those of a joint that rests.
JOINT_RESTS = 1e-9
#: A speed in a file is no higher than a limit by this, relative: files have four decimals of it.
SAME_SPEED = 1e-3
