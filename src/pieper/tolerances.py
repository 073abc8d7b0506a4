"""Every tolerance, named for why it exists. Lengths are relative to the arm's characteristic length."""

from __future__ import annotations

#: A pose whose rotation part departs from a rotation by more than this (max abs of R^T R - I) is refused;
#: below it, down to `ROTATION_EXACT`, it is replaced by the nearest rotation. float32 rounding gives about 3e-7.
ROTATION_ACCEPTED = 1e-5
#: Departures up to here are the rounding of double arithmetic and are not worth a remark.
ROTATION_EXACT = 1e-12

#: Axes are taken for parallel, and points for one point, when they miss by no more than this (rad; per length).
#: It is the size of rounding in tables that were typed exactly, not of drawing noise.
GEOMETRY_EXACT = 1e-12

#: A solution counts as verified when forward kinematics returns the pose within this (per length; rad).
VERIFIED = 1e-9

#: Solutions closer than this (rad, or per length for a prismatic joint) are one solution.
SAME_SOLUTION = 1e-7

#: A limit is not violated by less than this (rad, or per length for a prismatic joint): rounding at a stop.
LIMIT_SLACK = 1e-9

#: sigma_min / sigma_max of the scaled Jacobian below which a solution is looked at for self-motion and merged roots.
SINGULAR_EXAMINED = 1e-6
