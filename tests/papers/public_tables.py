"""The public pages about a KUKA KR210 and a student's Puma again in plain NumPy, as `public_pages` has others."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy import arccos, arctan2, cos, hypot, sin, sqrt

from tests.papers.public_pages import Checks, H, Rows, chain, entries, equal, joints, letters, same


def kr210(q: np.ndarray) -> list[np.ndarray]:
    rows = [(0, 0, 0.75, 0), (0.35, -H, 0, -H), (1.25, 0, 0, 0), (-0.054, -H, 1.5, 0), (0, H, 0, 0), (0, -H, 0, 0)]
    return chain([(a, x, d, (k, z)) for k, (a, x, d, z) in enumerate(rows)], q, "modified")


def kr210_euler() -> Checks:
    q = joints(6)
    F = kr210(q)
    R = (np.linalg.inv(F[3]) @ F[6])[:, :3, :3]
    yield "theta6", same(arctan2(R[:, 1, 0], R[:, 0, 0]), q[:, 5])
    yield "theta5", same(arctan2(-R[:, 2, 0], hypot(R[:, 0, 0], R[:, 1, 0])), q[:, 4])
    yield "theta4", same(arctan2(R[:, 2, 1], R[:, 2, 2]), q[:, 3])
    turn = np.array([[0.0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, 0.303], [0, 0, 0, 1]])
    at_zero = kr210(np.zeros((1, 6)))[6][0] @ turn
    right = np.array([[1, 0, 0, 2.153], [0, 1, 0, 0], [0, 0, 1, 1.946], [0, 0, 0, 1]])
    yield "T_total at zero", np.array([np.allclose(at_zero, right, atol=1e-9)])
    T = F[6] @ turn
    yield "the wrist centre from the gripper's pose", equal(F[6][:, 0, 3], T[:, 0, 3] - 0.303 * T[:, 0, 0])


def kr210_writeup() -> Checks:
    q = joints(6)
    F = kr210(q)
    c, s = cos(q[:, 5]), sin(q[:, 5])
    given = [[c, -s, 0, 0], [0, 0, 1, 0.303], [-s, -c, 0, 0]]
    yield "T5_6", entries(np.linalg.inv(F[5]) @ F[6], given)
    c, s = cos(q[:, 1] - H), sin(q[:, 1] - H)
    yield "T1_2", entries(np.linalg.inv(F[1]) @ F[2], [[c, -s, 0, 0.35], [0, 0, 1, 0], [-s, -c, 0, 0]])


def kr210_lengths() -> Checks:
    yield "d1", equal(0.330 + 0.42, 0.75)
    yield "d4", equal(0.960 + 0.54, 1.5)
    yield "d7", equal(0.193 + 0.11, 0.303)
    F = kr210(joints(6))
    x = (np.linalg.inv(F[3]) @ F[4])[:, 0, 3]
    yield "a3, in the list", equal(x, -0.0054)
    yield "a3, in the table", equal(x, -0.054)
    q4, c, s = joints(6)[:, 3], cos(1.5), sin(1.5)
    name = "row 4 of the numeric table, its columns as printed"
    yield name, entries(np.linalg.inv(F[3]) @ F[4], [[c, -s, 0, -0.054], [0, 0, 1, q4], [-s, -c, 0, 0]])
    wrist = kr210(np.zeros((1, 6)))[5][0, :3, 3]
    name = "the wrist with all joints at zero, from the description's distances"
    yield name, np.array([np.allclose(wrist, [0.35 + 0.96 + 0.54, 0, 0.33 + 0.42 + 1.25 - 0.054])])


D1, LINK, OFFSET = 0.67, 0.4318, 0.15005  # the student's Puma: both links are equally long


def student(q: np.ndarray) -> list[np.ndarray]:
    rows: Rows = [(0, H, D1, (0, 0.0)), (LINK, 0, 0, (1, 0.0)), (LINK, -H, OFFSET, (2, 0.0))]
    rows += [(0, H, 0, (3, 0.0)), (0, -H, 0, (4, 0.0)), (0, 0, 0, (5, 0.0))]
    return chain(rows, q, "standard")


def solved(T: np.ndarray) -> list[np.ndarray]:
    """Eight joint vectors a pose by the law of cosines: shoulder, elbow, and the wrist's two ways."""
    x, y, z = T[:, 0, 3], T[:, 1, 3], T[:, 2, 3] - D1
    reach, out = sqrt(x**2 + y**2 - OFFSET**2), []
    for shoulder in (1, -1):
        t1, r = arctan2(y, x) - arctan2(-OFFSET, shoulder * reach), shoulder * reach
        for elbow in (1, -1):
            t3 = elbow * arccos(np.clip((r**2 + z**2) / (2 * LINK**2) - 1, -1, 1))
            t2 = arctan2(z, r) - t3 / 2  # of two equal links
            arm = np.stack([t1, t2, t3, *3 * [0 * t1]], axis=1)
            R = np.linalg.inv(student(arm)[3]) @ T
            for wrist in (1, -1):
                t4 = arctan2(-wrist * R[:, 1, 2], -wrist * R[:, 0, 2])
                t5 = wrist * arctan2(hypot(R[:, 0, 2], R[:, 1, 2]), R[:, 2, 2])
                t6 = arctan2(-wrist * R[:, 2, 1], wrist * R[:, 2, 0])
                out.append(np.stack([t1, t2, t3, t4, t5, t6], axis=1))
    return out


def puma_project() -> Checks:
    q = joints(6)
    F = student(q)
    P = letters(F[-1])
    root = sqrt(P["px"] ** 2 + P["py"] ** 2 - OFFSET**2)
    one, two = (same(arctan2(P["py"], P["px"]) - arctan2(-OFFSET, s * root), q[:, 0]) for s in (1, -1))
    yield "theta1 has two solutions", one | two
    rows = solved(F[-1])
    reach = [np.abs(student(row)[-1] - F[-1]).max(axis=(1, 2)) < 1e-6 for row in rows]
    apart = [np.abs(np.exp(1j * a) - np.exp(1j * b)).max(axis=1) > 1e-6 for k, a in enumerate(rows) for b in rows[:k]]
    eight = np.all([*reach, *apart], axis=0)
    assert eight.all()
    yield "only two solutions", ~eight
    yield "the wrist's centre is the origin of frame 3", entries(F[3][:, :, 3:], [[P["px"]], [P["py"]], [P["pz"]]])
    yield "the position stands in (4,1)", equal(F[-1][:, 3, 0], P["px"])
    yield "the position stands in (1,4) (not on the page)", equal(F[-1][:, 0, 3], P["px"])
    yield "singular where the wrist centre lies on axis 1", hypot(P["px"], P["py"]) < OFFSET - 1e-9


TABLES: dict[str, Callable[[], Checks]] = {
    f.__name__: f for f in (kr210_euler, kr210_writeup, kr210_lengths, puma_project)
}
