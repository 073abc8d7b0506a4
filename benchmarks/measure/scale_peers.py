"""Maps and exported solvers beside others' own code, in one run: python -m benchmarks.measure.scale_peers.

--toolbox PYTHON: an interpreter that has robotics-toolbox-python with its extra `ik`; its generated C of a UR5e beside
ours, on the same poses, both by gcc -O2. --rm4d PYTHON FOLDER: an interpreter with numpy, scipy, tqdm, matplotlib and
pybullet, and a checkout of RM4D; its own constructor fills its own grid of its own UR5e for so many --samples, beside
our filling of all of the grid's cells. Adds to benchmarks/results/scale.json; processor times.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import re
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from benchmarks.kept import RESULTS, held, read, write
from benchmarks.measure.scale import least, rm4d

DERIVE = """
import json, sys, time
import roboticstoolbox as rtb
arm = rtb.DHRobot([rtb.RevoluteDH(d=d, a=a, alpha=alpha) for d, a, alpha in json.loads(sys.argv[1])], name="one")
start = time.process_time()
from roboticstoolbox.robot.symbolic_ik_rr import make_solver
solver = make_solver(arm, max_time=900)
text = solver.generate("c")
open(sys.argv[2], "w").write(text)
print(json.dumps([time.process_time() - start, rtb.__version__]))
"""
SAMPLE = """
import json, sys, time
sys.path.insert(0, sys.argv[1])
import numpy as np
from rm4d import ReachabilityMap4D
from rm4d.construction import JointSpaceConstructor
from rm4d.robots import Simulator, UR5E
robot = UR5E(Simulator(with_gui=False))
rmap = ReachabilityMap4D(xy_limits=[-1.05, 1.05], z_limits=[0, 1.35], voxel_res=0.05)
index = rmap.get_indices_for_ee_pose
def marked(pose):
    try:
        return index(pose)
    except IndexError:  # the arm reaches a little beyond the grid
        return (0, 0, 0, 0)
rmap.get_indices_for_ee_pose = marked
def sample(count, checked):
    start = time.process_time()
    JointSpaceConstructor(rmap, robot, seed=0).sample(n_samples=count, prevent_collisions=checked)
    return time.process_time() - start
count = int(sys.argv[2])
said = [sample(count, False), sample(count // 4, True), int(rmap.map.sum()), int(rmap.map.size)]
print("\\n" + json.dumps(said), flush=True)
"""


def told(python: str, script: str, *said: str) -> Any:
    """Return the list that a script of another environment prints last; simulators say more when they end."""
    ran = subprocess.run([python, "-c", script, *said], capture_output=True, text=True, check=False)
    if ran.returncode:
        raise RuntimeError(ran.stderr)
    return json.loads([line for line in ran.stdout.splitlines() if line.startswith("[")][-1])


def _timed(source: str, loop: str, folder: Path, poses: np.ndarray[Any, Any], slots: int) -> tuple[float, int]:
    """Compile C and a loop over poses; microseconds a pose and rows."""
    # a library of the same name that is loaded already would be taken again
    unit, made = folder / f"unit_{slots}_{len(source)}.c", folder / f"unit_{slots}_{len(source)}.so"
    unit.write_text(source + loop)
    subprocess.run(["gcc", "-O2", "-w", "-shared", "-fPIC", "-o", made, unit, "-lm"], check=True)
    library = ctypes.CDLL(str(made))
    library.all_of.restype = ctypes.c_long
    room, count = np.zeros((slots, 6)), []
    at = lambda array: ctypes.c_void_p(array.ctypes.data)  # noqa: E731
    took = least(lambda: count.append(library.all_of(at(poses), ctypes.c_long(len(poses)), at(room))), 5)
    return took / len(poses) * 1e6, count[0]


def toolbox(python: str) -> dict[str, Any]:
    """The C of robotics-toolbox-python and ours on 20,000 poses of the same UR5e."""
    ours = pieper.load("universal-robots-ur5e")
    table = [[row.d, row.a, row.alpha] for row in ours.description.rows]
    arm = pieper.Arm.from_dh(
        [pieper.DH(a=a, alpha=alpha, d=d, theta=0.0) for d, a, alpha in table],
        convention="standard",
        joint_types="RRRRRR",
        limits=[(-np.pi, np.pi)] * 6,
        name="ur5e-bare",
    )
    T = np.ascontiguousarray(arm.fk(np.random.default_rng(0).uniform(-np.pi, np.pi, (20_000, 6))))
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        derived, version = told(python, DERIVE, json.dumps(table), str(folder / "theirs.c"))
        theirs = (folder / "theirs.c").read_text()
        found = re.search(r"IKINE_MAX_SOLUTIONS (\d+)", theirs)
        slots = int(found[1]) if found else 16
        loop = (
            "\nlong all_of(const double *T, long n, double *q) {\n  long i, rows = 0;\n  for (i = 0; i < n; ++i) {\n"
            "    int count = 0;\n    ikine(T + 16 * i, 1e-6, (double (*)[IKINE_DOF])q, &count);\n    rows += count;\n"
            "  }\n  return rows;\n}\n"
        )
        them, their_rows = _timed(theirs, loop, folder, T, slots)
        writes = least(lambda: arm.code("c", folder / "ours.c", "one"), 2)
        loop = (
            "\nlong all_of(const double *T, long n, double (*q)[6]) {\n  long i, rows = 0;\n  int unclear;\n"
            "  for (i = 0; i < n; ++i) rows += one_ik_all(T + 16 * i, q, &unclear);\n  return rows;\n}\n"
        )
        us, rows = _timed((folder / "ours.c").read_text(), loop, folder, T, 8)
    native = least(lambda: arm.ik_many(T, threads=1), 3) / len(T) * 1e6
    return {
        "version": version,
        "poses": len(T),
        "theirs": {"derived_s": derived, "us": them, "rows": their_rows},
        "ours": {"written_s": writes, "us": us, "rows": rows, "native_us": native},
    }


def sampled(python: str, folder: str, samples: int) -> dict[str, Any]:
    """RM4D's own filling of its grid, and ours of all of its cells."""
    free, checked, cells, size = told(python, SAMPLE, folder, str(samples))
    ours = rm4d()
    return {
        "samples": samples,
        "us_a_sample": free / samples * 1e6,
        "us_a_sample_without_collisions": checked / (samples // 4) * 1e6,
        "cells_met": cells,
        "cells": size,
        "ours": ours,
        "its_ten_million_s": free / samples * 1e7,
        "ratio": free / samples * 1e7 / ours["cpu_s"],
    }


def keep(name: str, found: dict[str, Any]) -> None:
    """Add what was measured beside one peer; what stands beside the others stays as it is now, not as it was before."""
    print(json.dumps({name: found}, indent=1))
    with held():
        state = read("scale") or {}
        state["peers"] = state.get("peers", {}) | {name: found}
        write(state, RESULTS / "scale.json", indent=1)


def main() -> None:
    """Measure what is asked and keep it."""
    ask = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    ask.add_argument("--toolbox")
    ask.add_argument("--rm4d", nargs=2)
    ask.add_argument("--samples", type=int, default=20_000)
    said = ask.parse_args()
    if said.toolbox:
        keep("toolbox", toolbox(said.toolbox))
    if said.rm4d:
        keep("rm4d", sampled(said.rm4d[0], said.rm4d[1], said.samples))


if __name__ == "__main__":
    main()
