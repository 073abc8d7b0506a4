"""What a store that keeps another map, or is none, says of it: what there is and what was asked, in words."""

from __future__ import annotations

import json

import pytest

import pieper
from pieper.maps import reach_map as maps

BOX, STEP, TURNS = ((-0.4, 0.4), (-0.4, 0.4), (0.0, 0.6)), 0.2, (8, 4)


@pytest.fixture(scope="module")
def arm():
    return pieper.load("denso-vp6242")


@pytest.fixture
def kept(arm, tmp_path):
    arm.reach_map(BOX, STEP, TURNS, store=tmp_path / "map")
    return tmp_path / "map"


def asked_differently(arm, kept):
    """Another map each, and what must be said."""
    ask = lambda own=arm, box=BOX, step=STEP, turns=TURNS, **more: own.reach_map(box, step, turns, store=kept, **more)  # noqa: E731
    yield lambda: ask(own=pieper.load("denso-vs060")), "arm denso-vp6242 there, denso-vs060 asked"
    yield lambda: ask(step=0.1), r"step \(m\) 0\.2 there, 0\.1 asked"
    yield lambda: ask(turns=(16, 4)), "orientations 32 there, 64 asked"
    yield lambda: ask(measure=True), "measure False there, True asked"
    yield lambda: ask(own=arm.with_tool(pieper.pose(0, 0, 0.1))), "links, base, tool or limits"
    yield lambda: ask(own=arm.with_limits({arm.joint_names[0]: (-1, 1)})), "links, base, tool or limits"
    yield lambda: ask(scene=pieper.Scene([])), "scene"
    yield lambda: ask(symmetry="none"), "symmetry"
    yield lambda: ask(task="position"), "task pose there, position asked"


def test_a_store_of_another_map_says_what_is_there_and_what_was_asked(arm, kept):
    for ask, words in asked_differently(arm, kept):
        with pytest.raises(pieper.InputError, match=words) as refused:
            ask()
        assert "sha256" not in str(refused.value) and "Give another folder" in str(refused.value)


def test_a_store_of_another_version_says_which(arm, kept):
    page = kept / "map.json"
    known = json.loads(page.read_text())
    page.write_text(json.dumps(known | {"pieper": "0.0.7"}))
    with pytest.raises(pieper.InputError, match=r"version of pieper 0\.0\.7 there"):
        arm.reach_map(BOX, STEP, TURNS, store=kept)


def test_what_is_no_store_is_said_without_numbers_of_errors(arm, kept, tmp_path):
    (kept / "map.json").write_text("{")
    with pytest.raises(pieper.InputError, match="does not say which map"):
        arm.reach_map(BOX, STEP, TURNS, store=kept)
    (tmp_path / "file").write_text("mine")
    for path in (tmp_path / "file", tmp_path / "file" / "below"):
        with pytest.raises(pieper.InputError, match="a store is a folder") as refused:
            arm.reach_map(BOX, STEP, TURNS, store=path)
        assert "Errno" not in str(refused.value)


def test_places_of_a_base_say_which_list_is_wrong_and_when_poses_are_in_millimetres(arm):
    T = arm.fk("line-start")[None]
    places = {"x": [0.0], "y": [0.0], "z": [0.0], "yaw": [0.0]}
    with pytest.raises(pieper.InputError, match=r"^yaw must be a list of finite numbers, rad"):
        arm.base_places(T, **places | {"yaw": [float("nan")]})
    with pytest.raises(pieper.InputError, match=r"^x must be .* m, at least one, got \[\]"):
        arm.base_places(T, **places | {"x": []})
    with pytest.raises(pieper.InputError, match="no pose"):
        arm.base_places(T[:0], **places)
    T[:, :3, 3] *= 1000
    with pytest.warns(pieper.PieperWarning, match="Were these millimetres"):
        arm.base_places(T, **places)


@pytest.mark.parametrize("gone", ["removed", "null", "", "[]"])
def test_tiles_are_never_taken_for_another_maps_where_nothing_says_whose_they_are(arm, kept, gone):
    other = arm.with_limits({arm.joint_names[0]: (-1, 1)})
    if gone == "removed":
        (kept / "map.json").unlink()
    else:
        (kept / "map.json").write_text(gone)
        with pytest.raises(pieper.InputError, match="does not say which map"):
            other.reach_map(BOX, STEP, TURNS, store=kept)
        (kept / "map.json").unlink()
    wanted = other.reach_map(BOX, STEP, TURNS)
    assert (other.reach_map(BOX, STEP, TURNS, store=kept).bits == wanted.bits).all()


def test_tiles_that_changed_places_are_done_again(arm, tmp_path, monkeypatch):
    monkeypatch.setattr(maps, "TILE_POSES", 400)
    wanted = arm.reach_map(BOX, STEP, TURNS, symmetry="none", store=tmp_path / "s")
    tiles = sorted((tmp_path / "s").glob("tile_*.npz"))
    # two that are not alike, swapped with their marks
    first, other = tiles[0], next(tile for tile in tiles[1:] if tile.read_bytes() != tiles[0].read_bytes())
    for ending in (".npz", ".sha256"):
        a, b = first.with_suffix(ending), other.with_suffix(ending)
        kept_a, kept_b = a.read_bytes(), b.read_bytes()
        a.write_bytes(kept_b)
        b.write_bytes(kept_a)
    again = arm.reach_map(BOX, STEP, TURNS, symmetry="none", store=tmp_path / "s")
    assert (again.bits == wanted.bits).all() and (again.count == wanted.count).all()
