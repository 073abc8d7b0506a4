"""Build the page without a server: a folder that opens from a file, a solver an arm; see docs/static_page.md.

python -m static_page.build OUT [NAME ...]
"""

from __future__ import annotations

import base64
import gzip
import json
import sys
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from pieper.document import identity
from pieper.document.html import MATH_FONT
from static_page.kernel import kernel, prepared

HERE = Path(__file__).parent


def identifier(name: str) -> str:
    """Return an arm's name as a word of JavaScript."""
    return "arm_" + "".join(letter if letter.isalnum() else "_" for letter in name)


def arm_data(arm: pieper.Arm) -> dict[str, Any]:
    """Return what the page says of an arm: joints, links, where it starts, its equations and how it is solved."""
    low, high = np.where(np.isfinite(arm.limits), arm.limits, [-np.pi, np.pi]).T
    # off the middle of the ranges, where many arms are singular
    home = np.clip((low + high) / 2 + 0.3 * (np.arange(arm.n) % 3 - 1.3), low, high)
    return {
        "name": arm.name,
        "joints": list(arm.joint_names),
        "kinds": [kind == "P" for kind in arm.description.joint_types],
        "slides": [kind == "P" for kind in arm.description.axis_types],
        "limits": [[float(x) if np.isfinite(x) else None for x in row] for row in arm.limits],
        "links": arm.chain.links[:, :3].reshape(len(arm.chain.links), 12).tolist(),
        "home": [round(float(x), 3) for x in home],
        "gears": None if arm.chain.coupling is None else arm.chain.coupling.tolist(),
        "forward": arm.symbolic.fk().mathml(),
        "inverse": inverse_of(arm),
        "plan": arm.plan.explain(),
    }


def inverse_of(arm: pieper.Arm) -> str:
    """Return the equations of the inverse as HTML; why there are none where it is not written as formulas."""
    try:
        return arm.symbolic.ik().mathml()
    except pieper.PlanError as refused:
        return f"<p>{escape(str(refused))}</p>"


def arm_script(arm: pieper.Arm) -> tuple[str, bool]:
    """Return an arm's script, its data and its prepared numbers where the page can solve it; and whether it can."""
    data = arm_data(arm)
    try:
        arm.description.not_linked("it is not solved on this page", "The library solves it: arm.ik.")
        data["solver"] = prepared(arm)
    except pieper.PlanError as refused:
        data["solver"], data["refused"] = None, str(refused)
    return f"window.PIEPER.arrived({json.dumps(data)});\n", data["solver"] is not None


def build(out: Path, names: list[str], code: bytes | None = None) -> int:
    """Write the folder; returns how many arms are solved on it.

    Args:
        out: The folder.
        names: Arms of the catalogue.
        code: The kernels as WebAssembly; compiled when left out.
    """
    (out / "arms").mkdir(parents=True, exist_ok=True)
    listed = json.dumps([[name, identifier(name)] for name in names])
    page = (HERE / "page.html").read_text()
    said = {"identity": identity.both_themes(), "icon": identity.icon_address()}
    for name, text in {**said, "wordmark": identity.identity()["wordmark"]}.items():
        page = page.replace("{{" + name + "}}", text)
    # packed before it is made letters: letters of what is not packed would be packed badly on the way, or not at all
    packed = gzip.compress(code or kernel(), mtime=0)
    begun = {"kernel": base64.b64encode(packed).decode(), "axes": identity.axes()}
    texts = {
        "index.html": page,
        "page.js": (HERE / "page.js").read_text().replace("/* NAMES */ []", listed),
        "solver.js": (HERE / "solver.js").read_text(),
        "kernel.js": f"window.PIEPER = {json.dumps(begun)};\n",
    }
    solved = 0
    for name in names:
        texts[f"arms/{identifier(name)}.js"], own = arm_script(pieper.load(name))
        solved += own
    files = {file_name: text.encode() for file_name, text in texts.items()} | {"math.woff2": MATH_FONT.read_bytes()}
    for file_name, data in files.items():
        with pieper.whole_file(out / file_name) as file:
            file.write(data)
    return solved


if __name__ == "__main__":
    target, *wanted = sys.argv[1:] or ["out/site"]
    arms = wanted or list(pieper.catalog())
    print(f"{build(Path(target), arms)} of {len(arms)} arms are solved on the page: {Path(target) / 'index.html'}")
