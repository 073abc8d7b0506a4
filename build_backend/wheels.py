"""Build the wheels that are handed out, check what they ask of a machine, and try them: `make wheels`.

Usage: python build_backend/wheels.py [--out dist] [--machines x86_64 aarch64] [--pythons 3.11 3.12]

Zig compiles them all, whatever compiler the machine has: its glibc is as old as one asks for, its C++ library goes
into the module, and it compiles for the other machine as readily. From Python 3.12 on one wheel (abi3) serves every
Python; 3.11 has one of its own. Each wheel is audited (`audit_wheel.py`) and, where the machine can run it, installed
into an empty environment and tried (`try_wheel.py`) with every Python it is for.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from audit_wheel import audit, retagged
from try_wheel import interpreters, tried
from zig_compiler import zig_tools

ROOT = Path(__file__).resolve().parents[1]
#: The oldest C library the wheels run on; manylinux2014's, older than any NumPy 2 wheel's.
GLIBC = (2, 17)
MACHINES = ("x86_64", "aarch64")
#: The first Python of which the stable ABI has all that nanobind needs.
STABLE = (3, 12)


def build(machine: str, python: Path, version: tuple[int, int], folder: Path) -> Path:
    """Build one wheel and return its place.

    Args:
        machine: The processor it is for.
        python: An interpreter of the version it is for, with pip, ziglang and what the build needs.
        version: That version.
        folder: Where the wheel goes.
    """
    tag = f"cp{version[0]}{version[1]}"
    place = ROOT / "build" / "wheels" / f"{machine}-{tag}"
    scripts = place / "tools"
    scripts.mkdir(parents=True, exist_ok=True)
    tools = zig_tools(scripts, str(python), f"{machine}-linux-gnu.{GLIBC[0]}.{GLIBC[1]}")
    settings = [f"-Cbuild-dir={place / 'cmake'}"]
    if version >= STABLE:
        settings.append(f"-Cwheel.py-api=cp{STABLE[0]}{STABLE[1]}")
    asked = [f"-DCMAKE_AR={tools['AR']}", f"-DCMAKE_RANLIB={tools['RANLIB']}"]
    if machine != os.uname().machine:
        asked += ["-DCMAKE_SYSTEM_NAME=Linux", f"-DCMAKE_SYSTEM_PROCESSOR={machine}"]
    environment = os.environ | tools | {"CMAKE_ARGS": " ".join(asked), "_PYTHON_HOST_PLATFORM": f"linux-{machine}"}
    for variable in ("ZIG_GLOBAL_CACHE_DIR", "ZIG_LOCAL_CACHE_DIR"):
        environment.setdefault(variable, str(ROOT / "build" / "wheels" / "zig"))
    with tempfile.TemporaryDirectory() as raw:
        command = [str(python), "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps"]
        command += ["--no-build-isolation", "--wheel-dir", raw, *settings, str(ROOT)]
        subprocess.run(command, check=True, env=environment)
        (made,) = Path(raw).glob("*.whl")
        return retagged(made, folder, machine, GLIBC)


def builder(python: Path, folder: Path) -> Path:
    """Make an environment of an interpreter with what a build needs, and return its own interpreter."""
    subprocess.run([str(python), "-m", "venv", str(folder)], check=True)
    inside = folder / "bin" / "python"
    needed = ["scikit-build-core>=0.11", "nanobind>=2.4", "numpy>=2.0", "ziglang>=0.13", "cmake>=3.18", "ninja"]
    subprocess.run([str(inside), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *needed], check=True)
    return inside


def main() -> int:
    """Build, audit and try; return how many wheels failed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "dist")
    parser.add_argument("--machines", nargs="+", choices=MACHINES, default=MACHINES)
    parser.add_argument("--pythons", nargs="+", default=["3.11", "3.12"], help="3.12 makes the wheel for all after it.")
    asked = parser.parse_args()
    asked.out = asked.out.resolve()  # it is installed from another folder
    asked.out.mkdir(parents=True, exist_ok=True)
    there = interpreters()
    made: list[Path] = []
    for word in asked.pythons:
        version = (int(word.split(".")[0]), int(word.split(".")[1]))
        if version not in there:
            print(f"no Python {word} on this machine: its wheels are left out")
            continue
        place = ROOT / "build" / "wheels" / f"builder-{word}"
        python = place / "bin" / "python"
        if not python.exists():
            shutil.rmtree(place, ignore_errors=True)
            python = builder(there[version], place)
        for machine in asked.machines:
            made.append(build(machine, python, version, asked.out))
            print(f"built {made[-1].name}", flush=True)
    failed = 0
    for wheel in made:
        complaints = audit(wheel, GLIBC)
        if wheel.name.endswith(f"{os.uname().machine}.whl"):
            complaints += tried(wheel, there)
        else:
            print(f"{wheel.name}: for another machine, audited and not run")
        for complaint in complaints:
            print(f"{wheel.name}: {complaint}")
        failed += bool(complaints)
    return failed


if __name__ == "__main__":
    sys.exit(main())
