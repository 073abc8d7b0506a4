"""What is pasted: blocks of spreadsheets, CSV of many countries, lists of Python, NumPy and MATLAB."""

from __future__ import annotations

import numpy as np
import pytest

import pieper

from .test_fields import paste

ROW, OTHER = ["0", "90", "125", "0"], ["210", "0", "0", "pi/2"]
DECIMALS = [["0", "90", "125,5", "0"], ["210,25", "0", "0", "0"]]
#: A text and the rows that a reader of it sees.
BLOCKS = {
    "0\t90\t125\t0\r\n210\t0\t0\tpi/2\r\n": [ROW, OTHER],
    "0\t\t125\t0\n\t\t\t\n-75\t-90\t\t0": [["0", "", "125", "0"], [""] * 4, ["-75", "-90", "", "0"]],
    "\t\t125\n210\t0\t0": [["", "", "125"], ["210", "0", "0"]],
    "1\n\n3\n": [["1"], [""], ["3"]],
    "0;90;125,5;0\n210,25;0;0;0": DECIMALS,
    "0;90;125,5;0": DECIMALS[:1],
    "0;;125,5;\n;0;0;0": [["0", "", "125,5", ""], ["", "0", "0", "0"]],
    "0\t90\t125,5\t0\n210,25\t0\t0\t0": DECIMALS,
    "0 90 125,5 0\n210,25 0 0 0": DECIMALS,
    "[0 90 125,5 0; 210,25 0 0 0]": DECIMALS,
    "0,90,125.5,0": [["0", "90", "125.5", "0"]],
    "[[0,90,125,0],[210,0,0,pi/2]]": [ROW, OTHER],
    "[[0, 90, 125, 0],\n [210, 0, 0, pi/2]]": [ROW, OTHER],
    "[(0, 90, 125, 0), (210, 0, 0, pi/2)]": [ROW, OTHER],
    "{{0, 90, 125, 0}, {210, 0, 0, pi/2}}": [ROW, OTHER],
    "T = array([[0, 90,\n       125, 0],\n      [210, 0, 0, pi/2]])": [ROW, OTHER],
    "np.array([[0, 90, 125, 0], [210, 0, 0, pi/2]], dtype=float)": [ROW, OTHER],
    "[np.float64(0.5), np.float64(-2.0)]": [["0.5", "-2.0"]],
    "[0 90 125 0; 210 0 0 pi/2]": [ROW, OTHER],
    "[0, 90, 125, 0\n210, 0, 0, pi/2];": [ROW, OTHER],
    "0 90 125 0;\n210 0 0 pi/2;": [ROW, OTHER],
    "q = [1; 2; 3];": [["1"], ["2"], ["3"]],
    r"\begin{bmatrix} 0 & 90 & 125 & 0 \\ 210 & 0 & 0 & \pi/2 \end{bmatrix}": [ROW, OTHER],
    "0 mm, 90 deg, 125 mm, 0": [["0mm", "90deg", "125mm", "0"]],
    "[cos(pi/3), (1+2)*3, -5]": [["cos(pi/3)", "(1+2)*3", "-5"]],
    # one entry, which the field reads or refuses
    "pi / 2": [["pi/2"]],
    "125 + 85": [["125+85"]],
    "2(1+3)": [["2(1+3)"]],
    "1,5": [["1,5"]],
    "1,234.5": [["1,234.5"]],
    "1.234,5": [["1.234,5"]],
}


@pytest.mark.parametrize("text", BLOCKS)
def test_a_text_is_read_as_the_rows_that_a_reader_sees(calculator, text):
    assert calculator.page.evaluate("t => workbench.block(t)", text) == BLOCKS[text]


def test_python_and_numpy_are_read_as_they_write_themselves(calculator):
    rng = np.random.default_rng(3)
    for shape in ((2, 4), (4, 4), (1, 7), (3, 12)):
        a = rng.normal(scale=10.0 ** rng.integers(-3, 4), size=shape)
        for text in (repr(a), str(a), repr(a.tolist()), repr(list(map(list, a))), repr(tuple(map(tuple, a.tolist())))):
            got = calculator.page.evaluate("t => workbench.block(t).map((r) => r.map((v) => Number(v)))", text)
            assert np.allclose(got, a, rtol=1e-5, atol=1e-6), text


GEOMETRY = (
    "workbench.table.joints.map((j) => [j.a * 1000, j.alpha * 180 / Math.PI, j.d * 1000, j.theta * 180 / Math.PI])"
)


def remark(bench) -> str:
    return bench.page.locator("#remark").inner_text()


def test_an_empty_cell_leaves_what_stood_there_and_what_has_no_cell_is_said(bench):
    bench.tab("DH table")
    before = np.array(bench.value(GEOMETRY), dtype=float)
    paste(bench, "dh-1-a", "7\t\t125,5\t0\n\t\t\t\n-75\t-90\t\t1")
    want = before.copy()
    want[0] = [7, before[0, 1], 125.5, 0]
    want[2] = [-75, -90, before[2, 2], 1]
    assert np.allclose(bench.value(GEOMETRY), want)
    assert "Pasted 6 numbers; 6 empty cells left what stood there" in remark(bench)
    paste(bench, "dh-1-d", "1\t2\t3\n4\t5\t6")
    want[:2, 2:] = [[1, 2], [4, 5]]
    assert np.allclose(bench.value(GEOMETRY), want)
    assert "Pasted 4 numbers; 2 had no cell" in remark(bench)
    bench.page.get_by_role("button", name="Limits and zeros").click()
    paste(bench, "dh-1-lower", "-10\t\t0\n\t20\t0")
    limits = np.array(bench.value("workbench.table.joints.slice(0, 2).map((j) => [j.lower, j.upper])"), dtype=float)
    assert np.allclose(limits, np.radians([[-10, np.nan], [np.nan, 20]]), equal_nan=True), "no number there is no limit"


def test_a_pose_is_pasted_along_its_fields_and_a_longer_list_is_refused(bench):
    bench.tab("Inverse")
    shown = "[...document.querySelectorAll('input[data-testid^=target-]')].slice(0, 6).map((f) => f.value)"
    paste(bench, "target-0", "300,5\t0\t250,25\t180\t0\t0")
    assert bench.value("workbench.target[3]") == pytest.approx(0.3005)
    paste(bench, "target-0", "302\t\t250\t170\t\t")
    bench.page.get_by_test_id("target-0").blur()
    assert np.allclose([float(v) for v in bench.value(shown)], [302, 0, 250, 170, 0, 0])
    assert bench.value("workbench.history")[0] == "paste a pose"
    before = bench.value("workbench.target")
    paste(bench, "target-0", "1 0 0 300 0 1 0 0 0 0 1 200")
    assert "12 numbers for 6 fields: nothing was pasted" in remark(bench)
    assert bench.value("workbench.target") == before


@pytest.mark.parametrize("form", ["tabs", "blanks", "csv", "three rows", "expressions"])
def test_a_matrix_with_decimal_commas_is_read(bench, form):
    T = pieper.load("denso-vp6242").fk(np.radians([10, 70, -160, 20, 50, 30]))
    T[:3, 3] *= 1000
    between = {"csv": ";", "blanks": " "}.get(form, "\t")
    rows = [between.join(f"{v:.5f}" for v in row).replace(".", ",") for row in T[: 3 if form == "three rows" else 4]]
    if form == "expressions":
        T = np.array([[0.5, -np.sqrt(3) / 2, 0, 250], [np.sqrt(3) / 2, 0.5, 0, 40], [0, 0, 1, 300], [0, 0, 0, 1.0]])
        rows = ["[cos(pi/3), -sin(pi/3), 0, 0.25 m]", "[sin(pi/3), cos(pi/3), 0, 4 cm]", "[0, 0, 1, 300]"]
    bench.tab("Inverse")
    bench.button("Matrix")
    bench.page.get_by_test_id("target-matrix").fill("\n".join(rows))
    got = np.reshape(bench.value("workbench.target"), (4, 4))
    assert np.allclose(got[:3, 3], T[:3, 3] / 1000, atol=1e-8) and np.allclose(got[:3, :3], T[:3, :3], atol=1e-5)


def test_a_matrix_says_which_of_its_entries_cannot_be_read(bench):
    bench.tab("Inverse")
    bench.button("Matrix")
    bench.page.get_by_test_id("target-matrix").fill("1\t0\t0\t1.234,5\n0\t1\t0\t0\n0\t0\t1\t200")
    bench.page.get_by_text("row 1, column 4: a comma is the decimal sign").wait_for()


def test_joint_values_and_postures_of_a_sequence_are_pasted_as_one_step(bench):
    paste(bench, "q-1", "[10, 20.5, -150, 5, 6, 7]")
    assert np.allclose(bench.value("workbench.q"), np.radians([10, 20.5, -150, 5, 6, 7]))
    assert bench.value("workbench.history")[0] == "paste joint values"
    paste(bench, "q-5", "1 2 3")
    assert "3 numbers for 2 fields: nothing was pasted" in remark(bench)
    bench.tab("Sequence")
    for _ in range(3):
        bench.page.get_by_test_id("add-posture").click()
    paste(bench, "seq-1-q1", "1\t2\t\t4\t5\t6\n7\t8\t9\t10\t11\t12")
    got = np.degrees(bench.value("workbench.said.sequence.postures.map((p) => p.q)"))
    assert np.allclose(got[1:], [[1, 2, -150, 4, 5, 6], [7, 8, 9, 10, 11, 12]])
    bench.button("Undo")
    got = np.degrees(bench.value("workbench.said.sequence.postures.map((p) => p.q)"))
    assert np.allclose(got, [[10, 20.5, -150, 5, 6, 7]] * 3), "one step"
