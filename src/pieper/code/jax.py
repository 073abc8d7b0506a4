"""The printer of JAX: the NumPy file's arithmetic in shapes that no value decides, so that it can be compiled."""

from __future__ import annotations

from pieper.code.export import Export
from pieper.code.language import filled
from pieper.code.program import LoopWords
from pieper.code.python import LABEL, RIGID, arrays, nearest_of, own_parts

NEAREST = """

def _nearest(q, Ts):
    # least squares: joint vectors (k, 8, n) whose poses come nearest to those asked for; by how much each misses
    tested, weights = jnp.array(@TESTED@), jnp.array(@WEIGHTS@)

    def one(q, T):
        miss = lambda q: weights * (T - _walk(q@AT_AXES@)).ravel()[tested]

        def step(_, q):
            D = -jax.jacfwd(miss)(q)@HOLDING@
            A = D.T @ D
            return q + jnp.linalg.solve(A + @DAMPED@ * jnp.trace(A) * jnp.eye(len(q)), D.T @ miss(q))

        q = jax.lax.fori_loop(0, @STEPS@, step, q)
        turned = q - _TURN * jnp.ceil((q - jnp.pi) / _TURN)
        return jnp.where(@JOINTS_SLIDE@, q, turned), jnp.sqrt((miss(q) ** 2).sum())

    return jax.vmap(jax.vmap(one, (0, None)))(q, Ts)

"""
FRAME = '''"""@HEADER@

@SAID@NAME_ik(T) takes a pose (4, 4), base to tool, and returns the joint vectors (m, n) inside the limits.
NAME_ik_all(Ts) takes poses (k, 4, 4) and returns rows (k, 8, n) turned inside the limits where they can be, which of
them hold (k, 8), which lie inside (k, 8), and which poses are unclear (k,): at and next to singular poses, where a row
may stand for many and rows may be missing. A rotation that was rounded is taken as the nearest one; what is no rigid
motion is a ValueError of NAME_ik, and has no rows and is unclear in NAME_ik_all.
NAME_fk(q) takes (n,) or, through jax.vmap, more; NAME_label(q) takes
(n,). All but NAME_ik and NAME_label may be compiled (jax.jit).
Double precision is switched on, since single precision loses rows.
"""

import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", True)

LOWER = jnp.array(@LOWER@)
UPPER = jnp.array(@UPPER@)
SLIDES = @SLIDES@
LINKS = np.array(@LINKS@).reshape(-1, 3, 4)
_TURN = 6.28318530717958647693
SLIDES_ = np.array(SLIDES)
@COUPLED@_ALONE = @ALONE_IS@


def _angle(y, x):
    # an angle that rounds to -pi is said as pi
    r = jnp.arctan2(y, x)
    return jnp.where(r <= -jnp.pi, jnp.pi, r)


def _walk(q):
    # entry by entry, which compiles to one loop over all rows; products of many small matrices do not
    rows = LINKS[0].tolist()
    for value, slides, link in zip(q, SLIDES, LINKS[1:]):
        if slides:
            rows = [(x, y, z, p + z * value) for x, y, z, p in rows]
        else:
            c, s = jnp.cos(value), jnp.sin(value)
            rows = [(c * x + s * y, c * y - s * x, z, p) for x, y, z, p in rows]
        rows = [[sum(v * w for v, w in zip(row, [*L, k == 3]) if w) for k, L in enumerate(link.T)] for row in rows]
    o = 0.0 * q[0]
    return jnp.stack([jnp.stack([o + x for x in row]) for row in [*rows, (0.0, 0.0, 0.0, 1.0)]])


def NAME_fk(q):
    """Pose (4, 4) of a joint vector (n,)."""
    q = jnp.asarray(q)
    if q.shape != (N,):
        raise ValueError(f"q must have shape (N,), got {q.shape}; jax.vmap takes more.")
@TO_AXES@    return _walk(q)
@OWN_FUNCTIONS@

def NAME_jacobian(q):
    """Geometric Jacobian (6, n) of a joint vector (n,), base frame, linear rows first."""
    T, dT = NAME_fk(q), jax.jacfwd(NAME_fk)(q)
    W = jnp.einsum("abj,cb->acj", dT[:3, :3], T[:3, :3])
    return jnp.concatenate([dT[:3, 3], jnp.stack([W[2, 1], W[0, 2], W[1, 0]])])

@NEAREST@
@RIGID@


def _rows(T):
@PROGRAM@
    shape = T.shape[:1]
    q = jnp.stack([jnp.broadcast_to(x, shape) for x in [@ROWS@]], -1).reshape(*shape, 8, -1)
    valid = jnp.stack([jnp.broadcast_to(x, shape) for x in [@VALID@]], -1)
    return q, valid, jnp.broadcast_to(@UNCLEAR@, shape)


def NAME_ik_all(Ts@VALUES@):
    """Rows (k, 8, n), which hold (k, 8), which lie inside the limits (k, 8), which poses are unclear (k,)."""
    Ts, good = _rigid(jnp.asarray(Ts, jnp.float64))
    six, valid, unclear = _rows(@MOVED@)
    valid, unclear = valid & good[:, None], unclear | ~good
    six = jnp.where(valid[..., None], six, 0.0)
@ROW_VALUE@@OWN_ROW@    q = jnp.where(valid[..., None], q, 0.0)
    gap = jnp.abs(q[:, :, None] - q[:, None])
    gap = jnp.where(@JOINTS_SLIDE@, gap, jnp.abs(gap - _TURN * jnp.round(gap / _TURN))).max(-1)
    earlier = jnp.tril(jnp.ones((8, 8), bool), -1)
    valid = valid & ~((gap < 1e-9) & earlier & valid[:, None]).any(-1)
    away = jnp.abs(jax.vmap(jax.vmap(_walk))(q@AT_AXES@) - Ts[:, None]).reshape(-1, 8, 16)
    away = away[..., jnp.array(@TESTED@)].max(-1)
    valid = valid & (~(@DOUBT@)[:, None] | (away < @VERIFIED@))
@FROM_AXES@@MOVE@    low, high = _ALONE & (q < LOWER), _ALONE & (q > UPPER)
    q = jnp.where(low, q + _TURN * jnp.ceil(jnp.where(low, LOWER - q, 0.0) / _TURN), q)
    high = _ALONE & (q > UPPER)
    q = jnp.where(high, q - _TURN * jnp.ceil(jnp.where(high, q - UPPER, 0.0) / _TURN), q)
    return q, valid, valid & ((q >= LOWER) & (q <= UPPER)).all(-1), unclear


_compiled = jax.jit(NAME_ik_all)


def NAME_ik(T@VALUE@):
    """Every joint vector (m, n) inside the limits that reaches a pose (4, 4)."""
    T = jnp.asarray(T, jnp.float64)[None]
    if not _rigid(T)[1][0]:
        raise ValueError(_NO_POSE.format(0))
    q, _, inside, _ = _compiled(T@ONE_VALUE@)
    return q[0][inside[0]]


@LABEL@


def NAME_self_test():
    """How many of @TESTS@ stored poses fail: 0."""
    q, T, slides = jnp.array(@TEST_Q@), jnp.array(@TEST_T@).reshape(-1, 4, 4), jnp.array(SLIDES)
    rows, _, inside, _ = _compiled(T@TEST_VALUES@)
    gap = jnp.abs((rows - q[:, None])@GEARED_T@)
    gap = jnp.where(slides, gap, jnp.abs(gap - _TURN * jnp.round(gap / _TURN))).max(-1)
    met = ((gap < 1e-7) & inside).any(1)
    closes = jnp.abs(jax.vmap(NAME_fk)(q) - _rigid(T)[0]).max((1, 2)) < @VERIFIED@
    return int((~(met & closes & (inside.sum(1) == jnp.array(@COUNTS@)))).sum())


_NAMES = @NAMES@
ik, fk = NAME_ik, NAME_fk

if __name__ == "__main__":
    print(f"{NAME_self_test()} of @TESTS@ poses failed")
'''


def fixed_steps(loop: LoopWords) -> list[str]:
    """Return a loop of so many steps, which can be compiled and differentiated."""
    carried, name = ", ".join(loop.names), f"step_{loop.names[0]}"
    return [
        f"    def {name}(_, carried):",
        f"        {carried} = carried",
        *(f"    {line}" for line in loop.lines),
        f"        return {', '.join(loop.next)}",
        "",
        f"    {carried} = jax.lax.fori_loop(0, {loop.steps}, {name}, "
        f"tuple(jnp.broadcast_to(jnp.asarray(x, float), T.shape[:1]) for x in ({', '.join(loop.start)})))",
    ]


def text(export: Export) -> str:
    """Return the file's text."""
    own = export.between
    parts = own_parts(export, "jnp") | {
        "NEAREST": nearest_of(own, NEAREST),
        "TEST_VALUES": "" if own.held is None else f", q[:, {own.held}]",
        "GEARED_T": "" if own.gears is None else " @ _GEARS.T",
        "ALONE_IS": "~_JOINTS_SLIDE" if own.linked else "~SLIDES_" if own.tied is None else "~SLIDES_ & ~_TIED",
    }
    frame = FRAME.replace("@LABEL@", LABEL).replace("@RIGID@", RIGID.replace("MODULE", "jnp"))
    return filled(frame, arrays("jnp", fixed_steps).parts(export) | parts, export)
