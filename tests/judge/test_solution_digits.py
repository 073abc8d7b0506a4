"""A printed solution reaches its pose to the last digit of every joint, by that joint's own lever, and no more."""

from __future__ import annotations

import numpy as np
import pytest

import pieper
from oracle.arms import claim_headers
from pieper.judge.digits import box_least_squares

LENGTHS = 0.4318, 0.1244, 0.0203
D = pieper.DH
ARM = pieper.Arm.from_dh(
    [D(), D(0, -np.pi / 2), D(LENGTHS[0], 0, LENGTHS[1]), D(LENGTHS[2], -np.pi / 2, LENGTHS[0]), D(0, np.pi / 2)]
    + [D(0, -np.pi / 2)],
    convention="modified",
)


def puma(unit: str = "m") -> str:
    """Craig's Puma in metres or millimetres."""
    size = 1000 if unit == "mm" else 1
    length, offset, elbow = (size * x for x in LENGTHS)
    return claim_headers.puma(length, offset, elbow, length, unit)


def solutions(arm: str, rows: object, more: str):
    """The verdict on a list of solutions."""
    shown = str(rows).replace("'", '"')
    (found,) = pieper.check(f'{arm}\n[[claim]]\nkind = "solutions"\nsolutions_deg = {shown}\n{more}\n').verdicts
    return found


POSE = "q_deg = [10, 20, 30, 40, 50, 60]"


@pytest.mark.parametrize("unit", ["m", "mm"])
@pytest.mark.parametrize("decimals", [0, 1, 3])
def test_no_joint_may_be_off_by_more_than_its_last_digit(decimals, unit):
    """Whatever the other joints' last digits allow, one joint two units off is no solution."""
    right = np.array([10, 20, 30, 40, 50, 60.0])

    def shown(q: np.ndarray) -> list[str]:
        return [f"{v:.{decimals}f}" for v in q]

    assert solutions(puma(unit), [shown(right)], POSE).holds
    for joint, units in zip(range(6), (2, -2, 6, -6, 2, -2), strict=True):
        wrong = right.copy()
        wrong[joint] += units * 10.0**-decimals
        assert solutions(puma(unit), [shown(wrong)], POSE).wrong, (joint, units)


def test_plain_numbers_of_a_file_are_as_fine_as_the_finest_beside_them():
    assert solutions(puma(), [[10.5, 20.0, 30.0, 40.0, 50.0, 60.0]], POSE).wrong
    assert solutions(puma(), [[10, 20, 30, 40, 50, 60]], POSE).holds
    assert solutions(puma(), [[10, 14, 30, 40, 50, 60]], POSE).wrong


def test_every_solution_of_a_printed_pose_holds_to_its_digits_and_none_that_is_off():
    """The pose and the joints rounded as pages round them; the solver's rows are the right ones."""
    rng = np.random.default_rng(1)
    for _ in range(4):
        T = ARM.fk(rng.uniform(-np.pi, np.pi, 6))
        q = np.degrees(ARM.ik(T).q)
        finest, decimals = int(rng.integers(3, 7)), int(rng.integers(0, 5))
        matrix = "[" + ", ".join(str([f"{x:.{finest}f}" for x in row]).replace("'", '"') for row in T[:3]) + "]"
        rows = [[f"{x:.{decimals}f}" for x in row] for row in q]
        assert solutions(puma(), rows, f"matrix = {matrix}").holds
        k, joint = int(rng.integers(len(q))), int(rng.integers(6))
        off = max(3 * 10.0**-decimals, np.degrees(20 * 10.0**-finest))
        rows[k][joint] = f"{q[k][joint] + off:.{decimals}f}"
        assert solutions(puma(), rows, f"matrix = {matrix}").wrong, (finest, decimals, joint)


def test_joints_that_are_cut_off_hold():
    T = ARM.fk([0.3, 0.4, -0.5, 0.6, 0.7, -0.8])
    matrix = "[" + ", ".join(str([repr(float(x)) for x in row]).replace("'", '"') for row in T[:3]) + "]"
    cut = [[f"{np.trunc(10 * x) / 10:.1f}" for x in row] for row in np.degrees(ARM.ik(T).q)]
    assert solutions(puma(), cut, f"matrix = {matrix}").holds


def test_a_slide_s_digits_are_lengths():
    arm = """[arm]
convention = "standard"
length_unit = "mm"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0, "a1", 0], [0, "b2", 0, "90 deg"]]
values = { a1 = 400 }
"""
    pose = "q_deg = [30, 120]"
    for value, holds in (("120", True), ("121", False), ("119.9", False), ("120.0", True)):
        assert solutions(arm, [["30", value]], pose).holds == holds, value
    assert solutions(arm, [["32", "120"]], pose).wrong


def test_the_search_in_the_box_finds_the_least_value():
    """Against the bounded least squares of scipy."""
    optimize = pytest.importorskip("scipy.optimize")
    rng = np.random.default_rng(4)
    for _ in range(200):
        m, n = rng.integers(1, 9, 2)
        A, b = rng.normal(size=(m, n)), rng.normal(size=m) * rng.choice([0.3, 1, 4])
        if rng.random() < 0.3 and n > 1:
            A[:, 0] = A[:, 1]
        z = box_least_squares(A, b)
        best = optimize.lsq_linear(A, b, (-1, 1), method="bvls").x
        assert np.abs(z).max() <= 1
        assert np.linalg.norm(A @ z - b) <= np.linalg.norm(A @ best - b) + 1e-9


def test_the_jacobian_of_a_joint_whose_table_has_minus_q_turns_the_other_way():
    arm = """[arm]
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0, "a1", 0], ["-q2", 0, "a2", 0]]
values = { a1 = 0.4, a2 = 0.3 }
[[claim]]
kind = "jacobian"
of = "J[1,2]"
is = "a2 sin(q1 - q2)"
[[claim]]
kind = "jacobian"
of = "J[6,2]"
is = "-1"
"""
    assert all(found.holds for found in pieper.check(arm).verdicts)
