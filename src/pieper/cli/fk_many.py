"""A file of joint vectors turned into poses block by block, written as CSV in constant memory."""

from __future__ import annotations

import sys

import numpy as np

import pieper
from pieper.cli.failure import note
from pieper.cli.joint_file import JointFile
from pieper.cli.kept_rows import fingerprint, rows_to
from pieper.cli.many import progress
from pieper.cli.number_table import refuse_same
from pieper.cli.output import plural
from pieper.cli.status import DONE
from pieper.cli.units import Units
from pieper.tolerances import LIMIT_SLACK

#: Decimals of positions and rotations in a CSV: finer than any unit's rounding noise.
DECIMALS = 12


def pose_file(arm: pieper.Arm, file: str, units: Units, csv: str) -> int:
    """Write the tool's pose of every joint vector of a file: position, rotation matrix, whether inside the limits.

    `pieper ik ARM @poses.csv` reads the table back. Stopped, the same command goes on there.
    """
    table = JointFile(file, units, arm=arm)
    refuse_same(file, csv)
    lower, upper = arm.limits[:, 0] - LIMIT_SLACK, arm.limits[:, 1] + LIMIT_SLACK
    names = [f"{axis}_{units.length}" for axis in "xyz"] + [f"r{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)]
    form = "%d," + "%r," * len(names) + "%d\n"
    question = {"command": "fk", "version of pieper": pieper.__version__, "arm": fingerprint(arm), "unit": units.said}
    with progress(table.size, "joint vectors") as read, rows_to(csv, "joint vector", question) as out:
        for q in table.blocks(read, out.place):
            if not out.done:
                out.put(",".join(["row", *names, "in_limits"]) + "\n")
            T = arm.fk(q)
            poses = np.hstack([T[:, :3, 3] / units.metres, T[:, :3, :3].reshape(-1, 9)])
            poses = np.round(poses, DECIMALS) + 0.0
            inside = np.all((q >= lower) & (q <= upper), axis=1)
            rows = zip(range(out.done + 1, out.done + len(q) + 1), poses.tolist(), inside.tolist(), strict=True)
            out.put("".join(form % (i, *row, within) for i, row, within in rows))
            out.keep(table.place, done=len(q), beyond=int(np.count_nonzero(~inside)))
    if table.unused:
        note(f"not used of {file}: {', '.join(table.unused)}.")
    said = f"{plural(out.done, 'joint vector')}, {out.counts['beyond']:,} of them outside the limits"
    print(f"{said}; written: {csv}" if csv else f"{said}.", file=sys.stderr)
    return DONE
