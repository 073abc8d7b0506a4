"""Room for large answers: what the last one left behind is kept for the next, until the system wants it.

The system clears fresh memory before it hands it out, which takes half as long as solving the poses whose answers go
there. So the room of an answer that nobody holds any more is kept, one at a time, and told to the system as free
(MADV_FREE): it takes the pages when memory gets short, and until then the next answer finds them in place.
"""

from __future__ import annotations

import mmap
import sys
from contextlib import suppress

import numpy as np

from pieper.kinematics.arrays import Array

#: Bytes from which on a room is large. The C library gives those below back late by itself.
LARGE = 4 << 20
#: Bytes of a room that is kept at most, and how many times larger than what is asked for it may be.
MOST_KEPT, ROOMIER = 128 << 20, 2
#: Rooms begin with a page of this size, so that whole such pages may serve them.
PAGE = 2 << 20
#: Elsewhere NumPy's own arrays serve.
_KEEPING = sys.platform == "linux"
#: The room that is kept, if one is. Taken and put back whole, so no lock is wanted, in a forked process neither.
_kept: list[mmap.mmap] = []


class _Lease:
    """A room as long as arrays stand in it: the base of all of them, which goes with the last."""

    def __init__(self, room: mmap.mmap, count: int) -> None:
        self.room = room
        address = np.frombuffer(room, np.uint8).ctypes.data
        self.__array_interface__ = {
            "version": 3,
            "shape": (count,),
            "typestr": np.dtype(np.float64).str,
            "data": (-(-address // PAGE) * PAGE, False),
        }

    def __del__(self) -> None:
        if len(self.room) > MOST_KEPT + PAGE:
            return
        try:
            self.room.madvise(mmap.MADV_FREE)
        except OSError:
            return  # a system that knows no such advice would be left without the memory
        _kept[:] = [self.room]


def large_room(count: int) -> Array:
    """Return an array (count,) whose numbers are any, like `np.empty`: they must be written before they are shown."""
    size = 8 * count + PAGE
    if not _KEEPING or size < LARGE:
        return np.empty(count)
    try:
        room = _kept.pop()
    except IndexError:
        room = None
    if room is None or not size <= len(room) <= ROOMIER * size:
        try:
            room = mmap.mmap(-1, size, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
        except OSError:
            return np.empty(count)  # which says what is too much
        with suppress(OSError):  # a system without huge pages
            room.madvise(mmap.MADV_HUGEPAGE)
    return np.asarray(_Lease(room, count))


def let_go() -> None:
    """Give the room that is kept back to the system at once."""
    _kept.clear()
