"""URDF: the XML of a robot becomes links and joints, and an arm through `treearm`."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from xml.parsers import expat

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.description.ends import find_ends
from pieper.description.shapes import Unmeasured
from pieper.description.tree import Joint, Mimic, Tree, some
from pieper.description.treearm import arm_of
from pieper.description.wholefile import bytes_of
from pieper.errors import InputError
from pieper.kinematics.orientation import rotation
from pieper.tolerances import ALL_BUT_ZERO, NO_DIRECTION, REMARKABLE, ROUNDING

#: Larger than any URDF by far; what is larger is not parsed.
LARGEST_FILE = 16_000_000


#: What `urdf_text` writes into its files, all of which is the arm, however short its last slide: nothing is a gripper.
WHOLE = "<!-- from base to tool it is one arm -->"


class NotExpanded(InputError):
    """The file holds xacro macros that have not been expanded."""


@dataclass(slots=True)
class _Numbers:
    """The texts of a joint's frame, kept until somebody asks for its numbers."""

    xyz: tuple[str, ...] = ("0", "0", "0")
    rpy: tuple[str, ...] = ("0", "0", "0")
    axis: tuple[str, ...] = ("1", "0", "0")


def read(
    path: str | Path,
    *,
    base: str | None = None,
    tip: str | None = None,
    exact_angles: bool = True,
    missing_limits: str = "refuse",
) -> Description:
    """Read the chain from one link of a URDF to another.

    Args:
        path: A .urdf file.
        base: Link whose frame is the base; the root of the tree when left out.
        tip: Link whose frame is the tool; the one end of the arm when left out.
        exact_angles: Read angles that were typed as a rounded multiple of 15 deg (1.5708, 3.14159) as the exact
            multiple; the remarks say how many and by how much. False takes every digit as it stands.
        missing_limits: "refuse" a joint without a range, or take it as "unlimited".

    Returns:
        The arm as a standard DH table; its joint angles are those of the URDF.

    Raises:
        InputError: The file is not a URDF, or holds no such chain; the message names line and joint.
    """
    data = bytes_of(Path(path), LARGEST_FILE, "URDF")
    return loads(data, file=str(path), base=base, tip=tip, exact_angles=exact_angles, missing_limits=missing_limits)


def loads(
    data: bytes | str,
    *,
    file: str = "<urdf>",
    base: str | None = None,
    tip: str | None = None,
    exact_angles: bool = True,
    missing_limits: str = "refuse",
) -> Description:
    """Read the chain from the text of a URDF; `file` is what messages call it. See `read`."""
    data = data.encode() if isinstance(data, str) else data
    if len(data) > LARGEST_FILE:
        raise InputError(f"{file}: larger than {LARGEST_FILE:,} bytes; this is not a URDF.", file=file)
    # what pieper wrote has every digit, also where an angle looks like a rounded one
    exact_angles = exact_angles and WHOLE.encode() not in data
    tree = parse(data, file, exact_angles)
    if base is None and tip is None and WHOLE.encode() in data and {"base", "tool"} <= set(tree.links):
        base, tip = "base", "tool"
    arm = arm_of(tree, base=base, tip=tip, missing_limits=missing_limits)
    if b"<collision" not in data:
        return arm
    ends = find_ends(tree, base, tip)
    return replace(arm, unmeasured=Unmeasured(data, file, exact_angles, ends.base, ends.tip, arm.base))


def _undeclared(joints: list[Joint], declared: set[str]) -> list[str]:
    """Return a sentence about links that joints name and the file does not declare."""
    named = dict.fromkeys(link for joint in joints for link in (joint.parent, joint.child))
    left = [link for link in named if link not in declared]
    if not left:
        return []
    what = "is named by a joint and not declared" if len(left) == 1 else "are named by joints and not declared"
    return [f"{some(left)} {what}: frames without a <link>, which others refuse."]


def _said_of(rounded: dict[str, list[float]], joints: list[Joint]) -> tuple[str, ...]:
    changes = [change for joint in joints for change in rounded.get(joint.name, ())]
    if not changes:
        return ()
    one = len(changes) == 1
    return (
        f"{len(changes)} {'angle' if one else 'angles'} of the URDF {'is a' if one else 'are'} rounded "
        f"{'multiple' if one else 'multiples'} of 15 deg and {'was' if one else 'were'} read as the exact "
        f"{'one' if one else 'ones'}; the largest change is {max(changes):.1e} rad.",
    )


def parse(data: bytes, file: str, exact_angles: bool) -> Tree:
    """Return links and joints; a document type declaration (and with it any entity) is refused."""
    links: list[str] = []
    joints: dict[str, Joint] = {}
    numbers: dict[str, _Numbers] = {}
    #: joint -> by how much (rad) its angles, typed as rounded multiples of 15 deg, were changed
    rounded: dict[str, list[float]] = {}
    name = "arm"
    told: list[str] = []
    known: set[tuple[str, str]] = set()
    at: list[str] = []
    current: Joint | None = None
    parser = expat.ParserCreate()

    def refuse(kind: str, *_: object) -> None:
        if kind.lower() == "html":
            raise InputError(f"{file}: {_NO_XML[0][1]}", file=file)
        raise InputError(
            f"{file}, line {parser.CurrentLineNumber}: a URDF has no document type declaration; files with one "
            "(and entities in it) are not read. Take it out.",
            file=file,
            line=parser.CurrentLineNumber,
        )

    def start(tag: str, said: dict[str, str]) -> None:
        nonlocal name, current
        at.append(tag)
        line = parser.CurrentLineNumber
        if tag.startswith("xacro:") or any("${" in value for value in said.values()):
            raise NotExpanded(
                f"{file}, line {line}: this is a xacro, not a URDF; expand it first (xacro in.xacro > out.urdf), or "
                "load it as .xacro with the extra: pip install 'pieper[xacro]'.",
                file=file,
                line=line,
            )
        if len(at) == 1 and tag != "robot":
            cure = f" {_OTHERS[tag]}" if tag in _OTHERS else ""
            raise InputError(f"{file}: the first element is <{tag}>; a URDF begins with <robot>.{cure}", file=file)
        match tuple(at):
            case ("robot",):
                name = said.get("name", "arm")
            case ("robot", "link"):
                if said.get("name", "") in links:
                    told.append(f"Link {said.get('name', '')!r} is declared twice; its frame is one.")
                links.append(said.get("name", ""))
            case ("robot", "joint"):
                current = Joint(said.get("name", ""), said.get("type", ""), line)
                if not current.name:
                    raise InputError(
                        f'{file}, line {line}: a joint has no name; write <joint name="..." ...>.', file=file, line=line
                    )
                if current.name in joints:
                    raise InputError(
                        f"{file}, line {line}: joint {current.name!r} is there twice; names must differ.",
                        file=file,
                        line=line,
                        joint=current.name,
                    )
                joints[current.name] = current
                numbers[current.name] = _Numbers()
            case ("robot", "joint", _) if current is not None:
                if (current.name, tag) not in known:
                    _element(current, numbers[current.name], tag, said)
                elif tag in _ONCE:  # which of two counts differs between readers; the first does where robots are run
                    told.append(f"Joint {current.name!r} has more than one <{tag}>: the first counts, as in ROS.")
                known.add((current.name, tag))

    parser.StartDoctypeDeclHandler = refuse
    parser.EntityDeclHandler = refuse
    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: at.pop()
    with _xml(file, data):
        parser.Parse(data, True)
    for joint in joints.values():
        for word, link in (("parent", joint.parent), ("child", joint.child)):
            if not link:
                raise InputError(
                    f"{file}, line {joint.line}: joint {joint.name!r} has no {word} link.",
                    file=file,
                    line=joint.line,
                    joint=joint.name,
                )
    declared = set(links)
    return Tree(
        file,
        name,
        "URDF",
        links,
        list(joints.values()),
        lambda joint: _geometry(file, joint, numbers[joint.name], rounded if exact_angles else None),
        lambda asked: (*_said_of(rounded, asked), *told, *_undeclared(asked, declared)),
    )


#: What a joint has once.
_ONCE = ("parent", "child", "origin", "axis", "limit", "mimic")
#: How files begin that are none, and what to do about it.
_NO_XML = (
    (b"<html", "a web page, not the file: save the raw file and load that."),
    (b"version https://git-lfs", "a pointer of Git LFS, not the file: fetch that (git lfs pull) and load it."),
)
#: What else a file may be by its first element.
_OTHERS = {
    "mujoco": "It is an MJCF: give it the ending .xml.",
    "sdf": "It is an SDF: convert it to a URDF (with sdformat_urdf, for one) and load that.",
    "COLLADA": "It is a mesh: load the URDF that refers to it.",
    "html": "It is a web page: save the raw file and load that.",
}


@contextmanager
def _xml(file: str, data: bytes) -> Iterator[None]:
    try:
        yield
    except expat.ExpatError as error:
        if not data.strip():
            raise InputError(f"{file}: the file is empty. Load the robot's own file.", file=file) from None
        said = next((words for begin, words in _NO_XML if data.lstrip().startswith(begin)), "")
        cure = said or f"not valid XML: {error}. Correct it there, or write it anew with the program it is from."
        raise InputError(f"{file}: {cure}", file=file) from None


def first_element(data: bytes, file: str) -> str:
    """Return the name of the first element of an XML text."""
    found: list[str] = []
    parser = expat.ParserCreate()

    def start(tag: str, _: dict[str, str]) -> None:
        found.append(tag)
        raise StopIteration

    parser.StartElementHandler = start
    with _xml(file, data):
        try:
            parser.Parse(data, True)
        except StopIteration:
            pass
    return found[0]


def _element(joint: Joint, numbers: _Numbers, tag: str, said: dict[str, str]) -> None:
    if tag in ("parent", "child"):
        setattr(joint, tag, said.get("link", ""))
    elif tag == "origin":
        numbers.xyz = tuple(said.get("xyz", "0 0 0").split())
        numbers.rpy = tuple(said.get("rpy", "0 0 0").split())
    elif tag == "axis":
        numbers.axis = tuple(said.get("xyz", "1 0 0").split())
    elif tag == "limit":
        joint.lower, joint.upper = _bound(said.get("lower")), _bound(said.get("upper"))
    elif tag == "mimic":
        multiplier, offset = _bound(said.get("multiplier")), _bound(said.get("offset"))
        joint.mimic = Mimic(said.get("joint", ""), 1.0 if multiplier is None else multiplier, offset or 0.0)


def _bound(text: str | None) -> float | None:
    if text is None:
        return None
    try:
        return float(text)
    except ValueError:
        return math.nan


def _geometry(
    file: str, joint: Joint, numbers: _Numbers, rounded: dict[str, list[float]] | None
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Return the joint's frame (4, 4) in its parent and its unit axis (3,)."""
    T = np.eye(4)
    T[:3, 3] = [value for _, value in _three(file, joint, "origin xyz", numbers.xyz)]
    angles, changes = [], []
    for text, angle in _three(file, joint, "origin rpy", numbers.rpy):
        meant = _meant(text, angle) if rounded is not None else angle
        # a digit of rounding that a double cannot even hold apart is not worth a remark
        if abs(meant - angle) > REMARKABLE:
            changes.append(abs(meant - angle))
        angles.append(meant)
    if rounded is not None and changes:
        rounded[joint.name] = changes
    T[:3, :3] = rotation("rpy", angles)
    if not joint.moves:
        return T, np.zeros(3)
    axis = np.array([value for _, value in _three(file, joint, "axis", numbers.axis)])
    length = float(np.linalg.norm(axis))
    if length < NO_DIRECTION:
        _fail(file, joint, f"the axis of joint {joint.name!r} has no direction; give it one, such as 0 0 1.")
    return T, axis / length


def _meant(text: str, angle: float) -> float:
    """Return the multiple of 15 deg that was rounded or cut off to this text, else the angle itself."""
    near = math.radians(15 * round(math.degrees(angle) / 15))
    mantissa, _, exponent = text.lower().partition("e")
    decimals = len(mantissa.partition(".")[2]) - int(exponent or 0)
    last_digit = 10.0**-decimals
    if decimals < 4 or abs(angle - near) >= max(last_digit, ALL_BUT_ZERO):
        return angle if abs(angle) >= ROUNDING else 0.0
    return near


def _three(file: str, joint: Joint, what: str, texts: tuple[str, ...]) -> list[tuple[str, float]]:
    if len(texts) != 3:
        said = " ".join(texts)
        _fail(file, joint, f"{what} of joint {joint.name!r} needs three numbers apart by blanks, got {said!r}.")
    out = []
    for text in texts:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            _fail(file, joint, f"{what} of joint {joint.name!r} holds {text!r}, which is not a finite number.")
        out.append((text, value))
    return out


def _fail(file: str, joint: Joint, message: str) -> None:
    raise InputError(f"{file}, line {joint.line}: {message}", file=file, line=joint.line, joint=joint.name)
