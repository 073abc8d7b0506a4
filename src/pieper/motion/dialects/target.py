"""What is read back of a program: targets, how they are gone to, and what happens on the way."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from pieper.kinematics.arrays import Array
from pieper.kinematics.pose import pose_error
from pieper.motion.instructions import Happening
from pieper.tolerances import SAME_TOOL_IN_FILE


@dataclass(frozen=True)
class Words:
    """Configuration words of a target, as its file has them.

    Attributes:
        maker: Whose they are, as `arm.configuration` takes it.
        words: As `Configuration.words`.
        turns: As `Configuration.turns`.
    """

    maker: str
    words: tuple[str, ...]
    turns: tuple[int, ...]

    def __str__(self) -> str:
        turns = ", ".join(str(turn) for turn in self.turns)
        return f"{' '.join(self.words)} with turns {turns}"


@dataclass(frozen=True, eq=False)
class Target:
    """What is read back.

    Attributes:
        kind: "move_j", "move_l", "move_c", "point" of a trajectory, or "stay": nothing moves, and things happen.
        q: (n,) joint values, rad or m, where the file has them.
        joints: Names of the joints whose values these are, where the file says them.
        T: (4, 4) pose in the base, m, where the file has it.
        via: (4, 4) pose that a circle passes, where the file has it.
        q_via: (n,) joint values there, where the file has them.
        tool: (4, 4) the tool that is meant, m, where the file has it.
        frame: (4, 4) the work frame in the base that the target stands in, m; None for the base.
        speed: Part of the joints' full speed of a "move_j"; the tool's speed of the others, m/s; None: not said.
        joint_speed: Speed of the fastest joint of a "move_j", rad/s, where the file says that.
        blend: Radius round the target within which the corner is cut, m; None where the file says no radius.
        words: Which solution of the pose is meant, where the file says it in the maker's words.
        near: (n,) posture whose nearest solution is meant, where the file says that.
        before: Waits, outputs and gripper values between the target before and this one.
        after: Those behind the last target.
    """

    kind: str
    q: Array | None = None
    T: Array | None = None
    via: Array | None = None
    q_via: Array | None = None
    tool: Array | None = None
    frame: Array | None = None
    speed: float | None = None
    joint_speed: float | None = None
    blend: float | None = None
    words: Words | None = None
    near: Array | None = None
    before: tuple[Happening, ...] = ()
    after: tuple[Happening, ...] = ()
    joints: tuple[str, ...] = ()
    place: int = field(default=0, repr=False)

    def means_tool(self, T: Array) -> bool:
        """Whether the tool that is meant is T (4, 4), as exactly as files say it."""
        return self.tool is not None and bool((pose_error(self.tool, T) < SAME_TOOL_IN_FILE).all())

    def under(self, tool: Array | None, frame: Array | None) -> Target:
        """Return a target that was read as it stands in a work frame, its poses moved into the base."""
        if frame is None:
            return replace(self, tool=tool)
        moved = [None if T is None else frame @ T for T in (self.T, self.via)]
        return replace(self, T=moved[0], via=moved[1], tool=tool, frame=frame)
