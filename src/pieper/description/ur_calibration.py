"""A UR controller's factory calibration: the six measured joint frames that its driver writes as YAML."""

from __future__ import annotations

import math
import os
import re

import numpy as np

from pieper import arguments
from pieper.description.axes import described_by_axes
from pieper.description.dh import Description
from pieper.description.wholefile import bytes_of
from pieper.errors import InputError
from pieper.kinematics.orientation import rotation

#: Larger than any such file; it holds 36 numbers.
LARGEST_FILE = 100_000
#: No arm of the maker is as long (m), and no angle of such a file as large (rad).
LONGEST, MOST_TURNED = 20.0, 2 * math.pi
LINKS = ("shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3")
JOINTS = (
    *("shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint"),
    *("wrist_1_joint", "wrist_2_joint", "wrist_3_joint"),
)
_NUMBERS = ("x", "y", "z", "roll", "pitch", "yaw")
_PAIR = r"([\w-]+)\s*:\s*([^,{}]+)"


def read(path: str | os.PathLike[str]) -> Description:
    """Read the arm that a UR controller's calibration file describes.

    The base is the controller's base frame, the tool its flange; joints are unlimited to two turns either way, as UR's
    are (the elbow of most models to half a turn more or less: see `Arm.with_limits`).

    Args:
        path: The .yaml that `ur_calibration` extracts from a controller, with the key `kinematics`.

    Raises:
        InputError: The file is missing, or a number of it; the message names link and number.
    """
    path = arguments.file(path)
    data = bytes_of(path, LARGEST_FILE, "calibration file")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path}: not a text in UTF-8; a calibration file is YAML.", file=str(path)) from None
    if "delta_theta" in text:
        raise InputError(
            f"{path}: this is calibration.conf, differences to a table that the file does not say; extract the "
            "calibration with ur_calibration (calibration_correction) and give its .yaml.",
            file=str(path),
        )
    said = _numbers(text, str(path))
    T, axes, points = np.eye(4), [], []
    for link in LINKS:
        missing = [key for key in _NUMBERS if key not in said.get(link, {})]
        if missing:
            raise InputError(
                f"{path}: kinematics, {link}: {missing[0]} is missing; each of {', '.join(LINKS)} needs "
                f"{', '.join(_NUMBERS)}.",
                file=str(path),
                missing=missing[0],
                link=link,
            )
        at = said[link]
        for key in ("roll", "pitch", "yaw"):
            if abs(at[key]) > MOST_TURNED:
                raise InputError(
                    f"{path}: kinematics, {link}: {key} is {at[key]:g}; radians are meant. Were these degrees?",
                    file=str(path),
                    link=link,
                )
        step = np.eye(4)
        step[:3, :3] = rotation("rpy", [at["roll"], at["pitch"], at["yaw"]])
        step[:3, 3] = at["x"], at["y"], at["z"]
        T = T @ step
        axes.append(T[:3, 2].copy())
        points.append(T[:3, 3].copy())
    far = float(np.linalg.norm(T[:3, 3]))
    if far > LONGEST:
        raise InputError(
            f"{path}: the flange is {far:.4g} m away from the base with all joints at zero; metres are meant. "
            "Were these millimetres?",
            file=str(path),
            far=far,
        )
    return described_by_axes(
        np.array(axes),
        np.array(points),
        T,
        joint_names=JOINTS,
        limits=[(-2 * math.pi, 2 * math.pi)] * 6,
        name="ur-calibrated",
        manufacturer="Universal Robots",
        source=f"factory calibration {path.name}",
        postures={"zero": np.zeros(6)},
    )


def _numbers(text: str, file: str) -> dict[str, dict[str, float]]:
    """Return link -> name -> number of the two levels under `kinematics:`, in blocks or in braces."""
    found: dict[str, dict[str, float]] = {}
    inside, link, level = False, "", 0
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.split("#")[0].rstrip()
        if not bare.strip():
            continue
        depth = len(bare) - len(bare.lstrip())
        match = re.fullmatch(r"\s*([\w-]+)\s*:\s*(.*)", bare)
        if match is None:
            continue
        key, value = match.groups()
        if depth == 0:
            inside = key == "kinematics"
            level = 0
        elif inside and (not level or depth <= level):
            level, link = depth, key
            found[link] = {}
            for inner, said in re.findall(_PAIR, value):
                found[link][inner] = _float(said, f"{file}, line {number}: {link}, {inner}")
        elif inside and key in _NUMBERS:
            found[link][key] = _float(value, f"{file}, line {number}: {link}, {key}")
    bare = re.sub(r"#.*|['\"]", "", text)
    if not found and re.search(r"\bkinematics\s*:\s*{", bare):
        for link in LINKS:
            braces = re.search(rf"\b{link}\s*:\s*{{(.*?)}}", bare, re.S)
            for inner, said in re.findall(_PAIR, braces[1] if braces else ""):
                found.setdefault(link, {})[inner] = _float(said, f"{file}: {link}, {inner}")
    if not found:
        raise InputError(f"{file}: there is no key 'kinematics' with the six links of a calibration.", file=file)
    return found


def _float(text: str, where: str) -> float:
    try:
        value = float(text.strip().strip("'\""))
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(f"{where} holds {text.strip()!r}, which is not a finite number.", given=text)
    return value
