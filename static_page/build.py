"""Build the page without a server: a folder that opens from a file, a solver an arm; see docs/static_page.md.

python -m static_page.build OUT [NAME ...]: arms of the catalogue, all if none is named. --own FILE ... sets robot files
beside them (those that `arm.save` or `pieper calibrate` wrote, for two), first in the list; --add FILE ... puts robot
files into a folder that stands already.
"""

from __future__ import annotations

import argparse
import base64
import gzip
import json
import re
import sys
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

import pieper
from pieper.code.kernel_source import fingerprint
from pieper.document import identity
from pieper.document.html import MATH_FONT
from static_page.kernel import kernel, prepared

HERE = Path(__file__).parent
_LIST = re.compile(r"^const NAMES = (.*);$", re.MULTILINE)


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


def arm_script(arm: pieper.Arm, name: str) -> tuple[str, bool]:
    """Return an arm's script, its data and its prepared numbers where the page can solve it; and whether it can."""
    data = arm_data(arm) | {"name": name}
    try:
        arm.description.not_linked("it is not solved on this page", "The library solves it: arm.ik.")
        data["solver"] = prepared(arm)
    except pieper.PlanError as refused:
        data["solver"], data["refused"] = None, str(refused)
    return f"window.PIEPER.arrived({json.dumps(data)});\n", data["solver"] is not None


def named(own: list[str], taken: list[str]) -> dict[str, pieper.Arm]:
    """Return arms of robot files by names that no other arm on the page has: their own, or the file's."""
    out: dict[str, pieper.Arm] = {}
    words = {identifier(name) for name in taken}
    for file in own:
        if not Path(file).is_file():
            raise pieper.InputError(f"{file} is no file. Arms of the catalogue are named in front, without --own.")
        arm = pieper.load(file)
        number, name = 1, arm.name
        while identifier(name) in words:
            name = Path(file).stem + (f" {number}" if number > 1 else "")
            number += 1
        words.add(identifier(name))
        out[name] = arm
    return out


def arm_files(arms: dict[str, pieper.Arm]) -> tuple[dict[str, str], int]:
    """Return the scripts of arms by their files' names, and how many are solved on the page."""
    texts, solved = {}, 0
    for name, arm in arms.items():
        texts[f"arms/{identifier(name)}.js"], own = arm_script(arm, name)
        solved += own
    return texts, solved


def put(out: Path, texts: dict[str, str]) -> None:
    """Write files whole."""
    (out / "arms").mkdir(parents=True, exist_ok=True)
    for file_name, text in texts.items():
        with pieper.whole_file(out / file_name) as file:
            file.write(text.encode())


def build(out: Path, names: list[str], code: bytes | None = None, own: list[str] | None = None) -> int:
    """Write the folder; returns how many arms are solved on it.

    Args:
        out: The folder.
        names: Arms of the catalogue.
        code: The kernels as WebAssembly; compiled when left out.
        own: Robot files.
    """
    own_arms = named(own or [], names)
    # first what may be refused: preparing all arms takes minutes
    code = code or kernel()
    texts, solved = arm_files(own_arms | {name: pieper.load(name) for name in names})
    page = (HERE / "page.html").read_text()
    said = {"identity": identity.both_themes(), "icon": identity.icon_address()}
    for name, text in {**said, "wordmark": identity.identity()["wordmark"]}.items():
        page = page.replace("{{" + name + "}}", text)
    # packed before it is made letters: letters of what is not packed would be packed badly on the way, or not at all
    packed = gzip.compress(code, mtime=0)
    begun = {"made": fingerprint(), "kernel": base64.b64encode(packed).decode(), "axes": identity.axes()}
    texts |= {
        "index.html": page,
        "page.js": with_list(
            (HERE / "page.js").read_text(), [listed(name, True) for name in own_arms] + [listed(name) for name in names]
        ),
        "solver.js": (HERE / "solver.js").read_text(),
        "kernel.js": f"window.PIEPER = {json.dumps(begun)};\n",
    }
    put(out, texts)
    with pieper.whole_file(out / "math.woff2") as file:
        file.write(MATH_FONT.read_bytes())
    return solved


def listed(name: str, own: bool = False) -> list[Any]:
    """Return an arm as the page's list has it: name, script, whether it is a robot file's."""
    return [name, identifier(name), own]


def with_list(script: str, arms: list[list[Any]]) -> str:
    """Return the page's script with a list of arms in it."""
    return _LIST.sub(lambda _: f"const NAMES = {json.dumps(arms)};", script, count=1)


def add(out: Path, own: list[str]) -> int:
    """Put robot files into a folder that stands already; returns how many of them are solved on it.

    Raises:
        InputError: It is no such folder, or its kernels are of another version than the numbers made here.
    """
    try:
        script, kernels = (out / "page.js").read_text(), (out / "kernel.js").read_text()
    except OSError:
        raise pieper.InputError(f"{out} is no folder of the page; build it first, without --add.") from None
    known = _LIST.search(script)
    if known is None or f'"made": "{fingerprint()}"' not in kernels:
        raise pieper.InputError(f"The kernels in {out} are of another version of pieper; build it anew, with --own.")
    arms = json.loads(known[1])
    stand = [name for name, _, theirs in arms if not theirs]
    mine = named(own, stand)
    texts, solved = arm_files(mine)
    kept = [arm for arm in arms if arm[2] and arm[0] not in mine]
    put(
        out,
        texts
        | {"page.js": with_list(script, [listed(name, True) for name in mine] + kept + [a for a in arms if not a[2]])},
    )
    return solved


def main() -> None:
    """Write the folder, or put robot files into one."""
    ask = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    ask.add_argument("out", nargs="?", default="out/site", type=Path)
    ask.add_argument("names", nargs="*", metavar="NAME")
    ask.add_argument("--own", nargs="+", default=[], metavar="FILE")
    ask.add_argument("--add", nargs="+", default=[], metavar="FILE")
    said = ask.parse_args()
    names = said.names or list(pieper.catalog())
    try:
        solved = add(said.out, said.add) if said.add else build(said.out, names, own=said.own)
    except pieper.PieperError as refused:
        sys.exit(str(refused))
    count = len(said.add) if said.add else len(names) + len(said.own)
    print(f"{solved} of {count} arms are solved on the page: {said.out / 'index.html'}")


if __name__ == "__main__":
    main()
