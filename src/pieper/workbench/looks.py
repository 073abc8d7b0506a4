"""What arms look like: shapes and meshes of the user's own files, and nothing else of them."""

from __future__ import annotations

import secrets
import struct
import threading
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper

#: Kinds of mesh files that pages read.
MESHES = (".stl", ".obj", ".dae")
#: Bytes of one mesh, and shapes of one arm, at most.
LARGEST_MESH, MOST = 200_000_000, 2_000


class Looks:
    """The meshes that pages may fetch: those of arms that this server was started with, by addresses nobody guesses."""

    def __init__(self) -> None:
        self._kept: dict[str, Path | bytes] = {}
        self._known: dict[int, tuple[pieper.Arm, dict[str, Any] | None]] = {}
        self._lock = threading.Lock()

    def of(self, arm: pieper.Arm) -> dict[str, Any] | None:
        """Return an arm's shapes with the addresses of their meshes, and notes; None for an arm of a table."""
        with self._lock:
            known = self._known.get(id(arm))
            if known is None or known[0] is not arm:
                known = arm, self._read(arm)
                self._known[id(arm)] = known
            return known[1]

    def mesh(self, address: str) -> bytes | None:
        """Return what stands at an address; None where nothing is to be fetched."""
        kept = self._kept.get(address)
        if not isinstance(kept, Path):
            return kept
        try:
            return kept.read_bytes()
        except OSError:
            return None

    def _read(self, arm: pieper.Arm) -> dict[str, Any] | None:
        try:
            looks = arm.visuals
        except pieper.PieperError as error:
            return {"shapes": [], "notes": [str(error)]}
        if not looks.shapes and not looks.notes:
            return None
        notes, token = list(looks.notes), secrets.token_urlsafe(12)
        addresses: dict[str, str | None] = {}
        for name in dict.fromkeys(v.mesh for v in looks.shapes if v.mesh):
            addresses[name] = None
            if looks.triangles and name in looks.triangles:
                address = f"/looks/{token}/{len(addresses)}.stl"
                self._kept[address] = _stl(looks.triangles[name])
                addresses[name] = address
                continue
            try:
                file = looks.mesh_file(name)
            except pieper.InputError as error:
                notes.append(str(error))
                continue
            if file.suffix.lower() not in MESHES:
                notes.append(f"{name} is not drawn: meshes are read as {', '.join(MESHES)}.")
            elif file.stat().st_size > LARGEST_MESH:
                notes.append(f"{name} is not drawn: it has more than {LARGEST_MESH:,} bytes.")
            else:
                address = f"/looks/{token}/{len(addresses)}{file.suffix.lower()}"
                self._kept[address] = file
                addresses[name] = address
        shapes = [
            {**_said(v), **({"url": addresses[v.mesh]} if v.mesh else {})}
            for v in looks.shapes[:MOST]
            if not v.mesh or addresses[v.mesh] is not None
        ]
        return {"shapes": shapes, "notes": notes}


def named_only(arm: pieper.Arm) -> dict[str, Any] | None:
    """Return an arm's shapes, meshes by the names in its file, which a page sent that has them."""
    looks = arm.visuals
    if not looks.shapes:
        return None
    shapes = [{**_said(v), **({"file": v.mesh} if v.mesh else {})} for v in looks.shapes[:MOST]]
    return {"shapes": shapes, "notes": list(looks.notes)}


def _said(visual: Any) -> dict[str, Any]:
    return {
        "name": visual.name,
        "on": visual.on,
        "T": np.asarray(visual.T).ravel().tolist(),
        "kind": visual.kind,
        "size": [float(v) for v in visual.size],
        "colour": None if visual.colour is None else [float(v) for v in visual.colour],
    }


def _stl(corners: npt.NDArray[np.float32]) -> bytes:
    """Return triangles (k, 3, 3) as a binary STL without normals, which readers find themselves."""
    rows = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    rows["corners"] = corners
    return b"\0" * 80 + struct.pack("<I", len(corners)) + rows.tobytes()
