"""The native module that records closed forms; written by hand, see kernels/code/record.cpp."""

from typing import Any

def record(
    family: str, fields: dict[str, Any]
) -> (
    tuple[
        list[tuple[str, int, int, int, float]],
        list[int],
        list[int],
        int,
        list[tuple[int, list[int], list[int], int]],
    ]
    | None
): ...
