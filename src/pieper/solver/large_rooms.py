"""Room for large answers: what the last ones left behind is kept for the next, until the system wants it.

The system clears fresh memory before it hands it out, which takes half as long as solving the poses whose answers go
there. So rooms of arrays that nobody holds any more are kept, a few of them. Those made of huge pages are told to the
system as free (MADV_FREE): it takes them when memory gets short, and until then the next answer finds them in place.
"""

from __future__ import annotations

import mmap
import sys
from contextlib import suppress

import numpy as np
import numpy.typing as npt

#: Bytes from which on a room is kept, and from which on it begins with a page of the larger size, so that whole such
#: pages may serve it.
LARGE, HUGE, PAGE = 512 << 10, 4 << 20, 2 << 20
#: Bytes and rooms that are kept at most, and how many times larger than what is asked for a room may be.
MOST_KEPT, MOST_ROOMS, ROOMIER = 128 << 20, 16, 2
#: Elsewhere NumPy's own arrays serve.
_KEEPING = sys.platform == "linux"
#: The rooms that are kept, the oldest first. Each is taken and put back whole, so no lock is wanted, nor after a fork.
_kept: list[mmap.mmap] = []


class _Lease:
    """A room as long as arrays stand in it: the base of all of them, which goes with the last."""

    def __init__(self, room: mmap.mmap, count: int) -> None:
        self.room = room
        address, page = np.frombuffer(room, np.uint8).ctypes.data, PAGE if count >= HUGE else 1
        self.__array_interface__ = {
            "version": 3,
            "shape": (count,),
            "typestr": np.dtype(np.uint8).str,
            "data": (-(-address // page) * page, False),
        }

    def __del__(self) -> None:
        if len(self.room) > MOST_KEPT:
            return
        if len(self.room) >= HUGE:  # of many small pages the advice costs as much as fresh ones
            try:
                self.room.madvise(mmap.MADV_FREE)
            except OSError:
                return  # a system that knows no such advice would be left without the memory
        _kept.append(self.room)
        with suppress(IndexError):  # another thread took it
            while len(_kept) > MOST_ROOMS or sum(map(len, list(_kept))) > MOST_KEPT:
                _kept.pop(0)


def large_room(count: int) -> npt.NDArray[np.uint8]:
    """Return bytes (count,) that are any, like `np.empty`: they must be written before they are shown."""
    size = count + (PAGE if count >= HUGE else 0)
    if not _KEEPING or count < LARGE:
        return np.empty(count, np.uint8)
    room = _taken(size)
    if room is None:
        try:
            room = mmap.mmap(-1, size, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
        except OSError:
            return np.empty(count, np.uint8)  # which says what is too much
        if count >= HUGE:
            with suppress(OSError):  # a system without huge pages
                room.madvise(mmap.MADV_HUGEPAGE)
    return np.asarray(_Lease(room, count))


def _taken(size: int) -> mmap.mmap | None:
    """Return a kept room of so many bytes, not much larger, which is kept no more; None where there is none."""
    for room in reversed(_kept):
        if size <= len(room) <= ROOMIER * size:
            with suppress(ValueError):  # another thread took it
                _kept.remove(room)
                return room
    return None


def let_go() -> None:
    """Give the rooms that are kept back to the system at once."""
    _kept.clear()
