"""Where tiles are kept: each written whole, then marked with its checksum; what is not marked is done again."""

from __future__ import annotations

import hashlib
import io
import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from pieper import arguments
from pieper.document.writing import whole_file
from pieper.errors import InputError
from pieper.made_by import installed_version
from pieper.maps.tile import MEASURES, Question, Tile
from pieper.words_by_number import plural

#: Version of the layout; another one is refused, not guessed at.
LAYOUT = 5
#: Bytes of a map that is refused without a store.
MOST_BYTES = 10_000_000_000


def identity(question: Question, per_tile: int) -> dict[str, Any]:
    """Return what makes a map this map: arm, limits, grid, layout; two maps that agree in it have the same bits."""
    plan, grid = question.plan, question.grid
    arm = hashlib.sha256()
    for array in (plan.chain.links, plan.limits, plan.chain.prismatic):
        arm.update(np.ascontiguousarray(array).tobytes())
    if plan.chain.coupling is not None:
        arm.update(np.ascontiguousarray(plan.chain.coupling).tobytes())
    return {
        "layout": LAYOUT,
        "pieper": installed_version(),
        "arm": plan.name,
        "arm_sha256": arm.hexdigest(),
        "task": plan.task,
        "low_m": grid.low.tolist(),
        "step_m": grid.step,
        "shape": list(grid.shape),
        "rolls": grid.rolls,
        "turns": len(grid.turns),
        "turns_sha256": hashlib.sha256(np.ascontiguousarray(grid.turns).tobytes()).hexdigest(),
        "voxels_solved_a_tile": per_tile,
        "images": question.images.fold,
        "measured": question.measure,
        "around_sha256": None if question.around is None else question.around.fingerprint,
    }


#: What each part of it is called, in the order it is told; what follows from others is told where they agree.
CALLED = {
    "arm": "arm",
    "task": "task",
    "step_m": "step (m)",
    "low_m": "lower corner of the box (m)",
    "shape": "voxels",
    "turns": "orientations",
    "rolls": "rolls",
    "measured": "measure",
    "pieper": "version of pieper",
    "layout": "layout",
}
DIGESTS = {
    "arm_sha256": "links, base, tool or limits of the arm",
    "turns_sha256": "orientations",
    "around_sha256": "what stands around the arm (scene)",
    "images": "symmetry",
    "voxels_solved_a_tile": "size of a tile",
}


def _differences(known: dict[str, Any], wanted: dict[str, Any]) -> str:
    """Return in words in what two maps differ."""
    other = {key for key in wanted if known.get(key) != wanted[key]}
    said = [
        f"{called} {known.get(key) if known.get(key) != '' else 'unknown'} there, {wanted[key]} asked"
        for key, called in CALLED.items()
        if key in other
    ]
    if not said or other & {"around_sha256"}:
        said += [f"other {called}" for key, called in DIGESTS.items() if key in other]
    return "; ".join(said)


@dataclass(frozen=True)
class Store:
    """A folder of tiles.

    Args:
        folder: Where it is.
        map: SHA-256 of what makes the map that map.
    """

    folder: Path
    map: str

    @staticmethod
    def opened(path: str | os.PathLike[str], wanted: dict[str, Any]) -> Store:
        """Return the store of a map, made if there is none.

        Raises:
            InputError: The folder keeps another map; the message says in what it differs.
        """
        folder = arguments.file(path, "store")
        page = folder / "map.json"
        try:
            folder.mkdir(parents=True, exist_ok=True)
            known = json.loads(page.read_text()) if page.exists() else {}
            if not isinstance(known, dict):
                raise ValueError("it is no object")
        except ValueError as error:
            raise InputError(
                f"store: {page} does not say which map the folder keeps ({error}). Give another folder, or remove it.",
                path=folder,
            ) from None
        except (FileExistsError, NotADirectoryError):
            raise InputError(f"store: {folder} is or lies below a file; a store is a folder.", path=folder) from None
        except OSError as error:
            raise InputError(f"store: {folder} cannot be used: {error}.", path=folder) from None
        if not page.exists():
            with whole_file(page) as file:
                file.write(json.dumps(wanted, indent=1).encode())
        elif known != wanted:
            other = [key for key in wanted if known.get(key) != wanted[key]]
            raise InputError(
                f"store: {folder} keeps another map: {_differences(known, wanted)}. Give another folder, or ask the "
                "same as before.",
                path=folder,
                differs=other,
            )
        return Store(folder, hashlib.sha256(json.dumps(wanted, sort_keys=True).encode()).hexdigest())

    def put(self, number: int, tile: Tile) -> str:
        """Write a tile whole, then its mark; returns its checksum."""
        memory = io.BytesIO()
        np.savez(memory, bits=tile.bits, count=tile.count, measures=tile.measures)
        data = memory.getvalue()
        mark = hashlib.sha256(data).hexdigest()
        with whole_file(self._tile(number)) as file:
            file.write(data)
        with whole_file(self._mark(number)) as file:
            file.write(self._marked(mark, number).encode())
        return mark

    def get(self, number: int) -> Tile | None:
        """Return a tile of this map and place that is whole; None where it, its mark or a bit of it is missing."""
        try:
            data, mark = self._tile(number).read_bytes(), self._mark(number).read_text()
        except OSError:
            return None
        if mark != self._marked(hashlib.sha256(data).hexdigest(), number):
            return None
        held = np.load(io.BytesIO(data))
        return Tile(held["bits"], held["count"], held["measures"])

    def _marked(self, checksum: str, number: int) -> str:
        """Return a tile's mark: its checksum, then whose it is, so that no other map's or place's is taken for it."""
        return f"{checksum} {number} {self.map}\n"

    def _tile(self, number: int) -> Path:
        return self.folder / f"tile_{number:06d}.npz"

    def _mark(self, number: int) -> Path:
        return self.folder / f"tile_{number:06d}.sha256"


def refuse_too_much(voxels: int, turns: int, *, measure: bool, stored: bool) -> None:
    """Refuse a map of so many voxels and orientations that it would fill the machine, before any of it is made.

    Raises:
        InputError: The orientations alone are too much, the map is and has no store, or it is more than the memory.
    """
    rotations = turns * 9 * 8
    if rotations > MOST_BYTES:
        raise InputError(
            f"{_said(turns)} orientations of 72 bytes are {_gigabytes(rotations)}: give fewer.", bytes=rotations
        )
    size = voxels * (-(-turns // 8) + 8 * (1 + len(MEASURES) * measure))
    if size > MOST_BYTES and not stored:
        raise InputError(
            f"this map has {_said(voxels)} voxels with {plural(turns, 'orientation')} each, {_gigabytes(size)}: give a "
            "store=, a larger step or fewer orientations.",
            bytes=size,
        )
    room = _memory()
    if size > room:
        raise InputError(
            f"this map has {_said(voxels)} voxels with {plural(turns, 'orientation')} each, {_gigabytes(size)}, and "
            f"this machine has {_gigabytes(room)} of memory, which a store does not replace. Give a larger step, fewer "
            "orientations, or parts of the box one by one; lengths are metres here, millimetres on the command line.",
            bytes=size,
            room=room,
        )


def _memory() -> int:
    """Return how many bytes of memory this machine has; without end where it does not say."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        return 1 << 62


def _said(number: int) -> str:
    return f"{number:,}" if number < 10**15 else f"{number:.3g}"


def _gigabytes(size: int) -> str:
    return f"{size // 10**9:,} GB" if 10**11 <= size < 10**18 else f"{size / 10**9:.3g} GB"
