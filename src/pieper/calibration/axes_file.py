"""A robot file that keeps an arm as axes: nearly parallel axes have no table worth writing."""

from __future__ import annotations

import numpy as np

from pieper.calibration.model import AxesModel
from pieper.description.bodyfield import body_tables
from pieper.description.dh import Description
from pieper.description.fold import frames_of
from pieper.description.keys import quantity_key
from pieper.description.robottext import contents, text_of


def text_of_axes(description: Description, model: AxesModel) -> str:
    """Return the text of a robot file with the axes, points and tool of a model, the rest as a description has it."""
    top = contents(description)
    top["convention"] = "axes"
    joints = []
    for table, axis, point, slides in zip(top["joints"], model.axes, model.points, model.prismatic, strict=True):
        kept = {key: value for key, value in table.items() if key in ("name", "type") or key.startswith("limits")}
        said = {"axis": [float(x) for x in axis]} | ({} if slides else quantity_key("point", point.tolist(), "length"))
        joints.append({"name": kept.pop("name"), "type": kept.pop("type")} | said | kept)
    top["joints"] = joints
    for key in ("base", "tool"):
        top.pop(key, None)
    if description.bodies:
        frames = frames_of(description, np.zeros(description.n))
        at_zero = [body.moved(frames[body.on]) for body in description.bodies]
        top["bodies"] = body_tables(at_zero, description.joint_names)
    top["home"] = {"matrix_m": [[float(x) for x in row] for row in model.home]}
    return text_of(top)
