"""A motion as one page of HTML that plays it, needs nothing from elsewhere, and can be turned with the mouse."""

from __future__ import annotations

import json
from html import escape
from importlib import resources
from typing import Any

import numpy as np

from pieper.description.dh import Description
from pieper.document import identity
from pieper.drawing.animation.moving import Moving
from pieper.drawing.animation.painter import way_of_the_tool
from pieper.drawing.animation.telling import happenings
from pieper.drawing.skeleton import extent, skeletons

#: Decimals of what the page holds: tenths of a millimetre, thousandths of a degree.
METRES, DEGREES = 4, 3


def page(
    motion: Moving, description: Description, times: np.ndarray, *, speed: float, view: tuple[float, float]
) -> str:
    """Return the page.

    Args:
        motion: The joint curves.
        description: Whose.
        times: (k,) the moments it holds, s.
        speed: 1 as the motion runs.
        view: Elevation and azimuth, deg.
    """
    q = motion.between(times)
    parts = skeletons(description, q)
    way = way_of_the_tool(motion, description)
    centre, half = extent(way, *(p.polyline for p in parts))
    slides = np.array([kind == "P" for kind in description.joint_types])
    shown = np.where(slides, q * 1e3, np.degrees(q))
    data: dict[str, Any] = {
        "name": description.name,
        "joints": list(description.joint_names),
        "units": ["mm" if s else "deg" for s in slides],
        "times": np.round(times, 6).tolist(),
        "speed": speed,
        "view": list(view),
        "centre": np.round(centre, METRES).tolist(),
        "half": round(float(half), METRES),
        "floor": round(float(min(0.0, min(p.polyline[:, 2].min() for p in parts))), METRES),
        "links": [np.round(p.polyline, METRES).tolist() for p in parts],
        "drums": [np.round(np.hstack([p.centres, p.directions]), METRES).tolist() for p in parts],
        "tools": [np.round(p.frames[-1][:3], METRES).tolist() for p in parts],
        "way": np.round(way, METRES).tolist(),
        "q": np.round(shown, DEGREES).tolist(),
        "axes": identity.axes(),
        "told": [happenings(motion, float(t)) for t in times],
    }
    # "<" cannot end the script that holds the numbers
    numbers = json.dumps(data, separators=(",", ":")).replace("<", "\\u003c")
    template = resources.files("pieper.drawing.animation").joinpath("page.html").read_text(encoding="utf-8")
    said = {"identity": identity.both_themes(), "icon": identity.icon_address(), "title": escape(description.name)}
    for name, text in said.items():
        template = template.replace("{{" + name + "}}", text)
    return template.replace("{{numbers}}", numbers)
