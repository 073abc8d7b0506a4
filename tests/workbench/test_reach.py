"""Voxels of the page: what is sent is the library's reach map, layer by layer, and it can be stopped."""

from __future__ import annotations

import base64
import threading

import numpy as np
import pytest

import pieper
from pieper.workbench import reach
from pieper.workbench.messages import Refused, Stopped

STEP = 0.1


def asked(arm: pieper.Arm, **said: object) -> tuple[dict, np.ndarray, dict]:
    """Return the first piece, all voxels with their values, and the end."""
    pieces: list[dict] = []
    end = reach.voxels(arm, {"step": STEP, **said}, pieces.append, threading.Event())
    blocks = [np.frombuffer(base64.b64decode(p["points"]), "<f4").reshape(-1, 4) for p in pieces if "points" in p]
    return pieces[0], np.concatenate(blocks), end


@pytest.mark.parametrize("colour", reach.COLOURS)
def test_the_layers_are_the_library_s_map_of_the_whole_box(colour):
    arm = pieper.load("denso-vp6242")
    first, sent, end = asked(arm, colour=colour)
    low, shape = np.array(first["low"]), np.array(first["shape"])
    box = list(zip(low, low + shape * STEP, strict=True))
    whole = arm.reach_map(box, STEP, orientations=reach.ORIENTATIONS, measure=True)
    ijk = np.floor((sent[:, :3] - low) / STEP).astype(int)
    told = np.zeros(shape)
    told[tuple(ijk.T)] = sent[:, 3]
    assert end["reached"] == len(sent) == (whole.fraction > 0).sum()
    assert end["volume"] == pytest.approx(whole.volume)
    assert np.allclose(told, np.where(whole.fraction > 0, getattr(whole, colour), 0), atol=1e-6)


def test_the_box_holds_every_place_that_random_postures_reach():
    arm = pieper.load("fanuc-lrmate-200id")
    first, sent, _ = asked(arm, colour="fraction")
    q = np.random.default_rng(5).uniform(*arm.limits.T, (2000, arm.n))
    cells = np.floor((arm.fk(q)[:, :3, 3] - first["low"]) / STEP).astype(int)
    assert ((cells >= 0) & (cells < first["shape"])).all()
    reached = {tuple(c) for c in np.floor((sent[:, :3] - first["low"]) / STEP).astype(int)}
    assert np.mean([tuple(c) in reached for c in cells]) > 0.9, "a few lie in voxels whose centre is not reached"


def test_too_many_voxels_and_none_are_refused_and_a_stop_is_heard():
    arm = pieper.load("denso-vp6242")
    for step, said in ((0.001, "at most"), (0, "at least"), (-1, "at least"), (1e-300, "at least")):
        with pytest.raises(Refused, match=said):
            reach.voxels(arm, {"step": step}, lambda _: None, threading.Event())
    stop = threading.Event()
    stop.set()
    with pytest.raises(Stopped):
        reach.voxels(arm, {"step": STEP}, lambda _: None, stop)


def test_a_cloud_is_coloured_by_the_same_manipulability_as_the_map():
    for name in ("denso-vp6242", "three-r", "franka-panda"):
        arm = pieper.load(name)
        pieces: list[dict] = []
        message = {"count": 200, "colour": "manipulability", "seed": 5}
        reach.cloud(arm, message, pieces.append, threading.Event())
        sent = np.frombuffer(base64.b64decode(pieces[0]["points"]), "<f4").reshape(-1, 4)
        lower, upper = reach._ranges(arm)
        q = np.random.default_rng(5).uniform(lower, upper, (200, arm.n))
        assert np.allclose(sent[:, :3], arm.fk(q)[:, :3, 3], atol=1e-6)
        assert np.allclose(sent[:, 3], arm.aspects(q).manipulability, rtol=1e-5, atol=1e-9)
