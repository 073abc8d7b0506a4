"""Where an arm begins and ends in a robot's tree: said, or one possible answer, or all of them listed and asked for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NoReturn

import numpy as np
import numpy.typing as npt

from pieper.description.grippers import fingers, fixed_fingers, wheels
from pieper.description.tree import MOVING, Joint, Tree, some
from pieper.errors import InputError
from pieper.tolerances import SAME_TOOL

#: The kind of joint that lets a robot float as a whole, or a thing lie about.
FLOATING = "floating"
#: Names by which files say which frame is the tool's, the strongest first.
_TOOL_NAMES = ("tool0", "flange", "ee_link", "tcp")


@dataclass(frozen=True, slots=True)
class Ends:
    """Base and tip of an arm, and what was decided on the way, in sentences."""

    base: str
    tip: str
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class _Reach:
    """Every link that hangs from the base through joints of an arm, with the last of its moving joints."""

    last: dict[str, Joint | None]
    below: dict[str, list[Joint]]
    before: dict[str, Joint | None]


def find_ends(tree: Tree, base: str | None, tip: str | None) -> Ends:
    """Return base and tip of the arm.

    Args:
        tree: The robot.
        base: Link whose frame is the base, if said.
        tip: Link whose frame is the tool, if said.

    Returns:
        The two links. Fingers, jaws and wheels are no joints of an arm unless the tip is said to lie beyond them.

    Raises:
        InputError: No such link, or the file leaves a choice; the message lists every choice with its joints, and so
            does the attribute `choices` of the error.
    """
    for what, said in (("base", base), ("tip", tip)):
        if said is not None and said not in tree.links:
            raise InputError(
                f"{tree.file}: there is no link {said!r} for the {what}. Links: {some(tree.links)}.",
                given=said,
                allowed=tree.links,
            )
    afloat: tuple[str, ...] = ()
    if base is None:
        base = _root(tree) if tip is None else _root_of(tree, tip)
        afloat = _floats(tree, base)
    if tip is not None:
        return Ends(base, tip, afloat)
    moving, rolling = fingers(tree), wheels(tree)
    left_out = moving | rolling | fixed_fingers(tree, moving)
    anchor = _anchor(tree, base)
    reach = _reach(tree, anchor, left_out)
    chains = _longest_chains(tree, reach)
    if not chains:
        _nothing_moves(tree, base, anchor, left_out)
    candidates = {joint.name: _candidates(tree, reach, joint) for joint in chains}
    tip, why = _decide(tree, reach, chains, candidates)
    return Ends(base, tip, (*afloat, *_left_out(tree, _reach(tree, anchor, set()), reach, tip, moving, rolling), *why))


def _left_out(
    tree: Tree, everything: _Reach, reach: _Reach, tip: str, moving: set[str], rolling: set[str]
) -> list[str]:
    """Return sentences about the joints from the same base that the arm does not have."""
    notes = []
    there = [joint for joint in tree.joints if joint.name in moving and joint.child in everything.last]
    on_tool = [joint.name for joint in there if _carrier(tree, joint, moving, reach) is reach.last[tip]]
    beside = [joint.name for joint in there if joint.name not in on_tool]
    rolled = [joint.name for joint in tree.joints if joint.name in rolling and joint.child in everything.last]
    if on_tool:
        notes.append(
            f"The gripper was left out: {_joints(on_tool)} {'moves' if len(on_tool) == 1 else 'move'} its fingers, "
            f"and the arm ends before, at {tip!r}; tip= says otherwise."
        )
    if beside:
        notes.append(f"Beside the arm and not part of it: {_joints(beside)}.")
    if rolled:
        notes.append(f"Wheels were left out: {_joints(rolled)}.")
    return notes


def _carrier(tree: Tree, joint: Joint, moving: set[str], reach: _Reach) -> Joint | None:
    """Return the joint of the arm that carries a finger."""
    link = joint.parent
    while link in tree.above and (tree.above[link].name in moving or not tree.above[link].moves):
        link = tree.above[link].parent
    return reach.last.get(link)


def _root_of(tree: Tree, link: str) -> str:
    """Return the root that a link hangs from: of the tree, or of a robot that floats in it as a whole."""
    at = link
    while at in tree.above:
        at = tree.above[at].parent
    afloat = [root for root in _bodies_afloat(tree) if root in _above(tree, link)[1:]]
    return afloat[0] if afloat else at


def _above(tree: Tree, link: str) -> list[str]:
    found = [link]
    while found[-1] in tree.above:
        found.append(tree.above[found[-1]].parent)
    return found


def _bodies_afloat(tree: Tree) -> list[str]:
    """Return the first link of everything that floats with nothing before it that moves: robots, and things about."""
    found = []
    for joint in tree.joints:
        if joint.kind != FLOATING or any(tree.above[k].moves for k in _above(tree, joint.parent) if k in tree.above):
            continue
        # an MJCF's body hangs rigidly from what its own free joint moves
        below = tree.below.get(joint.child, [])
        found.append(below[0].child if len(below) == 1 and not below[0].moves else joint.child)
    return found


def _floats(tree: Tree, base: str) -> tuple[str, ...]:
    """Return in a sentence that the robot floats, where it does."""
    if base not in _bodies_afloat(tree):
        return ()
    joint = next(tree.above[k] for k in _above(tree, base) if tree.above[k].kind == FLOATING)
    return (f"The robot floats (joint {joint.name!r}); its own body {base!r} is the base.",)


def _root(tree: Tree) -> str:
    """Return the one root from which something moves."""
    roots = [root for root in (*tree.roots, *_bodies_afloat(tree)) if _moves(tree, root)]
    if len(roots) > 1:
        choices = [{"base": root, "joints": [j.name for j in _moving_below(tree, root)]} for root in roots]
        listed = "; ".join(f"base={c['base']!r} (joints {some(c['joints'])})" for c in choices)
        raise InputError(
            f"{tree.file}: {len(roots)} separate robots stand in this file; say which by its base: {listed}.",
            file=tree.file,
            choices=choices,
            allowed=roots,
        )
    return roots[0] if roots else tree.roots[0]


def _moving_below(tree: Tree, link: str) -> list[Joint]:
    found, stack = [], [link]
    while stack:
        for joint in tree.below.get(stack.pop(), []):
            if joint.kind == FLOATING:
                continue
            stack.append(joint.child)
            if joint.moves:
                found.append(joint)
    return found


def _moves(tree: Tree, link: str) -> bool:
    return bool(_moving_below(tree, link))


def _anchor(tree: Tree, base: str) -> str:
    """Return the highest link that is rigidly one with the base: a frame beside the chain may be its base."""
    if _moves(tree, base):
        return base
    link = base
    while link in tree.above and not tree.above[link].moves:
        link = tree.above[link].parent
    return link


def _reach(tree: Tree, anchor: str, left_out: set[str]) -> _Reach:
    last: dict[str, Joint | None] = {anchor: None}
    below: dict[str, list[Joint]] = {}
    before: dict[str, Joint | None] = {}
    stack = [anchor]
    while stack:
        link = stack.pop()
        for joint in tree.below.get(link, []):
            if joint.name in left_out or (joint.kind == FLOATING and last[link] is None):
                continue
            below.setdefault(link, []).append(joint)
            last[joint.child] = joint if joint.moves else last[link]
            if joint.moves:
                before[joint.name] = last[link]
            stack.append(joint.child)
    return _Reach(last, below, before)


def _longest_chains(tree: Tree, reach: _Reach) -> list[Joint]:
    """Return the last moving joint of every chain that is not the beginning of a longer one, in the file's order."""
    going_on = {joint.name for joint in reach.before.values() if joint is not None}
    return [joint for joint in tree.joints if joint.name in reach.before and joint.name not in going_on]


def _candidates(tree: Tree, reach: _Reach, joint: Joint) -> list[str]:
    """Return the links at the end of a chain: the last in each direction, and those whose name says tool."""
    here = [link for link in tree.links if reach.last.get(link) is joint]
    return [link for link in here if not reach.below.get(link) or any(_is_named(link, name) for name in _TOOL_NAMES)]


def _decide(
    tree: Tree, reach: _Reach, chains: list[Joint], candidates: dict[str, list[str]]
) -> tuple[str, tuple[str, ...]]:
    every = [link for joint in chains for link in candidates[joint.name]]
    if len(chains) == 1 and len(every) == 1:
        return every[0], ()
    for name in _TOOL_NAMES:
        named = [link for link in every if _is_named(link, name)]
        if len(named) == 1:
            others = [link for link in every if link != named[0]]
            return named[0], (
                f"{named[0]!r} was taken for the tool by its name; the file also ends in {some(others)}.",
            )
    if len(chains) == 1 and len(tools := _distinct(tree, every)) == 1:
        return tools[0], ()
    _ask(tree, reach, chains, candidates)


def _is_named(link: str, name: str) -> bool:
    return link == name or link.endswith(("_" + name, "-" + name, "/" + name))


def _distinct(tree: Tree, links: list[str]) -> list[str]:
    """Return one link of every tool frame among links that hang rigidly from one joint."""
    frames: list[npt.NDArray[np.float64]] = []
    found: list[str] = []
    for link in links:
        T, at = np.eye(4), link
        while at in tree.above and not tree.above[at].moves:
            T = tree.geometry(tree.above[at])[0] @ T
            at = tree.above[at].parent
        if not any(np.abs(T - other).max() <= SAME_TOOL for other in frames):
            frames.append(T)
            found.append(link)
    return found


def _ask(tree: Tree, reach: _Reach, chains: list[Joint], candidates: dict[str, list[str]]) -> NoReturn:
    choices = []
    for joint in chains:
        names, at = [], joint
        while at is not None:
            names.append(at.name)
            at = reach.before[at.name]
        choices += [{"tip": link, "joints": names[::-1]} for link in candidates[joint.name]]
    ends = [choice["tip"] for choice in choices]
    said = []
    for joint in chains:
        names = next(choice["joints"] for choice in choices if choice["tip"] == candidates[joint.name][0])
        tips = " or ".join(repr(link) for link in candidates[joint.name])
        said.append(f"{len(names)} {'joint' if len(names) == 1 else 'joints'} ({some(names, 20)}) to tip={tips}")
    if len(chains) > 1:
        text = f"several chains of joints end here; say which by tip=: {'; '.join(said)}. They end in: {some(ends)}."
    else:
        text = f"several frames end the same joints; say which is the tool by tip=: {said[0]}."
    raise InputError(f"{tree.file}: {text}", file=tree.file, choices=choices, allowed=ends)


def _nothing_moves(tree: Tree, base: str, anchor: str, left_out: set[str]) -> NoReturn:
    cut = [joint for joint in _moving_below(tree, anchor) if joint.name in left_out]
    if cut:
        choices = [{"tip": joint.child, "joints": [joint.name]} for joint in cut]
        raise InputError(
            f"{tree.file}: every moving joint that hangs from {base!r} looks like one of a gripper or a wheel "
            f"({some([joint.name for joint in cut])}); say by tip= where the arm ends: "
            f"{some([joint.child for joint in cut])}.",
            file=tree.file,
            choices=choices,
            allowed=[joint.child for joint in cut],
        )
    if not any(joint.kind in MOVING for joint in tree.joints):
        raise InputError(
            f"{tree.file}: no joint of this file moves ({', '.join(MOVING)} would): it is no arm. Load the robot's own "
            "file.",
            file=tree.file,
        )
    afloat = [joint.name for joint in tree.joints if joint.kind == FLOATING]
    loose = f" ({_joints(afloat)} {'is' if len(afloat) == 1 else 'are'} floating)" if afloat else ""
    raise InputError(
        f"{tree.file}: no moving joint hangs from {base!r}{loose}; kinds that move are {', '.join(MOVING)}. "
        "Say base= or tip= of a chain that moves.",
        file=tree.file,
        base=base,
    )


def _joints(names: list[str]) -> str:
    return f"joint {names[0]!r}" if len(names) == 1 else f"joints {some([repr(name) for name in names])}"
