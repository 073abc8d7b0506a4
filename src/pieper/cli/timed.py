"""What commands say and write of a timed motion: its length, what binds, curves, tables, moving pictures."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np

import pieper
from pieper.cli.layout import Column
from pieper.cli.output import as_json, number, print_table, say, si_units
from pieper.cli.units import Units

#: Limits that bind longest, and no more, are listed.
MOST = 8


def tell(arm: pieper.Arm, motion: pieper.Motion) -> None:
    """Print how long a motion takes, which limits bind for how long, and what happens on the way."""
    tell_limits(arm, motion)
    say(f"The largest value over its limit is {motion.margin:z.6f}, on the whole curve.")
    for remark in motion.remarks:
        say(remark)


def tell_limits(arm: pieper.Arm, motion: pieper.Motion) -> None:
    """Print how long a motion takes, which limits bind for how long, and when what happens."""
    columns = [Column("what binds", True), Column("for, s")]
    print_table(f"{arm.name}: {motion.duration:z.3f} s", columns, _binding(motion))
    if motion.events:
        rows = [[number(t), kind, _said(value)] for t, kind, value in motion.events]
        print_table("what happens", [Column("at, s"), Column("what", True), Column("value", True)], rows)


def _said(value: object) -> str:
    if isinstance(value, tuple):
        return f"{value[0]} {'on' if value[1] else 'off'}"
    return f"{value:g}" if isinstance(value, float) else str(value)


def _binding(motion: pieper.Motion) -> list[list[str]]:
    total: dict[str, float] = {}
    for piece in motion.tight:
        words = f"{piece.limit} of {piece.joint}" if piece.joint else piece.limit
        total[words] = total.get(words, 0.0) + piece.end - piece.start
    rows = [[words, number(t)] for words, t in sorted(total.items(), key=lambda item: -item[1])[:MOST]]
    return [*rows, ["none", number(max(motion.duration - sum(total.values()), 0.0))]]


def write(
    arm: pieper.Arm, motion: pieper.Motion, units: Units, *, csv: str = "", figure: str = "", animate: str = ""
) -> list[str]:
    """Write what was asked for; return sentences that say where."""
    out: list[str] = []
    if csv:
        _write_csv(arm, motion, csv, units)
        out.append(f"joints over time: {csv}")
    if figure:
        pieper.plot.save_figure(pieper.plot.limits_figure(motion, title=arm.name), figure)
        out.append(f"figure: {figure}")
    if animate:
        motion.animate(animate, arm=arm, progress=drawing())
        out.append(f"moving picture: {animate}")
    return out


def drawing() -> Any:
    """Return what tells, on a terminal, how many pictures are drawn."""
    if not sys.stderr.isatty():
        return None

    def said(done: int, of: int) -> None:
        print(f"\rpicture {done} of {of}", end="\n" if done == of else "", file=sys.stderr, flush=True)

    return said


def _write_csv(arm: pieper.Arm, motion: pieper.Motion, file: str, units: Units) -> None:
    names = [f"{name}_{unit}" for name, unit in zip(arm.joint_names, units.names_of_joints(arm), strict=True)]
    head = ["t_s", *names, *(f"{n}_per_s" for n in names), *(f"{n}_per_s2" for n in names)]
    scale = units.of_joints(arm)
    rows = np.column_stack([motion.t, motion.q / scale, motion.dq / scale, motion.ddq / scale])
    with pieper.whole_file(file) as out:
        out.write((",".join(head) + "\n").encode())
        np.savetxt(out, rows, fmt="%.9f", delimiter=",")


def print_data(arm: pieper.Arm, motion: pieper.Motion, **more: Any) -> None:
    """Print a motion as JSON."""
    as_json(
        {
            "arm": arm.name,
            "joint_names": arm.joint_names,
            "units": si_units(arm),
            "duration_s": motion.duration,
            "margin": motion.margin,
            "t": motion.t,
            "q": motion.q,
            "dq": motion.dq,
            "ddq": motion.ddq,
            "tight": [{"start": p.start, "end": p.end, "limit": p.limit, "joint": p.joint} for p in motion.tight],
            "events": [{"t": t, "kind": kind, "value": value} for t, kind, value in motion.events],
            "remarks": motion.remarks,
            **more,
        }
    )
