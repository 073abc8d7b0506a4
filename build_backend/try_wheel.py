"""Install a wheel into an empty environment, with no compiler in reach, and ask an arm for its solutions.

Usage: python build_backend/try_wheel.py dist/*.whl
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

#: What a user does first; every number is checked by forward kinematics, the native module is the wheel's own.
FIRST_ANSWER = """
import sys
import numpy as np
import pieper
assert "site-packages" in pieper.__file__, pieper.__file__
arm = pieper.load("denso-vp6242")
T = arm.fk([0, 0.9, -2.6, 0, 1.7, 0])
sols = arm.ik(T)
assert len(sols.all_q) == 8 and np.abs(arm.fk(sols.all_q) - T).max() < 1e-12
for name in ("ur5e", "fanuc-crx-10ia", "franka-panda", "stanford-arm"):
    one = pieper.load(name)
    q = np.linspace(0.1, 0.5, one.n) * np.where([k == "P" for k in one.joint_types], 0.5, 1)
    many = one.ik_many(np.stack([one.fk(q)] * 3))
    assert many.valid.any(1).all(), name
print(f"pieper {pieper.__version__} on Python {sys.version.split()[0]}: {len(sols.all_q)} solutions")
"""


def interpreters() -> dict[tuple[int, int], Path]:
    """Return one interpreter of each Python from 3.11 on that is on the path, or where pyenv keeps them.

    What lies on the path may be a script that looks for the interpreter (pyenv's and others' are); it needs a shell
    and the path, which a wheel's empty environment has not. So each is asked what it runs, and that is returned.
    """
    found: dict[tuple[int, int], Path] = {}
    places = [Path(p) for p in os.environ.get("PATH", "").split(os.pathsep)]
    places += sorted(Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"), "versions").glob("*/bin"))
    for folder in places:
        for minor in range(11, 20):
            python = folder / f"python3.{minor}"
            if (3, minor) not in found and python.is_file() and (itself := _itself(python, minor)):
                found[3, minor] = itself
    return found


def _itself(python: Path, minor: int) -> Path | None:
    """Return the interpreter that a name stands for; None where it is another version, or cannot make environments."""
    ask = "import sys, venv, ensurepip; print(sys.version_info[:2], sys.prefix == sys.base_prefix, sys.executable)"
    environment = dict(os.environ)
    for _ in range(2):  # asked once more by its own place and without a path: then nothing else is needed to run it
        try:
            done = subprocess.run(
                [str(python), "-c", ask], capture_output=True, text=True, env=environment, check=False
            )
        except OSError:
            return None
        said = done.stdout.strip()
        if done.returncode or not said.startswith(f"(3, {minor}) True "):
            return None
        python, environment["PATH"] = Path(said.removeprefix(f"(3, {minor}) True ")), ""
    return python


def tried(wheel: Path, there: dict[tuple[int, int], Path]) -> list[str]:
    """Try a wheel on every Python it is for, and return what went wrong, a sentence each."""
    python, abi, _ = wheel.stem.split("-")[-3:]
    least = int(python[3:])
    mine = [v for v in there if v[1] >= least] if abi == "abi3" else [v for v in there if v[1] == least]
    complaints = []
    for version in sorted(mine):
        started = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            said = _try(wheel, there[version], Path(folder))
        if said.returncode:
            complaints.append(f"Python 3.{version[1]}: {said.stderr.strip()[-600:]}")
        else:
            print(f"{wheel.name}: {said.stdout.strip()}, {time.monotonic() - started:.0f} s with its environment")
    return complaints


def _try(wheel: Path, python: Path, folder: Path) -> subprocess.CompletedProcess[str]:
    # no compiler: nothing but the environment's own programs is on the path
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "CMAKE", "CXX", "CC"))}
    inside = folder / "env" / "bin"
    environment["PATH"] = str(inside)
    environment["CXX"] = environment["CC"] = str(shutil.which("false") or "false")
    for command in (
        [str(python), "-m", "venv", str(folder / "env")],
        [str(inside / "python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", f"{wheel}[cli]"],
        [str(inside / "python"), "-c", FIRST_ANSWER],
        [str(inside / "pieper"), "ik", "denso-vp6242", "350", "0", "400"],
    ):
        done = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=folder, check=False)
        if done.returncode:
            return done
        if command[1] == "-c":
            answer = done
    return answer


if __name__ == "__main__":
    there = interpreters()
    wrong = [f"{name}: {said}" for name in sys.argv[1:] for said in tried(Path(name).resolve(), there)]
    sys.exit("\n".join(wrong) or 0)  # an empty text would be a failure as well
