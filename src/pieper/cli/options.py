"""The options that several commands share, said once."""

from __future__ import annotations

from typing import Annotated

import typer

ArmName = Annotated[str, typer.Argument(metavar="ARM", help="A catalogue name (see `pieper robots`) or a robot file.")]
Length = Annotated[str, typer.Option("--length", help="Unit of lengths, typed and printed: mm or m.")]
Angle = Annotated[str, typer.Option("--angle", help="Unit of angles, typed and printed: deg or rad.")]
Json = Annotated[bool, typer.Option("--json", help="Print JSON, in metres and radians, for machines.")]
Order = Annotated[
    str,
    typer.Option(
        "--order",
        help="What the numbers after x y z mean: rpy (roll, pitch, yaw about the fixed x, y, z), zyx (KUKA's A, B, C), "
        "zyz, rotation_vector, quaternion_wxyz or quaternion_xyzw.",
    ),
]
#: Negative numbers are numbers, not options.
NUMBERS = {"ignore_unknown_options": True}
