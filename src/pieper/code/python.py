"""The printer of Python: NumPy alone, many poses at once."""

from __future__ import annotations

from collections.abc import Callable

from pieper.code.between import STEPS, Between, held_words
from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import ENTRYWISE, USUAL, Language, filled, functions, quoted
from pieper.code.program import LoopWords
from pieper.tolerances import CLOSES, FILLED_STARTS, HOLDS_TO_ROUNDING, NEWTON_FINITE


def while_any_moves(loop: LoopWords) -> list[str]:
    """Return a loop over arrays, which ends when none of their entries moves."""
    carried = ", ".join(loop.names)
    return [
        f"    {carried} = {', '.join(loop.start)}",
        f"    for _ in range({loop.steps}):",
        *(f"    {line}" for line in loop.lines),
        f"        {carried} = {', '.join(loop.next)}",
        f"        if not np.any({loop.moving}):",
        "            break",
    ]


def arrays(module: str, loop: Callable[[LoopWords], list[str]] = while_any_moves) -> Language:
    """Return the language of a module of arrays, NumPy or what is called as it is, after its name here."""
    named = {"angle": "_angle({0}, {1})", "select": f"{module}.where({{0}}, {{1}}, {{2}})"}
    named |= {
        "atan2": f"{module}.arctan2({{0}}, {{1}})",
        "true": f"{module}.bool_(True)",
        "false": f"{module}.bool_(False)",
    }
    return Language(
        words=USUAL | ENTRYWISE | functions(f"{module}.") | named,
        entry=lambda k: f"T[:, {k // 4}, {k % 4}]",
        assign=lambda name, _, expression: f"    {name} = {expression}",
        loop=loop,
        infinity=f"{module}.inf",
        truths=("False", "True"),
        header=quoted,
        manner=Manner("np.sin({0})", "np.cos({0})", "q[{0}]", 0, "    {0} = {1}", "_side({0}, {1})"),
    )


def own_parts(export: Export, module: str) -> dict[str, str]:
    """Return what is said of what lies between the arm's joints and the six that are solved; JAX says it so too."""
    own = export.between
    numbers = arrays(module).numbers
    held, coupled = own.held is not None, own.gears is not None
    columns, slide = ", ".join(own.axes("six[..., {}]".format)), "_JOINTS_SLIDE" if own.linked else "SLIDES_"
    same = columns == ", ".join(f"six[..., {j}]" for j in range(6))
    filled_joints = "".join(
        f"    valid = valid & ({module}.abs(six[..., {k}]) < {FILLED_STARTS * unit!r})\n" for k, unit in own.filled
    )
    take = f"    columns = [{columns}]\n"
    take += f"    q = {module}.stack([{module}.broadcast_to(x, valid.shape) for x in columns], -1)\n"
    if own.linked:
        take += "    q, kept = _linked(q)\n    valid = valid & kept\n"
    lines = ""
    if own.joints_slide is not None:
        lines += f"_JOINTS_SLIDE = np.array({[bool(s) for s in own.joints_slide]})\n"
        lines += f"_STARTS = np.array({list(own.starts)})\n"
    if coupled:
        lines += f"_GEARS = {module}.array({numbers(own.gears)})\n_BACK = {module}.array({numbers(own.back)})\n"
    if own.tied is not None:
        lines += f"_TIED = np.array({[bool(t) for t in own.tied]})\n_MOVES = {module}.array({numbers(own.moves)})\n"
        lines += f"_WEIGHT = {module}.array({numbers(own.weight)})\n"
    if own.taken_off is not None and held:
        lines += f"_OFF = {module}.array({numbers(own.taken_off)})\n"
    return {
        "SAID": held_words(own),
        "COUPLED": lines,
        "VALUE": f", value={own.default!r}" if held else "",
        "VALUE_SAID": ", value" if held else "",
        "VALUES": ", values" if held else "",
        "VALUES_CHECKED": f"    values = {module}.asarray(values, float)\n    if values.shape != Ts.shape[:1] or not "
        f"{module}.isfinite(values).all():\n"
        '        raise ValueError(f"values must be finite, one a pose, got {values}.")\n'
        if held
        else "",
        "ONE_VALUE": f", {module}.asarray(value, float)[None]" if held else "",
        "TEST_VALUE": f", q[{own.held}]" if held else "",
        "MOVED": f"_moved(Ts, {module}.asarray(values, float))" if held else "Ts",
        "ROW_VALUE": f"    value = {module}.asarray(values, float)[:, None]\n" if held else "",
        "OWN_ROW": filled_joints
        + ("    q = six\n" if same else take)
        + (f"    q, miss = _nearest(q, Ts)\n    valid = valid & (miss < {CLOSES!r})\n" if own.weights else ""),
        "NEAREST": nearest_of(own, NEAREST),
        "AT_AXES": " @ _GEARS.T" if own.linked else "",
        "JOINTS_SLIDE": slide,
        "DOUBT": f"{module}.ones_like(unclear)" if own.always else "unclear",
        "TESTED": str(list(own.tested)),
        "TO_AXES": "    q = q @ _GEARS.T\n" if coupled else "",
        "GEARED": " @ _GEARS" if coupled else "",
        "FROM_AXES": ("    q = q @ _BACK.T\n" if coupled and not own.linked else "")
        + (f"    q = {module}.where({slide}, q, q - _TURN * {module}.ceil((q - {module}.pi) / _TURN))\n" * own.wraps),
        "MOVE": "    q = _move_inside(q)\n" if own.tied is not None else "",
        "ALONE": "_ALONE",
        "ALONE_IS": "~_JOINTS_SLIDE" if own.linked else "~SLIDES" if own.tied is None else "~SLIDES & ~_TIED",
        "GAP": "(rows - q) @ _GEARS.T" if coupled else "rows - q",
        "OWN_FUNCTIONS": (_MOVED if held else "")
        .replace("MODULE", module)
        .replace("Z_SAID", _z_said(export))
        .replace("PRODUCT", "Z @ (_OFF @ Ts)" if own.at_base else "(Ts @ _OFF) @ Z")
        + (_MOVE.replace("MODULE", module) if own.tied is not None else "")
        + (_LINKED.replace("MODULE", module) if own.linked else ""),
        "LABEL_AXES": "    q = np.asarray(q, float)\n    q = q @ _GEARS.T\n" if coupled else "",
    }


def _z_said(export: Export) -> str:
    """Return the joint's motion taken back, as rows of what is c, s, o, u and v."""
    slides = export.between.held is not None and export.slides[export.between.held]
    return "[[u, o, o, o], [o, u, o, o], [o, o, u, -v]]" if slides else "[[c, s, o, o], [-s, c, o, o], [o, o, u, o]]"


_MOVED = """

def _moved(Ts, v):
    # what the held joint does is taken off the poses
    c, s, o, u = MODULE.cos(v), MODULE.sin(v), MODULE.zeros_like(v), MODULE.ones_like(v)
    rows = [*Z_SAID, [o, o, o, u]]
    Z = MODULE.stack([MODULE.stack(row, -1) for row in rows], -2)
    return PRODUCT

"""
_LINKED = """

def _linked(v):
    # joint vectors that put the joints' own axes at v, and which have the linkage put the others there too, nearly
    q = v @ _BACK.T
    off = MODULE.abs(v - q @ _GEARS.T)
    off = MODULE.where(SLIDES_, off, MODULE.abs(off - _TURN * MODULE.round(off / _TURN)))
    return q, (off < _STARTS).all(-1)

"""
_MOVE = """

def _move_inside(q):
    # joints whose numbers whole turns of the axes move together: the shortest move that brings them inside
    away = (_WEIGHT * _MOVES**2).sum(-1)
    there = q[..., None, :] + _MOVES
    ok = (((there >= LOWER) & (there <= UPPER)) | ~_TIED).all(-1)
    now = (((q >= LOWER) & (q <= UPPER)) | ~_TIED).all(-1)
    best = MODULE.argmin(MODULE.where(ok, away, MODULE.inf), -1)
    return MODULE.where((~now & ok.any(-1))[..., None], q + _MOVES[best], q)

"""


#: Of arms with filled or linked joints: rows become the joint vectors whose poses come nearest to what was asked.
NEAREST = """

def _nearest(q, Ts):
    # least squares: joint vectors (k, 8, n) whose poses come nearest to those asked for; by how much each misses
    tested, weights, point = @TESTED@, np.array(@WEIGHTS@), np.array([0.0, 0.0, 0.0, 1.0])[:, None]
    shape, q, Ts = q.shape, q.reshape(-1, q.shape[-1]).copy(), np.repeat(Ts, q.shape[1], 0)
    miss, go = np.zeros(len(q)), np.arange(len(q))
    for step in range(@STEPS@ + 1):
        frames, P = _walk(q[go]@AT_AXES@)
        r = weights * (Ts[go] - P).reshape(-1, 16)[:, tested]
        miss[go] = np.sqrt((r * r).sum(-1))
        if step == @STEPS@ or not len(go):
            break
        z, p = frames[..., None, :3, 2], frames[..., None, :3, 3]
        columns = np.swapaxes(P[..., None, :3, :], -1, -2)
        way = np.where(SLIDES[:, None, None], point * z, np.cross(z, columns - point * p))
        D = @BY_JOINTS@weights * np.swapaxes(way, -1, -2).reshape(*way.shape[:-2], 12)[..., tested]@END@
@FIXED@        A = D @ np.swapaxes(D, -1, -2)
        A = A + @DAMPED@ * np.trace(A, axis1=-2, axis2=-1)[..., None, None] * np.eye(q.shape[-1])
        move = np.linalg.solve(A, D @ r[..., None])[..., 0]
        q[go] += move
        go = go[np.abs(move).max(-1) > @SETTLED@]
    q = np.where(@JOINTS_SLIDE@, q, q - _TURN * np.ceil((q - np.pi) / _TURN))
    return q.reshape(shape), miss.reshape(shape[:-1])

"""


def nearest_of(own: Between, frame: str) -> str:
    """Return the function that brings rows nearest to their poses, of arms that need it; JAX has a frame of its own."""
    if not own.weights:
        return ""
    text = frame.replace("@TESTED@", str(list(own.tested))).replace("@WEIGHTS@", str(list(own.weights)))
    by, end = ("_GEARS.T @ (", ")") if own.linked else ("", "")
    fixed = f"        D[..., {own.fixed}, :] = 0.0\n" if own.fixed else ""
    text = text.replace("@FIXED@", fixed).replace(
        "@HOLDING@", f".at[:, np.array({own.fixed})].set(0.0)" if own.fixed else ""
    )
    text = text.replace("@BY_JOINTS@", by).replace("@END@", end).replace("@AT_AXES@", " @ _GEARS.T" * own.linked)
    slide = "_JOINTS_SLIDE" if own.linked else "SLIDES_"
    text = text.replace("@STEPS@", str(STEPS)).replace("@SETTLED@", repr(HOLDS_TO_ROUNDING))
    return text.replace("@JOINTS_SLIDE@", slide).replace("@DAMPED@", repr(NEWTON_FINITE))


#: What a matrix means as a pose; the same for every module of arrays.
RIGID = """_NO_POSE = "Ts[{}] is no rigid motion: R^T R departs from I by more than @ACCEPTED@, or R is a mirror."


def _rigid(T):
    # poses whose rotations, where they were rounded, are the nearest ones; and which are rigid motions at all
    good = MODULE.isfinite(T).all((1, 2))
    T = MODULE.where(good[:, None, None], T, MODULE.eye(4))
    R = T[:, :3, :3]
    off = MODULE.abs(MODULE.swapaxes(R, 1, 2) @ R - MODULE.eye(3)).max((1, 2))
    off = off + MODULE.abs(T[:, 3] - MODULE.array([0.0, 0.0, 0.0, 1.0])).sum(1)
    good = good & (off <= @ACCEPTED@) & (MODULE.linalg.det(R) > 0)
    X = MODULE.where(good[:, None, None], R, MODULE.eye(3))
    for _ in range(2):  # each step of Newton's iteration for the polar factor squares what is off
        X = 1.5 * X - 0.5 * X @ (MODULE.swapaxes(X, 1, 2) @ X)
    last = MODULE.broadcast_to(MODULE.array([[[0.0, 0.0, 0.0, 1.0]]]), (len(T), 1, 4))
    return MODULE.concatenate([MODULE.concatenate([X, T[:, :3, 3:]], 2), last], 1), good"""
#: The name of a posture; the same for every module of arrays.
LABEL = '''def _side(v, facing):
    # 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way
    v = -v if facing < 0 else v
    return 0 if v > @NO_SIDE@ else 1 if v < -@NO_SIDE@ else 2


def NAME_label(q):
    """The name of a posture (n,), such as "front, elbow up, wrist flip"; "" where the postures have none."""
@LABEL_AXES@@SUMS@
    return _NAMES[@PLACE@]'''
FRAME = '''"""@HEADER@

@SAID@ik(T) takes a pose (4, 4), base to tool, and returns the joint vectors (m, n) inside the limits; ik_all(Ts)
takes poses (k, 4, 4) and returns rows (k, 8, n) before limits, which of them hold (k, 8), and which poses are unclear
(k,): at and next to singular poses, where a row may stand for many and rows may be missing. A rotation that was rounded
is taken as the nearest one; what is no rigid motion is a ValueError. fk(q) and jacobian(q) take (..., n), label(q)
takes (n,).
"""

import numpy as np

LOWER = np.array(@LOWER@)
UPPER = np.array(@UPPER@)
SLIDES = np.array(@SLIDES@)
LINKS = np.array(@LINKS@).reshape(-1, 3, 4)
_TURN = 6.28318530717958647693
@COUPLED@_ALONE = @ALONE_IS@


def _angle(y, x):
    # an angle that rounds to -pi is said as pi
    r = np.arctan2(y, x)
    return np.where(r <= -np.pi, np.pi, r)


def _walk(q):
    """Frames of the joints before they move (..., n, 4, 4), and the tool's pose."""
    q = np.asarray(q, float)
    if q.shape[-1:] != SLIDES.shape:
        raise ValueError(f"q must have shape (..., {len(SLIDES)}), got {q.shape}.")
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
@TO_AXES@    return _walk(q)[1]


def jacobian(q):
    """Geometric Jacobian(s) (..., 6, n), base frame, linear rows first."""
@TO_AXES@    frames, T = _walk(q)
    z = frames[..., :3, 2]
    way = np.where(SLIDES[:, None], z, np.cross(z, T[..., None, :3, 3] - frames[..., :3, 3]))
    return np.swapaxes(np.concatenate([way, np.where(SLIDES[:, None], 0.0, z)], -1), -1, -2)@GEARED@
@OWN_FUNCTIONS@
@NEAREST@
@RIGID@


def _rows(T):
@PROGRAM@
    shape = T.shape[:1]
    q = np.stack([np.broadcast_to(x, shape) for x in [@ROWS@]], -1).reshape(*shape, 8, -1)
    valid = np.stack([np.broadcast_to(x, shape) for x in [@VALID@]], -1)
    return q, valid, np.broadcast_to(@UNCLEAR@, shape)


def ik_all(Ts@VALUES@):
    """Rows (k, 8, n) of poses (k, 4, 4) before limits, which hold (k, 8), which poses are unclear (k,)."""
    Ts = np.asarray(Ts, float)
    if Ts.ndim != 3 or Ts.shape[1:] != (4, 4):
        raise ValueError(f"Ts must have shape (k, 4, 4), got {Ts.shape}.")
@VALUES_CHECKED@    Ts, good = _rigid(Ts)
    if not good.all():
        raise ValueError(_NO_POSE.format(int(np.argmin(good))))
    with np.errstate(all="ignore"):
        six, valid, unclear = _rows(@MOVED@)
    six = np.where(valid[..., None], six, 0.0)
@ROW_VALUE@@OWN_ROW@    q = np.where(valid[..., None], q, 0.0)
    gap = np.abs(q[:, :, None] - q[:, None])
    gap = np.where(@JOINTS_SLIDE@, gap, np.abs(gap - _TURN * np.round(gap / _TURN))).max(-1)
    earlier = np.tril(np.ones((8, 8), bool), -1)
    valid = valid & ~((gap < 1e-9) & earlier & valid[:, None]).any(-1)
    look = @DOUBT@
    away = np.abs(_walk(q[look]@AT_AXES@)[1] - Ts[look, None]).reshape(-1, 8, 16)[..., @TESTED@].max(-1)
    valid[look] &= away < @VERIFIED@
@FROM_AXES@    return np.where(valid[..., None], q, 0.0), valid, unclear


def _inside(q):
@MOVE@    q = np.where(_ALONE & (q < LOWER), q + _TURN * np.ceil(np.where(q < LOWER, LOWER - q, 0.0) / _TURN), q)
    q = np.where(_ALONE & (q > UPPER), q - _TURN * np.ceil(np.where(q > UPPER, q - UPPER, 0.0) / _TURN), q)
    return q, ((q >= LOWER) & (q <= UPPER)).all(-1)


def ik(T@VALUE@):
    """Every joint vector (m, n) inside the limits that reaches a pose (4, 4)."""
    q, valid, _ = ik_all(np.asarray(T, float)[None]@ONE_VALUE@)
    q, inside = _inside(q[0][valid[0]])
    return q[inside]


@LABEL@


def self_test():
    """How many of @TESTS@ stored poses fail: 0."""
    failed = 0
    for q, T, count in zip(_Q, _T, _COUNTS):
        rows = ik(T.reshape(4, 4)@TEST_VALUE@)
        gap = np.abs(@GAP@)
        gap = np.where(SLIDES, gap, np.abs(gap - _TURN * np.round(gap / _TURN))).max(-1, initial=0.0)
        ok = np.abs(fk(q) - _rigid(T.reshape(1, 4, 4))[0]).max() < @VERIFIED@
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
    parts = {name: part.replace("SLIDES_", "SLIDES") for name, part in own_parts(export, "np").items()}
    frame = FRAME.replace("@LABEL@", LABEL.replace("NAME_", "")).replace("@RIGID@", RIGID.replace("MODULE", "np"))
    return filled(frame, arrays("np").parts(export) | parts, export)
