"""What Python adds to the picture, as the page draws it: frames, curves, postures, bodies, motions."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper

#: Points of a curve and samples of a motion that are sent, at most.
MOST = 4_000
KINDS = ("frame", "path", "points", "postures")


def thing(arm: pieper.Arm, what: Any, kind: str | None, every: float) -> dict[str, Any]:
    """Return what the page draws of an object, by what it is.

    Args:
        arm: The arm that joint vectors are of.
        what: A pose (4, 4), poses (k, 4, 4), points (k, 3), postures (k, n), a `Motion`, `Track`, `Program`, or a
            body: a `Box` with `T` and `size`, a `Capsule` with `a`, `b`, `r`, a `Cylinder` with `T`, `r`, `h`.
        kind: One of KINDS where an array could be two things; None to tell by its shape.
        every: Seconds between two postures, where they have no time of their own.

    Raises:
        InputError: It is none of these, or could be two of them.
    """
    body = _body(what)
    if body is not None:
        return body
    if isinstance(what, pieper.Program):
        what = what.motion()
    if isinstance(what, pieper.Motion):
        events = [[float(t), str(k), v] for t, k, v in what.events]
        return _motion(np.asarray(what.t, np.float64), np.asarray(what.q, np.float64), events)
    if isinstance(what, pieper.Track):
        q = np.asarray(what.q)[np.asarray(what.reached, bool)]
        return _motion(np.linspace(0.0, every * (len(q) - 1), len(q)), q, [])
    if kind not in (None, *KINDS):
        raise pieper.InputError(f"kind must be one of {', '.join(KINDS)}, got {kind!r}.", given=kind)
    try:
        array: npt.NDArray[np.float64] = np.asarray(what, dtype=np.float64)
    except (TypeError, ValueError):
        raise pieper.InputError(
            f"what is shown is a pose (4, 4), poses, points or postures, a Motion, a Track, a Program or a body, got "
            f"{type(what).__name__}.",
            given=what,
        ) from None
    kind = kind or _kind(array, arm.n)
    if kind == "frame":
        return {"kind": "frame", "T": _pose(array).ravel().tolist()}
    if kind == "path":
        return {"kind": "curve", "points": _thin(array.reshape(-1, 4, 4)[:, :3, 3]).tolist()}
    if kind == "points":
        return {"kind": "curve", "points": _thin(array.reshape(-1, 3)).tolist()}
    q = array.reshape(-1, arm.n)
    return _motion(np.linspace(0.0, every * (len(q) - 1), len(q)), q, [])


def _kind(array: npt.NDArray[np.float64], n: int) -> str:
    fits = [
        name
        for name, yes in (
            ("frame", array.shape == (4, 4)),
            ("path", array.ndim == 3 and array.shape[1:] == (4, 4)),
            ("points", array.ndim == 2 and array.shape[1] == 3),
            ("postures", array.ndim == 2 and array.shape[1] == n),
        )
        if yes
    ]
    if array.shape == (4, 4) and np.allclose(array[3], [0, 0, 0, 1]):
        return "frame"
    if len(fits) == 1:
        return fits[0]
    if not fits:
        raise pieper.InputError(
            f"an array of shape {array.shape} is nothing that can be shown: a pose is (4, 4), a path (k, 4, 4), points "
            f"(k, 3), postures of this arm (k, {n}).",
            given=array.shape,
        )
    raise pieper.InputError(
        f"an array of shape {array.shape} can be {' or '.join(fits)}: say kind=.", given=array.shape
    )


def _pose(array: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    if array.shape != (4, 4) or not np.isfinite(array).all():
        raise pieper.InputError(f"a frame is a pose (4, 4) of finite numbers, got shape {array.shape}.")
    return array


def _body(what: Any) -> dict[str, Any] | None:
    """Return a body as the page draws it; None for anything else."""

    def numbers(*names: str) -> dict[str, Any]:
        return {name: np.asarray(operator.attrgetter(name)(what), float).ravel().tolist() for name in names}

    if isinstance(what, pieper.Box):
        return {"kind": "box", **numbers("T", "size")}
    if isinstance(what, pieper.Capsule):
        return {"kind": "capsule", **numbers("a", "b"), "r": float(what.r)}
    if isinstance(what, pieper.Cylinder):
        return {"kind": "cylinder", **numbers("T"), "r": float(what.r), "h": float(what.h)}
    return None


def _thin(points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    if not np.isfinite(points).all():
        raise pieper.InputError("a curve's points must be finite.")
    return points[np.unique(np.linspace(0, len(points) - 1, min(len(points), MOST)).round().astype(int))]


def _motion(t: npt.NDArray[np.float64], q: npt.NDArray[np.float64], events: list[list[Any]]) -> dict[str, Any]:
    if not len(q):
        raise pieper.InputError("there is no posture to show: the motion is empty.")
    kept = np.unique(np.linspace(0, len(q) - 1, min(len(q), MOST)).round().astype(int))
    return {"kind": "motion", "t": t[kept].tolist(), "q": q[kept].tolist(), "events": events}
