"""The contract with the kernels: what the stub says is there, and what is prepared can be copied and pickled."""

from __future__ import annotations

import ast
import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper import _kernel
from pieper.solver.families import FAMILIES

ARMS = [
    "denso-vs060",
    "universal-robots-ur5e",
    "fanuc-crx-10ia",
    "stanford-arm",
    "kuka-lbr-iiwa-14-r820",
    "rethink-sawyer",
]
STUB = ast.parse(Path(pieper.__file__).with_name("_kernel.pyi").read_text())


def names(body: list[ast.stmt]) -> set[str]:
    """Return the public names that a stub's statements define."""
    out = set()
    for node in body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            out.add(node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            out.add(node.target.id)
        elif isinstance(node, ast.Assign):
            out |= {target.id for target in node.targets if isinstance(target, ast.Name)}
    return {name for name in out if not name.startswith("_")}


def bases(node: ast.ClassDef) -> list[ast.ClassDef]:
    """Return the stub's own bases of a class, which the module has not."""
    named = {base.id for base in node.bases if isinstance(base, ast.Name) and base.id.startswith("_")}
    return [other for other in STUB.body if isinstance(other, ast.ClassDef) and other.name in named]


def test_the_stub_has_every_public_name_of_the_module_and_no_other():
    assert names(STUB.body) == {name for name in dir(_kernel) if not name.startswith("_")}


def test_the_stub_has_every_attribute_of_every_class():
    for node in STUB.body:
        if isinstance(node, ast.ClassDef) and node.name not in ("Flag", "Geometry", "_Group"):
            kind = getattr(_kernel, node.name)
            said = {name for part in (node, *bases(node)) for name in names(part.body)}
            said |= {"name", "joints", "slots"} if issubclass(kind, _kernel.Geometry) else set()
            assert said == {name for name in dir(kind) if not name.startswith("_")}, node.name


def test_the_stub_has_the_flags_with_their_values():
    (flags,) = [node for node in STUB.body if isinstance(node, ast.ClassDef) and node.name == "Flag"]
    said = {a.targets[0].id: a.value.value for a in flags.body if isinstance(a, ast.Assign)}
    assert said == {flag.name: flag.value for flag in _kernel.Flag}
    assert _kernel.Flag(5) == _kernel.Flag.DEGENERATE | _kernel.Flag.OUT_OF_REACH == 5


def test_every_family_has_its_name_its_words_and_a_kernel():
    kernels = {getattr(_kernel, name).name for name in dir(_kernel) if hasattr(getattr(_kernel, name), "slots")}
    assert {family.name for family in FAMILIES} <= kernels
    assert all(family.words.endswith(".") and family.arrangement for family in FAMILIES)


def same(a: object, b: object) -> bool:
    """Return whether two geometries have equal fields, those of the geometry inside included."""
    fields, others = a.__getstate__(), b.__getstate__()
    return fields.keys() == others.keys() and all(
        same(v, others[k]) if isinstance(v, _kernel.Geometry) else np.array_equal(v, others[k])
        for k, v in fields.items()
    )


@pytest.mark.parametrize("name", ARMS)
def test_a_plan_is_the_same_after_a_pickle_and_a_deep_copy(name):
    arm = pieper.load(name)
    T = arm.fk(np.random.default_rng(3).uniform(-2, 2, (40, arm.n)))
    arm.ik_many(T)
    for again in (pickle.loads(pickle.dumps(arm.plan)), copy.deepcopy(arm.plan)):
        assert same(again.spec.geometry, arm.plan.spec.geometry)
        for ours, theirs in zip(arm.plan.solver.many(T, 1), again.solver.many(T, 1), strict=True):
            assert np.array_equal(ours, theirs)
        solver = pickle.loads(pickle.dumps(again.solver))
        assert np.array_equal(solver.one(T[0])[0], arm.plan.solver.one(T[0])[0])
