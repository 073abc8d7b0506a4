"""Which joints of a robot move fingers, jaws or wheels, and are therefore not joints of the arm."""

from __future__ import annotations

import re
from typing import Any

from pieper.description.tree import Joint, Tree, span

#: Words in the name of a joint or of the link it moves that belong to the moving parts of a gripper.
FINGERS = frozenset(
    "gripper finger fingers fingertip jaw jaws claw claws thumb knuckle pincer pincers grip grasp gripper1 gripper2 "
    "index pinky".split()
)
#: The same for a link that is fixed: gripper and grasp are also names of tool frames.
_RIGID = FINGERS - {"gripper", "grip", "grasp", "index"}
#: Words that say the joint turns the gripper as a whole.
_WRIST = frozenset("wrist roll yaw pitch rotate rotation rot twist swivel".split())
_WHEELS = frozenset("wheel wheels caster casters castor tyre tire rotor propeller".split())
#: A slide at the end of an arm that moves no further than this (m) opens a gripper; a quill of a SCARA moves further.
SHORT_SLIDE = 0.1
#: The same where it stands alone, without a second jaw beside it.
SHORT_SINGLE_SLIDE = 0.06


def words_of(name: str) -> set[str]:
    """Return the words of a name: parts between anything but letters, and between small and capital letters."""
    split = re.sub(r"([a-z])([A-Z])", r"\1 \2", name)
    return {word.lower() for word in re.findall(r"[^\W\d_]+", split)}


def wheels(tree: Tree) -> set[str]:
    """Return the names of joints that carry wheels or rotors, and nothing else that moves."""
    return _ends(tree, lambda joint, _: bool((words_of(joint.name) | words_of(joint.child)) & _WHEELS))


def fingers(tree: Tree) -> set[str]:
    """Return the names of joints that move fingers: terminal ones that mimic, are short slides, or are named so."""
    followed: dict[str, list[Joint]] = {}
    for joint in tree.joints:
        if joint.mimic is not None:
            followed.setdefault(joint.mimic.joint, []).append(joint)
    by_name = {joint.name: joint for joint in tree.joints}

    def is_finger(joint: Joint, bears_fingers: bool) -> bool:
        words = words_of(joint.name) | words_of(joint.child)
        # a joint that turns a link named gripper, on which fingers move, is a wrist
        if words & (_RIGID if bears_fingers else FINGERS) and not words_of(joint.name) & _WRIST:
            return True
        leader = None if joint.mimic is None else by_name.get(joint.mimic.joint)
        if leader is not None and not _hangs_from(tree, joint, leader):
            return True
        # a joint that another one follows, the follower not hanging from it: the driver of a pair of jaws
        if any(not _hangs_from(tree, other, joint) for other in followed.get(joint.name, ())):
            return True
        if joint.kind != "prismatic" or bears_fingers:
            return False
        beside = [j for j in tree.below[joint.parent] if j is not joint and j.kind == "prismatic"]
        return span(joint) <= (SHORT_SLIDE if beside else SHORT_SINGLE_SLIDE) and _turns_above(tree, joint)

    return _ends(tree, is_finger)


def fixed_fingers(tree: Tree, moving: set[str]) -> set[str]:
    """Return the names of fixed joints that carry a finger or jaw and no joint of the arm.

    Args:
        tree: The robot.
        moving: Names of the joints that move fingers: a jaw that is fixed beside one of them is a jaw too.
    """
    found: set[str] = set()
    for joint in _leaves_first(tree):
        below = tree.below.get(joint.child, ())
        if joint.moves or any(other.name not in found and other.name not in moving for other in below):
            continue
        words = words_of(joint.child)
        beside = [j for j in tree.below[joint.parent] if j.name in moving]
        if words & _RIGID or joint.mimic is not None or any(words_of(j.child) == words for j in beside):
            found.add(joint.name)
    return found


def _ends(tree: Tree, is_end: Any) -> set[str]:
    """Return the moving joints that satisfy a test and from which only joints hang that do."""
    found: set[str] = set()
    blocked: set[str] = set()  # links from which an arm joint hangs
    bearing: set[str] = set()  # links from which an end hangs
    for joint in _leaves_first(tree):
        if joint.child in blocked or (joint.moves and not is_end(joint, joint.child in bearing)):
            blocked.add(joint.parent)
        elif joint.moves:
            found.add(joint.name)
            bearing.add(joint.parent)
        elif joint.child in bearing:
            bearing.add(joint.parent)
    return found


def _leaves_first(tree: Tree) -> list[Joint]:
    order: list[Joint] = []
    stack = list(tree.roots)
    while stack:
        below = tree.below.get(stack.pop(), [])
        order += below
        stack += [joint.child for joint in below]
    return order[::-1]


def _hangs_from(tree: Tree, joint: Joint, other: Joint | None) -> bool:
    link = joint.parent
    while other is not None and link in tree.above:
        if tree.above[link] is other:
            return True
        link = tree.above[link].parent
    return False


def _turns_above(tree: Tree, joint: Joint) -> bool:
    link = joint.parent
    while link in tree.above:
        if tree.above[link].kind in ("revolute", "continuous"):
            return True
        link = tree.above[link].parent
    return False
