"""Distances between bodies: each is proved by its points on the one side and by its direction on the other."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

import pieper
from pieper import _kernel
from pieper.tolerances import DISTANCE_ROUNDING

EYE = np.eye(4)
SEGMENT, BOX, CYLINDER = range(3)


def rotation(rng):
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return q * np.sign(np.linalg.det(q))


def placed(rng, spread=0.6):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation(rng), rng.uniform(-spread, spread, 3)
    return T


def kernel_pair(one, other):
    """A chain of one slide, the first body on it and the second in the world."""
    (k1, T1, h1, r1), (k2, T2, h2, r2) = one, other
    slide = _kernel.Forward(np.stack([EYE, EYE]), [1], EYE[None], 1.0)
    model = _kernel.Collision(
        slide, link=[0, 1], place=np.stack([T2, T1]), half=[h2, h1],
        radius=[r2, r1], kind=[k2, k1], pair=[[1, 0]], outer=[0],
    )  # fmt: skip
    d, _, points, normal = model.nearest(np.zeros((3, 1)))
    assert d[0] == d[1] == d[2]
    return d[0], points[0], normal[0]


def support(body, n):
    """How far a body reaches along n, and the point there."""
    kind, T, h, r = body
    seen = T[:3, :3].T @ n
    if kind == CYLINDER:
        flat = np.hypot(*seen[:2])
        local = np.array([*(seen[:2] * (h[0] / flat if flat else 0.0)), np.sign(seen[2]) * h[2]])
    else:
        local = np.sign(seen) * h
    return T[:3, :3] @ local + T[:3, 3] + r * n


def outside(body, point):
    """How far a point is outside a body's core, less its layer."""
    kind, T, h, r = body
    x = T[:3, :3].T @ (point - T[:3, 3])
    if kind == CYLINDER:
        rho = np.hypot(*x[:2])
        return np.hypot(max(rho - h[0], 0), max(abs(x[2]) - h[2], 0)) - r
    return np.linalg.norm(x - np.clip(x, -h, h)) - r


def random_body(rng, kind):
    h = rng.uniform(0.05, 0.4, 3)
    if kind == SEGMENT:
        h[:2] = 0.0
    if kind == CYLINDER:
        h[1] = h[0]
    return kind, placed(rng), h, float(rng.uniform(0.02, 0.1)) if kind == SEGMENT else 0.0


@pytest.mark.parametrize("kinds", [(0, 0), (0, 1), (1, 0), (1, 1), (0, 2), (2, 0)])
def test_a_distance_is_proved_from_both_sides(kinds):
    rng = np.random.default_rng(sum(kinds))
    apart = overlapping = 0
    for _ in range(400):
        one, other = (random_body(rng, kind) for kind in kinds)
        d, (a, b), n = kernel_pair(one, other)
        assert abs(np.linalg.norm(n) - 1) < 1e-14
        assert np.abs((a - b) - d * n).max() < 1e-14
        # from below: along n they are apart by that much; from above: the points belong to the bodies
        assert abs(support(one, -n) @ n - support(other, n) @ n - d) < 1e-13
        if d > 0:
            apart += 1
            assert max(outside(one, a), outside(other, b)) < 1e-13
        else:
            overlapping += 1
            for m in rng.normal(size=(60, 3)):
                m /= np.linalg.norm(m)
                assert support(one, -m) @ m - support(other, m) @ m <= d + 1e-9
    assert apart > 100 and overlapping > 10


def test_segments_next_to_parallel_keep_their_digits():
    rng = np.random.default_rng(5)
    mpmath.mp.dps = 50
    for tilt in (0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3):
        for height in (0.0, 1e-6, 0.1):
            T1, T2 = EYE.copy(), placed(rng, 0.0)
            z = T2[:3, 2]
            side = T2[:3, 0]
            lean = z + tilt * T2[:3, 1]
            lean /= np.linalg.norm(lean)
            x = np.cross(T2[:3, 1], lean)
            x /= np.linalg.norm(x)
            T1[:3, :3] = np.stack([x, np.cross(lean, x), lean], 1)
            T1[:3, 3] = height * side + rng.uniform(-0.1, 0.1) * z
            h1, h2 = np.array([0, 0, 0.3]), np.array([0, 0, 0.4])
            d, _, _ = kernel_pair((0, T1, h1, 0.0), (0, T2, h2, 0.0))
            assert abs(d - float(exact_segments(T1, h1, T2, h2))) < 1e-15


def exact_segments(T1, h1, T2, h2):
    """The distance of two segments in 50 digits: the interior, and each end."""
    c = [mpmath.matrix([mpmath.mpf(x) for x in T[:3, 3]]) for T in (T1, T2)]
    u, v = (mpmath.matrix([mpmath.mpf(x) * mpmath.mpf(h[2]) for x in T[:3, 2]]) for T, h in ((T1, h1), (T2, h2)))
    w = c[0] - c[1]
    dot = lambda a, b: sum(a[i] * b[i] for i in range(3))  # noqa: E731
    A, E, B, C, D = dot(u, u), dot(v, v), dot(u, v), dot(u, w), dot(v, w)
    clip = lambda x: max(mpmath.mpf(-1), min(mpmath.mpf(1), x))  # noqa: E731
    tries = []
    det = A * E - B * B
    if det > mpmath.mpf(10) ** -45:
        s, t = (B * D - C * E) / det, (A * D - B * C) / det
        if abs(s) <= 1 and abs(t) <= 1:
            tries.append((s, t))
    for end in (-1, 1):
        tries += [(mpmath.mpf(end), clip((B * end + D) / E)), (clip((B * end - C) / A), mpmath.mpf(end))]
    return min(mpmath.sqrt(dot(g, g)) for g in (w + s * u - t * v for s, t in tries))


def test_a_sphere_is_a_capsule_of_no_length():
    d, (a, b), n = kernel_pair((0, EYE, np.zeros(3), 0.1), (0, EYE @ shifted(0.5), np.zeros(3), 0.2))
    assert d == pytest.approx(0.2, abs=1e-16)
    assert np.allclose(n, [0, 0, -1]) and np.allclose([a, b], [[0, 0, 0.1], [0, 0, 0.3]])
    d, _, n = kernel_pair((0, EYE, np.zeros(3), 0.1), (0, EYE, np.zeros(3), 0.2))
    assert d == pytest.approx(-0.3) and np.linalg.norm(n) == pytest.approx(1.0)


def shifted(z):
    T = np.eye(4)
    T[2, 3] = z
    return T


def scene():
    return pieper.Scene(
        [
            pieper.Box([0.45, 0.0, 0.1], [0.3, 0.5, 0.2], name="table"),
            pieper.Capsule([0.1, -0.4, 0.0], [0.1, -0.4, 0.7], 0.03, name="post"),
            pieper.Cylinder([-0.3, 0.3, 0.3], 0.05, 0.6),
        ]
    )


@pytest.mark.parametrize("name", ["denso-vp6242", "universal-robots-ur10e", "stanford-arm", "kuka-lbr-iiwa-14-r820"])
def test_the_gradient_is_what_differences_say(name):
    arm, around, h = pieper.load(name), scene(), 1e-6
    rng = np.random.default_rng(2)
    q = rng.uniform(-1, 1, (40, arm.n)) + np.array([0.2 if t == "P" else 0.0 for t in arm.joint_types])
    d = arm.distance(q, around)
    assert d.shape == (40,) and d.gradient.shape == (40, arm.n) and d.pair.shape == (40, 2)
    good = 0
    for j in range(arm.n):
        step = np.zeros(arm.n)
        step[j] = h
        up, down = arm.distance(q + step, around), arm.distance(q - step, around)
        same = (up.pair == d.pair).all(1) & (down.pair == d.pair).all(1)
        smooth = same & (np.abs(up.normal - down.normal).max(1) < 1e-3)
        off = np.abs((up - down) / (2 * h) - d.gradient[:, j])
        assert off[smooth].max() < 1e-5
        good += smooth.sum()
    assert good > 20 * arm.n


def test_a_tool_and_what_it_holds_move_with_the_arm():
    arm = pieper.load("denso-vp6242")
    T = np.eye(4)
    T[2, 3] = 0.2
    held = arm.with_tool(T).with_bodies({"tool": [pieper.Box([0, 0, 0.05], [0.1, 0.1, 0.1], name="part")]})
    assert "part" in held.bodies.names and "part" not in arm.bodies.names
    q = np.radians([0, 90, -180, 0, 0, 0])
    ceiling = pieper.Scene([pieper.Box(held.fk(q) @ shifted(0.125), [0.3, 0.3, 0.06], name="lid")])
    d = held.distance(q, ceiling)
    assert tuple(d.pair) == ("part", "lid") and float(d) == pytest.approx(-0.005, abs=1e-12)
    free = pieper.Scene(list(ceiling), allowed=[("part", "lid")])
    assert tuple(held.distance(q, free).pair) != ("part", "lid")


def test_shapes_agree_whoever_says_them_and_order_changes_nothing():
    arm, around = pieper.load("universal-robots-ur10e"), scene()
    q = np.random.default_rng(0).uniform(-3, 3, (50, 6))
    turned = pieper.Scene(list(around)[::-1])
    assert np.abs(arm.distance(q, around) - arm.distance(q, turned)).max() < 1e-15
    alone = np.array([float(arm.distance(row, around)) for row in q])
    assert np.abs(arm.distance(q, around) - alone).max() < 20 * DISTANCE_ROUNDING
    base = pieper.pose(1.0, -2.0, 0.5, rpy=(0.3, -0.2, 1.0))
    moved = arm.with_base(base @ arm.base)
    elsewhere = pieper.Scene([shape.moved(base) for shape in around])
    assert np.abs(moved.distance(q, elsewhere) - arm.distance(q, around)).max() < 1e-14


def test_the_other_convention_and_the_arm_seen_from_its_end_are_the_same_solids():
    arm = pieper.load("denso-vp6242")
    arm = arm.with_bodies({"tool": pieper.Capsule([0, 0, 0], [0, 0, 0.1], 0.02)})
    real = arm.with_bodies(
        {n: b.shape for n, b in zip(("base", "joint_2", "joint_3", "joint_4"), arm.bodies, strict=False)}
    )
    q = np.random.default_rng(1).uniform(-1, 1, (30, 6))
    d = real.distance(q)
    assert np.abs(real.to("modified").distance(q) - d).max() < 1e-13
    assert np.abs(real.reversed().distance(q[:, ::-1]) - d).max() < 1e-13
    locked = real.with_joints_locked({"joint_5": 0.3})
    q[:, 4] = 0.3
    # neighbours grow together where a joint is held, so that fewer pairs are looked at
    assert (locked.distance(np.delete(q, 4, 1)) >= real.distance(q) - 1e-13).all()


def test_ik_marks_the_rows_that_touch():
    arm = pieper.load("denso-vp6242")
    T = arm.fk(np.radians([20, 60, -200, 10, 40, 0]))
    sols = arm.ik(T, scene=scene())
    assert sols.clear.shape == (len(sols),) and (sols.clearance > 0).tolist() == sols.clear.tolist()
    with pytest.raises(pieper.InputError, match="scene"):
        arm.ik(T).clear  # noqa: B018


def test_what_is_computed_of_distances_is_a_plain_array():
    arm = pieper.load("denso-vp6242")
    d = arm.distance(np.zeros((3, 6)), scene())
    for plain in (d + 1, d > 0, d[0], d[:2], d.min(), -d):
        assert not isinstance(plain, type(d))
    assert float(arm.distance(np.zeros(6), scene())) == d[0]
