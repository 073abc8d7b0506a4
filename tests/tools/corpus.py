"""Run pieper's readers over public robot files: each loads, asks or refuses with a cure, and agrees with a product.

    python -m tests.tools.corpus ROOT [--list tests/tools/corpus.tsv] [--report out.tsv]

ROOT has one folder a repository, named owner+name, with its files as they are at the commit of the list. A loaded URDF
is multiplied joint by joint (`own_tree`) at random joint vectors, an MJCF by MuJoCo; nothing of pieper does that.
"""

from __future__ import annotations

import argparse
import re
import signal
import tempfile
import time
import warnings
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import pieper
from pieper.description import urdf, xacro
from pieper.description.dh import Description
from pieper.errors import InputError
from tests.tools.own_tree import Array, between, joints_of

LIST = Path(__file__).with_name("corpus.tsv")
#: Names that a finger's joint has.
FINGER = re.compile(r"finger|jaw|knuckle|thumb|claw", re.IGNORECASE)
#: Seconds after which a file counts as hung.
PATIENCE = 30
#: Joint vectors a file.
DRAWN = 5


@dataclass(frozen=True)
class Outcome:
    """What became of one file."""

    word: str
    detail: str = ""
    worst: float = 0.0


def judged(path: Path) -> Outcome:
    """Return what pieper makes of a file: "loads", "asks", "refuses", or what must not be."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            arm = pieper.load(path)
    except InputError as error:
        said = str(error)
        if getattr(error, "choices", None) or "tip=" in said or "base=" in said or "missing_limits=" in said:
            return Outcome("asks", said)
        return Outcome("refuses", said)
    except TimeoutError:
        return Outcome("HANGS")
    except Exception as error:
        return Outcome("CRASHES", f"{type(error).__name__}: {error}")
    last = arm.description.joint_names[-1]
    if FINGER.search(last):
        return Outcome("FINGER", last)
    try:
        worst = _worst(path, arm)
    except (ValueError, LookupError) as error:  # a branch of the file beside the arm cannot be read, say
        return Outcome("loads, not compared", f"{type(error).__name__}: {error}")
    return Outcome("loads" if worst < 1e-9 else "DIFFERS", f"{arm.n} joints", worst)


def _worst(path: Path, arm: pieper.Arm) -> float:
    said = arm.description
    lower = np.where(np.isfinite(said.limits[:, 0]), said.limits[:, 0], -np.pi)
    upper = np.where(np.isfinite(said.limits[:, 1]), said.limits[:, 1], np.pi)
    drawn = lower + np.random.default_rng(0).uniform(0, 1, (DRAWN, said.n)) * (upper - lower)
    if said.origin is not None and said.origin.kind == "MJCF":
        from pieper.verify import with_mujoco

        model = with_mujoco.build(said)
        return max(float(np.abs(model.fk(q) - arm.fk(q)).max()) for q in drawn)
    if b"xmlns:xacro" in path.read_bytes():
        with tempfile.TemporaryDirectory() as folder:
            plain = Path(folder) / "expanded.urdf"
            plain.write_text(xacro.expanded(path, {}), encoding="utf-8")
            return _product_gap(plain, said, drawn)
    return _product_gap(path, said, drawn)


def _product_gap(path: Path, said: Description, drawn: Array) -> float:
    """Return the worst gap to the file's own product, every digit as it stands; relative beyond a metre."""
    origin = said.origin
    if origin is None:
        return 0.0
    arm = pieper.Arm(urdf.read(path, base=origin.base, tip=origin.tip, exact_angles=False))
    joints, worst = joints_of(path, exact=False), 0.0
    for q in drawn:
        T = between(joints, origin.base, origin.tip, dict(zip(said.joint_names, q, strict=True)))
        worst = max(worst, float(np.abs(arm.fk(q) - T).max()) / max(1.0, float(np.abs(T[:3, 3]).max())))
    return worst


def main(argv: list[str] | None = None) -> int:
    """Run the corpus; 1 where a file does what it must not."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("root", type=Path)
    parser.add_argument("--list", type=Path, default=LIST)
    parser.add_argument("--report", type=Path)
    parser.add_argument("--seconds", type=float, default=0.0, help="stop after so much processor time")
    args = parser.parse_args(argv)

    def hung(*_: object) -> None:
        raise TimeoutError

    signal.signal(signal.SIGALRM, hung)
    counts: Counter[str] = Counter()
    lines, worst, start = [], 0.0, time.process_time()
    for row in args.list.read_text(encoding="utf-8").splitlines()[1:]:
        if args.seconds and time.process_time() - start > args.seconds:
            counts["not run"] += 1
            continue
        repo, _, path = row.split("\t")
        file = args.root / repo.replace("/", "+") / path
        if not file.exists():
            counts["not there"] += 1
            continue
        signal.alarm(PATIENCE)
        try:
            outcome = judged(file)
        except TimeoutError:
            outcome = Outcome("HANGS")
        signal.alarm(0)
        counts[outcome.word] += 1
        worst = max(worst, outcome.worst if outcome.word == "loads" else 0.0)
        lines.append(f"{outcome.word}\t{repo}\t{path}\t{outcome.worst:.2g}\t{' '.join(outcome.detail.split())}")
    if args.report:
        args.report.write_text("\n".join(lines) + "\n", encoding="utf-8")
    for line in lines:
        if line.split("\t")[0].isupper():
            print(line[:300])
    print(dict(counts), f"worst difference of what loads {worst:.2g}, {time.process_time() - start:.0f} s")
    return int(any(word.isupper() for word in counts))


if __name__ == "__main__":
    raise SystemExit(main())
