"""What a path keeps away all along: what is called proved holds wherever one looks, and is drawn."""

from __future__ import annotations

import json

import numpy as np
import pytest

import pieper
from pieper.cli import main


def random_scene(rng):
    boxes = [pieper.Box(rng.uniform(-0.9, 0.9, 3), rng.uniform(0.05, 0.4, 3), name=f"box {k}") for k in range(3)]
    return pieper.Scene([*boxes, pieper.Capsule(rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3), 0.03, name="rod")])


def random_path(rng, arm, count):
    return rng.uniform(-1.5, 1.5, (1, arm.n)) + np.cumsum(rng.uniform(-0.3, 0.3, (count, arm.n)), axis=0)


@pytest.mark.parametrize("points", [1, 2, 5, 600])
def test_what_is_proved_of_a_stretch_holds_all_along_it(points):
    arm, rng = pieper.load("universal-robots-ur10e"), np.random.default_rng(points)
    proved = 0
    for _ in range(6):
        scene = random_scene(rng)
        path = random_path(rng, arm, min(points, 5))
        if points > 5:
            at = np.linspace(0, 4, points)
            path = np.stack([np.interp(at, np.arange(5), column) for column in path.T], -1)
        kept = arm.clearance(path, scene, 0.01)
        assert kept.swept.verdict is arm.clear(path, scene, 0.01).verdict
        s = (kept.s[:-1, None] + np.diff(kept.s)[:, None] * np.linspace(0, 1, 9)).ravel()
        at = s * (len(path) - 1)
        dense = np.stack([np.interp(at, np.arange(len(path)), column) for column in path.T], -1)
        metres = np.asarray(arm.distance(dense, scene)).reshape(-1, 9)
        known = ~np.isnan(kept.proved)
        assert (metres[known].min(1, initial=np.inf) >= kept.proved[known]).all()
        # nothing is given away where the arm is far from everything
        assert known[metres.min(1) > 0.05].all()
        proved += int(known.sum())
        if points == 1:
            assert kept.s.tolist() == [0.0] and not len(kept.proved)
    assert proved > 100 or points == 1


def test_a_hit_between_two_points_is_as_deep_as_many_postures_see_it():
    arm = pieper.load("universal-robots-ur10e")
    path = np.zeros((2, 6))
    path[:, 1] = -0.5
    path[1, 0] = 2.0
    T = arm.fk([1.234, -0.5, 0, 0, 0, 0])
    post = pieper.Scene([pieper.Capsule(T[:3, 3] - [0, 0, 1], T[:3, 3] + [0, 0, 1], 0.03, name="post")])
    for margin in (0.0, 0.01):
        found = arm.clear(path, post, margin)
        many = arm.distance(path[0] + np.linspace(0, 1, 20001)[:, None] * (path[1] - path[0]), post)
        mine = (many.pair == np.array(found.pair)).all(1)
        # both points of the path are far from the post
        assert found.depth > 0.03 + margin
        assert found.depth >= margin - np.asarray(many)[mine].min() - 1e-9


def test_a_figure_tells_the_pairs_the_margin_and_the_hit(tmp_path, capsys):
    arm = pieper.load("denso-vp6242")
    scene = pieper.Scene([pieper.Box([0.3, 0.0, 0.2], [0.1, 0.4, 0.4], name="crate")])
    path = np.radians([[90, 90, -180, 0, 0, 0], [0, 90, -180, 0, 0, 0]])
    kept = arm.clearance(path, scene, 0.005)
    figure = pieper.plot.clearance_figure(kept)
    labels = figure.axes[0].get_legend_handles_labels()[1]
    assert {"proved to be kept", "not proved to be apart", "margin", "hit"} <= set(labels)
    assert any("crate" in label for label in labels)
    assert figure.get_suptitle().startswith(f"hit at s = {kept.swept.s:.4g}") and "crate" in figure.get_suptitle()
    free = pieper.plot.clearance_figure(arm.clearance(path))
    assert (
        free.get_suptitle().startswith("clear, proved: ") and "hit" not in free.axes[0].get_legend_handles_labels()[1]
    )
    scene.save(tmp_path / "cell.toml")
    there = ["clear", "denso-vp6242", "--from", "90 90 -180 0 0 0", "--to", "0 90 -180 0 0 0"]
    with pytest.raises(SystemExit) as left:
        main([*there, "--scene", str(tmp_path / "cell.toml"), "--plot", str(tmp_path / "proof.svg"), "--json"])
    assert left.value.code == 1 and json.loads(capsys.readouterr().out)["verdict"] == "HIT"
    assert "<svg" in (tmp_path / "proof.svg").read_text()
