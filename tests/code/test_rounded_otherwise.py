"""A list of operations that is worked out with other rounding than the kernel's loses no row without saying so.

Compilers of arrays work a value out anew wherever it is used, and join products and sums there in one place and not in
the other, so that one and the same value is rounded otherwise in each.
"""

from __future__ import annotations

import operator

import numpy as np
import pytest

import pieper
from pieper.code.program import recorded

EPS = 2.2e-16
TRUTHS = {"lt": np.less, "le": np.less_equal, "gt": np.greater, "ge": np.greater_equal, "eq": np.equal}
TRUTHS |= {"ne": np.not_equal, "and": np.logical_and, "or": np.logical_or}
SUMS = {"add": operator.add, "sub": operator.sub, "mul": operator.mul, "div": operator.truediv}
ONE = {"neg": operator.neg, "abs": np.abs, "sqrt": np.sqrt, "sin": np.sin, "cos": np.cos}


class RoundedOtherwise:
    """The values of a program's nodes at poses; each use of a sum sees it rounded in another way."""

    def __init__(self, program, T, seed):
        self.program, self.rng = program, np.random.default_rng(seed)
        self.known, self.rounding = {}, {}
        self.entries = T.reshape(-1, 16).T
        for i in program.order:
            self._work_out(i)

    def __call__(self, i):
        """Return a node's value as one use of it sees it."""
        op, a, *_, value = self.program.nodes[i]
        if op in ("const", "in", "true", "false"):
            return {"const": value, "true": True, "false": False}[op] if op != "in" else self.entries[a]
        known = self.known[i]
        if i not in self.rounding:
            return known
        return known + self.rounding[i] * self.rng.uniform(-1.0, 1.0, np.shape(known))

    def _work_out(self, i):
        op, *given, _ = self.program.nodes[i]
        values = [self(a) for a in self.program.arguments(i)]
        if op in TRUTHS:
            self.known[i] = TRUTHS[op](*values)
        elif op == "not":
            self.known[i] = np.logical_not(values[0])
        elif op == "select":
            self.known[i] = np.where(*values)
        elif op in ("atan2", "angle"):
            self.known[i] = np.arctan2(*values)
        elif op in ONE:
            self.known[i] = ONE[op](values[0])
        else:
            self.known[i] = SUMS[op](*values)
            if op in ("add", "sub"):  # a product beside it may have been joined to it or not
                self.rounding[i] = EPS * np.maximum(np.abs(values[0]), np.abs(values[1]))


def beside_the_first_axis(arm, count, away):
    """Return poses whose wrist centre stands so far, m, from where the first joint has no direction."""
    fields = {name: np.asarray(value) for name, value in arm.plan.spec.geometry.__getstate__().items()}
    rng = np.random.default_rng(1)
    T = arm.fk(rng.uniform(-2, 2, (count, 6)))
    into = fields["base"]
    centre = fields["origin"] + T[:, :3, 3] @ into.T + into @ T[:, :3, :3] @ fields["tool"] @ fields["centre"]
    turn, far = rng.uniform(-np.pi, np.pi, count), np.hypot(away, fields["b"])
    there = np.stack([far * np.cos(turn), far * np.sin(turn), centre[:, 2]], 1)
    T[:, :3, 3] += (there - centre) @ into
    return np.ascontiguousarray(T)


@pytest.mark.parametrize("name", ["fanuc-cr-35ia", "denso-vp6242", "universal-robots-ur5e", "stanford-arm"])
def test_rows_that_rounding_takes_are_told(name):
    arm = pieper.load(name)
    program = recorded(arm.plan)
    if arm.plan.family == "spherical_wrist_parallel":
        T = beside_the_first_axis(arm, 3000, 5e-6 * arm.chain.length)
    else:
        T = arm.fk(np.random.default_rng(1).uniform(-2, 2, (3000, 6)) * np.where(arm.chain.prismatic, 0.3, 1.0))
    wanted = arm.plan.solver.many(np.ascontiguousarray(T), 1)
    with np.errstate(all="ignore"):
        # the rows and the doubt are worked out apart, as a compiler does that makes two loops of them
        rows, doubt = RoundedOtherwise(program, T, 1), RoundedOtherwise(program, T, 2)
    found = sum(np.broadcast_to(rows(i), len(T)).astype(int) for i in program.valid)
    unclear = np.broadcast_to(doubt(program.unclear), len(T))
    assert not program.loops or name == "stanford-arm"
    assert unclear.mean() < 0.9
    assert not ((found < wanted[1].sum(1)) & ~unclear).any()
