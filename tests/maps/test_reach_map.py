"""Maps are what asking pose by pose gives, whoever computes the tiles and whatever happens in between."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import pieper
from pieper.maps import reach_map as maps
from pieper.maps.grid import orientations_of
from tests.calibration.command import main
from tests.calibration.planted import postures

PAGE = Path(__file__).parents[2] / "docs" / "maps.md"
BOX = ((-0.6, 0.5), (-0.5, 0.6), (-0.2, 0.8))
ARMS = ("denso-vp6242", "universal-robots-ur5e", "fanuc-crx-10ia", "stanford-arm", "unimation-puma-560", "abb-irb140")


def small(arm, **more):
    return arm.reach_map(BOX, 0.25, orientations=(6, 4), **more)


@pytest.mark.parametrize("name", ARMS)
def test_a_map_is_what_asking_each_pose_gives(name):
    arm = pieper.load(name)
    m = small(arm)
    T = m.grid.poses(np.arange(m.grid.count), m.grid.turns).reshape(m.grid.count, -1, 4, 4)
    rng = np.random.default_rng(1)
    bits = np.unpackbits(m.bits, axis=1)[:, : len(m.grid.turns)].astype(bool)
    for voxel in rng.choice(m.grid.count, 12, replace=False):
        asked = [arm.ik(pose) for pose in T[voxel]]
        assert [bool(len(s.q)) or any(len(c.inside) for c in s.self_motions) for s in asked] == bits[voxel].tolist()
        if all(not s.self_motions for s in asked):
            assert sum(len(s.q) for s in asked) == m.count.ravel()[voxel]


@pytest.mark.parametrize("name", ARMS)
def test_symmetry_changes_no_bit(name):
    arm = pieper.load(name)
    for limits in (None, {arm.joint_names[-1]: (-0.5, 1.0)}, {arm.joint_names[-1]: (-9.0, -4.0)}):
        tried = arm if limits is None else arm.with_limits(limits)
        a, b = small(tried), small(tried, symmetry="none")
        assert np.array_equal(a.bits, b.bits)
        assert np.array_equal(a.count, b.count)


def test_a_voxel_on_the_first_axis_is_asked_as_well():
    arm = pieper.load("denso-vp6242")
    box = ((-0.05, 0.05), (-0.05, 0.05), (0.5, 0.6))
    a, b = (arm.reach_map(box, 0.1, (16, 4), symmetry=s) for s in ("auto", "none"))
    assert np.array_equal(a.bits, b.bits)


@pytest.mark.parametrize("name", [*ARMS, "franka-panda", "adept-cobra-600", "three-r"])
def test_the_pose_of_any_joint_vector_is_reached(name):
    arm, rng = pieper.load(name), np.random.default_rng(2)
    m = arm.reach_map(((0.0, 0.1), (0.0, 0.1), (0.0, 0.1)), 0.1, (1, 1))
    assert m.reached(arm.fk(postures(arm, rng, 30))).all()
    assert m.reached(arm.fk(postures(arm, rng, 1)[0])).shape == ()
    assert not m.reached(pieper.pose(50.0, 0.0, 0.0))


def test_looking_a_pose_up_is_mostly_right():
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(3)
    m = arm.reach_map(((-0.6, 0.6), (-0.6, 0.6), (-0.3, 0.9)), 0.1, (64, 8))
    T = arm.fk(postures(arm, rng, 500))
    inside, _ = m.grid.voxel_of(T[:, :3, 3])
    assert m.reached(T[inside], cell=True).mean() > 0.85
    centres = m.grid.poses(np.arange(20), m.grid.turns)
    assert np.array_equal(m.reached(centres, cell=True), m.reached(centres))


def test_two_sets_of_orientations_agree_on_the_volume():
    arm = pieper.load("universal-robots-ur5e")
    turned = pieper.pose(0, 0, 0, rpy=(0.3, 0.5, 0.7))[:3, :3] @ orientations_of(64, 4)
    a = arm.reach_map(((-1, 1), (-1, 1), (-1, 1.2)), 0.2, (64, 4))
    b = arm.reach_map(((-1, 1), (-1, 1), (-1, 1.2)), 0.2, turned)
    assert abs(a.volume - b.volume) < 0.04 * a.volume
    assert abs(a.fraction.mean() - b.fraction.mean()) < 0.02


@pytest.fixture
def tiny_tiles(monkeypatch):
    monkeypatch.setattr(maps, "TILE_POSES", 240)


class Backwards(Executor):
    """Runs the newest task first, some twice."""

    def submit(self, fn, /, *args, **kwargs):
        future = Future()
        fn(*args, **kwargs)
        future.set_result(fn(*args, **kwargs))
        return future


@pytest.mark.usefixtures("tiny_tiles")
def test_any_executor_gives_the_same_bits(tmp_path):
    arm = pieper.load("denso-vp6242")
    alone = small(arm)
    with ThreadPoolExecutor(2) as threads, ProcessPoolExecutor(1) as processes:
        for k, executor in enumerate((threads, processes, Backwards())):
            for store in (None, tmp_path / f"store{k}"):
                m = small(arm, executor=executor, store=store)
                assert np.array_equal(m.bits, alone.bits)
                assert np.array_equal(m.count, alone.count)


@pytest.mark.usefixtures("tiny_tiles")
def test_a_map_goes_on_where_it_stopped(tmp_path, monkeypatch):
    arm, store = pieper.load("denso-vp6242"), tmp_path / "map"
    whole = small(arm, store=tmp_path / "other")
    done, solve = [], maps.solved

    def stopping(question, which, threads):
        if len(done) == 3:
            raise KeyboardInterrupt
        done.append(1)
        return solve(question, which, threads)

    monkeypatch.setattr(maps, "solved", stopping)
    with pytest.raises(KeyboardInterrupt):
        small(arm, store=store)
    monkeypatch.setattr(maps, "solved", solve)
    told = []
    m = small(arm, store=store, progress=lambda *said: told.append(said))
    assert m.computed == whole.computed - 3
    assert told == [(k, whole.computed) for k in range(4, whole.computed + 1)]
    assert small(arm, store=store).computed == 0
    names = sorted(p.name for p in store.iterdir())
    assert names == sorted(p.name for p in (tmp_path / "other").iterdir())
    assert all((store / n).read_bytes() == (tmp_path / "other" / n).read_bytes() for n in names)


@pytest.mark.usefixtures("tiny_tiles")
def test_a_spoilt_or_half_written_tile_is_done_again(tmp_path):
    arm, store = pieper.load("denso-vp6242"), tmp_path / "map"
    first = small(arm, store=store)
    tiles = sorted(store.glob("*.npz"))
    data = bytearray(tiles[0].read_bytes())
    data[len(data) // 2] ^= 1
    tiles[0].write_bytes(bytes(data))
    tiles[1].write_bytes(tiles[1].read_bytes()[:100])
    tiles[2].unlink()
    tiles[3].with_suffix(".sha256").unlink()
    again = small(arm, store=store)
    assert again.computed == 4
    assert np.array_equal(first.bits, again.bits)


def test_the_store_of_another_map_is_refused(tmp_path):
    arm = pieper.load("denso-vp6242")
    small(arm, store=tmp_path)
    for other, word in (
        (lambda: small(pieper.load("abb-irb140"), store=tmp_path), "abb-irb140 asked"),
        (lambda: small(arm.with_limits({"joint_2": (0.0, 1.0)}), store=tmp_path), "limits"),
        (lambda: arm.reach_map(BOX, 0.2, (6, 4), store=tmp_path), "step"),
        (lambda: arm.reach_map(BOX, 0.25, (6, 5), store=tmp_path), "orientations"),
    ):
        with pytest.raises(pieper.InputError, match=word):
            other()
    (tmp_path / "map.json").write_text("{")
    with pytest.raises(pieper.InputError, match="does not say which map"):
        small(arm, store=tmp_path)


def test_a_full_disk_leaves_nothing_half(tmp_path, monkeypatch):
    from pieper.maps import store

    arm, write = pieper.load("denso-vp6242"), store.whole_file

    def full(path):
        if str(path).endswith(".npz"):
            raise OSError(28, "No space left on device")
        return write(path)

    monkeypatch.setattr(store, "whole_file", full)
    with pytest.raises(OSError, match="space"):
        small(arm, store=tmp_path)
    monkeypatch.setattr(store, "whole_file", write)
    assert small(arm, store=tmp_path).computed > 0


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"step": 0}, "positive"),
        ({"step": -0.1}, "positive"),
        ({"step": 20}, "20 mm is 0.02"),
        ({"step": float("nan")}, "finite number"),
        ({"step": "fine"}, "finite number"),
        ({"box": ((-600, 600), (-600, 600), (0, 800))}, "metres are meant"),
        ({"box": ((0, 1), (0, 1))}, "x0 < x1"),
        ({"box": ((1, 0), (0, 1), (0, 1))}, "x0 < x1"),
        ({"orientations": (0, 4)}, "at least 1"),
        ({"orientations": 128}, "at least 1"),
        ({"orientations": 2 * np.eye(3)[None]}, "not a rotation"),
        ({"symmetry": "mirror"}, "'auto' or 'none'"),
        ({"step": 0.0005}, "give a store="),
    ],
)
def test_impossible_maps_are_refused(said, words):
    asked = {"box": BOX, "step": 0.25, "orientations": (6, 4)} | said
    with pytest.raises(pieper.InputError, match=words):
        pieper.load("denso-vp6242").reach_map(**asked)


@pytest.mark.parametrize(
    ("step", "orientations", "words"),
    [
        (0.1, (10**7, 16), "11.5 GB: give fewer"),
        (0.1, (10**6, 10**6), "72,000 GB: give fewer"),
        (1e-12, (128, 16), "7e[+]35 voxels with 2048 orientations each, 1.85e[+]29 GB"),
        (5e-4, (128, 16), "5,600,000,000 voxels with 2048 orientations each, 1,478 GB: give a store="),
    ],
)
def test_what_is_too_much_is_refused_before_it_is_made(step, orientations, words, monkeypatch):
    monkeypatch.setattr("pieper.maps.grid.orientations_of", lambda *counts: pytest.fail("they were made"))
    with pytest.raises(pieper.InputError, match=words):
        pieper.load("denso-vp6242").reach_map(((-0.5, 0.5), (-0.5, 0.5), (0, 0.7)), step, orientations)


def test_sampled_orientations_of_a_palletizer_are_refused_and_its_own_are_asked():
    arm, box = pieper.load("kuka-kr120-r3200-pa"), ((-3, 3), (-3, 3), (0, 2))
    with pytest.raises(pieper.InputError, match="moves|guides its tool"):
        arm.reach_map(box, 1.0, (16, 4))
    found = arm.reach_map(box, 1.0, arm.fk(np.zeros(4))[None, :3, :3])
    assert found.volume > 50 and "4 joints hold 4 of 6 numbers. " in found.explain()


def test_a_page_that_says_of_no_map_is_refused(tmp_path):
    (tmp_path / "map.json").write_text("[]")
    with pytest.raises(pieper.InputError, match="does not say which map"):
        pieper.load("denso-vp6242").reach_map(((0, 1), (0, 1), (0, 1)), 0.5, (4, 1), store=tmp_path)


def test_degrees_of_a_base_are_cured_by_what_there_is():
    with pytest.warns(pieper.PieperWarning, match=r"yaw has 90 rad.*: numpy.radians\(\.\.\.\) takes those"):
        pieper.load("denso-vp6242").base_places(np.eye(4), [0], [0], [0], [0, 90])


@pytest.mark.skipif(not hasattr(os, "kill") or sys.platform == "win32", reason="signals of POSIX")
def test_workers_end_with_the_command_that_was_killed(tmp_path):
    words = "map ur5e --symmetry none --step 25 --workers 2".split()
    driver = subprocess.Popen(
        [sys.executable, "-m", "pieper", *words, "--box", "-900 900 -900 900 -600 1000", "--out", tmp_path / "kept"],
        stdout=subprocess.PIPE,
    )
    until = time.monotonic() + 120
    while not list(tmp_path.glob("kept/tile_*.sha256")) and time.monotonic() < until:
        time.sleep(0.1)
    driver.kill()
    # whoever holds the pipe open is alive: this returns when the last worker is gone
    assert driver.communicate(timeout=300)[0] == b""


def test_slices_and_voxels_say_the_same():
    m = small(pieper.load("universal-robots-ur5e"))
    assert m.slice(z=0.1).shape == m.fraction.shape[:2]
    assert np.array_equal(m.slice(x=m.axes[0][1]), m.fraction[1])
    found = m.voxels()
    assert len(found.points) == (m.fraction > 0).sum()
    assert found.count.sum() == m.count.sum()
    inside, which = m.grid.voxel_of(found.points)
    assert inside.all() and np.array_equal(m.fraction.ravel()[which], found.fraction)
    for bad in ({}, {"x": 0.0, "z": 0.0}, {"z": 9.0}):
        with pytest.raises(pieper.InputError):
            m.slice(**bad)


def test_a_base_is_placed_where_most_poses_are_reached():
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(4)
    T = arm.fk(postures(arm, rng, 40))
    x, yaw = [-0.4, 0.0, 0.4], [0.0, 1.0]
    shares = arm.base_places(T, x, [0.0], [0.0], yaw)
    assert shares.shape == (3, 1, 1, 2)
    assert shares[1, 0, 0, 0] == 1.0
    base = pieper.pose(0.4, 0, 0, rpy=(0, 0, 1.0))
    expected = [bool(len(arm.ik(np.linalg.inv(base) @ pose).q)) for pose in T]
    assert shares[2, 0, 0, 1] == pytest.approx(np.mean(expected))


def test_the_command_maps(tmp_path, capsys):
    said = ["map", "denso-vp6242", "--box", "-500 500 -500 500 0 700", "--step", "250", "--orientations", "6 4"]
    assert main([*said, "--out", str(tmp_path / "m")]) == 0
    out, told = capsys.readouterr()
    assert "voxels of 250 mm" in out.replace("\n", " ")
    assert told == "pieper: note: the box has whole voxels of 250 mm: it reaches z to 750 mm.\n"
    whole = [word.replace("700", "750") for word in said]
    assert main(whole) == 0 and capsys.readouterr().err == ""
    assert main([*said, "--workers", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["volume_m3"] > 0
    assert main(["map", "denso-vp6242", "--box", "1 2 3", "--step", "250"]) == 2


def test_the_example_of_the_page_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for block in re.findall(r"```python\n(.*?)```", PAGE.read_text(), re.S):
        exec(compile(block, str(PAGE), "exec"), {})


def test_a_store_does_not_make_a_map_larger_than_the_memory_possible(tmp_path):
    """A step typed in metres where millimetres were meant is told before anything is made."""
    with pytest.raises(pieper.InputError, match=r"this machine has .* of memory, which a store does not replace"):
        pieper.load("denso-vp6242").reach_map(((-1, 1),) * 3, 1e-6, (512, 32), store=tmp_path / "big")
    assert not (tmp_path / "big").exists()


def test_a_coupled_arm_is_not_sent_to_a_task_that_it_refuses():
    row = pieper.DH
    arm = pieper.Arm.from_dh(
        [row(a=0.3, d=0.4), row(a=0.25, alpha=np.pi), row(), row(d=0.05)],
        joint_types="RRPR",
        convention="standard",
        limits=[(-2.5, 2.5), (-2.5, 2.5), (0, 0.2), (-13, 13)],
        coupling=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.003], [0, 0, 0, 1]],
    )
    box = ((-0.6, 0.6), (-0.6, 0.6), (-0.3, 0.9))
    said = arm.reach_map(box, 0.3, (8, 4)).explain()
    assert "give orientations that it can hold" in said
    assert "task=" not in said
    held = arm.reach_map(box, 0.3, np.diag([1.0, -1.0, -1.0])[None])
    assert held.solutions.any()
