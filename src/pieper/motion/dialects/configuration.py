"""A posture in a maker's configuration words, with the rule they follow and where it is from."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from pieper import arguments
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, ArrayLike
from pieper.kinematics.forward import checked_joints
from pieper.kinematics.joints import TURN
from pieper.motion.dialects.shape import Shape, shape
from pieper.solver.plan.plan import Plan
from pieper.tolerances import LIMIT_SLACK

#: The maker whose arms have a dialect and no configuration words, and what its name in a robot file says.
UR, _UR = "ur", "universal"
_OPEN = " Not confirmed on a controller."
_NOBODY = " The arm's file names no maker: that its joints count as {maker}'s do is taken for granted."


#: Words and turns of a posture (n,).
WordsOf: TypeAlias = Callable[[Shape, Array], tuple[tuple[str, ...], tuple[int, ...]]]


@dataclass(frozen=True)
class Configuration:
    """A posture as a maker says it.

    Attributes:
        words: What says which of the solutions of a pose it is, without its turns, such as ("N", "U", "T").
        turns: Numbers that say which whole turns of the joints, in the maker's order.
        rule: How they were found, with the source.
        clear: How far the posture is from where a word changes, without units; near zero the words are open.
        untold: Joints with another whole turn inside the limits that the words and turns do not tell apart.
    """

    words: tuple[str, ...]
    turns: tuple[int, ...]
    rule: str
    clear: float
    untold: tuple[str, ...] = ()


def _abb(s: Shape, q: Array) -> tuple[tuple[str, ...], tuple[int, ...]]:
    cfx = 4 * s.rear + 2 * s.behind_lower_arm + (s.bend < 0)
    return (str(cfx),), tuple(int(np.floor(q[j] / (np.pi / 2))) for j in (0, 3, 5))


def _kuka(s: Shape, q: Array) -> tuple[tuple[str, ...], tuple[int, ...]]:
    status = int(s.rear) + 2 * int(not s.behind_lower_arm) + 4 * int(s.bend > 0)
    return (str(status),), (int(sum(1 << j for j in range(6) if q[j] < 0)),)


def _fanuc(s: Shape, q: Array) -> tuple[tuple[str, ...], tuple[int, ...]]:
    words = "F" if s.bend > 0 else "N", "U" if s.above else "D", "B" if s.rear else "T"
    return words, tuple(int(np.floor((q[j] + np.pi) / (2 * np.pi))) for j in (0, 3, 5))


def _yaskawa(s: Shape, q: Array) -> tuple[tuple[str, ...], tuple[int, ...]]:
    words = str(int(s.bend < 0)), str(int(not s.above)), str(int(s.rear))
    return words, tuple(int(not -np.pi < q[j] <= np.pi) for j in (3, 5, 0))


def _denso(s: Shape, q: Array) -> tuple[tuple[str, ...], tuple[int, ...]]:
    figure = int(s.rear) + 2 * int(not s.above) + 4 * int(s.bend < 0)
    double = [int(not -np.pi < q[j] <= np.pi) for j in (5, 3)]
    return (str(figure + 8 * double[0] + 16 * double[1]),), (double[1], double[0])


#: maker -> (what its name in a robot file says one of, what the words are called, the words, the rule)
MAKERS: dict[str, tuple[tuple[str, ...], str, WordsOf, str]] = {
    "abb": (
        ("abb",),
        "cf1, cf4, cf6, cfx",
        _abb,
        "cf1, cf4, cf6: the quarter turn floor(angle / 90 deg) of axes 1, 4, 6. cfx: 4 if the wrist centre is behind "
        "axis 1, plus 2 if it is behind the lower arm, plus 1 if axis 5 is negative. The quarter turns are those of "
        "ABB's Basic Characteristics RAPID, confdata, which also says that the IRB 6400C counts cf1 otherwise; cfx, "
        "whose use depends on the model (RobotStudio API, ConfigurationData), follows the RAPID reference's table for "
        "serial link arms from memory.",
    ),
    "kuka": (
        ("kuka",),
        "S and T",
        _kuka,
        "S: 1 if the wrist root point has a negative x in the frame that turns with A1 (overhead area), plus 2 if A3 "
        "is past the angle at which the arm is stretched, plus 4 if A5 is positive. T: bit i - 1 is set where Ai is "
        "negative. The overhead area is that of KUKA's expert programming manual, as quoted on robot-forum.com (thread "
        "7173); on whether the sign of A5 alone decides the last bit manuals and users disagree (thread 45777). LIN "
        "and CIRC ignore both.",
    ),
    "fanuc": (
        ("fanuc",),
        "CONFIG",
        _fanuc,
        "N or F: the wrist is not flipped or flipped, taken as J5 negative or positive; published pages contradict "
        "each other on this sign (industrialmonitordirect.com, configuration from joint angles, has the other one). U "
        "or D: the elbow is above or below the line from shoulder to wrist. T or B: the wrist is before or behind "
        "axis 1. Turns of J1, J4, J6: 0 from -180 to 180 deg (FANUC operator's manual, configuration).",
    ),
    "yaskawa": (
        ("yaskawa", "motoman"),
        "RCONF",
        _yaskawa,
        "Flip (0, B positive) or no flip (1), upper (0) or lower (1) arm, front (0) or rear (1), then R, T and S: 0 "
        "from -180 to 180 deg, 1 beyond. The order and meaning of the six numbers are those of Yaskawa's NX100 and "
        "DX100 manuals (HW0481924 and HW0482494, Job Data Format, RCONF); that flip is a positive B is from memory.",
    ),
    "denso": (
        ("denso",),
        "figure",
        _denso,
        "1 if lefty, taken as the wrist behind axis 1, plus 2 if the elbow is below, plus 4 if the wrist is not "
        "flipped, taken as J5 negative, plus 8 if J6 and 16 if J4 is beyond -180 to 180 deg. DENSO's RC8 manual (ID "
        "1968) has 1 for lefty and 16 for a fourth axis beyond -180 < J4 <= 180 deg, of arms with four axes; the rest "
        "is from memory of the programmer's manual.",
    ),
}


def configuration(plan: Plan, q: ArrayLike, maker: str, made_by: str) -> Configuration:
    """Return a posture in a maker's configuration words.

    Args:
        plan: How the arm is solved.
        q: (n,) joint vector, rad.
        maker: "abb", "kuka", "fanuc", "yaskawa" or "denso".
        made_by: Whose arm it is, as its robot file says; empty where nobody does, which the rule then says.

    Raises:
        InputError: The maker is unknown or has no such words, the arm is another maker's, or it is not of the kind
            that the words are defined for.
    """
    joints = checked_joints(q, plan.n)
    if joints.ndim != 1:
        raise InputError(f"q must be one joint vector ({plan.n},), got {joints.shape}.", given=joints.shape)
    words, turns, clear = words_at(plan, joints, maker, made_by)
    key = maker.lower()
    untold: list[str] = []
    for j in range(6):
        low, high = plan.limits[j]
        for turn in (-2, -1, 1, 2):
            other = joints.copy()
            other[j] += turn * TURN
            inside = low - LIMIT_SLACK <= other[j] <= high + LIMIT_SLACK
            if inside and words_at(plan, other, key, made_by)[:2] == (words, turns):
                untold.append(plan.names[j])
                break
    said = MAKERS[key][3] if made_by.strip() else MAKERS[key][3] + _NOBODY.format(maker=key)
    return Configuration(words, turns, said + _OPEN, clear, tuple(untold))


def words_at(plan: Plan, q: Array, maker: str, made_by: str) -> tuple[tuple[str, ...], tuple[int, ...], float]:
    """Return the words and turns of a posture (n,) alone, and how clear they are; see `configuration`."""
    key = str(maker).lower()
    if key not in MAKERS:
        raise InputError(
            f"maker {arguments.kind_of(maker)} has no configuration words here; those of {', '.join(MAKERS)} are "
            "known. Universal Robots has none: its poses are solved near the posture the arm is in.",
            given=maker,
            allowed=list(MAKERS),
        )
    if not is_of(made_by, key):
        raise InputError(
            f"{plan.name} is made by {made_by}; {key}'s words are said of its own arms alone: signs and zeros of "
            f"joints differ from maker to maker. {_own(made_by)}",
            given=maker,
            maker=made_by,
        )
    _, named, words_of, _ = MAKERS[key]
    s = shape(plan, q, f"{key}'s {named}")
    return *words_of(s, q), s.nearest


def is_of(made_by: str, maker: str) -> bool:
    """Whether an arm of whom its file names is of a maker; one that names nobody may be anybody's."""
    said = made_by.lower()
    names = (_UR,) if maker == UR else MAKERS[maker][0]
    return not said.strip() or any(re.search(rf"\b{name}\b", said) for name in names)


def _own(made_by: str) -> str:
    """Return what words an arm has instead, in a sentence."""
    own = next((maker for maker in MAKERS if is_of(made_by, maker)), None)
    if own is not None:
        return f'Its own are those of "{own}".'
    none = "Its maker has none" if is_of(made_by, UR) else "Its maker's are not known here"
    return f"{none}: write joint targets."
