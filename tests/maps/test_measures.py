"""What a map keeps beside its bits is the best of what asking each pose gives; and what is made of a map."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from tests.calibration.command import main

BOX = ((-0.6, 0.5), (-0.5, 0.6), (-0.2, 0.8))
ARMS = ("denso-vp6242", "universal-robots-ur5e", "fanuc-crx-10ia", "stanford-arm", "abb-irb140")


def small(arm, **more):
    return arm.reach_map(BOX, 0.3, orientations=(6, 4), measure=True, **more)


def best(arm, q):
    """Return the best manipulability and margin of rows, from each one alone."""
    J = np.atleast_3d(arm.jacobian(q).T).T.reshape(-1, 6, arm.n)
    lower, upper = arm.limits.T
    bounded = np.isfinite(lower) & np.isfinite(upper)
    half = np.where(bounded, (upper - lower) / 2, 1.0)
    share = np.minimum(q - lower, upper - q) / half
    share = np.where(bounded, share, 1.0)
    return np.sqrt(np.linalg.det(J @ np.swapaxes(J, 1, 2))).max(), np.clip(share, 0, 1).min(1).max()


@pytest.mark.parametrize("name", ARMS)
def test_the_best_of_a_voxel_is_the_best_of_its_solutions(name):
    arm, rng = pieper.load(name), np.random.default_rng(1)
    m = small(arm)
    T = m.grid.poses(np.arange(m.grid.count), m.grid.turns).reshape(m.grid.count, -1, 4, 4)
    for voxel in rng.choice(np.flatnonzero(m.count.ravel()), 8, replace=False):
        rows = arm.ik_many(T[voxel])
        q = rows.q[rows.in_limits]
        manipulability, margin = best(arm, q)
        assert m.manipulability.ravel()[voxel] == pytest.approx(manipulability, rel=1e-6, abs=1e-9)
        assert m.margin.ravel()[voxel] == pytest.approx(margin, abs=1e-7)
    assert (m.manipulability.ravel()[m.count.ravel() == 0] == 0).all()


@pytest.mark.parametrize("name", ARMS)
def test_symmetry_changes_no_measure(name):
    arm = pieper.load(name)
    a, b = small(arm), small(arm, symmetry="none")
    assert a.manipulability == pytest.approx(b.manipulability, rel=1e-6, abs=1e-9)
    assert a.margin == pytest.approx(b.margin, abs=1e-7)


@pytest.mark.parametrize("name", ["franka-panda", "three-r"])
def test_other_arms_are_measured_too(name):
    m = pieper.load(name).reach_map(((0.2, 0.8), (-0.3, 0.3), (0.1, 0.7)), 0.3, (4, 2), measure=True)
    assert m.manipulability.shape == m.margin.shape == m.count.shape
    assert ((m.manipulability > 0) <= (m.count > 0)).all() and m.margin.max() <= 1


def test_a_map_that_was_not_measured_says_so():
    m = pieper.load("denso-vp6242").reach_map(BOX, 0.5, (4, 2))
    with pytest.raises(pieper.InputError, match="measure=True"):
        _ = m.margin


def test_measures_are_kept_in_the_store(tmp_path):
    arm = pieper.load("denso-vp6242")
    first, again = small(arm, store=tmp_path), small(arm, store=tmp_path)
    assert again.computed == 0 and np.array_equal(first.margin, again.margin)
    with pytest.raises(pieper.InputError, match="measure True there, False asked"):
        arm.reach_map(BOX, 0.3, (6, 4), store=tmp_path)


def test_two_tools_are_compared_voxel_by_voxel():
    arm = pieper.load("denso-vp6242")
    a, b = (small(x) for x in (arm, arm.with_tool(pieper.pose(0, 0, 0.2))))
    assert np.array_equal(a.minus(b), a.fraction - b.fraction) and np.abs(a.minus(b)).max() > 0
    assert not a.minus(a).any()
    with pytest.raises(pieper.InputError, match="same box"):
        a.minus(arm.reach_map(BOX, 0.25, (6, 4)))


def test_a_map_is_written_for_others(tmp_path):
    m = small(pieper.load("denso-vp6242"))
    held = np.load(m.save(tmp_path / "m.npz"))
    assert np.array_equal(held["fraction"], m.fraction) and np.array_equal(held["x"], m.axes[0])
    data = m.save(tmp_path / "m.vtk").read_bytes()
    nx, ny, nz = m.grid.shape
    assert f"DIMENSIONS {nx + 1} {ny + 1} {nz + 1}".encode() in data
    start = data.index(b"SCALARS fraction double 1\nLOOKUP_TABLE default\n") + 47
    cells = np.frombuffer(data, ">f8", m.grid.count, start).reshape(nz, ny, nx)
    assert np.array_equal(cells.transpose(2, 1, 0), m.fraction)
    with pytest.raises(pieper.InputError, match=r"\.npz, \.parquet, \.vtk"):
        m.save(tmp_path / "m.obj")


def test_a_map_is_written_as_parquet(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    m = small(pieper.load("denso-vp6242"))
    table = parquet.read_table(m.save(tmp_path / "m.parquet"))
    assert np.array_equal(table["fraction"].to_numpy(), m.fraction.ravel())


def test_a_map_is_drawn(tmp_path):
    m = small(pieper.load("denso-vp6242"))
    for what in ("fraction", "count", "manipulability", "margin"):
        assert len(pieper.plot.map_figure(m, what=what, at=(0.1, 0.1, 0.3)).axes) == 4
    with pytest.raises(pieper.InputError, match="it may be"):
        pieper.plot.map_figure(m, what="colour")
    with pytest.raises(pieper.InputError, match="outside"):
        pieper.plot.map_figure(m, at=(9.0, 0.0, 0.0))


def test_the_command_saves_and_draws(tmp_path, capsys):
    said = ["map", "denso-vp6242", "--box", "-500 500 -500 500 0 700", "--step", "250", "--orientations", "6 4"]
    files = [str(tmp_path / "m.vtk"), str(tmp_path / "m.png")]
    assert main([*said, "--measure", "--save", files[0], "--picture", files[1]]) == 0
    assert all((tmp_path / name).stat().st_size > 500 for name in ("m.vtk", "m.png"))
    capsys.readouterr()
