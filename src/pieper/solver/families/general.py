"""Any six joints, revolute and prismatic in any order: elimination to an eigenvalue problem."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pieper import _kernel
from pieper.errors import PlanError
from pieper.kinematics.arrays import Array
from pieper.kinematics.chain import Chain
from pieper.kinematics.geometry import Geometry, look
from pieper.solver.families.family import Family, KernelSpec
from pieper.solver.families.loop import full_rank, nearly_full_rank
from pieper.tolerances import BELIEVED_NOISE, GEOMETRY_EXACT, LENGTHLESS, TINY

#: The kernel's order of trials: six starts of the loop, two directions, two orders of the pair.
_DIRECTIONS = ("forward", "backward")
#: Poses that were made by random postures of which each is to be certain.
MADE_POSES = 16


@dataclass(frozen=True)
class Match:
    """Six joints of whatever kind.

    Args:
        geometry: What was found about the axes; a refusal carries it.
    """

    geometry: Geometry


def match(chain: Chain, geometry: Geometry) -> Match | None:
    """Return a match for every six-joint chain; whether the arm can be solved is said by `prepare`."""
    return Match(geometry) if chain.n == 6 else None


def prepare(chain: Chain, match: Match | None = None) -> KernelSpec:
    """Choose how the elimination is done for this arm, by trying every way on test poses.

    The loop of six joints is opened at each joint and walked in both directions; each way hides another joint in
    the eigenvalue problem. Ways that vanish identically, lose solutions or are noisy fall behind or away. Lengths are
    scaled, and frames slid along their axes towards each other, so that neither units nor the table's habits matter.

    Args:
        chain: Six joints.
        match: What `match` found.

    Returns:
        The spec. Its `info` holds `usable` (number of ways left), `certified` (False where every way vanishes for
        this geometry and a slightly changed arm is solved instead, its solutions polished onto this one: poses are
        then flagged uncertain; or where the best way is noisier than can be believed and does not tell all the same
        how many solutions poses have), `hidden_joint` (1-based, of the best way), `direction`, `noise` (of the best
        way, relative; 1e-16 is perfect), `ways` (a tuple of dicts: rank, hidden joint, direction, missed test
        solutions, noise), `max_solutions` (what the degree allows) and `scale` (m).

    Raises:
        PlanError: No way of elimination is of use; the message says why, as far as it is known.
    """
    slides = int(chain.prismatic.sum())
    links, scale = slid(chain)
    geometry = _kernel.General(links=links, slides=tuple(chain.prismatic.tolist()), scale=scale)
    ways = _ways(geometry.trials)
    whole = full_rank(chain)
    proven = geometry.usable > 0 and not whole and nearly_full_rank(chain) and _proves(chain, geometry)
    if geometry.usable == 0 or not (whole or proven):
        found = match.geometry if match is not None else look(chain, GEOMETRY_EXACT)
        reason, cure = _reason(chain, slides)
        raise PlanError(f"{reason} {cure}", geometry=found, ways=ways, reason=reason)
    exact = [way for way in ways if way["rank"] == 1]
    best: dict[str, Any]
    if slides == 3:
        best = {"hidden_joint": None, "direction": "closed form", "noise": 0.0}
    elif exact:
        best = exact[0]
    else:
        best = {"hidden_joint": None, "direction": "a nearby arm's solutions, polished", "noise": 1.0}
    info: dict[str, Any] = {
        "usable": geometry.usable,
        "certified": slides == 3
        or (bool(exact) and (best["noise"] < BELIEVED_NOISE or proven or _proves(chain, geometry))),
        "hidden_joint": best["hidden_joint"],
        "direction": best["direction"],
        "noise": best["noise"],
        "ways": ways,
        "scale": scale,
        "max_solutions": {0: 16, 1: 16, 2: 8}.get(slides, 2),
    }
    facts = (f"The angle sought first is that of joint {best['hidden_joint']}.",) if exact else ()
    return KernelSpec(geometry, info, facts)


FAMILY = Family(
    name="general",
    arrangement="no special arrangement that a closed form could use",
    words=(
        "Five of the six joints are eliminated (Raghavan and Roth, 1993); the roots of the remaining "
        "equation, of degree sixteen at most, are found as eigenvalues, and each gives the other joints."
    ),
    match=match,
    prepare=prepare,
    eliminating=True,
)


def _proves(chain: Chain, geometry: _kernel.General) -> bool:
    """Whether noisy eliminations tell of poses all the same how many solutions there are: of some that were made."""
    free = np.tile([-np.inf, np.inf], (6, 1))
    solver = KernelSpec(geometry).solver(free, chain.prismatic)
    q = np.random.default_rng(5).uniform(-np.pi, np.pi, (MADE_POSES, 6)) * np.where(chain.prismatic, chain.length, 1.0)
    return all(not solver.one(T)[3] & int(_kernel.Flag.UNCERTAIN) for T in chain.native.fk(q))


def _ways(trials: Array) -> tuple[dict[str, Any], ...]:
    """Turn the kernel's record (24, 4) into words, best first."""
    out: list[dict[str, Any]] = []
    for index, (rank, missed, left_open, noise) in enumerate(trials):
        if not rank:
            continue
        shift, backward = index // 4, (index // 2) % 2
        at = (2 + shift) % 6
        out.append(
            {
                "rank": int(rank),
                "hidden_joint": (6 - at) if backward else at + 1,
                "direction": _DIRECTIONS[backward],
                "missed": int(missed),
                "open": int(left_open),
                "noise": float(noise),
            }
        )
    return tuple(sorted(out, key=lambda way: way["rank"]))


def _reason(chain: Chain, slides: int) -> tuple[str, str]:
    """Return why six joints have no solver, and what to do about it."""
    if slides > 3:
        return (
            f"There are {slides} prismatic joints among the six: four or more slides depend on each other, and with "
            "the rest they cannot give six independent motions."
        ), "Lock a slide, or ask for a partial task."
    if not full_rank(chain):
        return (
            "The six joint axes depend on each other in every posture (under six independent motions), so a reachable "
            "pose has a self-motion, infinitely many solutions."
        ), "Lock a joint, or ask for a partial task."
    reason = "Every way to eliminate joints vanishes for the geometry of the six joints."
    return reason, "Perturb the table by a millionth, or lock a joint."


def slid(chain: Chain) -> tuple[np.ndarray, float]:
    """Return links (7, 4, 4) with frames slid where joints do not notice, and the length (m) that counts as one.

    The frame of a revolute joint may slide along its axis, that of a prismatic one move anywhere, without changing
    joint values; chosen is what makes the five inner translations shortest (least squares), since coordinates of
    far-away points would cost digits.
    """
    moves = [np.eye(3) if p else np.eye(3)[:, 2:] for p in chain.prismatic]
    starts = np.concatenate([[0], np.cumsum([m.shape[1] for m in moves])])
    A = np.zeros((15, starts[-1]))
    b = np.zeros(15)
    for i in range(1, 6):
        rows = slice(3 * i - 3, 3 * i)
        A[rows, starts[i - 1] : starts[i]] = -moves[i - 1]
        A[rows, starts[i] : starts[i + 1]] += chain.links[i][:3, :3] @ moves[i]
        b[rows] = -chain.links[i][:3, 3]
    x = np.linalg.lstsq(A, b, rcond=None)[0]
    links = np.array(chain.links)
    for i in range(6):
        step = moves[i] @ x[starts[i] : starts[i + 1]]
        links[i][:3, 3] += links[i][:3, :3] @ step
        links[i + 1][:3, 3] -= step
    scale = float(np.linalg.norm(links[1:6, :3, 3], axis=1).sum()) / 3
    size = float(np.abs(chain.links[1:6, :3, 3]).max())
    if scale <= LENGTHLESS * max(
        size, TINY
    ):  # nothing left between the axes: base and tool are all the lengths there are
        scale = max(float(np.linalg.norm(chain.links[[0, 6], :3, 3], axis=1).max()), size) or 1.0
    return np.ascontiguousarray(links), scale
