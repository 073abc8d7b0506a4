"""Sentences of the library in the units that a command speaks."""

import re

import numpy as np
import pytest

from pieper.cli.spoken_units import in_units
from pieper.cli.units import Units

RADIANS, METRES = Units("mm", "rad"), Units("m", "deg")


@pytest.mark.parametrize(
    "said, units, told",
    [
        ("turned by 180 deg.", RADIANS, "turned by 3.142 rad."),
        ("limits of -180 to 90.5 deg", RADIANS, "limits of -3.142 to 1.58 rad"),
        ("between -10.00 and 20.00 deg about", RADIANS, "between -0.1745 and 0.3491 rad about"),
        ("(10, 20, 30.25) mm off", METRES, "(0.01, 0.02, 0.03025) m off"),
        ("1.23456789 mm", METRES, "0.00123456789 m"),
        ("5e-07 mm apart at 90 deg", METRES, "5e-10 m apart at 90 deg"),
        ("120 deg/s of joints 1 and 2", RADIANS, "2.094 rad/s of joints 1 and 2"),
        ("an arm with 6 degrees of freedom, 3 mm thick", RADIANS, "an arm with 6 degrees of freedom, 3 mm thick"),
        ("20 mm² and 3 mmol", METRES, "20 mm² and 3 mmol"),
        ("tilted by 1 degree", RADIANS, "tilted by 0.01745 rad"),
    ],
)
def test_a_size_is_told_in_the_units_said(said, units, told):
    assert in_units(said, units) == told
    assert in_units(said, Units()) == said


def typed(angle):
    """Return ends of a line, a turn's interval and a cone in units of an angle (rad)."""
    half = repr(np.pi / angle)
    ends = [f"--{end}=900 {y} 900 0 {half} 0" for end, y in (("from", -300), ("to", 300))]
    return [*ends, f"--turn={-0.3 / angle!r} {0.3 / angle!r}", f"--cone={0.1 / angle!r}"]


def test_a_route_is_told_in_one_unit(run):
    said = {}
    for unit, angle in (("deg", np.pi / 180), ("rad", 1.0)):
        status, out, _ = run("route", "abb-irb2400", *typed(angle), "--angle", unit)
        assert status == 0
        said[unit] = " ".join(out.split())
    assert "deg" not in said["rad"] and "rad" not in said["deg"]
    turned = {u: re.search(r"turns between (\S+) and (\S+) ", text).groups() for u, text in said.items()}
    degrees, radians = (np.array(turned[u], float) for u in ("deg", "rad"))
    assert np.allclose(np.radians(degrees), radians, atol=1e-4)


def test_what_was_typed_is_refused_in_its_unit(run):
    words = ("--from", "0.9 0 0.9 0 3.14159265 0", "--to", "0.9 0.1 0.9 0 3.14159265 0", "--free")
    status, out, err = run(
        "route", "abb-irb2400", *words, "--start", "3.3 0 0 0 0 0", "--angle", "rad", "--length", "m"
    )
    assert status == 2 and "3.3 rad" in err and "deg" not in out + err and "mm" not in out + err
