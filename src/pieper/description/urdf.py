"""A serial arm out of a URDF: one chain of joints, written as a standard DH table with base and tool."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat

import numpy as np

from pieper.description.commonnormal import PARALLEL, standard_table
from pieper.description.dh import Description, describe
from pieper.errors import InputError
from pieper.kinematics.orientation import rotation

#: Larger than any URDF by far; what is larger is not parsed.
LARGEST_FILE = 16_000_000
_MOVING = {"revolute": "R", "continuous": "R", "prismatic": "P"}
_NAMED_TIPS = ("tool0", "flange", "ee_link", "tcp")


@dataclass
class _Joint:
    name: str
    kind: str
    line: int
    parent: str = ""
    child: str = ""
    xyz: tuple[str, ...] = ("0", "0", "0")
    rpy: tuple[str, ...] = ("0", "0", "0")
    axis: tuple[str, ...] = ("1", "0", "0")
    lower: str | None = None
    upper: str | None = None
    mimics: str | None = None


@dataclass
class _Robot:
    file: str
    name: str = "arm"
    links: list[str] = field(default_factory=list)
    joints: list[_Joint] = field(default_factory=list)


@dataclass
class _Rounded:
    """Angles that were typed as a rounded multiple of 15 deg and are read as the exact one."""

    count: int = 0
    largest: float = 0.0


def read(
    path: str | Path, *, base: str | None = None, tip: str | None = None, exact_angles: bool = True
) -> Description:
    """Read the chain from one link of a URDF to another.

    Args:
        path: A .urdf file (a .xacro has to be expanded first).
        base: Link whose frame is the base; the root of the tree when left out.
        tip: Link whose frame is the tool; the end of the longest chain of moving joints when left out.
        exact_angles: Read angles that were typed as a rounded multiple of 15 deg (1.5708, 3.14159) as the exact
            multiple; the notes say how many and by how much. False takes every digit as it stands.

    Returns:
        The arm as a standard DH table; its joint angles are those of the URDF.

    Raises:
        InputError: The file is not a URDF, or holds no such chain; the message names line and joint.
    """
    path = Path(path)
    try:
        with path.open("rb") as stream:
            data = stream.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise InputError(f"there is no file {str(path)!r}.", file=str(path)) from None
    except OSError as error:
        raise InputError(f"{str(path)!r} cannot be read: {error.strerror}.", file=str(path)) from None
    return loads(data, file=str(path), base=base, tip=tip, exact_angles=exact_angles)


def loads(
    data: bytes | str,
    *,
    file: str = "<urdf>",
    base: str | None = None,
    tip: str | None = None,
    exact_angles: bool = True,
) -> Description:
    """Read the chain from the text of a URDF; `file` is what messages call it. See `read`."""
    data = data.encode() if isinstance(data, str) else data
    if len(data) > LARGEST_FILE:
        raise InputError(f"{file}: larger than {LARGEST_FILE:,} bytes; this is not a URDF.", file=file)
    robot = _parse(data, file)
    chain = _chain(robot, base, tip)
    rounded = _Rounded()
    T, axes, points, types, names, limits = np.eye(4), [], [], "", [], []
    for joint in chain:
        T = T @ _origin(joint, robot, rounded, exact_angles)
        if joint.kind == "fixed":
            continue
        axes.append(T[:3, :3] @ _axis(joint, robot))
        points.append(T[:3, 3].copy())
        types += _MOVING[joint.kind]
        names.append(joint.name)
        limits.append(_limits(joint, robot))
    table = standard_table(np.array(axes), np.array(points), T)
    return describe(
        table.rows,
        convention="standard",
        joint_types=types,
        joint_names=names,
        limits=limits,
        base=table.base,
        tool=table.tool,
        name=robot.name,
        source=f"URDF {Path(file).name}, from {chain[0].parent} to {chain[-1].child}",
        notes=_notes(rounded, table.largest_turn),
        postures={"zero": np.zeros(len(names))},
    )


def _notes(rounded: _Rounded, turn: float) -> str:
    notes = []
    if rounded.count:
        notes.append(
            f"{rounded.count} angles of the URDF are rounded multiples of 15 deg and were read as the exact ones; "
            f"the largest change is {rounded.largest:.1e} rad."
        )
    if turn > 1e-12:
        notes.append(
            f"Neighbouring axes within {PARALLEL:g} rad were taken for parallel; the largest angle was {turn:.1e} rad."
        )
    return " ".join(notes)


def _parse(data: bytes, file: str) -> _Robot:
    """Return links and joints; a document type declaration (and with it any entity) is refused."""
    robot, path = _Robot(file), []
    parser = expat.ParserCreate()

    def refuse(*_: object) -> None:
        raise InputError(
            f"{file}, line {parser.CurrentLineNumber}: a URDF has no document type declaration; files with one "
            "(and entities in it) are not read.",
            file=file,
            line=parser.CurrentLineNumber,
        )

    def start(tag: str, attributes: dict[str, str]) -> None:
        path.append(tag)
        if tag.startswith("xacro:") or any("${" in value for value in attributes.values()):
            raise InputError(
                f"{file}, line {parser.CurrentLineNumber}: this is a xacro, not a URDF; expand it first "
                "(xacro in.xacro > out.urdf).",
                file=file,
                line=parser.CurrentLineNumber,
            )
        if len(path) == 1 and tag != "robot":
            raise InputError(f"{file}: the first element is <{tag}>; a URDF begins with <robot>.", file=file)
        _element(robot, tuple(path), attributes, parser.CurrentLineNumber)

    parser.StartDoctypeDeclHandler = refuse
    parser.EntityDeclHandler = refuse
    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: path.pop()
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        raise InputError(f"{file}: not valid XML: {error}.", file=file) from None
    return robot


def _element(robot: _Robot, path: tuple[str, ...], attributes: dict[str, str], line: int) -> None:
    match path:
        case ("robot",):
            robot.name = attributes.get("name", "arm")
        case ("robot", "link"):
            robot.links.append(attributes.get("name", ""))
        case ("robot", "joint"):
            name, kind = attributes.get("name", ""), attributes.get("type", "")
            if any(joint.name == name for joint in robot.joints):
                _fail(robot, f"joint {name!r} is there twice.", line)
            robot.joints.append(_Joint(name, kind, line))
        case ("robot", "joint", tag):
            joint = robot.joints[-1]
            if tag in ("parent", "child"):
                setattr(joint, tag, attributes.get("link", ""))
            elif tag == "origin":
                joint.xyz = tuple(attributes.get("xyz", "0 0 0").split())
                joint.rpy = tuple(attributes.get("rpy", "0 0 0").split())
            elif tag == "axis":
                joint.axis = tuple(attributes.get("xyz", "1 0 0").split())
            elif tag == "limit":
                joint.lower, joint.upper = attributes.get("lower"), attributes.get("upper")
            elif tag == "mimic":
                joint.mimics = attributes.get("joint", "")


def _chain(robot: _Robot, base: str | None, tip: str | None) -> list[_Joint]:
    """Return the joints from base to tip, each checked to be one that a serial arm can have."""
    above: dict[str, _Joint] = {}
    for joint in robot.joints:
        if joint.child in above:
            _fail(robot, f"link {joint.child!r} hangs from two joints; a closed loop is not a serial arm.", joint.line)
        above[joint.child] = joint
    links = list(dict.fromkeys([*robot.links, *(link for j in robot.joints for link in (j.parent, j.child))]))
    for name, said in (("base", base), ("tip", tip)):
        if said is not None and said not in links:
            raise InputError(
                f"{robot.file}: there is no link {said!r} for the {name}. Links: {_some(links)}.", allowed=links
            )
    end = _tip(robot, above, links, base) if tip is None else tip
    chain = _up(robot, above, end, base)
    if not chain or (base is not None and chain[0].parent != base):
        raise InputError(
            f"{robot.file}: link {end!r} does not hang from {base or 'any other link'!r}.", base=base, tip=end
        )
    for joint in chain:
        if joint.kind not in _MOVING and joint.kind != "fixed":
            _fail(
                robot,
                f"joint {joint.name!r} is of type {joint.kind!r}; a serial arm may have revolute, continuous, "
                "prismatic and fixed joints.",
                joint.line,
                joint.name,
            )
        if joint.mimics is not None:
            _fail(
                robot,
                f"joint {joint.name!r} mimics {joint.mimics!r}; coupled joints cannot be described. "
                "Choose another tip.",
                joint.line,
                joint.name,
            )
    if not any(joint.kind in _MOVING for joint in chain):
        raise InputError(f"{robot.file}: no moving joint between {chain[0].parent!r} and {end!r}.", base=base, tip=end)
    return chain


def _up(robot: _Robot, above: dict[str, _Joint], link: str, base: str | None) -> list[_Joint]:
    """Return the joints that lead from base (or the root) down to a link."""
    chain: list[_Joint] = []
    while link in above and link != base:
        if len(chain) > len(above):
            raise InputError(f"{robot.file}: the links form a ring at {link!r}.", file=robot.file)
        chain.append(above[link])
        link = above[link].parent
    return chain[::-1]


def _tip(robot: _Robot, above: dict[str, _Joint], links: list[str], base: str | None) -> str:
    """Return the link at the end of the longest chain of moving joints, a link with a tool's name before others."""
    parents = {joint.parent for joint in robot.joints}
    if not above:
        raise InputError(f"{robot.file}: there is no joint in this file.", file=robot.file)
    moving = {}
    for link in links:
        chain = _up(robot, above, link, base)
        if chain and (base is None or chain[0].parent == base):
            usable = all(j.mimics is None and (j.kind in _MOVING or j.kind == "fixed") for j in chain)
            moving[link] = [j.name for j in chain if j.kind in _MOVING] if usable else []
    for name in _NAMED_TIPS:
        named = [link for link in moving if (link == name or link.endswith("_" + name)) and moving[link]]
        if len(named) == 1:
            return named[0]
    most = max((len(joints) for joints in moving.values()), default=0)
    ends = [link for link in moving if link not in parents and len(moving[link]) == most]
    if not ends:  # the longest chain goes on into something that is not a serial arm
        ends = [link for link in moving if len(moving[link]) == most][-1:]
    if len({tuple(moving[link]) for link in ends}) > 1:
        raise InputError(
            f"{robot.file}: several chains have {most} moving joints; say which by tip=. They end in: {_some(ends)}.",
            allowed=ends,
        )
    return ends[0]


def _origin(joint: _Joint, robot: _Robot, rounded: _Rounded, exact: bool) -> np.ndarray:
    T = np.eye(4)
    T[:3, 3] = [_number(text, "origin xyz", joint, robot) for text in _three(joint.xyz, "origin xyz", joint, robot)]
    angles = []
    for text in _three(joint.rpy, "origin rpy", joint, robot):
        angle = _number(text, "origin rpy", joint, robot)
        meant = _meant(text, angle) if exact else angle
        if meant != angle:
            rounded.count += 1
            rounded.largest = max(rounded.largest, abs(meant - angle))
        angles.append(meant)
    T[:3, :3] = rotation("rpy", angles)
    return T


def _meant(text: str, angle: float) -> float:
    """Return the multiple of 15 deg that was rounded or cut off to this text, else the angle itself."""
    near = math.radians(15 * round(math.degrees(angle) / 15))
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2]) - int(exponent or 0)
    last_digit = 10.0**-decimals
    if decimals < 4 or abs(angle - near) >= max(last_digit, 1e-15):
        return angle if abs(angle) >= 1e-12 else 0.0
    return near


def _axis(joint: _Joint, robot: _Robot) -> np.ndarray:
    axis = np.array([_number(text, "axis", joint, robot) for text in _three(joint.axis, "axis", joint, robot)])
    length = float(np.linalg.norm(axis))
    if length < 1e-9:
        _fail(robot, f"the axis of joint {joint.name!r} has no direction.", joint.line, joint.name)
    return axis / length


def _limits(joint: _Joint, robot: _Robot) -> tuple[float | None, float | None]:
    if joint.kind == "continuous":
        return None, None
    if joint.lower is None and joint.upper is None:
        _fail(robot, f"joint {joint.name!r} is {joint.kind} and needs limits (lower, upper).", joint.line, joint.name)
    # the URDF specification: a side that is not given is zero
    lower, upper = (_number(text or "0", "limit", joint, robot) for text in (joint.lower, joint.upper))
    if lower > upper:
        _fail(
            robot,
            f"the limits of joint {joint.name!r} are swapped: {lower:g} is above {upper:g}.",
            joint.line,
            joint.name,
        )
    return lower, upper


def _three(values: tuple[str, ...], what: str, joint: _Joint, robot: _Robot) -> tuple[str, ...]:
    if len(values) != 3:
        _fail(robot, f"{what} of joint {joint.name!r} needs three numbers, got {len(values)}.", joint.line, joint.name)
    return values


def _number(text: str, what: str, joint: _Joint, robot: _Robot) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        _fail(
            robot,
            f"{what} of joint {joint.name!r} holds {text!r}, which is not a finite number.",
            joint.line,
            joint.name,
        )
    return value


def _fail(robot: _Robot, message: str, line: int, joint: str | None = None) -> None:
    raise InputError(f"{robot.file}, line {line}: {message}", file=robot.file, line=line, joint=joint)


def _some(names: list[str]) -> str:
    return ", ".join(names[:12]) + (f" and {len(names) - 12} more" if len(names) > 12 else "")
