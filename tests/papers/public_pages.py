"""The formulas of the public pages once more in plain NumPy, typed from the pages and not from the claims files.

Each entry says at which of some random joint vectors a formula gives what it should; the verdicts are held against it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy import arccos, arcsin, arctan, arctan2, cos, hypot, sin, sqrt

from oracle.joints import turns_apart

COUNT = 400
Rows = list[tuple[float, float, float, Any]]
Checks = Iterator[tuple[str, np.ndarray]]


def chain(rows: Rows, q: np.ndarray, kind: str, tool: np.ndarray | None = None) -> list[np.ndarray]:
    """Frames 0 .. n of a table of (a, alpha, d, theta), a variable being (joint, sign, zero); and the tool's."""
    T = [np.broadcast_to(np.eye(4), (len(q), 4, 4))]
    for a, alpha, d, theta in rows:
        d = q[:, d[0]] if isinstance(d, tuple) else np.full(len(q), float(d))
        theta = q[:, theta[0]] + theta[1] if isinstance(theta, tuple) else np.full(len(q), float(theta))
        Z, X = np.zeros((len(q), 4, 4)), np.eye(4)
        Z[:, 0, 0], Z[:, 0, 1], Z[:, 1, 0], Z[:, 1, 1] = cos(theta), -sin(theta), sin(theta), cos(theta)
        Z[:, 2, 2] = Z[:, 3, 3] = 1
        Z[:, 2, 3] = d
        X[1:3, 1:3] = [[cos(alpha), -sin(alpha)], [sin(alpha), cos(alpha)]]
        X[0, 3] = a
        T.append(T[-1] @ (Z @ X if kind == "standard" else X @ Z))
    return [*T, T[-1] @ (np.eye(4) if tool is None else tool)]


def joints(n: int, slides: tuple[int, ...] = (), seed: int = 5) -> np.ndarray:
    rng = np.random.default_rng(seed)
    q = rng.uniform(-np.pi, np.pi, (COUNT, n))
    for j in slides:
        q[:, j] = rng.uniform(0.1, 0.8, COUNT)
    return q


def same(value: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    with np.errstate(invalid="ignore"):
        return turns_apart(value, wanted) < 1e-8


def equal(value: Any, wanted: Any) -> np.ndarray:
    with np.errstate(invalid="ignore"):
        return np.abs(np.broadcast_to(value - wanted, (COUNT,))) < 1e-9


def entries(M: np.ndarray, given: list[list[Any]]) -> np.ndarray:
    good = np.ones(len(M), dtype=bool)
    for i, row in enumerate(given):
        for j, cell in enumerate(row):
            good &= np.abs(M[:, i, j] - cell) < 1e-9
    return good


def letters(T: np.ndarray) -> dict[str, np.ndarray]:
    out = {f"r{i + 1}{j + 1}": T[:, i, j] for i in range(3) for j in range(4)}
    return out | {a + b: T[:, i, j] for j, a in enumerate("noap") for i, b in enumerate("xyz")}


H = np.pi / 2


def puma_course() -> Checks:
    q = joints(6)
    a2, a3, d3, d4 = 0.4318, 0.0203, 0.1244, 0.4331
    rows = [(0, 0, 0, 0), (0, -H, 0, 1), (a2, 0, d3, 2), (a3, -H, d4, 3), (0, H, 0, 4), (0, -H, 0, 5)]
    P = letters(chain([(a, x, d, (k, 0.0)) for a, x, d, k in rows], q, "modified")[-1])
    r11, r13, r21, r23, r31, r33 = (P[k] for k in ("r11", "r13", "r21", "r23", "r31", "r33"))
    (c1, _, _, c4, c5, c6), (s1, _, _, s4, s5, s6) = cos(q).T, sin(q).T
    c23, s23 = cos(q[:, 1] + q[:, 2]), sin(q[:, 1] + q[:, 2])
    t4 = arctan2(c1 * r23 - r13 * s1, -c1 * c23 * r13 - c23 * r23 * s1 + r33 * s23)
    yield "theta4", same(t4, q[:, 3])
    yield "theta4, where s5 is positive", same(t4, q[:, 3])[s5 > 0]
    k5 = -c23 * r33 - c1 * r13 * s23 - r23 * s1 * s23
    n5 = -c1 * c23 * c4 * r13 - s1 * s4 * r13 - c23 * c4 * r23 * s1 + c4 * r33 * s23 + c1 * r23 * s4
    yield "c5", equal(k5, c5)
    yield "s5", equal(n5, s5)
    yield "theta5", same(arctan2(n5, k5), q[:, 4])
    k6 = c5 * (c4 * (c1 * c23 * r11 + c23 * r21 * s1 - r31 * s23) - (c1 * r21 - r11 * s1) * s4)
    k6 = k6 + (-c23 * r31 - c1 * r11 * s23 - r21 * s1 * s23) * s5
    n6 = -c1 * c4 * r21 - c23 * s1 * s4 * r21 + c4 * r11 * s1 - c1 * c23 * r11 * s4 + r31 * s23 * s4
    yield "c6", equal(k6, c6)
    yield "s6", equal(n6, s6)
    yield "theta6", same(arctan2(n6, k6), q[:, 5])


def six_axis_ur() -> Checks:
    q = joints(6)
    d1, d2, a2, d3, a3, d4, d5 = 94.5, 130.5, 425, 120, 392.5, 93, 93

    def at(twists: tuple[float, ...]) -> dict[str, np.ndarray]:
        lengths = [(0, d1), (0, d2), (a2, d3), (a3, d4), (0, d5), (0, 0)]
        rows: Rows = [(a, x, d, (k, 0.0)) for k, ((a, d), x) in enumerate(zip(lengths, twists, strict=True))]
        return letters(chain(rows, q, "modified")[-1])

    E = d2 + d3 + d4
    t1, t2, t3, t4, t5, t6 = q.T
    for twists, more in (((0, -H, 0, -H, -H, 0), ", table of the file"), ((0, -H, 0, 0, -H, -H), "")):
        P = at(twists)
        F = sqrt(P["px"] ** 2 + P["py"] ** 2 - E**2 + 0j).real
        yield f"theta1{more}", same(arctan2(P["py"], P["px"]) - arctan2(E, -F), t1)
        m = (-P["nx"] * sin(t1) + P["ny"] * cos(t1)) ** 2 + (-P["ox"] * sin(t1) + P["oy"] * cos(t1)) ** 2
        s5 = -sqrt(m)
        yield f"theta5{more}", same(arctan2(s5, P["ax"] * sin(t1) - P["ay"] * cos(t1)), t5)
    other = same(arctan2(P["py"], P["px"]) - arctan2(E, F), t1)
    yield "theta1, both roots", other | same(arctan2(P["py"], P["px"]) - arctan2(E, -F), t1)
    low = sin(t5) < 0
    y, x = (-P["ox"] * sin(t1) + P["oy"] * cos(t1)) / s5, (P["nx"] * sin(t1) - P["ny"] * cos(t1)) / s5
    yield "theta6", same(arctan2(y, x), t6)[low]
    both = arctan2(P["az"] / s5, -(P["ax"] * cos(t1) + P["ay"] * sin(t1)) / s5)
    yield "theta234", same(both, t2 + t3 + t4)[low]
    N = P["pz"] - d1 + d5 * cos(t2 + t3 + t4)
    M = P["px"] * cos(t1) + P["py"] * sin(t1) + d5 * sin(t2 + t3 + t4)
    A, B, C = 2 * a2 * N, 2 * a2 * M, M**2 + N**2 + a2**2 - a3**2
    root = sqrt(np.maximum(A**2 + B**2 - C**2, 0))
    one, two = (same(arctan2(B, A) - arctan2(C, s * root), t2) for s in (1, -1))
    yield "theta2", one
    yield "theta2, both roots", one | two
    yield "theta23", same(arctan2(-(N + a2 * sin(t2)) / a3, (M - a2 * cos(t2)) / a3), t2 + t3)


def ur5e_numpy() -> Checks:
    q = joints(6)
    A, D = [0, -0.425, -0.3922], [0.1625, 0, 0, 0.1333, 0.0997, 0.0996]
    rows = [(0, 0, D[0]), (0, H, 0), (A[1], 0, 0), (A[2], 0, D[3]), (0, H, D[4]), (0, -H, D[5])]
    F = chain([(a, x, d, (k, 0.0)) for k, (a, x, d) in enumerate(rows)], q, "modified")
    T, t1, t2, t3, t4, t5, t6 = F[-1], *q.T
    p = (T @ [0, 0, -D[5], 1])[:, :3]
    phi, rest = arctan2(p[:, 1], p[:, 0]) + H, arccos(D[3] / hypot(p[:, 1], p[:, 0]))
    yield "th1", same(phi + rest, t1) | same(phi - rest, t1)
    c5 = arccos(np.clip((T[:, 0, 3] * sin(t1) - T[:, 1, 3] * cos(t1) - D[3]) / D[5], -1, 1))
    yield "th5", same(c5, t5) | same(-c5, t5)
    X, Y = np.linalg.inv(T)[:, :3, 0], np.linalg.inv(T)[:, :3, 1]
    y, x = -X[:, 1] * sin(t1) + Y[:, 1] * cos(t1), X[:, 0] * sin(t1) - Y[:, 0] * cos(t1)
    yield "th6", same(arctan2(y / sin(t5), x / sin(t5)), t6)
    p = (np.linalg.inv(F[1]) @ F[4])[:, :3, 3]
    far = hypot(p[:, 0], p[:, 2])
    c3 = arccos(np.clip((far**2 - A[1] ** 2 - A[2] ** 2) / (2 * A[1] * A[2]), -1, 1))
    yield "th3", np.abs(cos(c3) - cos(t3)) < 1e-9
    yield "th2, this arm", same(arctan2(-p[:, 2], -p[:, 0]) - arcsin(-A[2] * sin(t3) / far), t2)
    M = np.linalg.inv(F[3]) @ F[4]
    yield "th4", same(arctan2(M[:, 1, 0], M[:, 0, 0]), t4)


def three_links(d1: float, l2: float, l3: float) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    q = joints(3)
    rows: Rows = [(0, H, d1, (0, 0.0)), (l2, 0, 0, (1, 0.0)), (l3, 0, 0, (2, 0.0))]
    return q, letters(chain(rows, q, "standard")[-1])


def three_r_matlab() -> Checks:
    d1, l2, l3 = 0.3, 0.25, 0.2
    q, P = three_links(d1, l2, l3)
    t1, t2, t3 = q.T
    c3 = (P["px"] ** 2 + P["py"] ** 2 + (P["pz"] - d1) ** 2 - l2**2 - l3**2) / (2 * l2 * l3)
    root = sqrt(np.maximum(1 - c3**2, 0))
    yield "c3", equal(c3, cos(t3))
    yield "theta3", same(arctan2(-root, c3), t3)
    yield "theta1", same(arctan2(P["py"], P["px"]), t1)
    A = np.array([[l2 + l3 * cos(t3), -l3 * sin(t3)], [l3 * sin(t3), l2 + l3 * cos(t3)]]).transpose(2, 0, 1)
    b = np.array([cos(t1) * P["px"] + sin(t1) * P["py"], P["pz"] - d1]).T
    S = np.linalg.solve(A, b[..., None])[..., 0]
    yield "theta2", same(arctan2(S[:, 1], S[:, 0]), t2)


def two_links_readme() -> Checks:
    q, (L1, L2) = joints(2), (0.3, 0.25)
    P = letters(chain([(L1, 0, 0, (0, 0.0)), (L2, 0, 0, (1, 0.0))], q, "standard")[-1])
    D = hypot(P["px"], P["py"])
    k = (L1**2 + L2**2 - D**2) / (2 * L1 * L2)
    yield "theta2", same(arccos(np.clip(k, -1, 1)), q[:, 1])
    yield "theta2, cosine", equal(k, cos(q[:, 1]))
    yield "a", equal(arctan(P["py"] / P["px"]), arctan2(P["py"], P["px"]))
    beta = arccos(np.clip((L1**2 + D**2 - L2**2) / (2 * L1 * D), -1, 1))
    yield "alpha", same(arctan(P["py"] / P["px"]) - beta, q[:, 0])


def surrey_coursework() -> Checks:
    q = joints(6)
    d2, a2, d4, d6 = 0.25, 0.5, 1, 0.5
    rows = [(0, -H, 0), (a2, 0, d2), (0, H, 0), (0, -H, d4), (0, H, 0), (0, 0, d6)]
    P = letters(chain([(a, x, d, (k, 0.0)) for k, (a, x, d) in enumerate(rows)], q, "standard")[-1])
    t1, t2, t3, t4, t5, t6 = q.T
    x, y, z = (P["p" + b] - d6 * P["a" + b] for b in "xyz")
    root = sqrt(x**2 + y**2 - d2**2)
    one, two = (same(arctan2(y, x) - arctan2(d2, s * root), t1) for s in (1, -1))
    yield "theta1", one
    yield "theta1, with the sign changed as the program does", one | two
    A = cos(t1) * x + sin(t1) * y
    for a, name in ((a2, "theta2, this arm"), (0.4, "theta2, another arm")):
        rows[1] = (a, 0, d2)
        P2 = letters(chain([(b, w, d, (k, 0.0)) for k, (b, w, d) in enumerate(rows)], q, "standard")[-1])
        u, v, w = (P2["p" + b] - d6 * P2["a" + b] for b in "xyz")
        G = cos(t1) * u + sin(t1) * v
        B = G**2 + w**2 + a**2 - d4**2
        r = sqrt(np.maximum(G**2 + w**2 - B**2, 0))
        yield name, same(arctan2(G, w) - arctan2(B, r), t2) | same(arctan2(G, w) - arctan2(B, -r), t2)
    yield "theta3", same(arctan2(A - a2 * cos(t2), z + a2 * sin(t2)) - t2, t3)
    c1, s1, c23, s23 = cos(t1), sin(t1), cos(t2 + t3), sin(t2 + t3)
    u, v = -s1 * P["ax"] + c1 * P["ay"], c23 * (c1 * P["ax"] + s1 * P["ay"]) - s23 * P["az"]
    yield "theta4", same(arctan2(u, v), t4)
    yield "theta5", same(arctan2(hypot(u, v), s23 * (c1 * P["ax"] + s1 * P["ay"]) + c23 * P["az"]), t5)
    u = s23 * (c1 * P["ox"] + s1 * P["oy"]) + c23 * P["oz"]
    v = -(s23 * (c1 * P["nx"] + s1 * P["ny"]) + c23 * P["nz"])
    yield "theta6", same(arctan2(u, v), t6)


def scara_paste() -> Checks:
    q = joints(4, slides=(2,))
    rows: Rows = [(1, 0, 0.9, (0, 0.0)), (1, np.pi, 0, (1, 0.0)), (0, 0, (2,), 0.0), (0, 0, 0, (3, 0.0))]
    P = letters(chain(rows, q, "standard")[-1])
    x, y, psi = P["px"], P["py"], arctan2(P["r21"], P["r11"])
    t1, t2, d3, t4 = q.T
    yield "t2", np.abs(cos(t2) - (x**2 + y**2 - 2) / 2) < 1e-9
    yield "t1", same(arctan2(y, x) - arctan2(sin(t2), 1 + cos(t2)), t1)
    yield "d3", equal(0.9 - P["pz"], d3)
    yield "t4", same(psi + t2 + t1, t4)
    yield (
        "t4, with psi measured about the tool's own axis, which points down (not said there)",
        same(-psi + t2 + t1, t4),
    )


def rrr_paste() -> Checks:
    l1, l2, l3 = 3, 3, 2
    q, P = three_links(l1, l2, l3)
    t1, t2, t3 = q.T
    r, z = P["px"] * cos(t1) + P["py"] * sin(t1), P["pz"]
    A, B, C = -2 * l3 * r, -2 * l3 * (z - l1), r**2 + (z - l1) ** 2 + l3**2 - l2**2
    yield "the equation", equal(A * cos(t2 + t3) + B * sin(t2 + t3) + C, 0)
    arc, psi = arccos(np.clip(-C / hypot(A, B), -1, 1)), arctan2(B, A)
    yield "theta23", same(psi + arc, t2 + t3) | same(psi - arc, t2 + t3)
    cut = [same(np.fmod(psi + s * arc, np.pi), t2 + t3) for s in (1, -1)]
    yield "theta23, with fmod(.., pi)", cut[0] | cut[1]
    yield "theta2", same(arctan2(z - l1 - l3 * sin(t2 + t3), r - l3 * cos(t2 + t3)), t2)


def rrr_degrees() -> Checks:
    d1, a2, a3 = 2, 3, 5
    q, P = three_links(d1, a2, a3)
    r, k = hypot(P["px"], P["py"]), arctan2(a3 * sin(q[:, 2]), a2 + a3 * cos(q[:, 2]))
    D = (r**2 + (P["pz"] - d1) ** 2 - a2**2 - a3**2) / (2 * a2 * a3)
    yield "th3", np.abs(D - cos(q[:, 2])) < 1e-9
    yield "th2_UP", same(arctan2(P["pz"] - d1, sqrt(r)) - k, q[:, 1])
    yield "th2, with r (not in the script)", same(arctan2(P["pz"] - d1, r) - k, q[:, 1])
    yield "th1", same(arctan2(P["py"], P["px"]), q[:, 0])


def three_r_question() -> Checks:
    q, (l1, l2) = joints(3), (0.4, 0.3)
    rows: Rows = [(0, 0, 0, (0, 0.0)), (l1, H, 0, (1, 0.0)), (l2, 0, 0, (2, 0.0))]
    T = chain(rows, q, "modified")[-1]
    (c1, c2, _), (s1, s2, _) = cos(q).T, sin(q).T
    c23, s23 = cos(q[:, 1] + q[:, 2]), sin(q[:, 1] + q[:, 2])
    first = [[c1 * c23, -c1 * c23, s1, l1 * s1 - l2 * c1 * s2], [s1 * c23, -s1 * s23, -c1, l1 * c1 - l2 * s1 * s2]]
    yield "0T3", entries(T, [*first, [s23, c23, 0, l2 * s2]])
    right = [[c1 * c23, -c1 * s23, s1, l1 * c1 + l2 * c1 * c2], [s1 * c23, -s1 * s23, -c1, l1 * s1 + l2 * s1 * c2]]
    yield "0T3, last column put right (not on the page)", entries(T, right)


def robotic_dog() -> Checks:
    q, (a1, a2, a3) = joints(3), (0.05, 0.12, 0.13)
    rows: Rows = [(a1, H, 0, (0, H)), (a2, 0, 0, (1, 0.0)), (a3, -H, 0, (2, 0.0))]
    F = chain(rows, q, "standard")
    (c1, _, c3), (s1, _, s3) = cos(q).T, sin(q).T
    A3 = np.linalg.inv(F[2]) @ F[3]
    yield "R0_1", entries(F[1], [[-s1, 0, c1], [c1, 0, s1], [0, 1, 0]])
    yield "R2_3", entries(A3, [[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    yield "D0_1", equal(F[1][:, 0, 3], a1 * c1) & equal(F[1][:, 1, 3], a1 * s1)
    yield "D2_3", equal(A3[:, 0, 3], a3 * c3) & equal(A3[:, 1, 3], a3 * s3)


def slide_turn_slide() -> Checks:
    q, a2 = joints(3, slides=(0, 2)), 0.3
    P = letters(chain([(0, 0, (0,), 0.0), (0, -H, 0, (1, 0.0)), (-a2, 0, (2,), 0.0)], q, "modified")[-1])
    yield "q3", equal(P["py"], q[:, 2])
    yield "cos_q2", equal(-P["px"] / a2, cos(q[:, 1]))
    yield "q1_1", equal(P["pz"] + a2 * sin(q[:, 1]), q[:, 0])
    yield "q1_2", equal(P["pz"] - a2 * sin(q[:, 1]), q[:, 0])


def simple_manipulator() -> Checks:
    q, (L1, L2, L3) = joints(3), (0.2, 0.3, 0.25)
    rows: Rows = [(0, 0, L1, (0, 0.0)), (0, H, 0, (1, H)), (L2, 0, 0, (2, 0.0)), (L3, 0, 0, 0.0)]
    P = letters(chain(rows, q, "modified")[-1])
    (c1, c2, c3), (s1, s2, s3) = cos(q).T, sin(q).T
    yield "x", equal((L3 * c3 + L2) * c1 * c2 - L3 * s3 * c1 * s2, P["px"])
    yield "y", equal((L3 * c3 + L2) * s1 * c2 - L3 * s3 * s1 * s2, P["py"])
    yield "z", equal((L3 * c3 + L2) * s2 + L3 * s3 * c2 + L1, P["pz"])


def ur5_review() -> Checks:
    q, (d1, a2, a3, d4, d5, d6) = joints(6), (0.089159, -0.425, -0.39225, 0.10915, 0.09465, 0.0823)
    rows = [(0, H, d1), (a2, 0, 0), (a3, 0, 0), (0, H, d4), (0, -H, d5), (0, 0, d6)]
    F = chain([(a, x, d, (k, 0.0)) for k, (a, x, d) in enumerate(rows)], q, "standard")
    M = np.linalg.inv(F[3]) @ F[6] @ np.linalg.inv(np.linalg.inv(F[4]) @ F[6])
    yield "theta4, after", same(arctan2(M[:, 1, 0], M[:, 0, 0]), q[:, 3])
    p = (np.linalg.inv(F[1]) @ F[4])[:, :3, 3]
    far = hypot(p[:, 0], p[:, 1])
    yield "theta2, this arm", same(arctan2(-p[:, 1], -p[:, 0]) - arcsin(-a3 * sin(q[:, 2]) / far), q[:, 1])


def quadruped_thread() -> Checks:
    h, hu, hl = 5, 20, 20
    base = np.array([[0, 0, 1.0, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]])

    def foot(*angles: float) -> np.ndarray:
        rows: Rows = [(0, H, 0, (0, -H)), (hu, 0, h, (1, 0.0)), (hl, 0, 0, (2, 0.0))]
        return (base @ chain(rows, np.radians([angles]), "standard")[-1][0])[:3, 3]

    yield "all motors at zero, left leg", np.array([np.allclose(foot(0, 0, 0), [0, 5, -40])])
    yield "all motors at zero, right leg", np.array([np.allclose(foot(0, 0, 0), [0, -5, -40])])
    name = "the inverse program's answer, right leg: alpha = -45, beta = 0.0346566 degrees"
    yield name, np.array([np.allclose(foot(0, -45, 0.0346566), [0, -5, -40], atol=0.5)])


def quaternion_paste() -> Checks:
    rows: Rows = [(0, -H, 290, (0, 0.0)), (0, 0, 0, -H), (270, 0, 0, (1, 0.0)), (70, -H, 0, (2, 0.0))]
    rows += [(0, H, 302, (3, 0.0)), (0, -H, 0, (4, 0.0)), (0, 0, 72, (5, 0.0))]
    at_zero = chain(rows, np.zeros((1, 6)), "standard")[-1][0][:3, 3]
    yield "the pose with all joints at zero", np.array([np.allclose(at_zero, [374, 0, 630])])
    P = letters(chain(rows, joints(6), "standard")[-1])
    w = 0.5 * sqrt(P["r11"] + P["r22"] + P["r33"] + 1)
    x = 0.5 * sqrt(P["r11"] - P["r22"] - P["r33"] + 1) * np.sign(P["r32"] - P["r23"])
    y = 0.5 * sqrt(-P["r11"] + P["r22"] - P["r33"] + 1) * np.sign(P["r13"] - P["r31"])
    z = 0.5 * sqrt(-P["r11"] - P["r22"] + P["r33"] + 1) * np.sign(P["r21"] - P["r12"])
    yield "a unit quaternion", equal(w**2 + x**2 + y**2 + z**2, 1)
    yield "it is the pose's: r21", equal(2 * (x * y + w * z), P["r21"])
    yield "it is the pose's: r13", equal(2 * (x * z + w * y), P["r13"])


PAGES: dict[str, Callable[[], Checks]] = {
    f.__name__: f
    for f in (puma_course, six_axis_ur, ur5e_numpy, three_r_matlab, two_links_readme, surrey_coursework, scara_paste)
}
PAGES |= {f.__name__: f for f in (rrr_paste, rrr_degrees, three_r_question, robotic_dog, slide_turn_slide)}
PAGES |= {f.__name__: f for f in (simple_manipulator, ur5_review, quadruped_thread, quaternion_paste)}
