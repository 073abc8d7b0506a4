"""Build the page without a server: a folder that opens from a file, a solver an arm; see docs/static_page.md.

python -m static_page.build OUT [NAME ...]
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import pieper

HERE = Path(__file__).parent


def identifier(name: str) -> str:
    """Return an arm's name as a word of JavaScript."""
    return "arm_" + "".join(letter if letter.isalnum() else "_" for letter in name)


def arm_data(arm: pieper.Arm) -> dict[str, Any]:
    """Return what the page says of an arm: joints, links, where it starts, its equations and how it is solved."""
    low, high = np.where(np.isfinite(arm.limits), arm.limits, [-np.pi, np.pi]).T
    # off the middle of the ranges, where many arms are singular
    home = np.clip((low + high) / 2 + 0.15 * (np.arange(arm.n) % 3 - 1), low, high)
    return {
        "name": arm.name,
        "joints": list(arm.joint_names),
        "slides": [bool(s) for s in arm.chain.prismatic],
        "limits": [[float(x) if np.isfinite(x) else None for x in row] for row in arm.limits],
        "links": arm.chain.links[:, :3].reshape(len(arm.chain.links), 12).tolist(),
        "home": [round(float(x), 3) for x in home],
        "equations": arm.symbolic.fk().text(),
        "plan": arm.plan.explain(),
        "solver": identifier(arm.name),
    }


def arm_script(arm: pieper.Arm) -> tuple[str, bool]:
    """Return an arm's script, its data and its solver where that is a list of operations; and whether it is."""
    data = arm_data(arm)
    solver = ""
    try:
        with tempfile.TemporaryDirectory() as folder:
            text = arm.code("javascript", Path(folder) / "solver.js", identifier(arm.name)).read_text()
        # a function of its own: arms must not see each other's names
        solver = f"(() => {{\nconst module = undefined;\n{text}\n}})();\n"
    except pieper.PlanError as refused:
        data["solver"], data["refused"] = None, str(refused)
    return f"{solver}window.PIEPER.arrived({json.dumps(data)});\n", bool(solver)


def build(out: Path, names: list[str]) -> int:
    """Write the folder; returns how many arms have a solver in it."""
    (out / "arms").mkdir(parents=True, exist_ok=True)
    solved = 0
    for name in names:
        text, own = arm_script(pieper.load(name))
        solved += own
        with pieper.whole_file(out / "arms" / f"{identifier(name)}.js") as file:
            file.write(text.encode())
    page = (HERE / "page.html").read_text()
    listed = json.dumps([[name, identifier(name)] for name in names])
    for file_name, text in (
        ("index.html", page),
        ("page.js", (HERE / "page.js").read_text().replace("/* NAMES */ []", listed)),
    ):
        with pieper.whole_file(out / file_name) as file:
            file.write(text.encode())
    return solved


if __name__ == "__main__":
    target, *wanted = sys.argv[1:] or ["out/site"]
    arms = wanted or list(pieper.catalog())
    print(f"{build(Path(target), arms)} of {len(arms)} arms are solved on the page: {Path(target) / 'index.html'}")
