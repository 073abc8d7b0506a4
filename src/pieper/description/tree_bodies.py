"""The shapes of a robot's links become bodies of the arm between two of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.description.fold import frames_of
from pieper.description.mjcf_solids import Geoms
from pieper.description.shapes import Body, unique_names
from pieper.description.tree import Joint, Tree
from pieper.description.urdf import parse
from pieper.description.urdf_solids import Solids
from pieper.errors import InputError
from pieper.kinematics.pose import inverse

Array = npt.NDArray[np.float64]


def known_bodies(arm: Description) -> tuple[tuple[Body, ...], tuple[str, ...]]:
    """Return what is known of an arm's bodies, a file's shapes measured if need be, and sentences on what was left out.

    Bodies are the links' from base to tip, and those of what hangs from them and is no part of the arm. Joints of that,
    such as fingers, are taken at zero; a sentence says so.
    """
    source = arm.unmeasured
    if arm.bodies or source is None:
        return arm.bodies, ()
    if source.data:
        shapes, tree = Solids(source.data, source.file), parse(source.data, source.file, source.exact_angles)
    else:
        try:
            shapes = Geoms(source.file)
        except InputError as error:
            return (), (f"The shapes of the file were left out: {error}",)
        tree = shapes.tree
    still: list[str] = []
    bodies = [
        Body(link, on, shape.moved(T), said)
        for link, on, T in links_of(replace(arm, base=source.at), tree, source.base, source.tip, still)
        for shape, said in shapes.of(link)
    ]
    names = unique_names([body.name for body in bodies])
    notes = list(shapes.notes)
    if still and bodies:
        joints = ", ".join(still[:12])
        notes.append(f"Joints {joints} are not the arm's: the bodies behind them stand where these are at zero.")
    return tuple(replace(body, name=name) for body, name in zip(bodies, names, strict=True)), tuple(notes)


def links_of(
    arm: Description, tree: Tree, base: str, tip: str, still: list[str] | None = None
) -> Iterator[tuple[str, int, Array]]:
    """Yield each link from base to tip and what hangs from it: its name, what carries it, its frame (4, 4) in that.

    Args:
        arm: The arm, its base where it was when it was read.
        tree: The robot it was read from.
        base: Link the arm begins at.
        tip: Link it ends at.
        still: Takes the names of moving joints that are not the arm's, which are taken at zero.
    """
    frames = frames_of(arm, np.zeros(arm.n))
    path = tree.path(base, tip)
    own = {joint.name for joint, _ in path}

    def take(link: str, on: int, T: Array) -> Iterator[tuple[str, int, Array]]:
        yield link, on, inverse(frames[on]) @ T
        for joint in tree.below.get(link, ()):
            if joint.name not in own:
                origin, _ = tree.geometry(joint)
                if joint.moves and still is not None:
                    still.append(joint.name)
                yield from take(joint.child, on, T @ origin)

    on, T = 0, np.eye(4)
    yield from take(base, on, T)
    for joint, upward in path:
        origin, _ = tree.geometry(joint)
        T = T @ (inverse(origin) if upward else origin)
        if joint.moves and joint.name in arm.joint_names:
            on += 1
        yield from take(_end(joint, upward), on, T)


def _end(joint: Joint, upward: bool) -> str:
    return joint.parent if upward else joint.child
