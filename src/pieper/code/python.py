"""The printer of Python: NumPy alone, many poses at once."""

from __future__ import annotations

from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import ENTRYWISE, USUAL, Language, filled, functions, quoted


def arrays(module: str) -> Language:
    """Return the language of a module of arrays, NumPy or what is called as it is, after its name here."""
    named = {"angle": "_angle({0}, {1})", "select": f"{module}.where({{0}}, {{1}}, {{2}})"}
    named |= {"atan2": f"{module}.arctan2({{0}}, {{1}})", "true": f"{module}.True_", "false": f"{module}.False_"}
    return Language(
        words=USUAL | ENTRYWISE | functions(f"{module}.") | named,
        entry=lambda k: f"T[:, {k // 4}, {k % 4}]",
        assign=lambda name, _, expression: f"    {name} = {expression}",
        infinity=f"{module}.inf",
        truths=("False", "True"),
        header=quoted,
        manner=Manner("np.sin({0})", "np.cos({0})", "q[{0}]", 0, "    {0} = {1}", "_side({0}, {1})"),
    )


#: The name of a posture; the same for every module of arrays.
LABEL = '''def _side(v, facing):
    # 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way
    v = -v if facing < 0 else v
    return 0 if v > @NO_SIDE@ else 1 if v < -@NO_SIDE@ else 2


def NAME_label(q):
    """The name of a posture (n,), such as "front, elbow up, wrist flip"; "" where the postures have none."""
@SUMS@
    return _NAMES[@PLACE@]'''
FRAME = '''"""@HEADER@

ik(T) takes a pose (4, 4), base to tool, and returns the joint vectors (m, n) inside the limits; ik_all(Ts) takes poses
(N, 4, 4) and returns rows (N, 8, n) before limits, which of them hold (N, 8), and which poses are unclear (N,): at and
next to singular poses, where a row may stand for many and rows may be missing. fk(q) and jacobian(q) take (..., n),
label(q) takes (n,).
"""

import numpy as np

LOWER = np.array(@LOWER@)
UPPER = np.array(@UPPER@)
SLIDES = np.array(@SLIDES@)
LINKS = np.array(@LINKS@).reshape(-1, 3, 4)
_TURN = 6.28318530717958647693


def _angle(y, x):
    # an angle that rounds to -pi is said as pi
    r = np.arctan2(y, x)
    return np.where(r <= -np.pi, np.pi, r)


def _walk(q):
    """Frames of the joints before they move (..., n, 4, 4), and the tool's pose."""
    q = np.asarray(q, float)
    links = np.concatenate([LINKS, np.broadcast_to([0.0, 0.0, 0.0, 1.0], (len(LINKS), 1, 4))], 1)
    T = np.broadcast_to(links[0], (*q.shape[:-1], 4, 4))
    frames = []
    for i, slides in enumerate(SLIDES):
        frames.append(T)
        Z = np.zeros((*q.shape[:-1], 4, 4))
        Z[..., range(4), range(4)] = 1.0
        if slides:
            Z[..., 2, 3] = q[..., i]
        else:
            Z[..., 0, 0] = Z[..., 1, 1] = np.cos(q[..., i])
            Z[..., 1, 0] = np.sin(q[..., i])
            Z[..., 0, 1] = -Z[..., 1, 0]
        T = T @ Z @ links[i + 1]
    return np.stack(frames, -3), T


def fk(q):
    """Poses (..., 4, 4) of joint vectors (..., n)."""
    return _walk(q)[1]


def jacobian(q):
    """Geometric Jacobians (..., 6, n), base frame, linear rows first."""
    frames, T = _walk(q)
    z = frames[..., :3, 2]
    way = np.where(SLIDES[:, None], z, np.cross(z, T[..., None, :3, 3] - frames[..., :3, 3]))
    return np.swapaxes(np.concatenate([way, np.where(SLIDES[:, None], 0.0, z)], -1), -1, -2)


def _rows(T):
@PROGRAM@
    shape = T.shape[:1]
    q = np.stack([np.broadcast_to(x, shape) for x in [@ROWS@]], -1).reshape(*shape, 8, -1)
    valid = np.stack([np.broadcast_to(x, shape) for x in [@VALID@]], -1)
    return q, valid, np.broadcast_to(@UNCLEAR@, shape)


def ik_all(Ts):
    """Rows (N, 8, n) of poses (N, 4, 4) before limits, which hold (N, 8), which poses are unclear (N,)."""
    Ts = np.asarray(Ts, float)
    with np.errstate(all="ignore"):
        q, valid, unclear = _rows(Ts)
    q = np.where(valid[..., None], q, 0.0)
    gap = np.abs(q[:, :, None] - q[:, None])
    gap = np.where(SLIDES, gap, np.abs(gap - _TURN * np.round(gap / _TURN))).max(-1)
    earlier = np.tril(np.ones((8, 8), bool), -1)
    valid = valid & ~((gap < 1e-9) & earlier & valid[:, None]).any(-1)
    away = np.abs(fk(q[unclear]) - Ts[unclear, None]).max((-1, -2))
    valid[unclear] &= away < @VERIFIED@
    return q, valid, unclear


def _inside(q):
    q = np.where(~SLIDES & (q < LOWER), q + _TURN * np.ceil(np.where(q < LOWER, LOWER - q, 0.0) / _TURN), q)
    q = np.where(~SLIDES & (q > UPPER), q - _TURN * np.ceil(np.where(q > UPPER, q - UPPER, 0.0) / _TURN), q)
    return q, ((q >= LOWER) & (q <= UPPER)).all(-1)


def ik(T):
    """Every joint vector (m, n) inside the limits that reaches a pose (4, 4)."""
    q, valid, _ = ik_all(np.asarray(T, float)[None])
    q, inside = _inside(q[0][valid[0]])
    return q[inside]


@LABEL@


def self_test():
    """How many of @TESTS@ stored poses fail: 0."""
    failed = 0
    for q, T, count in zip(_Q, _T, _COUNTS):
        rows = ik(T.reshape(4, 4))
        gap = np.abs(rows - q)
        gap = np.where(SLIDES, gap, np.abs(gap - _TURN * np.round(gap / _TURN))).max(-1, initial=0.0)
        ok = np.abs(fk(q).ravel() - T).max() < @VERIFIED@
        failed += not (ok and len(rows) == count and (gap < 1e-7).any())
    return failed


_Q = np.array(@TEST_Q@)
_T = np.array(@TEST_T@)
_COUNTS = @COUNTS@
_NAMES = @NAMES@

if __name__ == "__main__":
    print(f"{self_test()} of @TESTS@ poses failed")
'''


def text(export: Export) -> str:
    """Return the file's text."""
    return filled(FRAME.replace("@LABEL@", LABEL.replace("NAME_", "")), arrays("np").parts(export), export)
