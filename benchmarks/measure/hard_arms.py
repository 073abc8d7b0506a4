"""Judge arms that are nearly special, tiny, huge, far from their base or tool, or of mixed units, decade by decade.

Usage: python -m benchmarks.measure.hard_arms [--poses 300] [--searched 10] [--out FILE]

Every pose's joint vector must be found again, and some poses are searched from 1,500 random starts as well.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.kept import RESULTS, write
from benchmarks.measure.random_arms import joint_vectors, judged, poses, slopes, smallest
from oracle import build, compare, machine, whole_set
from oracle.arms.known import free
from oracle.arms.numbered import random_arm
from pieper import Arm

NAMES = (
    "denso-vp6242",
    "universal-robots-ur5e",
    "motoman-ea1400n",
    "fanuc-crx-10ia",
    "stanford-arm",
    "kinova-jaco-j2n6",
)
SMALL = [10.0**-k for k in range(3, 13)]
#: About the reach of these arms, m.
LENGTH = 1.0


def changed(name: str, *, joint=None, scale=1.0, base=None, tool=None, **more) -> Arm:
    """Return an arm of the catalogue without limits, with values added to one row, scaled, its base or tool moved."""
    d = free(name).description
    rows = [replace(r, a=r.a * scale, d=r.d * scale) for r in d.rows]
    if joint is not None:
        rows[joint] = replace(rows[joint], **{key: getattr(rows[joint], key) + value for key, value in more.items()})
    types = "".join(d.joint_types)
    place: dict[str, Any] = {"base": d.base if base is None else base, "tool": d.tool if tool is None else tool}
    offset = np.where(np.array(list(types)) == "P", np.asarray(d.offset) * scale, d.offset)
    return Arm.from_dh(rows, convention=d.convention, joint_types=types, sign=d.sign, offset=offset, name=name, **place)


def moved(distance: float) -> np.ndarray:
    """Return a pose turned at random and `distance` away."""
    rng = np.random.default_rng(5)
    R = np.linalg.qr(rng.standard_normal((3, 3)))[0]
    T = np.eye(4)
    T[:3, :3] = R * np.linalg.det(R)
    away = rng.standard_normal(3)
    T[:3, 3] = distance * away / np.linalg.norm(away)
    return T


def cases():
    """Yield (what, how much, arm)."""
    for size in SMALL:
        for name in NAMES:
            yield "axes 5 and 6 miss by a further", size, changed(name, joint=4, a=size)
            yield "twist of joint 2 off by", size, changed(name, joint=1, alpha=size)
            yield "twist of joint 5 off by", size, changed(name, joint=4, alpha=size)
            yield "every length and twist off by", size, noisy(free(name), size)
    for scale in (1e-6, 1e-3, 1e3, 1e6):
        for name in NAMES:
            yield "every length times", scale, changed(name, scale=scale)
    for times in (1e1, 1e2, 1e3):
        for name in NAMES:
            yield "tool, in reaches", times, changed(name, tool=moved(times * LENGTH))
    for times in (1e2, 1e4, 1e6):
        for name in NAMES:
            yield "base, in reaches", times, changed(name, base=moved(times * LENGTH))
    for scale in (1e-3, 1e3):
        for name in NAMES:
            d = free(name).description.rows
            longest = int(np.argmax([abs(r.a) + abs(r.d) for r in d]))
            row = d[longest]
            more = {"a": row.a * (scale - 1), "d": row.d * (scale - 1)}
            yield "longest link's lengths times", scale, changed(name, joint=longest, **more)
    for arm in special(20):
        for size in SMALL:
            yield "random special arms, every length and twist off by", size, noisy(arm, size)


def noisy(arm: Arm, size: float) -> Arm:
    """Return an arm with errors in every length and twist, without its limits."""
    d = arm.description
    errors = size * np.random.default_rng(11).uniform(-1, 1, (arm.n, 3))
    rows = [replace(r, a=r.a + e[0], d=r.d + e[1], alpha=r.alpha + e[2]) for r, e in zip(d.rows, errors, strict=True)]
    place: dict[str, Any] = {"base": d.base, "tool": d.tool, "sign": d.sign, "offset": d.offset}
    return Arm.from_dh(rows, convention=d.convention, joint_types="".join(d.joint_types), name=arm.name, **place)


def special(count: int):
    """Yield random arms with special geometry, at most two slides and clear poses."""
    number = 0
    while count:
        arm, kind = random_arm(number)
        number += 1
        if kind in ("general", "scales") or arm.joint_types.count("P") > 2:
            continue
        m = machine(arm)
        if np.median(smallest(slopes(m, joint_vectors(arm, 0, 9, m.unit)))) > 1e-3:
            count -= 1
            yield arm


def searched(arm: Arm, count: int, library, out: dict) -> None:
    """Compare the whole sets of some poses."""
    m = machine(arm)
    q = joint_vectors(arm, 1, count, m.unit)
    T = poses(m, q)
    many = arm.ik_many(T, threads=1)
    for i in range(count):
        found = whole_set(m, T[i], library=library, rng=np.random.default_rng(i))
        verdict = compare(m, T[i], many.q[i][many.valid[i]], found)
        out["missing"] += len(verdict.missing)
        out["unseen"] += len(verdict.unseen)


def main() -> None:
    """Judge every case and write the file."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--poses", type=int, default=300)
    parser.add_argument("--searched", type=int, default=10)
    parser.add_argument("--out", type=Path, default=RESULTS / "hard_arms.json")
    args = parser.parse_args()
    state = (
        json.loads(args.out.read_text())
        if args.out.exists()
        else {"poses": args.poses, "searched": args.searched, "rows": {}}
    )
    keys = ("poses", "missed", "found_within_rounding", "odd", "uncertain", "singular", "wrong", "twice")
    with tempfile.TemporaryDirectory() as folder:
        library = build(folder)
        for what, size, arm in cases():
            row = state["rows"].setdefault(
                f"{what} {size:g}",
                dict.fromkeys((*keys, "missing", "unseen", "failed"), 0) | {"worst": 0.0, "arms": {}},
            )
            if arm.name in row["arms"]:
                continue
            note = {}
            try:
                result = judged(arm, 0, args.poses)
                if "refused" in result:
                    raise ValueError(result["refused"])
                for key in keys:
                    row[key] += result[key]
                row["worst"] = max(row["worst"], result.get("worst", 0.0))
                note = {"family": result["family"]} | {
                    k: result[k] for k in ("missed", "uncertain", "odd", "lost") if result[k]
                }
                before = row["missing"]
                searched(arm, args.searched, library, row)
                if row["missing"] > before:
                    note["missing"] = row["missing"] - before
            except Exception as error:  # whatever comes out is the finding
                row["failed"] += 1
                note["failed"] = f"{type(error).__name__}: {error}"
            row["arms"][arm.name] = note
            if len(note) > 1 or "failed" in note:
                print(what, size, arm.name, json.dumps(note)[:500], flush=True)
            write(state, args.out)
    print("done")


if __name__ == "__main__":
    main()
