"""Frameworks that are extras: where one is not installed, what says so says how it comes."""

from __future__ import annotations

import sys

import pytest

import pieper
from pieper import jax, torch


@pytest.mark.parametrize(("module", "name"), [(torch, "torch"), (jax, "jax")])
def test_a_framework_that_is_not_there_is_named_with_its_extra(monkeypatch, module, name):
    monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ModuleNotFoundError, match=rf"pip install 'pieper\[{name}\]'"):
        module.ik(pieper.load("universal-robots-ur5e"))
