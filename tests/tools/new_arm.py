"""Make a catalogue file from the numbers of a URDF, with check poses from a second source.

    python -m tests.tools.new_arm FILE --name abb-irb120-3-58 --maker ABB --source "..." \
        --against OTHER --against-source "..." --reach 580 --reach-source "data sheet" --payload 3

The table comes from FILE. The first checks multiply FILE's joint origins and axes one by one. Another one has to come
from elsewhere: OTHER, a URDF by somebody else whose own product agrees, or the maker's reach: with axis 6 vertical the
flange is as far from axis 1 as the wrist's centre. Without one, nothing is written.
"""

from __future__ import annotations

import argparse
import dataclasses
import itertools
import math
import re
import tempfile
from pathlib import Path

import numpy as np

import pieper
from oracle.joints import around
from pieper.description import catalog, robottext
from pieper.description.dh import DH, Check, Description
from tests.tools.own_tree import Array, Joint, joints_of, meant, moving, product, way

#: A joint vector without symmetry, deg; a slide takes a tenth of it in mm.
POSED = (10.0, 20.0, -30.0, 40.0, 50.0, -60.0, 25.0)
OTHER = (-35.0, 15.0, 25.0, -70.0, 35.0, 80.0, -15.0)
#: Lengths within this of a multiple of 0.1 um are that multiple, m.
GRAIN = 1e-9


def tidy(value: float, unit: float) -> float:
    """Return the number of at most seven decimals in a unit that a computed value stands for."""
    said = round(value / unit, 7) + 0.0
    return said * unit if abs(said * unit - value) < GRAIN else value


def degrees(value: float) -> float:
    """Return a limit as the degrees, to half a degree, that its rounded radians came from; else to 4 decimals.

    Radians of k decimals may stand for anything within half a unit of the last one, half a degree being seventeen units
    of the third decimal.
    """
    if not math.isfinite(value):
        return value
    said, decimals = math.degrees(value), len(repr(float(value)).partition(".")[2])
    half = round(said * 2) / 2
    slack = max(1e-5, math.degrees(0.55 * 10.0 ** -max(decimals, 3)))
    return math.radians(half if abs(said - half) < slack else round(said, 4))


def values(joints: list[Joint], said: tuple[float, ...]) -> dict[str, float]:
    """Return a joint vector of the named joints, rad and m."""
    return {
        joint.name: said[i % len(said)] / 10_000 if joint.kind == "prismatic" else math.radians(said[i % len(said)])
        for i, joint in enumerate(moving(joints))
    }


def exact_text(text: str) -> str:
    """Return a URDF whose rounded right angles are written to the last digit."""

    def exactly(found: re.Match[str]) -> str:
        return 'rpy="' + " ".join(repr(meant(float(word), True)) for word in found[1].split()) + '"'

    return re.sub(r'rpy="([^"$]*)"', exactly, text)


def clean(arm: Description) -> Description:
    """Return the description with computed numbers as the round ones they stand for."""
    rows = [
        DH(tidy(r.a, 1e-3), tidy(r.alpha, math.pi / 180), tidy(r.d, 1e-3), tidy(r.theta, math.pi / 180))
        for r in arm.rows
    ]
    limits = np.array(
        [
            [degrees(v) for v in pair] if kind == "R" else pair
            for pair, kind in zip(arm.limits, arm.joint_types, strict=True)
        ]
    )
    return dataclasses.replace(
        arm, rows=tuple(rows), limits=limits, base=_tidy_pose(arm.base), tool=_tidy_pose(arm.tool), origin=None
    )


def _tidy_pose(T: Array) -> Array:
    out = np.where(np.abs(T - np.round(T)) < 1e-12, np.round(T) + 0.0, T)
    out[:3, 3] = [tidy(v, 1e-3) for v in T[:3, 3]]
    return out


def axes_of(joints: list[Joint]) -> tuple[Array, Array]:
    """Return direction (n, 3) and moment (n, 3) of the joints' axes, all at zero."""
    T, directions, moments = np.eye(4), [], []
    for joint in joints:
        T = T @ joint.origin
        if joint.kind in ("revolute", "continuous", "prismatic"):
            u = T[:3, :3] @ joint.axis
            directions.append(u)
            moments.append(np.cross(T[:3, 3], u) if joint.kind != "prismatic" else np.zeros(3))
    return np.array(directions), np.array(moments)


def compared(ours: list[Joint], theirs: list[Joint]) -> tuple[float, Array, float]:
    """Return how far two sources' axes lie apart (m and rad alike), their senses, and how far their ends at zero."""
    (u, m), (v, k) = axes_of(ours), axes_of(theirs)
    if len(u) != len(v):
        return math.inf, np.ones(len(u)), math.inf
    sense = np.where(np.sum(u * v, axis=1) < 0, -1.0, 1.0)
    # both may stand at another height: a shift along z common to all axes
    best = math.inf
    shift = 0.0
    for lift in (0.0, *_lifts(u, m, sense[:, None] * v, sense[:, None] * k)):
        moved = sense[:, None] * (k + np.cross([0, 0, lift], v))
        gap = max(float(np.abs(u - sense[:, None] * v).max()), float(np.abs(m - moved).max()))
        if gap < best:
            best, shift = gap, lift
    a, b = product(ours, {}), product(theirs, {})
    return best, sense, float(np.linalg.norm(a[:3, 3] - b[:3, 3] - [0, 0, shift]))


def _lifts(u: Array, m: Array, v: Array, k: Array) -> list[float]:
    out = []
    for i in range(len(u)):
        c = np.cross([0, 0, 1.0], v[i])
        if c @ c > 0.5:
            out.append(float((m[i] - k[i]) @ c / (c @ c)))
    return out


def check_from(other: list[Joint], ours: list[Joint], sense: Array, source: str, tolerance: float) -> Check:
    """Return the check that a second source's own product gives: the position of the flange."""
    q = np.array(list(values(ours, OTHER).values()))
    T = np.full((4, 4), np.nan)
    T[3] = [0, 0, 0, 1]
    there = product(other, dict(zip([j.name for j in moving(other)], sense * q, strict=True)))
    lift = product(ours, {})[2, 3] - product(other, {})[2, 3]
    T[:3, 3] = np.round(there[:3, 3] + [0, 0, lift], 9)
    return Check(q, T, source, tolerance)


def wrist_of(joints: list[Joint]) -> Array | None:
    """Return where the last three axes meet, all joints at zero; None where they do not."""
    u, m = axes_of(joints)
    if len(u) < 6:
        return None
    A = np.vstack([_cross(w) for w in u[-3:]])
    p: Array = np.asarray(np.linalg.lstsq(-A, m[-3:].ravel(), rcond=None)[0], np.float64)
    return p if np.abs(-A @ p - m[-3:].ravel()).max() < 1e-6 else None


def _cross(w: Array) -> Array:
    x, y, z = w
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def reach_posture(joints: list[Joint]) -> tuple[Array, float] | None:
    """Return a joint vector with the wrist's centre farthest from axis 1, axis 6 vertical, and how far it is."""
    at = wrist_of(joints)
    if at is None:
        return None
    names = [joint.name for joint in moving(joints)]
    best: tuple[float, Array] | None = None
    tip: Array = np.asarray(np.linalg.inv(product(joints, {})) @ np.append(at, 1), np.float64)
    for first in np.radians(np.arange(-170, 180, 85)):
        for second in np.radians(np.arange(-170, 180, 85)):
            q = np.zeros(len(names))
            q[1], q[2] = first, second
            q, far = _climb(joints, names, q, tip)
            if best is None or far > best[0] + 1e-9:
                best = far, q
    assert best is not None
    far, q = best
    for angle4 in np.radians([0, 90, 180, 270]):
        for sign in (1, -1):
            q[3] = angle4
            for angle in np.radians(np.arange(-180, 180, 7)):
                q[4] = angle
                for _ in range(30):
                    q[4] -= _slope(joints, names, q, sign)
                z = product(joints, dict(zip(names, q, strict=True)))[:3, :3] @ _axis6(joints, names)
                if abs(z[2]) > 1 - 1e-14:
                    q = around(q)
                    return q, far
    return None


def _axis6(joints: list[Joint], names: list[str]) -> Array:
    u, _ = axes_of(joints)
    return product(joints, dict.fromkeys(names, 0.0))[:3, :3].T @ u[-1]


def _slope(joints: list[Joint], names: list[str], q: Array, sign: int) -> float:
    """Return a Newton step of joint 5 towards a vertical axis 6."""

    def up(value: float) -> Array:
        p = q.copy()
        p[4] = value
        return product(joints, dict(zip(names, p, strict=True)))[:3, :3] @ _axis6(joints, names)

    h = 1e-5
    z, after, before = up(q[4]), up(q[4] + h), up(q[4] - h)
    first, second = sign * (after - before)[2] / (2 * h), sign * (after - 2 * z + before)[2] / h**2
    return float(np.clip(-abs(1) * first / abs(second) if abs(second) > 1e-6 else 0.0, -0.3, 0.3))


def _climb(joints: list[Joint], names: list[str], q: Array, tip: Array) -> tuple[Array, float]:
    """Return the nearest posture (joints 2 and 3) with the wrist's centre farthest from axis 1, and how far."""
    u, m = axes_of(joints)
    foot = np.cross(u[0], m[0])

    def far(x: Array) -> float:
        p = (product(joints, dict(zip(names, x, strict=True))) @ tip)[:3] - foot
        return float(np.linalg.norm(p - (p @ u[0]) * u[0]))

    step, value = 0.4, far(q)
    while step > 1e-9:
        moved = False
        for i in (1, 2):
            for s in (step, -step):
                x = q.copy()
                x[i] += s
                if (there := far(x)) > value + 1e-15:
                    q, value, moved = x, there, True
        for s, t in ((step, step), (step, -step), (-step, step), (-step, -step)):
            x = q.copy()
            x[1], x[2] = x[1] + s, x[2] + t
            if (there := far(x)) > value + 1e-15:
                q, value, moved = x, there, True
        step = step if moved else step / 2
    return q, value


def _foot(joints: list[Joint]) -> Array:
    """Return the point of axis 2 nearest axis 1, all joints at zero."""
    u, m = axes_of(joints)
    p, w = np.cross(u[0], m[0]), np.cross(u[1], m[1])
    n = np.cross(u[0], u[1])
    return w if n @ n < 1e-9 else w + ((np.cross(p - w, u[0]) @ n) / (n @ n)) * u[1]


def upright(joints: list[Joint], *, sideways: bool = False) -> tuple[Array, float]:
    """Return the quarter turns with the highest flange (axis n level if so wished), and its height over axis 2."""
    names = [joint.name for joint in moving(joints)]
    best, last = (np.zeros(len(names)), -math.inf), _axis6(joints, names)
    for turns in itertools.product((0, 1, -1), repeat=len(names) - 2):
        q = np.array([0, *turns, 0]) * np.pi / 2
        height = float(product(joints, dict(zip(names, q, strict=True)))[2, 3])
        level = abs(float((product(joints, dict(zip(names, q, strict=True)))[:3, :3] @ last)[2])) < 1e-6
        if height > best[1] + 1e-9 and (level or not sideways):
            best = (q, height)
    return best[0], best[1] - float(_foot(joints)[2])


def main(argv: list[str] | None = None) -> int:
    """Write the file; 1 where no second source agrees."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("file")
    for word in ("name", "maker", "source"):
        parser.add_argument(f"--{word}", required=True)
    for word in ("base", "tip", "against", "against-base", "against-tip", "against-source", "notes", "into"):
        parser.add_argument(f"--{word}", default="")
    parser.add_argument("--reach", type=float, help="as the maker says it, mm")
    parser.add_argument("--payload", type=float, help="kg")
    parser.add_argument("--reach-source", default="")
    parser.add_argument("--reach-grain", type=float, default=1.0, help="how fine the maker's figure is, mm")
    parser.add_argument("--stretched", default="", help="source of a reach from axis 2 to the flange, all drawn out")
    parser.add_argument(
        "--zero", type=float, nargs=3, help="where the maker says the flange is, all joints at zero, mm"
    )
    parser.add_argument("--sideways", action="store_true", help="that reach ends at the wrist's centre")
    parser.add_argument("--zero-source", default="")
    parser.add_argument("--slack", type=float, default=0.0005, help="how far the sources may lie apart, m")
    args = parser.parse_args(argv)
    with tempfile.TemporaryDirectory() as folder:
        # angles typed with three digits are meant as well as those of more, which the reader sees by itself
        plain = Path(folder) / "plain.urdf"
        plain.write_text(exact_text(Path(args.file).read_text(encoding="utf-8")), encoding="utf-8")
        arm = pieper.load(plain, args.base or None, args.tip or None).description
    if arm.origin is None:
        raise SystemExit("not a URDF")
    ours = way(joints_of(args.file), arm.origin.base, arm.origin.tip)
    q = np.array(list(values(ours, POSED).values()))
    first = "joint origins and axes of the source, multiplied one by one, no DH table involved"
    checks = [
        Check(np.zeros(arm.n), _tidy_pose(product(ours, {})), first),
        Check(q, product(ours, values(ours, POSED)), first),
    ]
    reach = None if args.reach is None else args.reach / 1000
    if args.against:
        said = pieper.load(args.against, args.against_base or None, args.against_tip or None).description.origin
        assert said is not None
        theirs = way(joints_of(args.against), said.base, said.tip)
        gap, sense, ends = compared(ours, theirs)
        print(f"{args.name}: axes {gap:.2g} apart, ends {ends:.2g}")
        if gap < args.slack and ends < args.slack:
            tolerance = max(1e-9, float(f"{4 * max(gap, ends):.0e}"))
            checks.append(check_from(theirs, ours, sense, args.against_source, tolerance))
    if reach is not None and args.reach_source:
        found = reach_posture(ours)
        if found is not None:
            print(f"{args.name}: wrist's centre {1000 * found[1]:.2f} mm from axis 1, the maker says {1000 * reach:g}")
            slack = (0.6 * args.reach_grain + 0.5) / 1000
            # some makers count in the arm's plane, which passes axis 1 at a distance
            at = product(ours, dict(zip([j.name for j in moving(ours)], found[0], strict=True)))[0, 3]
            if min(abs(found[1] - reach), abs(abs(at) - reach)) < slack:
                checks.append(_reach_check(ours, found[0], reach, args.reach_source, slack))
    if reach is not None and args.stretched:
        q, rise = upright(ours, sideways=args.sideways)
        print(f"{args.name}: drawn out {1000 * rise:.2f} mm above axis 2, the maker says {1000 * reach:g}")
        slack = (0.6 * args.reach_grain + 0.5) / 1000
        if abs(rise - reach) < slack:
            T = np.full((4, 4), np.nan)
            T[3] = [0, 0, 0, 1]
            T[2, 3] = _foot(ours)[2] + reach
            checks.append(Check(q, T, args.stretched, slack))
    if args.zero:
        T = np.full((4, 4), np.nan)
        T[3] = [0, 0, 0, 1]
        T[:3, 3] = np.array(args.zero) / 1000
        off = float(np.abs(T[:3, 3] - product(ours, {})[:3, 3]).max())
        print(f"{args.name}: at zero {1000 * off:.2f} mm off what the maker says")
        if off < args.slack:
            checks.append(Check(np.zeros(arm.n), T, args.zero_source, args.slack))
    if len(checks) < 3:
        print(f"{args.name}: no second source agrees; nothing written")
        return 1
    notes = " ".join(filter(None, (args.notes, *arm.remarks)))
    done = dataclasses.replace(
        clean(arm),
        name=args.name,
        manufacturer=args.maker,
        source=args.source,
        notes=notes,
        remarks=(),
        checks=tuple(checks),
        postures={"zero": np.zeros(arm.n)},
        payload=args.payload,
        reach=reach,
        bodies=(),
        allowed=(),
        unmeasured=None,
    )
    head = f"# {args.maker} {args.name}, {pieper.words_by_number.plural(arm.n, 'joint')}.\n\n"
    into = Path(args.into or catalog.FOLDER)
    (into / f"{args.name}.toml").write_text(head + robottext.dumps(done), encoding="utf-8")
    return 0


def _reach_check(ours: list[Joint], q: Array, reach: float, source: str, slack: float) -> Check:
    there = product(ours, dict(zip([j.name for j in moving(ours)], q, strict=True)))[:3, 3]
    T = np.full((4, 4), np.nan)
    T[3] = [0, 0, 0, 1]
    # axis 1 is vertical and passes the base's origin in every file this is used for; joint 1 at zero points along x, y
    along = int(np.argmax(np.abs(there[:2])))
    T[along, 3] = math.copysign(reach, there[along])
    return Check(np.radians(np.round(np.degrees(q), 6)), T, source, slack)


if __name__ == "__main__":
    raise SystemExit(main())
