"""MJCF: bodies and joints of a MuJoCo model, read by the extra `mujoco`, become links and joints of a tree."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from pieper.description.dh import Description
from pieper.description.ends import find_ends
from pieper.description.mjcf_ties import body_names, name_of, remarks, ties_of, without_space_tendons
from pieper.description.shapes import Unmeasured
from pieper.description.tree import Joint, Tree
from pieper.description.treearm import arm_of
from pieper.description.urdf import LARGEST_FILE
from pieper.description.wholefile import bytes_of
from pieper.errors import InputError
from pieper.kinematics.orientation import rotation
from pieper.kinematics.pose import rotation_about, transform

#: What a chain of bodies does not need and whose files are often not at hand.
_UNNEEDED = (
    "geoms meshes textures materials hfields skins flexes actuators sensors keys pairs excludes cameras lights"
).split()


def read(
    path: str | Path, *, base: str | None = None, tip: str | None = None, missing_limits: str = "refuse"
) -> Description:
    """Read the chain from one body of an MJCF file to another body or site.

    Args:
        path: An .xml file that begins with <mujoco>; meshes need not be there.
        base: Body or site whose frame is the base; the world when left out.
        tip: Body or site whose frame is the tool; the one end of the arm when left out.
        missing_limits: Joints without a range are unlimited in MJCF, so this only concerns ranges of 0..0.

    Returns:
        The arm as a standard DH table; its joint values are those of the model (`qpos`).

    Raises:
        InputError: The extra is not installed, the file is no model, or holds no such chain.
    """
    path = Path(path)
    bytes_of(path, LARGEST_FILE, "MJCF file")
    tree = tree_of(path)
    arm = arm_of(tree, base=base, tip=tip, missing_limits=missing_limits)
    ends = find_ends(tree, base, tip)
    return replace(arm, unmeasured=Unmeasured(b"", str(path), True, ends.base, ends.tip, arm.base))


def tree_of(path: Path) -> Tree:
    """Return the links and joints of an MJCF file."""
    mujoco = _package(path)
    model, keys, tendons = _compiled(mujoco, path)
    return _links(model, mujoco, str(path), keys, tendons)


Shapes: TypeAlias = "list[tuple[str, Any, dict[str, Any]]]"
Corners: TypeAlias = "dict[str, npt.NDArray[np.float32]]"


def looks(path: Path) -> tuple[Tree, Shapes, Corners]:
    """Return the tree, the shapes of each body to look at (groups 0 to 2), and the corners (k, 3, 3) of the meshes.

    Raises:
        InputError: A mesh is missing, or it is no model; the message says what MuJoCo said.
    """
    tree, shapes, corners = _geoms(path, "looks", lambda model, g: int(model.geom_group[g]) <= 2)
    return tree, [shape for shape in shapes if shape[2]["kind"] != "ellipsoid"], corners


def solids(path: Path) -> tuple[Tree, Shapes, Corners]:
    """Return the same of the shapes that can touch something: those with a contype or a conaffinity.

    Raises:
        InputError: As for `looks`.
    """
    return _geoms(path, "shapes", lambda model, g: bool(model.geom_contype[g] or model.geom_conaffinity[g]))


def _geoms(path: Path, what: str, wanted: Callable[[Any, int], bool]) -> tuple[Tree, Shapes, Corners]:
    mujoco = _package(path)
    try:
        model: Any = mujoco.MjModel.from_xml_path(str(path))
    except (ValueError, RuntimeError, TypeError) as error:
        reason = " ".join(str(error).split())
        raise InputError(f"{path}: its {what} cannot be read: {reason[:300]}", file=str(path)) from None
    bodies = body_names(model)
    kinds = {
        int(mujoco.mjtGeom.mjGEOM_BOX): "box",
        int(mujoco.mjtGeom.mjGEOM_CYLINDER): "cylinder",
        int(mujoco.mjtGeom.mjGEOM_CAPSULE): "capsule",
        int(mujoco.mjtGeom.mjGEOM_SPHERE): "sphere",
        int(mujoco.mjtGeom.mjGEOM_ELLIPSOID): "ellipsoid",
        int(mujoco.mjtGeom.mjGEOM_MESH): "mesh",
    }
    found: Shapes = []
    triangles: Corners = {}
    for g in range(model.ngeom):
        kind = kinds.get(int(model.geom_type[g]))
        if kind is None or not wanted(model, g) or int(model.geom_bodyid[g]) == 0:
            continue
        size = [float(v) for v in model.geom_size[g]]
        material = int(model.geom_matid[g])
        rgba = model.mat_rgba[material] if material >= 0 else model.geom_rgba[g]
        colour = tuple(float(v) for v in rgba)
        T = _pose(model.geom_pos[g], model.geom_quat[g])
        body = bodies[model.geom_bodyid[g]]
        if kind == "mesh":
            name, corners = _triangles(model, int(model.geom_dataid[g]))
            triangles[name] = corners
            found.append((body, T, {"kind": kind, "size": (1.0, 1.0, 1.0), "mesh": name, "colour": colour}))
            continue
        sizes = {
            "box": tuple(2 * v for v in size),
            "cylinder": (size[0], 2 * size[1]),
            "capsule": (size[0], 2 * size[1]),
            "sphere": (size[0],),
            "ellipsoid": tuple(2 * v for v in size),
        }
        found.append((body, T, {"kind": kind, "size": sizes[kind], "colour": colour}))
    return _links(model, mujoco, str(path)), found, triangles


def _triangles(model: Any, mesh: int) -> tuple[str, npt.NDArray[np.float32]]:
    first, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    points = np.array(model.mesh_vert[first : first + count], np.float32)
    face, faces = int(model.mesh_faceadr[mesh]), int(model.mesh_facenum[mesh])
    return model.mesh(mesh).name or f"mesh_{mesh}", points[np.array(model.mesh_face[face : face + faces])]


def _package(path: Path) -> Any:
    try:
        import mujoco  # pyright: ignore[reportMissingImports]
    except ImportError:
        raise InputError(
            f"{path}: reading MJCF needs an extra: pip install 'pieper[mujoco]'.", file=str(path)
        ) from None
    return mujoco


def compiled(mujoco: Any, path: str | Path) -> Any:
    """Return the compiled model of an MJCF file, read by the package `mujoco` without shapes and masses.

    Raises:
        InputError: It is no model; the message says what MuJoCo said.
    """
    return _compiled(mujoco, path)[0]


def _compiled(mujoco: Any, path: str | Path) -> tuple[Any, dict[str, list[float]], list[str]]:
    """Return the model, its keyframes (name -> `qpos`), and the names of tendons through space that tie something."""
    try:
        spec: Any = mujoco.MjSpec.from_file(str(path))  # pyright: ignore[reportAttributeAccessIssue]
        keys = {key.name or f"key_{i}": [float(v) for v in key.qpos] for i, key in enumerate(spec.keys)}
        tendons = without_space_tendons(spec, mujoco)
        for kind in _UNNEEDED:
            for element in list(getattr(spec, kind, ())):
                spec.delete(element)
        for body in spec.bodies:
            if body.name != "world":
                body.mass, body.inertia, body.explicitinertial = 1.0, [1.0, 1.0, 1.0], True
                body.fullinertia = [np.nan] * 6  # a matrix beside the diagonal would be one too many
        return spec.compile(), keys, tendons
    except (ValueError, RuntimeError, TypeError) as error:
        reason = " ".join(str(error).split())
        raise InputError(f"{path}: MuJoCo cannot read this model: {reason[:300]}", file=str(path)) from None


def _links(
    model: Any, mujoco: Any, file: str, keys: dict[str, list[float]] | None = None, tendons: Sequence[str] = ()
) -> Tree:
    """Return the tree of a compiled model; a body with several joints becomes several links."""
    kinds = {
        int(mujoco.mjtJoint.mjJNT_HINGE): "revolute",
        int(mujoco.mjtJoint.mjJNT_SLIDE): "prismatic",
        int(mujoco.mjtJoint.mjJNT_BALL): "ball",
        int(mujoco.mjtJoint.mjJNT_FREE): "floating",
    }
    bodies = body_names(model)
    ties = ties_of(model, mujoco)
    joints: list[Joint] = []
    frames: dict[str, tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]] = {}

    def add(joint: Joint, T: npt.NDArray[np.float64], axis: npt.NDArray[np.float64]) -> None:
        joints.append(joint)
        frames[joint.name] = (T, axis)

    for i in range(1, model.nbody):
        parent = bodies[model.body_parentid[i]]
        pending = _pose(model.body_pos[i], model.body_quat[i])
        first, count = int(model.body_jntadr[i]), int(model.body_jntnum[i])
        for j in range(first, first + count):
            name, held = name_of(model, j), ties.held.get(j)
            kind = kinds[int(model.jnt_type[j])]
            at = _pose(model.jnt_pos[j], [1.0, 0.0, 0.0, 0.0])
            link = f"{bodies[i]}/{name}"
            lower, upper = (float(v) for v in model.jnt_range[j])
            # MuJoCo passes over a range that is the wrong way round; it is told as in other files
            limited = bool(model.jnt_limited[j]) or lower > upper
            add(
                Joint(
                    name,
                    "fixed" if held is not None else kind if limited or kind != "revolute" else "continuous",
                    parent=parent,
                    child=link,
                    lower=lower if limited else -np.inf,
                    upper=upper if limited else np.inf,
                    mimic=ties.mimics.get(j),
                    held=held,
                    bound=ties.bound.get(j, ""),
                ),
                pending @ at @ _moved_to(model, j, kind, held or 0.0),
                np.array(model.jnt_axis[j], float),
            )
            parent, pending = link, _pose(-model.jnt_pos[j], [1.0, 0.0, 0.0, 0.0])
        add(Joint(f"body {bodies[i]}", "fixed", parent=parent, child=bodies[i]), pending, np.zeros(3))
    for i in range(model.nsite):
        site = model.site(i).name
        if site and site not in bodies:
            parent = bodies[model.site_bodyid[i]]
            add(
                Joint(f"site {site}", "fixed", parent=parent, child=site),
                _pose(model.site_pos[i], model.site_quat[i]),
                np.zeros(3),
            )
    postures = {
        name: {name_of(model, j): qpos[model.jnt_qposadr[j]] for j in range(model.njnt)}
        for name, qpos in (keys or {}).items()
        if len(qpos) == model.nq
    }
    through = tuple(f"A constraint on the tendon {name!r}, through space, was not read." for name in tendons)
    tree = Tree(
        file,
        model.names[: model.names.find(b"\0")].decode() or "arm",
        "MJCF",
        bodies,
        joints,
        lambda j: frames[j.name],
        lambda asked: (*remarks(tree, ties, bodies, asked), *through),
        postures,
    )
    return tree


def _moved_to(model: Any, joint: int, kind: str, value: float) -> npt.NDArray[np.float64]:
    """Return the motion from a model's reference posture, in which its bodies are said, to a value of the joint."""
    if kind not in ("revolute", "prismatic"):
        return np.eye(4)
    axis, by = np.array(model.jnt_axis[joint], float), value - float(model.qpos0[model.jnt_qposadr[joint]])
    return transform(p=by * axis) if kind == "prismatic" else transform(rotation_about(axis, by))


def _pose(position: Any, quaternion: Any) -> npt.NDArray[np.float64]:
    T = np.eye(4)
    T[:3, :3] = rotation("quaternion_wxyz", [float(v) for v in quaternion])
    T[:3, 3] = position
    return T
