"""A map written for other programs: npz, parquet, VTK; each whole or not at all."""

from __future__ import annotations

import io
import os
from importlib import import_module
from pathlib import Path
from typing import Any, Protocol, cast

import numpy as np

from pieper import arguments
from pieper.document.writing import whole_file
from pieper.errors import InputError
from pieper.kinematics.arrays import Array, Bits, Indices
from pieper.maps.grid import Grid
from pieper.maps.tile import MEASURES
from pieper.solver.plan.plan import Plan


class Mapped(Protocol):
    """What is written of a map."""

    @property
    def plan(self) -> Plan:
        """How the arm is solved."""
        ...

    @property
    def grid(self) -> Grid:
        """The voxels."""
        ...

    @property
    def bits(self) -> Bits:
        """(v, k) packed: which orientations are reached."""
        ...

    @property
    def measures(self) -> Array:
        """(v, 6) what was measured, or (v, 0)."""
        ...

    @property
    def fraction(self) -> Any:
        """Share of orientations reached (v,)."""
        ...

    @property
    def count(self) -> Indices:
        """Solutions inside the limits (v,)."""
        ...

    @property
    def axes(self) -> tuple[Array, Array, Array]:
        """The voxels' centres along x, y and z, m."""
        ...


def export(m: Mapped, path: str | os.PathLike[str]) -> Path:
    """Write a map; see `ReachMap.save`.

    Raises:
        InputError: An ending that is none of these, a place that cannot be written, pyarrow missing for parquet.
    """
    target = arguments.file(path)
    writers = {".npz": _npz, ".parquet": _parquet, ".vtk": _vtk}
    if target.suffix not in writers:
        raise InputError(f"{target.name}: a map is written as {', '.join(writers)}.", given=target.suffix)
    data = writers[target.suffix](m)
    with whole_file(target) as file:
        file.write(data)
    return target


def _layers(m: Mapped) -> dict[str, Array]:
    out = {"fraction": m.fraction, "count": m.count.astype(np.float64)}
    return out | {name: v.reshape(m.grid.shape) for name, v in zip(MEASURES, m.measures.T, strict=False)}


def _npz(m: Mapped) -> bytes:
    memory = io.BytesIO()
    x, y, z = m.axes
    held: dict[str, Any] = {"bits": m.bits, "turns": m.grid.turns, "x": x, "y": y, "z": z, "step": m.grid.step}
    np.savez_compressed(memory, **held, **cast("dict[str, Any]", _layers(m)))
    return memory.getvalue()


def _parquet(m: Mapped) -> bytes:
    try:
        arrow: Any = import_module("pyarrow")
        parquet: Any = import_module("pyarrow.parquet")
    except ModuleNotFoundError:
        raise InputError("writing parquet needs an extra: pip install 'pieper[parquet]'.") from None
    p = m.grid.centres(np.arange(m.grid.count))
    columns = {"x": p[:, 0], "y": p[:, 1], "z": p[:, 2], **{k: v.ravel() for k, v in _layers(m).items()}}
    memory = io.BytesIO()
    parquet.write_table(arrow.table(columns), memory)
    return memory.getvalue()


def _vtk(m: Mapped) -> bytes:
    """Legacy VTK, binary: an image whose cells are the voxels, x fastest, big-endian."""
    nx, ny, nz = m.grid.shape
    head = (
        "# vtk DataFile Version 3.0\n"
        f"reach of {' '.join(m.plan.name.split())[:200]}, metres\nBINARY\nDATASET STRUCTURED_POINTS\n"
        f"DIMENSIONS {nx + 1} {ny + 1} {nz + 1}\nORIGIN {' '.join(repr(float(v)) for v in m.grid.low)}\n"
        f"SPACING {m.grid.step!r} {m.grid.step!r} {m.grid.step!r}\nCELL_DATA {m.grid.count}\n"
    )
    out = head.encode()
    for name, values in _layers(m).items():
        out += f"SCALARS {name} double 1\nLOOKUP_TABLE default\n".encode()
        out += np.asarray(values).transpose(2, 1, 0).astype(">f8").tobytes() + b"\n"
    return out
