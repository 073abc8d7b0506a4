"""The arms every contestant solves, as bare DH tables; NumPy alone, so that every environment can read it."""

import numpy as np

PI = np.pi
_rng = np.random.default_rng(7)
_alpha, _a, _d = _rng.uniform(-PI, PI, 6), _rng.uniform(0.1, 0.5, 6), _rng.uniform(0.1, 0.5, 6)

#: name -> rows (d, a, alpha), standard DH, theta free; metres and radians.
TABLES = {
    "denso-vp6242": [
        (0.125, 0, PI / 2),
        (0, 0.21, 0),
        (0, -0.075, -PI / 2),
        (0.21, 0, PI / 2),
        (0, 0, -PI / 2),
        (0.07, 0, 0),
    ],
    "fanuc-r2000ic-165f": [
        (0.324, 0.312, -PI / 2),
        (0, 1.075, 0),
        (0, 0.225, -PI / 2),
        (1.280, 0, PI / 2),
        (0, 0, -PI / 2),
        (0.215, 0, 0),
    ],
    "puma-560": [
        (0, 0, PI / 2),
        (0, 0.4318, 0),
        (0.15005, 0.0203, -PI / 2),
        (0.4318, 0, PI / 2),
        (0, 0, -PI / 2),
        (0, 0, 0),
    ],
    "ur5e": [
        (0.1625, 0, PI / 2),
        (0, -0.425, 0),
        (0, -0.3922, 0),
        (0.1333, 0, PI / 2),
        (0.0997, 0, -PI / 2),
        (0.0996, 0, 0),
    ],
    "motoman-ea1400n": [
        (0.450, 0.150, PI / 2),
        (0, 0.570, PI),
        (0, 0.200, PI / 2),
        (0.640, 0, PI / 2),
        (0, 0.030, PI / 2),
        (0.200, 0, 0),
    ],
    "random-6r": list(zip(_d, _a, _alpha, strict=True)),
    "fanuc-crx-10ia": [
        (0, 0, -PI / 2),
        (0, 0.540, 0),
        (0, 0, -PI / 2),
        (0.540, 0, PI / 2),
        (-0.150, 0, -PI / 2),
        (0.160, 0, 0),
    ],
}
for _size in (1e-3, 1e-4, 1e-5, 1e-6):
    _noise = _size * np.random.default_rng(3).uniform(-1, 1, (6, 3))
    TABLES[f"ur5e-calibrated-{_size:g}"] = [tuple(np.array(r) + e) for r, e in zip(TABLES["ur5e"], _noise, strict=True)]

#: Arms without a closed form in the peers.
GENERAL_ARMS = ("motoman-ea1400n", "fanuc-crx-10ia", "random-6r", *(n for n in TABLES if "calibrated" in n))


def product(table, q):
    """Return poses (N, 4, 4) of joint vectors q (N, 6): a plain product of DH matrices."""
    q = np.asarray(q, float)
    T = np.broadcast_to(np.eye(4), (len(q), 4, 4))
    for i, (d, a, alpha) in enumerate(table):
        c, s, ca, sa = np.cos(q[:, i]), np.sin(q[:, i]), np.cos(alpha), np.sin(alpha)
        o, one = np.zeros_like(c), np.ones_like(c)
        A = np.stack(
            [c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s, o, sa * one, ca * one, d * one, o, o, o, one], -1
        )
        T = T @ A.reshape(-1, 4, 4)
    return T


def poses(name, count, seed=0):
    """Return random joint vectors (count, 6) over the whole turn and their poses."""
    q = np.random.default_rng(seed).uniform(-PI, PI, (count, 6))
    return q, product(TABLES[name], q)
