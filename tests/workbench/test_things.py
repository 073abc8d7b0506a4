"""What Python may show on a page beside it, and what it is told of everything else."""

from __future__ import annotations

import pytest

import pieper
from pieper.workbench.things import thing

ARM = pieper.load("denso-vp6242")


@pytest.mark.parametrize("what", ["x", ARM, {}, [[1.0, "a"]], object()])
def test_what_is_nothing_that_can_be_shown_is_refused_in_words(what):
    with pytest.raises(pieper.InputError, match=f"what is shown is a pose .* got {type(what).__name__}"):
        thing(ARM, what, None, 0.02)


def test_a_pose_is_a_frame():
    assert thing(ARM, pieper.pose(0.3, 0.1, 0.2), None, 0.02)["kind"] == "frame"
