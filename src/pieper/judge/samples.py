"""Joint vectors at which claims are tried, with the value of everything a formula can name."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from pieper.judge.model import POSE_NAMES, ArmModel


@dataclass(frozen=True, eq=False)
class Samples:
    """Joint vectors at which claims are tried.

    Attributes:
        q: (K, n) in rad (or the unit of length), tenths of a degree so that a counter-example can be read and retyped.
        env: every symbol's values, (K,) each.
        frames: A1 .. An and T, (K, 4, 4).
        nominal: (K,) bool, True where the lengths are those of the arm, False where they were varied.
    """

    q: np.ndarray
    env: dict[str, np.ndarray]
    frames: dict[str, np.ndarray]
    nominal: np.ndarray


def sample(
    model: ArmModel,
    count: int = 96,
    *,
    seed: int = 20_24,
    vary: Mapping[str, str] | None = None,
    held: Mapping[int, float] | None = None,
    zeros: Collection[str] = (),
) -> Samples:
    """Draw joint vectors (and, in the second half, other lengths) and evaluate everything a formula can name.

    Args:
        model: the arm.
        count: number of joint vectors.
        seed: start of the generator; the same claims get the same counter-examples every time.
        vary: the lengths that get other values in the second half, so that "identically" means for every arm of this
            build; lengths of one group keep their ratio. None varies every length by itself.
        held: joints (1-based) that stay at a value, rad or the unit of length.
        zeros: the lengths that are zero for this arm and get values all the same, where they are varied.
    """
    rng = np.random.default_rng(seed)
    n = model.n
    degrees = rng.integers(-1799, 1800, size=(count, n))
    degrees += (degrees % 50 == 0).astype(int)
    q = np.radians(degrees / 10)
    scale = model.length() / max(n, 1)
    for joint in range(1, n + 1):
        if model.sliding(joint):
            q[:, joint - 1] = np.round(rng.uniform(0.2, 1.5, count) * scale, 3)
    for joint, value in (held or {}).items():
        q[:, joint - 1] = value
    groups = {name: name for name in model.values} if vary is None else vary
    second = np.arange(count) >= count // 2 if groups else np.zeros(count, dtype=bool)
    factors: dict[str, np.ndarray] = {}
    lengths: dict[str, np.ndarray] = {}
    for name, value in model.values.items():
        drawn = np.round(rng.uniform(0.7, 1.4, count - count // 2), 3)
        lengths[name] = np.full(count, float(value))
        if name in groups:
            other = factors.setdefault(groups[name], drawn)
            lengths[name][count // 2 :] = np.round(other * scale, 3) if name in zeros else value * other
    return samples_at(model, q, lengths=lengths, nominal=~second)


def samples_at(
    model: ArmModel,
    q: np.ndarray,
    *,
    lengths: Mapping[str, np.ndarray] | None = None,
    nominal: np.ndarray | None = None,
) -> Samples:
    """Evaluate lengths, pose and frames at joint vectors (n,) or (K, n); `lengths` are (K,) each, the arm's without."""
    q = np.atleast_2d(np.asarray(q, dtype=float))
    count = len(q)
    env = {name: np.full(count, float(value)) for name, value in model.values.items()}
    env.update(lengths or {})
    for joint in range(1, model.n + 1):
        env[f"theta{joint}"] = q[:, joint - 1]
    for alias, target in model.aliases.items():
        env[alias] = env[target]
    frames = model.frames(env)
    env.update(pose_symbols(frames["T"]))
    return Samples(q, env, frames, np.ones(count, dtype=bool) if nominal is None else nominal)


def some(samples: Samples, rows: np.ndarray) -> Samples:
    """The samples of some rows."""
    env = {k: v[rows] for k, v in samples.env.items()}
    return Samples(samples.q[rows], env, {k: v[rows] for k, v in samples.frames.items()}, samples.nominal[rows])


def joined(parts: list[Samples]) -> Samples:
    """Samples one after the other."""
    env = {k: np.concatenate([p.env[k] for p in parts]) for k in parts[0].env}
    frames = {k: np.concatenate([p.frames[k] for p in parts]) for k in parts[0].frames}
    q, nominal = (np.concatenate([getattr(p, k) for p in parts]) for k in ("q", "nominal"))
    return Samples(q, env, frames, nominal)


def pose_of(model: ArmModel, q: np.ndarray) -> np.ndarray:
    """The poses (K, 4, 4) of joint vectors (n,) or (K, n), lengths as they are."""
    return samples_at(model, q).frames["T"]


def pose_symbols(T: np.ndarray) -> dict[str, np.ndarray]:
    """Name the entries of poses (K, 4, 4), nx .. az, px, Px, r11 .. r34, and their roll, pitch and yaw.

    R = Rz(yaw) Ry(pitch) Rx(roll), in rad.
    """
    return {name: T[:, i, j] for name, i, j in POSE_NAMES} | {
        "roll": np.arctan2(T[:, 2, 1], T[:, 2, 2]),
        "pitch": np.arctan2(-T[:, 2, 0], np.hypot(T[:, 0, 0], T[:, 1, 0])),
        "yaw": np.arctan2(T[:, 1, 0], T[:, 0, 0]),
    }
