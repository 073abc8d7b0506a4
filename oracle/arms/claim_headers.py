"""Arms as a page of claims prints them: the elbow of three joints and Craig's Puma, with the lengths a test wants."""

from __future__ import annotations

_ARM = """[arm]
convention = "{convention}"
length_unit = "{unit}"
columns = {columns}
rows = {rows}
values = {{ {values} }}
"""


def elbow(d1: float, a2: float, a3: float, unit: str = "m") -> str:
    """Return the lines of a claims file that describe an elbow: a turntable, then two links."""
    return _ARM.format(
        convention="standard",
        unit=unit,
        columns='["theta", "d", "a", "alpha"]',
        rows='[["q1", "d1", 0, "pi/2"], ["q2", 0, "a2", 0], ["q3", 0, "a3", 0]]',
        values=f"d1 = {d1!r}, a2 = {a2!r}, a3 = {a3!r}",
    )


def puma(a2: float, d3: float, a3: float, d4: float, unit: str = "m") -> str:
    """Return the lines of a claims file that describe Craig's Puma."""
    return _ARM.format(
        convention="modified",
        unit=unit,
        columns='["alpha", "a", "d", "theta"]',
        rows=(
            '[[0, 0, 0, "q1"], ["-90 deg", 0, 0, "q2"], [0, "a2", "d3", "q3"], ["-90 deg", "a3", "d4", "q4"],\n'
            '        ["90 deg", 0, 0, "q5"], ["-90 deg", 0, 0, "q6"]]'
        ),
        values=f"a2 = {a2!r}, d3 = {d3!r}, a3 = {a3!r}, d4 = {d4!r}",
    )
