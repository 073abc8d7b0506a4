"""STL: the corners of a mesh's triangles, binary or text; no other kind of mesh is read."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from pieper.errors import InputError

#: Larger meshes are for looking at.
LARGEST_FILE = 200_000_000


def read(path: Path) -> npt.NDArray[np.float64]:
    """Return the corners (k, 3) of the triangles of an STL file, in its own unit.

    Raises:
        InputError: It cannot be read, is no STL, or has no triangle.
    """
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(f"{path}: larger than {LARGEST_FILE:,} bytes.", file=str(path))
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror}.", file=str(path)) from None
    count = int.from_bytes(data[80:84], "little") if len(data) >= 84 else -1
    if count >= 0 and len(data) == 84 + 50 * count:
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        points = np.frombuffer(data, record, count, 84)["corners"].reshape(-1, 3).astype(float)
    else:
        try:
            lines = (line.split() for line in data.decode("ascii", "replace").splitlines())
            points = np.array([line[1:4] for line in lines if line[:1] == ["vertex"]], dtype=float).reshape(-1, 3)
        except ValueError:
            points = np.empty((0, 3))
    if not len(points) or not np.isfinite(points).all():
        raise InputError(f"{path}: no STL with triangles of finite corners.", file=str(path))
    return points
