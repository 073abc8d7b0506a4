"""The printer of Python: NumPy alone, many poses at once."""

from __future__ import annotations

from pieper.code.export import Export, filled, finite_or, nested
from pieper.code.labels import Manner
from pieper.code.program import statements

WORDS = {
    "add": "{0} + {1}",
    "sub": "{0} - {1}",
    "mul": "{0} * {1}",
    "div": "{0} / {1}",
    "neg": "-{0}",
    "abs": "np.abs({0})",
    "sqrt": "np.sqrt({0})",
    "sin": "np.sin({0})",
    "cos": "np.cos({0})",
    "atan2": "np.arctan2({0}, {1})",
    "angle": "_angle({0}, {1})",
    "select": "np.where({0}, {1}, {2})",
    "lt": "{0} < {1}",
    "le": "{0} <= {1}",
    "gt": "{0} > {1}",
    "ge": "{0} >= {1}",
    "eq": "{0} == {1}",
    "ne": "{0} != {1}",
    "and": "{0} & {1}",
    "or": "{0} | {1}",
    "not": "~{0}",
    "true": "np.True_",
    "false": "np.False_",
}

MANNER = Manner("np.sin({0})", "np.cos({0})", "q[{0}]", 0, "    {0} = {1}", "_side({0}, {1})")

FRAME = '''"""@HEADER@

ik(T) takes a pose (4, 4), base to tool, and returns the joint vectors (m, n) inside the limits; ik_all(Ts) takes poses
(N, 4, 4) and returns rows (N, 8, n) before limits, which of them hold (N, 8), and which poses are unclear (N,): at and
next to singular poses, where a row may stand for many and rows may be missing. fk(q) and jacobian(q) take (..., n),
label(q) takes (n,).
"""

import numpy as np

LOWER = np.array(@LOWER_NUMBERS@)
UPPER = np.array(@UPPER_NUMBERS@)
SLIDES = np.array(@SLIDES_NUMBERS@)
LINKS = np.array(@LINKS_NUMBERS@).reshape(-1, 3, 4)
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
    """Pose(s) (..., 4, 4) of joint vectors (..., n)."""
    return _walk(q)[1]


def jacobian(q):
    """Geometric Jacobian(s) (..., 6, n), base frame, linear rows first."""
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


def _side(v, facing):
    # 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way
    v = -v if facing < 0 else v
    return 0 if v > @NO_SIDE@ else 1 if v < -@NO_SIDE@ else 2


def label(q):
    """The name of a posture (n,), such as "front, elbow up, wrist flip"; "" where the postures have none."""
@SUMS@
    return _NAMES[@PLACE@]


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
    lines, said = statements(
        export.program,
        WORDS,
        lambda k: f"T[:, {k // 4}, {k % 4}]",
        lambda name, _, expression: f"    {name} = {expression}",
    )
    number, program = finite_or("np.inf"), export.program
    parts = {
        "HEADER": "\n".join(export.header).replace("\\", "/").replace('"""', "'''"),
        "LOWER_NUMBERS": nested(export.lower, "[]", number),
        "UPPER_NUMBERS": nested(export.upper, "[]", number),
        "SLIDES_NUMBERS": "[" + ", ".join(str(s) for s in export.slides) + "]",
        "LINKS_NUMBERS": nested(export.links.reshape(export.n + 1, 12), "[]", number),
        "PROGRAM": "\n".join(lines),
        "ROWS": ", ".join(said(i) for i in program.q),
        "VALID": ", ".join(said(i) for i in program.valid),
        "UNCLEAR": said(program.unclear),
        **MANNER.parts(export.labels, repr(list(export.labels.names))),
        "VERIFIED": repr(export.verified),
        "TEST_Q": nested(export.q, "[]", number),
        "TEST_T": nested(export.T.reshape(-1, 16), "[]", number),
        "COUNTS": "[" + ", ".join(str(k) for k in export.counts) + "]",
    }
    return filled(FRAME, parts, export)
