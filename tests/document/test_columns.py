"""Results as columns: equal lengths, units in names, nothing lost on the way to a file and back."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest

import pieper
from pieper.cli import main

ARMS = "denso-vp6242 franka-panda stanford-arm adept-cobra-600 three-r".split()


def some_pose(arm):
    low, high = np.where(np.isfinite(arm.limits), arm.limits, np.array([-1.0, 1.0])).T
    return arm.fk(low + (high - low) * 0.6)


@pytest.mark.parametrize("name", ARMS)
def test_solutions_come_as_columns_of_equal_length(name):
    arm = pieper.load(name)
    sols = arm.ik(some_pose(arm))
    table = sols.columns()
    assert {len(column) for column in table.values()} == {len(sols.all_q)}
    joints = [f"{n}_{'rad' if k == 'R' else 'm'}" for n, k in zip(arm.joint_names, arm.joint_types, strict=True)]
    assert list(table) == ["solution", *joints, "in_limits", "label", "residual_m", "residual_rad"]
    assert np.array_equal(np.column_stack([table[j] for j in joints]), sols.all_q)
    asked = sols.columns(degrees=True, mm=True)
    for n, kind in zip(arm.joint_names, arm.joint_types, strict=True):
        if kind == "R":
            np.testing.assert_allclose(asked[f"{n}_deg"], np.degrees(table[f"{n}_rad"]), atol=1e-12)
        else:
            np.testing.assert_allclose(asked[f"{n}_mm"], 1e3 * table[f"{n}_m"], atol=1e-12)
    assert json.loads(json.dumps(sols.to_dict())) == sols.to_dict()


def test_a_batch_keeps_a_row_for_a_pose_without_solutions(tmp_path):
    arm = pieper.load("denso-vp6242")
    T = np.stack([some_pose(arm), pieper.pose(9.0, 0, 0), some_pose(arm)])
    many = arm.ik_many(T)
    table = many.columns()
    assert {len(column) for column in table.values()} == {many.count[0] * 2 + 1}
    assert table["pose"].tolist() == sorted(table["pose"].tolist())
    lost = table["pose"] == 2
    assert lost.sum() == 1 and table["solution"][lost] == 0 and table["status"][lost] == "OUT_OF_REACH"
    assert np.isnan(table["joint_1_rad"][lost]).all() and not table["in_limits"][lost].any()
    assert table["solution"][~lost].tolist() == [*range(1, many.count[0] + 1)] * 2
    kept = np.load(many.save(tmp_path / "many.npz"), allow_pickle=False)
    for name, column in table.items():
        np.testing.assert_array_equal(kept[name], column)


def test_tables_count_from_one_and_indices_from_zero(tmp_path):
    arm = pieper.load("denso-vp6242")
    T = np.stack([some_pose(arm)] * 3)
    many = arm.ik_many(T)
    rows, _ = many.rows()
    assert many.columns()["pose"].tolist() == (rows + 1).tolist() == sorted(many.to_dict()["pose"])
    with open(many.save(tmp_path / "ours.csv"), encoding="utf-8") as file:
        ours = [(row["pose"], row["solution"]) for row in csv.DictReader(file)]
    poses = tmp_path / "poses.csv"
    poses.write_text("\n".join(",".join(map(repr, row[:3].ravel().tolist())) for row in T))
    with pytest.raises(SystemExit):
        main(["ik", arm.name, f"@{poses}", "--length", "m", "--all", "--csv", str(tmp_path / "theirs.csv")])
    with (tmp_path / "theirs.csv").open(encoding="utf-8") as file:
        assert [(row["pose"], row["solution"]) for row in csv.DictReader(file)] == ours
    assert many[2].pose == 2 and "at index 2" in repr(many[2])
    with pytest.raises(IndexError, match=r"index 3 of 3 poses; indices go from 0 to 2"):
        many[3]
    T[1, 0, 0] = 7
    with pytest.raises(pieper.InputError, match=r"at index 1\)") as refused:
        arm.ik_many(T)
    assert refused.value.data["index"] == (1,)


def test_csv_reads_back_to_the_last_bit(tmp_path):
    arm = pieper.load("stanford-arm")
    T0 = some_pose(arm)
    T1 = T0.copy()
    T1[2, 3] += 0.05
    track = arm.follow(pieper.line(T0, T1, n=7), start=arm.ik(T0).all_q[0])
    with open(track.save(tmp_path / "track.csv", degrees=True, mm=True), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    table = track.columns(degrees=True, mm=True)
    assert len(rows) == 7 == len(track.path), "one row a point, reached or not"
    for name, column in table.items():
        assert [float(row[name]) for row in rows] == [float(value) for value in column.tolist()]
    assert {"point", "s", "x_mm", "r33", "reached"} <= set(table)


def test_other_endings_are_refused_and_a_frame_needs_pandas(tmp_path, monkeypatch):
    arm = pieper.load("denso-vp6242")
    sols = arm.ik(some_pose(arm))
    with pytest.raises(pieper.InputError, match=r"\.npz or \.csv"):
        sols.save(tmp_path / "rows.parquet")
    assert not list(tmp_path.iterdir())
    monkeypatch.setitem(__import__("sys").modules, "pandas", None)
    with pytest.raises(pieper.InputError, match="needs pandas"):
        sols.to_frame()


def test_a_data_frame_has_the_same_columns():
    pytest.importorskip("pandas")
    arm = pieper.load("denso-vp6242")
    frame = arm.ik(some_pose(arm)).to_frame(degrees=True)
    assert "joint_1_deg" in frame.columns and len(frame) == 8


def test_objects_print_on_one_line():
    arm = pieper.load("denso-vp6242")
    T = some_pose(arm)
    start = arm.ik(T).q[0]
    track = arm.follow(np.stack([T, T]), start=start)
    limits = pieper.Limits(speed=[1.0] * 6, acceleration=[2.0] * 6)
    program = pieper.Program(arm, limits, start=start).wait(0.5)
    singular = arm.ik(arm.fk([0.1, 0.5, -2.0, 0.3, 0.0, 0.2]))
    redundant = pieper.load("franka-panda")
    curves = [*singular.self_motions, *redundant.ik(some_pose(redundant)).self_motions]
    assert len(curves) > 1
    for thing in (arm, arm.plan, singular, arm.ik_many(T[None]), track, program, program.motion(), *curves):
        said = repr(thing)
        assert said.startswith(("<", "Motion(")) and "\n" not in said and len(said) < 200, said
    assert "1 instruction>" in repr(program) and "reached" in repr(track)
