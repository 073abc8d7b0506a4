"""Bad input gets a clear error, a hard arm an honest status, and nothing hangs."""

from __future__ import annotations

import contextlib
import faulthandler
import time
import warnings

import numpy as np
import pytest

import pieper
from oracle.joints import turns_apart
from pieper import DH, Arm

QUARTER = np.pi / 2
Q = np.array([0.3, 0.5, -2.4, 0.6, 0.7, 0.2])


@contextlib.contextmanager
def within(seconds: float):
    """Fail where the block computes longer; end the process with a traceback where it hangs in native code."""
    faulthandler.dump_traceback_later(30 * seconds, exit=True)
    start = time.process_time()  # a busy machine is not the library's fault
    try:
        yield
    finally:
        faulthandler.cancel_dump_traceback_later()
    spent = time.process_time() - start
    assert spent < seconds, f"took {spent:.1f} s"


@pytest.fixture(scope="module")
def arm():
    return pieper.load("denso-vp6242")


@pytest.fixture(scope="module")
def general():
    return pieper.load("motoman-ea1400n")


def edited(T, change):
    """Return a copy of T that change has been applied to."""
    T = T.copy()
    return T if change(T) is None else change(T)


def put(row, column, value):
    """Return an edit that sets one entry."""

    def change(T):
        T[row, column] = value

    return change


BAD_POSES = {
    "nan in the rotation": (put(0, 1, np.nan), "finite"),
    "nan in the position": (put(1, 3, np.nan), "finite"),
    "infinity": (put(2, 3, np.inf), "finite"),
    "3x3": (lambda T: T[:3, :3], "(4, 4)"),
    "one row": (lambda T: T[0], "(4, 4)"),
    "5x5": (lambda T: np.eye(5), "(4, 4)"),
    "a batch": (lambda T: np.stack([T, T]), "(4, 4)"),
    "left-handed": (lambda T: T @ np.diag([1.0, 1, -1, 1]), "rotation"),
    "scaled": (lambda T: T @ np.diag([2.0, 2, 2, 1]), "rotation"),
    "sheared": (lambda T: T @ (np.eye(4) + 0.1 * np.eye(4, k=1) * np.array([[1], [0], [0], [0]])), "rotation"),
    "noisy": (lambda T: T + 1e-3 * np.array([[1, -1, 1, 0], [0, 1, 0, 0], [1, 0, -1, 0], [0] * 4]), "rotation"),
    "zero": (lambda T: np.zeros((4, 4)), ""),
    "bad last row": (put(3, 0, 0.5), ""),
    "text": (lambda T: "pose", ""),
    "none": (lambda T: None if T is None else "none", ""),
    "complex": (lambda T: T + 0.5j, ""),
    "ragged": (lambda T: [[1, 2], [3]], ""),
    "empty": (lambda T: np.zeros((0, 4)), ""),
}


@pytest.mark.parametrize("name", BAD_POSES)
@pytest.mark.parametrize("which", ["arm", "general"])
def test_a_bad_pose_is_refused_with_what_is_wrong_with_it(request, which, name):
    arm = request.getfixturevalue(which)
    change, word = BAD_POSES[name]
    T = arm.fk(Q)
    bad = None if name == "none" else change(T.copy())
    bad = edited(T, change) if bad is None and name != "none" else bad
    with within(2), pytest.raises(ValueError) as error, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        arm.ik(bad)
    assert isinstance(error.value, pieper.InputError), f"{type(error.value).__name__} is not an InputError"
    assert word in str(error.value), str(error.value)


@pytest.mark.parametrize("name", ["nan in the rotation", "left-handed", "scaled", "noisy", "zero", "bad last row"])
@pytest.mark.parametrize("which", ["arm", "general"])
def test_one_bad_pose_among_many_is_named_by_its_index(request, which, name):
    arm = request.getfixturevalue(which)
    Ts = np.stack([arm.fk(Q)] * 9)
    changed = BAD_POSES[name][0](Ts[7])
    if changed is not None:
        Ts[7] = changed
    with within(2), pytest.raises(pieper.InputError) as error:
        arm.ik_many(Ts)
    assert "7" in str(error.value)


@pytest.mark.parametrize("shape", [(4, 4), (2, 3, 4), (2, 2, 4, 4), (3,)])
def test_many_poses_of_the_wrong_shape_are_refused(arm, shape):
    Ts = np.broadcast_to(np.eye(4), shape) if shape[-2:] == (4, 4) else np.zeros(shape)
    with within(2), pytest.raises(pieper.InputError) as error:
        arm.ik_many(Ts)
    assert "4, 4" in str(error.value)


def test_no_poses_at_all_are_an_empty_batch(arm):
    many = arm.ik_many(np.zeros((0, 4, 4)))
    assert many.q.shape == (0, arm.plan.max_solutions, 6) and many.valid.shape == (0, arm.plan.max_solutions)


@pytest.mark.parametrize("threads", [0, -1, 1.5, "two"])
def test_an_impossible_number_of_threads_is_refused(arm, threads):
    with within(2), pytest.raises(ValueError):
        arm.ik_many(np.stack([arm.fk(Q)]), threads=threads)


@pytest.mark.parametrize("which", ["arm", "general"])
def test_a_pose_rounded_to_float32_is_solved_and_said_to_be_rounded(request, which):
    arm = request.getfixturevalue(which)
    T = arm.fk(Q).astype(np.float32).astype(float)
    sols = arm.ik(T)
    gap = turns_apart(sols.all_q, Q).max(1).min()
    assert sols.rounded and gap < 1e-4
    assert arm.ik_many(T[None]).flag[0] & 8
    assert not arm.ik(arm.fk(Q)).rounded


def test_a_rounded_pose_of_a_redundant_arm_is_said_to_be_rounded():
    arm = pieper.load("franka-panda")
    T = arm.fk(np.full(7, 0.4))
    rounded = T.astype(np.float32).astype(float)
    assert arm.ik(rounded, redundancy=0.4).rounded and arm.ik_many(rounded[None], redundancy=0.4).flag[0] & 8
    assert not arm.ik(T, redundancy=0.4).rounded and not arm.ik_many(T[None], redundancy=0.4).flag[0] & 8


@pytest.mark.parametrize("q", [np.zeros(5), np.zeros((2, 7)), np.full(6, np.nan), "abc", None, 3.0, [[1, 2], [3]]])
@pytest.mark.parametrize("method", ["fk", "frames", "jacobian"])
def test_bad_joint_vectors_are_refused(arm, method, q):
    with within(2), pytest.raises(pieper.InputError):
        getattr(arm, method)(q)


def test_a_huge_pose_is_out_of_reach_with_a_number(arm, general):
    for each in (arm, general):
        T = each.fk(Q)
        for far in (1e3, 1e9):
            T[:3, 3] = [far, 0, 0]
            with within(5):
                sols = each.ik(T)
            assert sols.status.name == "OUT_OF_REACH" and len(sols.all_q) == 0
            assert any(c.isdigit() for c in sols.why)
            assert not {"nan", "inf"} & set(sols.why.split())
        T[:3, 3] = [1e300, 0, 0]
        with within(5), pytest.raises(pieper.InputError, match="metres"):
            each.ik(T)


@pytest.mark.parametrize("task", ["poses", "", 3, "axis", None.__class__])
def test_an_unknown_task_is_refused_and_the_known_ones_are_named(arm, task):
    with within(2), pytest.raises(pieper.InputError) as error:
        arm.ik(arm.fk(Q), task=task)
    assert "position+axis" in str(error.value)


@pytest.mark.parametrize("value", [np.nan, np.inf, "a", [1, 2, 3]])
def test_an_impossible_redundancy_value_is_refused(value):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    T = arm.fk(np.full(7, 0.4))
    with within(5), pytest.raises(pieper.InputError):
        arm.ik(T, redundancy=value)


def test_a_redundancy_value_outside_the_limits_is_said(arm):
    seven = pieper.load("kuka-lbr-iiwa-14-r820")
    T = seven.fk(np.full(7, 0.4))
    with within(10):
        try:
            sols = seven.ik(T, redundancy=3.1)
        except pieper.InputError as error:
            assert "limit" in str(error) or "range" in str(error)
        else:
            assert len(sols.q) == 0 and sols.status.name in ("OUTSIDE_LIMITS", "OUT_OF_REACH")


@pytest.mark.parametrize(
    ("value", "word"),
    [
        ({"elbow": 0.1}, "joint_1, joint_2"),
        ({"joint_1": np.nan}, "finite"),
        ({"joint_1": "a"}, "finite"),
        ({"joint_1": 3.1}, "limits"),
        ({"arm angle": np.inf}, "finite"),
        ({"arm angle": None}, "finite"),
        ([[0.1, 0.2]], "shape"),
        ([0.1, 0.2, 0.3, 0.4], "shape"),
    ],
)
def test_an_impossible_redundancy_by_name_or_pose_is_refused_alone_and_in_a_batch(value, word):
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    T = arm.fk(np.full(7, 0.4))
    with within(5), pytest.raises(pieper.InputError, match=word):
        arm.ik(T, redundancy=value)
    with within(5), pytest.raises(pieper.InputError, match=word):
        arm.ik_many(np.stack([T, T]), redundancy=value)


def test_one_impossible_redundancy_among_many_is_refused():
    arm = pieper.load("kuka-lbr-iiwa-14-r820")
    Ts = np.stack([arm.fk(np.full(7, 0.4))] * 3)
    for values, word in (([0.1, np.nan, 0.2], "finite"), ([0.1, 0.2, 9.0], "limits")):
        with within(5), pytest.raises(pieper.InputError, match=word):
            arm.ik_many(Ts, redundancy=values)


def test_too_few_values_for_several_spare_joints_are_refused_and_the_joints_named():
    arm = Arm.from_dh([DH(0.1, 1.0, 0.2, 0)] * 9, convention="standard")
    with within(10), pytest.raises(pieper.InputError) as error:
        arm.ik(arm.fk(np.full(9, 0.3)), redundancy=0.2)
    assert all(name in str(error.value) for name in arm.plan.redundancy) and len(arm.plan.redundancy) == 3


def test_thirty_joints_give_their_self_motions_in_bounded_time():
    arm = HARD["30 joints"]()
    with within(60):
        sols = arm.ik(arm.fk(np.linspace(-1, 1, 30)))
        assert sols.self_motions and all(motion.dimension > 1 for motion in sols.self_motions)


def test_a_bad_pose_of_a_redundant_arm_is_refused_and_named_by_its_index():
    arm = pieper.load("franka-panda")
    for change, _ in (BAD_POSES[name] for name in ("nan in the rotation", "left-handed", "scaled", "bad last row")):
        Ts = np.stack([arm.fk(np.full(7, 0.4))] * 9)
        changed = change(Ts[7])
        if changed is not None:
            Ts[7] = changed
        with within(5), pytest.raises(pieper.InputError, match="7"):
            arm.ik_many(Ts, redundancy=0.4)


def test_a_redundancy_value_for_an_arm_that_has_none_is_refused(arm):
    with pytest.raises(pieper.InputError):
        arm.ik(arm.fk(Q), redundancy=0.3)


def same_rows(n, row, types=None):
    """Return an arm of n equal DH rows."""
    return Arm.from_dh([DH(*row)] * n, convention="standard", joint_types=types, name=f"{n} equal rows")


HARD = {
    "zero reach": lambda: same_rows(6, (0, QUARTER, 0, 0)),
    "zero reach, nothing at all": lambda: same_rows(6, (0, 0, 0, 0)),
    "two identical joints": lambda: Arm.from_dh(
        [
            DH(0, 0, 0.3, 0),
            DH(0, QUARTER, 0, 0),
            DH(0.4, 0, 0, 0),
            DH(0.3, QUARTER, 0, 0),
            DH(0, -QUARTER, 0.1, 0),
            DH(0, 0, 0.1, 0),
        ],
        convention="standard",
    ),
    "all axes parallel": lambda: same_rows(6, (0.3, 0, 0, 0)),
    "all axes parallel, slides": lambda: same_rows(6, (0.3, 0, 0.1, 0), "RPRPRP"),
    "all slides": lambda: same_rows(6, (0.2, QUARTER, 0.1, 0.3), "PPPPPP"),
    "all slides parallel": lambda: same_rows(6, (0.2, 0, 0.1, 0.3), "PPPPPP"),
    "30 joints": lambda: same_rows(30, (0.1, QUARTER, 0.05, 0.2)),
    "30 parallel joints": lambda: same_rows(30, (0.1, 0, 0, 0)),
    "one joint": lambda: same_rows(1, (0.1, QUARTER, 0.05, 0.2)),
    "one slide": lambda: same_rows(1, (0.1, QUARTER, 0.05, 0.2), "P"),
    "axes through one point": lambda: same_rows(6, (0, 1.0, 0, 0.2)),
    "a millionth of a metre": lambda: same_rows(6, (1e-6, 1.1, 2e-6, 0.2)),
    "a million metres": lambda: same_rows(6, (1e6, 1.1, 2e6, 0.2)),
    "mixed scales": lambda: Arm.from_dh(
        [
            DH(1e-6, 1.1, 1e3, 0),
            DH(1.0, QUARTER, 1e-6, 0),
            DH(1e3, 0.3, 0, 0),
            DH(1e-3, 1, 1, 0),
            DH(0, 1, 1, 0),
            DH(1, 1, 1, 0),
        ],
        convention="standard",
    ),
}


@pytest.mark.parametrize("name", HARD)
def test_a_hard_arm_is_planned_or_refused_and_answers_truly(name):
    """True answers with an honest status for poses it can take, or a plan that says why not."""
    with within(30):
        arm = HARD[name]()
        size = max(arm.chain.length, 1e-12)
        rng = np.random.default_rng(3)
        try:
            plan = arm.plan
        except pieper.PlanError as error:
            assert len(str(error)) > 40
            return
        for _ in range(2):
            q = rng.uniform(-1, 1, arm.n) * np.where(np.array(list(arm.joint_types)) == "P", size, np.pi)
            T = arm.fk(q)
            sols = arm.ik(T)
            error = sols.residual
            assert np.isfinite(sols.all_q).all()
            assert len(sols.all_q) or sols.status.name == "UNCERTAIN", f"{sols.status.name}: {sols.why}"
            assert not len(error) or (error[:, 0].max() < 1e-8 * (size + np.abs(T).max()) and error[:, 1].max() < 1e-8)
            again = arm.ik_many(np.stack([T, T]), threads=1)
            assert again.valid.any(1).all() or sols.status.name == "UNCERTAIN"
        assert plan.explain()


@pytest.mark.parametrize("task", ["pose", "position", "position+axis"])
@pytest.mark.parametrize("name", ["one joint", "one slide", "all slides", "all axes parallel", "zero reach"])
def test_a_task_beyond_an_arm_s_joints_is_answered_or_refused(name, task):
    arm = HARD[name]()
    q = np.linspace(0.1, 0.7, arm.n)
    with within(30):
        try:
            sols = arm.ik(arm.fk(q), task=task)
        except pieper.PlanError as error:
            assert len(str(error)) > 40
            return
        assert len(sols.all_q) or sols.status.name == "UNCERTAIN", f"{sols.status.name}: {sols.why}"


@pytest.mark.parametrize(
    "limits",
    [[(1.0, -1.0)] * 6, [(np.nan, 1.0)] * 6, [(-1.0, 1.0)] * 5, [(0.0,)] * 6, "wide", [("a", "b")] * 6],
)
def test_impossible_limits_are_refused(limits):
    with within(2), pytest.raises(ValueError):
        Arm.from_dh([DH(0.1, QUARTER, 0.2, 0)] * 6, convention="standard", limits=limits)


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([], {}),
        ([(np.nan, 0, 0, 0)], {}),
        ([(np.inf, 0, 0, 0)], {}),
        ([DH(0.1, 0, 0, 0)], {"convention": "classic"}),
        ([DH(0.1, 0, 0, 0)], {"joint_types": "X"}),
        ([DH(0.1, 0, 0, 0)], {"joint_types": "RR"}),
        ([DH(0.1, 0, 0, 0)], {"base": np.eye(3)}),
        ([DH(0.1, 0, 0, 0)], {"tool": np.diag([1.0, 1, -1, 1])}),
        ([DH(0.1, 0, 0, 0)], {"tool": np.full((4, 4), np.nan)}),
        ([(0.1, 0)], {}),
        ("rows", {}),
    ],
)
def test_impossible_tables_are_refused(rows, said):
    with within(2), pytest.raises(ValueError):
        Arm.from_dh(rows, **{"convention": "standard", **said})


def test_the_convention_must_be_said():
    with pytest.raises(TypeError):
        Arm.from_dh([DH(0.1, 0, 0, 0)])


@pytest.mark.parametrize("T1", [np.eye(3), np.full((4, 4), np.nan), np.diag([1.0, 1, -1, 1]), "end"])
def test_a_path_to_a_bad_pose_is_refused(T1):
    with within(2), pytest.raises(ValueError):
        pieper.line(np.eye(4), T1, n=5)


@pytest.mark.parametrize("n", [-1, 0, 1.5, "many", np.nan])
def test_a_path_of_an_impossible_number_of_points_is_refused(n):
    with within(2), pytest.raises(ValueError):
        pieper.line(np.eye(4), np.eye(4), n=n)


def test_paths_of_no_length_and_of_one_point_are_followed(arm):
    start = np.array([0.1, 0.9, -2.8, 0.2, 0.7, 0.1])
    T = arm.fk(start)
    for path in (pieper.line(T, T, n=5), T[None]):
        with within(10):
            track = arm.follow(path, start=start)
        assert track.complete and np.abs(track.followed - start).max() < 1e-9


@pytest.mark.parametrize("where", [0, 2])
def test_a_path_with_a_nan_in_it_is_refused(arm, where):
    path = np.stack([arm.fk(Q)] * 4)
    path[where, 1, 3] = np.nan
    with within(5), pytest.raises(ValueError):
        arm.follow(path, start=Q)
