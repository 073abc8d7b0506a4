"""What Python and kernels both ask of poses, axes, solutions and limits."""

#: A pose whose rotation part departs from a rotation by more than this (max abs of R^T R - I) is refused;
#: below it, down to `ROTATION_EXACT`, it is replaced by the nearest rotation. float32 rounding gives about 3e-7.
ROTATION_ACCEPTED = 1e-5
#: Departures up to here are the rounding of double arithmetic and are not worth a remark. Well below what a solution
#: may miss (`CLOSED_VERIFIED`): rows of a pose rounded to twelve digits that stays as it is would miss by as much.
ROTATION_EXACT = 2e-13

#: Axes are parallel, and points one point, when they miss by no more than this (rad; per length): rounding alone.
GEOMETRY_EXACT = 1e-12

#: A solution counts as verified when forward kinematics returns the pose within this (per length; rad).
VERIFIED = 1e-9

#: Solutions closer than this (rad, or per length for a prismatic joint) are one solution.
SAME_SOLUTION = 1e-7

#: A limit is not violated by less than this (rad, or per length for a prismatic joint): rounding at a stop.
LIMIT_SLACK = 1e-9

#: sigma_min / sigma_max of the scaled Jacobian below which a solution is looked at for self-motion and merged roots.
SINGULAR_EXAMINED = 1e-6

#: Divisors are kept at least this far from zero where zero is meant and answered otherwise.
TINY = 1e-300

#: Joint values this close (rad, m) are rounding and do not order rows.
KERNEL_ROW_ORDER = 1e-6

#: A pose is out of reach for certain where it is this part farther away than the links laid end to end.
BEYOND_REACH = 1e-9
