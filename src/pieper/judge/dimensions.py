"""Is a formula a length, an area, or neither? All lengths of the arm are doubled and trebled, and its value is seen."""

from __future__ import annotations

import math

import numpy as np

from pieper.algebra.expression import Expr, Num
from pieper.judge.evidence import Evidence
from pieper.judge.keys import UNITS
from pieper.judge.model import POSE_NAMES
from pieper.judge.samples import Samples, pose_symbols
from pieper.tolerances import JUDGED_HOLDS

TRIED = 24  # joint vectors
SCALES = (2.0, 3.0)  # of the whole arm; a sum of a length and an area cannot look like a power at both
SMALL = 3  # whole numbers up to this one are factors and powers, and no lengths in another unit
POWERS = {1: "a length", 2: "an area", 3: "a volume"}


def power_of_length(ev: Evidence, node: Expr) -> int | None:
    """The power of the arm's size with which a formula goes: 1 of a length, 0 of a ratio or an angle of its lengths.

    None says that there is no telling: the formula holds plain numbers, which may be lengths themselves.
    """
    samples = ev.draw(TRIED, seed=31_415, vary={})
    root = node.substitute(ev.definitions)
    if not root.symbols() or any(name.endswith("?") for name in root.symbols()):
        return None

    def sizes(scale: float) -> np.ndarray:
        with np.errstate(all="ignore"):
            return np.broadcast_to(np.asarray(root.evaluate(_scaled(ev, samples, scale).env), float), (len(samples.q),))

    first = sizes(1.0)
    known = np.isfinite(first) & (np.abs(first) > JUDGED_HOLDS * np.abs(first[np.isfinite(first)]).max(initial=0.0))
    if not known.any():
        return None
    with np.errstate(all="ignore"):
        powers = [np.log(np.abs(sizes(scale)[known] / first[known])) / math.log(scale) for scale in SCALES]
    power = round(float(np.nan_to_num(np.median(powers))))
    if not np.all(np.abs(np.array(powers) - power) < JUDGED_HOLDS):
        return None
    numbers = [float(x.value) for x in root.walk() if isinstance(x, Num) and not x.args]
    other = any(abs(x) > SMALL or x % 1 for x in numbers)
    return None if other and power != 1 else power


def in_unit(ev: Evidence, node: Expr, unit: str) -> tuple[float, str]:
    """What the value of a formula is multiplied by to be in a unit, and why it has no value in that unit.

    A formula that names lengths of the arm is in the arm's unit; one of plain numbers is in the unit that is printed.
    """
    power = power_of_length(ev, node) if unit else None
    if unit in UNITS:
        if power not in (1, None):
            return 1.0, f"is {POWERS.get(power, 'a ratio or an angle' if not power else 'no length')}, not a length"
        named = power == 1 or _names_lengths(ev, node)
        return (UNITS[ev.model.unit] / UNITS[unit] if named else 1.0), ""
    if power:
        kind = "a ratio" if unit == "%" else "an angle"
        return 1.0, f"is {POWERS.get(power, 'a power of a length')}, not {kind}"
    if unit == "%":
        by_hand = any(isinstance(x, Num) and not x.args and float(x.value) == 100 for x in node.walk())
        return (1.0 if by_hand else 100.0), ""
    return (180 / np.pi if unit == "deg" else 1.0), ""


def _names_lengths(ev: Evidence, node: Expr) -> bool:
    places = {name for name, _, j in POSE_NAMES if j == len("xyz")}
    return bool(node.substitute(ev.definitions).symbols() & {*ev.model.values, *places, *ev.letters, *_slides(ev)})


def _slides(ev: Evidence) -> set[str]:
    return {f"theta{j}" for j in range(1, ev.model.n + 1) if ev.model.sliding(j)} | set(ev.model.aliases)


def _scaled(ev: Evidence, samples: Samples, scale: float) -> Samples:
    """The samples of an arm that is larger as a whole."""
    frames = {name: value.copy() for name, value in samples.frames.items() if name not in ev.matrices}
    for name, value in frames.items():
        if name == "J":
            turning = [j for j in range(ev.model.n) if not ev.model.sliding(j + 1)]
            value[:, :3, turning] *= scale
        else:
            value[:, :3, 3] *= scale
    lengths = {*ev.model.values, *_slides(ev)}
    env = {name: value * scale if name in lengths else value for name, value in samples.env.items()}
    env.update(pose_symbols(frames["T"]))
    ev.pick(env, frames)
    ev.fill(env)
    return Samples(samples.q, env, frames, samples.nominal)
