"""Exported solvers beside the native one, arm by arm and language by language: python -m benchmarks.measure.exports.

--language LANGUAGE ... (all that stand on this machine), NAME ... (the catalogue), --poses (100,000), --seconds (170):
pairs that are not kept yet are measured until the time is used, each kept at once in benchmarks/results/exports.json;
asked again it goes on. --again measures anew. Of ten poses five are as they are, five written down: rounded to 6, 8, 10
and 12 digits and to float32. `make pages` makes docs/exported_solvers.md of it.
"""

from __future__ import annotations

import argparse
import os
import runpy
import tempfile
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import pieper
from benchmarks.kept import RESULTS, commit, held, in_lines, read, write_text
from benchmarks.measure.exported import LANGUAGES, Asked, Found
from pieper.code.between import between, solved_by
from pieper.code.program import RECORDED
from pieper.kinematics.arrays import Array, Bits, Bools, Indices
from pieper.kinematics.pose import checked_pose
from pieper.solver.redundant.at_values import rows_at_choice
from pieper.solver.redundant.choice import choice
from pieper.solver.verbs import ik_many

#: Rows of two ways to one answer differ by no more than rounding at the exported arms (rad, m).
ALIKE = 1e-7
#: How poses are written down, of every ten those at odd places; None: as float32.
DIGITS = (6, 8, 10, 12, None)


class Native(NamedTuple):
    """What the library answers: rows (N, slots, n), which of them lie inside the limits, flags (N,)."""

    q: Array
    in_limits: Bools
    flag: Bits


def asked(arm: pieper.Arm, poses: int) -> Asked:
    """Return random joint vectors inside the limits and their poses, half of them rounded, and the native answer."""
    rng = np.random.default_rng(17)
    reach = np.where(arm.chain.prismatic, arm.chain.length, np.pi)[:, None] * [-1.0, 1.0]
    limits = np.where(np.isfinite(arm.limits), arm.limits, reach)
    q = rng.uniform(limits[:, 0], limits[:, 1], (poses, arm.n))
    own = between(arm.plan)
    for j in own.fixed:
        q[:, j] = own.columns[j]
    T = np.ascontiguousarray(arm.fk(q))
    for k, digits in enumerate(DIGITS):
        some = slice(1 + 2 * k, None, 2 * len(DIGITS))
        T[some] = np.float32(T[some]) if digits is None else np.round(T[some], digits)
    return Asked(q, T, own.held)


def native(arm: pieper.Arm, ask: Asked) -> Native:
    """Return what the library answers, with joints to spare held where the file holds them.

    Rows held in the numbers are asked for without the status of the batch: of poses that have none it would say whether
    there are any at other values, which takes a hundred times as long and no file says.
    """
    plan, locked = arm.plan, list(arm.plan.reduction.locked)
    value = ask.q[:, locked] if locked else None
    if value is None or ask.spare is not None:
        many = arm.ik_many(ask.T, threads=1, redundancy=value)
        return Native(many.q, many.in_limits, many.flag)
    poses, held = checked_pose(ask.T, batch=True), choice(plan, value, len(ask.T))
    rows = rows_at_choice(plan, poses, held, 1, lambda own, T, threads: ik_many(own, T, threads).found)
    return Native(rows.q, rows.inside, rows.flags)


def unclear(arm: pieper.Arm, ask: Asked, many: Native, found: Found, which: Indices) -> Bools:
    """Return at which poses (k,) the native solver or the file says that it is unsure.

    Each language writes the same list of operations down; where the file itself was not asked, the one of NumPy is.
    What is no list is the native solver itself.
    """
    marked = (many.flag[which] & 3) != 0
    if found.unclear is not None:
        return np.asarray(marked | found.unclear[which])
    if not len(which) or solved_by(arm.plan).family not in RECORDED:
        return marked
    values = () if ask.spare is None else (ask.q[which, ask.spare],)
    with tempfile.TemporaryDirectory() as place:
        solver = runpy.run_path(str(arm.code("python", Path(place) / "solver.py")))
    return np.asarray(marked | solver["ik_all"](ask.T[which], *values)[2])


def compared(arm: pieper.Arm, ask: Asked, many: Native, found: Found) -> dict[str, Any]:
    """Return at how many poses the rows inside the limits are not the native ones, and at how many of those it is said.

    As many rows, each of them a native one, and each native one among them.
    """
    wanted = many.in_limits.sum(1)
    wrong = found.counts != wanted
    first = np.concatenate([[0], np.cumsum(found.counts)[:-1]])
    met = ~many.in_limits
    for k in range(int(found.counts.max(initial=0))):
        some = np.flatnonzero((found.counts > k) & ~wrong)
        gap = np.abs(many.q[some] - found.rows[first[some] + k][:, None]).max(-1)
        same = many.in_limits[some] & (gap <= ALIKE)
        wrong[some] |= ~same.any(1)
        met[some] |= same
    wrong |= ~met.all(1)
    said = unclear(arm, ask, many, found, np.flatnonzero(wrong)).tolist()
    return {
        "poses": len(ask.q),
        "rows": int(wanted.sum()),
        "differ": said.count(False),
        "differ_unclear": said.count(True),
        "us": round(found.seconds / len(ask.q) * 1e6, 2),
    }


def measured(arm: pieper.Arm, language: str, ask: Asked, many: Native) -> dict[str, Any]:
    """Return an arm's solver in a language beside the native one."""
    with tempfile.TemporaryDirectory() as place:
        start = time.process_time()
        path = arm.code(language, Path(place) / LANGUAGES[language].file, "one")
        wrote = time.process_time() - start
        files = [path] if path.is_file() else list(path.iterdir())
        size = sum(file.stat().st_size for file in files)
        found = LANGUAGES[language].run(path, ask)
    return compared(arm, ask, many, found) | {"kB": round(size / 1e3, 1), "written_s": round(wrote, 3)}


def refused_early(arm: pieper.Arm, language: str) -> None:
    """Raise PlanError where the arm is not written in a language, before its poses are solved."""
    if language not in ("c++", "wasm"):
        with tempfile.TemporaryDirectory() as place:
            arm.code(language, Path(place) / LANGUAGES[language].file, "one")


def keep(name: str, language: str, found: dict[str, Any]) -> None:
    """Add what was found to what is kept, an arm a line; several may measure at once."""
    with held():
        arms = (read("exports") or {"arms": {}})["arms"]
        arms.setdefault(name, {})[language] = found
        text = f'{{"commit": "{commit()}", "arms": {in_lines(dict(sorted(arms.items())))}}}\n'
        write_text(text, RESULTS / "exports.json")


def main() -> None:
    """Measure what is not known until the time is used."""
    ask = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    ask.add_argument("names", nargs="*")
    ask.add_argument("--language", nargs="*", choices=list(LANGUAGES))
    ask.add_argument("--poses", type=int, default=100_000)
    ask.add_argument("--seconds", type=float, default=170.0)
    ask.add_argument("--again", action="store_true")
    said = ask.parse_args()
    known = (read("exports") or {"arms": {}})["arms"]
    used = lambda: sum(os.times()[:4])  # noqa: E731
    languages = [k for k in said.language or LANGUAGES if LANGUAGES[k].there()]
    for name in said.names or pieper.catalog():
        own = known.get(name, {})
        open_ends = [k for k in languages if said.again or k not in own]
        if not open_ends:
            continue
        if used() > said.seconds:
            break
        arm, poses, many = pieper.load(name), None, None
        for language in open_ends:
            try:
                if poses is None or many is None:
                    refused_early(arm, language)
                    poses = asked(arm, said.poses)
                    many = native(arm, poses)
                found = measured(arm, language, poses, many)
            except pieper.PlanError as refused:
                found = {"refused": str(refused)}
            print(name, language, found, flush=True)
            keep(name, language, found)
            if used() > said.seconds:
                break


if __name__ == "__main__":
    main()
