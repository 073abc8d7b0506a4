"""Measure this package beside its peers in one run and write a JSON file and a table of ratios.

Usage: python -m benchmarks.measure.speed [--poses 100000] [--rounds 3] [--recall 1000000] [--no-peers]

Peers are installed into environments of their own under .bench/ (an optional extra: nothing else needs them). Every
contestant runs in its own process; rounds are interleaved so that the machine's moods fall on all alike, and the best
of the rounds counts. Absolute times mean little on a shared machine; the ratios are the result.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import tempfile
import time
import venv
from pathlib import Path

import numpy as np

from benchmarks.kept import RESULTS, ROOT, commit, write_text
from benchmarks.measure.contestants import PACKAGES, SETTINGS
from oracle.arms.tables import GENERAL_ARMS, TABLES, poses
from oracle.joints import turns_apart

ENVIRONMENT = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def python_of(peer: str) -> str | None:
    """Return the interpreter of a peer's environment, made on first use; None if it cannot be installed."""
    home = ROOT / ".bench" / peer
    interpreter = home / "bin" / "python"
    if not interpreter.exists():
        venv.create(home, with_pip=True)
        made = subprocess.run(
            [interpreter, "-m", "pip", "-q", "install", "numpy", PACKAGES[peer]], capture_output=True, text=True
        )
        if made.returncode:
            print(f"{peer} could not be installed: {made.stderr.strip()[-200:]}")
            return None
    return str(interpreter)


def measure(interpreter: str, contestant: str, arm: str, count: int) -> dict:
    """Run one worker and return what it printed."""
    told = ENVIRONMENT | SETTINGS.get(contestant, {})
    q, T = poses(arm, count)
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder) / "case.npz"
        np.savez(case, arm=arm, table=np.array(TABLES[arm]), general=arm in GENERAL_ARMS, q=q, T=T)
        command = [interpreter, "-m", "benchmarks.measure.worker", contestant, str(case)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, env=told, timeout=1800)
    if done.returncode:
        return {"contestant": contestant, "arm": arm, "failed": done.stderr.strip()[-300:]}
    return json.loads(done.stdout.strip().splitlines()[-1])


def best(a: dict | None, b: dict) -> dict:
    """Merge two rounds: the smaller time and the larger rate of each."""
    if a is None:
        return b
    out = dict(b)
    for key, value in a.items():
        if key.endswith("_per_s"):
            out[key] = max(value, b.get(key, value))
        elif "_us" in key or "_ns" in key:
            out[key] = min(value, b.get(key, value))
    return out


def recall(arm: str, count: int, chunk: int = 50_000) -> dict:
    """Count generating joint vectors that are not among the solutions of their poses, and the worst residual."""
    import pieper

    rows = [pieper.DH(a=a, alpha=alpha, d=d, theta=0) for d, a, alpha in TABLES[arm]]
    robot = pieper.Arm.from_dh(rows, convention="standard")
    missed = odd = uncertain = 0
    worst = np.zeros(2)
    spent = 0.0
    for start in range(0, count, chunk):
        q, T = poses(arm, min(chunk, count - start), seed=1000 + start)
        t = time.perf_counter()
        found = robot.ik_many(T, threads=1)
        spent += time.perf_counter() - t
        gap = turns_apart(found.q, q[:, None]).max(-1)
        missed += int(np.sum(~((gap < 1e-6) & found.valid).any(1)))
        odd += int(np.sum(found.count % 2))
        uncertain += int(np.sum((found.flag & 2) > 0))
        if start == 0:
            error = robot.plan.residual(found.q[found.valid], np.repeat(T, found.count, axis=0))
            worst = error.max(0)
    return {
        "arm": arm,
        "family": robot.plan.family,
        "poses": count,
        "missed": missed,
        "odd": odd,
        "uncertain": uncertain,
        "worst_m": float(worst[0]),
        "worst_rad": float(worst[1]),
        "us_a_pose": 1e6 * spent / count,
    }


def cpu() -> str:
    """Return the processor's name."""
    try:
        text = Path("/proc/cpuinfo").read_text()
        return next(line.split(":", 1)[1].strip() for line in text.splitlines() if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown"


def start_up() -> dict:
    """Measure imports, a whole command-line process, and the size on disk."""

    def process(*command: str) -> float:
        times = []
        for _ in range(7):
            t = time.perf_counter()
            subprocess.run(command, check=True, capture_output=True)
            times.append(time.perf_counter() - t)
        return min(times)

    import pieper

    bare = process(sys.executable, "-c", "import numpy")
    ours = process(sys.executable, "-c", "import numpy, pieper")
    command = [sys.executable, "-m", "pieper", "ik", "denso-vp6242", "350", "0", "400"]
    folder = Path(pieper.__file__).parent
    # a working tree holds the page's sources and tools too, which the wheel leaves out
    skipped = {"__pycache__", "node_modules", "src"}
    files = [f for f in folder.rglob("*") if f.is_file() and not skipped & set(f.relative_to(folder).parts)]
    size = sum(f.stat().st_size for f in files)
    out = {"import_beyond_numpy_ms": 1e3 * (ours - bare), "installed_mb": size / 1e6}
    try:
        out["cli_ik_s"] = process(*command)
    except subprocess.CalledProcessError as error:
        out["cli_ik_failed"] = error.stderr.decode()[-200:]
    return out


def main() -> None:
    """Measure everything asked for and write benchmarks/results/speed.json."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--poses", type=int, default=100_000)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--recall", type=int, default=100_000, help="poses an arm; 0 keeps the rows of the last run")
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--arms", nargs="*", default=list(TABLES))
    parser.add_argument("--out", type=Path, default=RESULTS / "speed.json")
    args = parser.parse_args()
    if not args.recall and not args.out.exists():
        parser.error(f"--recall 0 keeps the rows of the last run, and there is no {args.out}; give a number of poses")
    from pieper import _kernel

    interpreters = {"pieper": sys.executable}
    if "baseline" in _kernel.isa_available.split() and _kernel.isa != "baseline":
        interpreters["pieper-baseline"] = sys.executable
    if not args.no_peers:
        interpreters |= {peer: python for peer in PACKAGES if (python := python_of(peer))}
    rows: dict[tuple[str, str], dict] = {}
    for turn in range(args.rounds):
        for arm in args.arms:
            for name, interpreter in interpreters.items():
                count = args.poses if arm not in GENERAL_ARMS else max(2000, args.poses // 20)
                rows[arm, name] = best(rows.get((arm, name)), measure(interpreter, name, arm, count))
                print(f"round {turn + 1}: {json.dumps(rows[arm, name])}", flush=True)
    recalled, recalled_at = [], commit()
    if not args.recall:
        last = json.loads(args.out.read_text())
        recalled, recalled_at = last["recall"], last.get("recalled_at", last["commit"])
    for arm in args.arms if args.recall else []:
        recalled.append(recall(arm, args.recall))
        print(json.dumps(recalled[-1]), flush=True)
    result = {
        "commit": commit(),
        "cpu": cpu(),
        "instruction_set": getattr(_kernel, "isa", ""),
        "python": platform.python_version(),
        "numpy": np.__version__,
        "shared": os.getloadavg()[0] > (os.cpu_count() or 1),
        "measured": list(rows.values()),
        "recall": recalled,
        "recalled_at": recalled_at,
        "start_up": start_up(),
    }
    write_text(json.dumps(result, indent=1) + "\n", args.out)
    print(f"written: {args.out.name}")


if __name__ == "__main__":
    main()
