"""Following a path: the branch nearest to the start, every stop with its cause and what would cure it."""

from __future__ import annotations

from pieper.kinematics.arrays import ArrayLike
from pieper.kinematics.pose import PoseLike
from pieper.motion.cures import cures
from pieper.motion.following import followed
from pieper.motion.track import Track
from pieper.solver.plan.plan import Plan


def follow(plan: Plan, path: PoseLike, *, start: ArrayLike | None = None) -> Track:
    """Follow a path by the branch whose first solution is nearest to the start posture.

    Each branch is carried by continuity, not merely by nearness: steps are compared with what the Jacobian predicts and
    halved between the points when in doubt, so that a track never changes branch unnoticed. Between two given points
    the tool is taken to move on the straight line of `pieper.line`. Whole turns stay continuous, from the turn nearest
    to the start. Where the first pose is singular and has a continuum of solutions, the branches are those that
    leave it.

    Args:
        plan: How the arm is solved.
        path: (N, 4, 4) poses, m; one pose is a path too.
        start: (n,) posture the arm is in, rad or m; all joints at zero when left out.

    Returns:
        The Track. A pose that cannot be reached is never an exception: it is the stop, with its cause.

    Raises:
        InputError: The path is not a stack of poses, or start is not a joint vector.
    """
    return followed(plan, path, start=start, seek=cures)
