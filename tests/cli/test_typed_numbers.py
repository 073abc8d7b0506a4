"""Commas in numbers, typed and in tables: before decimals, between thousands, between numbers; never silently wrong."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import pieper
from pieper.cli.arguments import numbers
from pieper.cli.pose_file import PoseFile
from pieper.cli.units import Units
from tests.calibration.command import main

ARM = pieper.load("denso-vp6242")


@pytest.mark.parametrize(
    "words",
    [
        ("350,5", "0", "400"),
        ("350,5", "0,0", "400,5"),
        ("1.234,5", "0", "400"),
        ("1,234.5", "0", "400"),
        ("1,234", "0", "400"),
        ("0 51,5 -150,6 0",),
        ("0", "51,5", "-150,6", "0"),
        ("-0,5", "0,1"),
    ],
)
def test_a_word_that_may_be_one_number_or_two_is_refused_with_the_cure(words):
    with pytest.raises(pieper.InputError, match="a comma parts numbers, so .* is two. Write .* with a point"):
        numbers(words, "pose")
    fields = [repr(v).rstrip("0").rstrip(".") for v in np.atleast_1d(numbers(words, "--box", pairs=True))]
    assert len(fields) > len(" ".join(words).split())


@pytest.mark.parametrize(
    ("words", "values"),
    [
        (("350,0,400",), (350, 0, 400)),
        (("350,", "0,", "400"), (350, 0, 400)),
        (("350 , 0 , 400",), (350, 0, 400)),
        (("[350, 0, 400.5]",), (350, 0, 400.5)),
        (("350,5; 0; 400",), (350.5, 0, 400)),
        (("350,5;0,0;400,25",), (350.5, 0, 400.25)),
        (("1,0,0,350;0,1,0,0",), (1, 0, 0, 350, 0, 1, 0, 0)),
        (("pi/2", "sqrt(2)/2", "-1e-3"), (np.pi / 2, np.sqrt(2) / 2, -1e-3)),
        (("30,5",), (30, 5)),
    ],
)
def test_what_can_be_told_is_read(words, values):
    assert numbers(words, "pose") == pytest.approx(values, abs=1e-15)


def test_numbers_of_a_file_are_read_the_same_way(tmp_path):
    file = tmp_path / "pose.txt"
    file.write_text("1;0;0;350,5\n0;1;0;0,25\n0;0;1;400\n")
    assert numbers([f"@{file}"], "pose") == [1, 0, 0, 350.5, 0, 1, 0, 0.25, 0, 0, 1, 400]
    file.write_text("350,5\n0\n400\n")
    with pytest.raises(pieper.InputError, match="is two"):
        numbers([f"@{file}"], "pose")


def written(value: float, sign: str, thousands: str) -> str:
    """Return a number as a country writes it."""
    return f"{value:,.3f}".translate({ord(","): thousands, ord("."): sign})


HEAD = ["x_mm", "y_mm", "z_mm"]
ROWS = np.array([[350.5, 0.25, 400.125], [1234.5, 2.5, 12345.678], [0.001, -1999.999, 1.234]])


@pytest.mark.parametrize("delimiter", [",", ";", "\t", " "])
@pytest.mark.parametrize("sign", [".", ","])
@pytest.mark.parametrize("thousands", ["", ".", ",", "'", " ", "\u00a0"])
@pytest.mark.filterwarnings("ignore:.*commas stand before decimals")
def test_a_table_of_any_country_is_read_right_or_refused(tmp_path, delimiter, sign, thousands):
    if sign == thousands:
        return
    file = tmp_path / "poses.csv"
    lines = [delimiter.join(HEAD), *(delimiter.join(written(v, sign, thousands) for v in row) for row in ROWS)]
    # without names nobody can tell whether 350,5,0,25,400,1 are three numbers or six: six is what it says
    nameless = [] if sign == delimiter == "," else [[2, 1]]
    for some in ([0, 1, 2, 3], [0, 1], [0, 2], [0, 3, 1], *nameless):
        file.write_text("\n".join(lines[i] for i in some), encoding="utf-8")
        plain = thousands == "" and (sign == "." or delimiter in ";\t")
        rows = [ROWS[i - 1] for i in some if i]
        try:
            poses = np.concatenate(list(PoseFile(str(file), Units()).blocks()))
        except pieper.InputError as error:
            large = any(abs(v) >= 1000 for row in rows for v in row)
            assert not plain and (large or sign == ","), error
        else:
            assert np.allclose(poses[:, :3, 3] * 1e3, rows, atol=1e-9)


def test_a_line_with_more_numbers_than_names_is_refused_whatever_parts_them(tmp_path):
    file = tmp_path / "poses.csv"
    for delimiter in " ,;\t":
        file.write_text(delimiter.join(HEAD) + "\n" + delimiter.join("1234") + "\n")
        with pytest.raises(pieper.InputError, match="line 2: 4 cells where the first line has 3"):
            list(PoseFile(str(file), Units()).blocks())


def test_signs_that_change_from_line_to_line_are_refused(tmp_path):
    file = tmp_path / "poses.csv"
    for first, second in itertools.permutations(["350,5;0;400", "350.5;0;400"]):
        file.write_text(f"x_mm;y_mm;z_mm\n{first}\n350;0;400\n{second}\n")
        with pytest.raises(pieper.InputError, match="line 4.*nobody can tell"):
            list(PoseFile(str(file), Units()).blocks())
    file.write_text("x_mm;y_mm;z_mm;day;why\n350,5;0;400;1.2.2026;a, b\n350,25;0;400;3.4.26;c\n")
    (poses,) = PoseFile(str(file), Units()).blocks()
    assert np.allclose(poses[:, 0, 3], [0.3505, 0.35025])


def test_what_looks_like_thousands_is_read_as_decimals_with_a_word(tmp_path):
    file = tmp_path / "poses.csv"
    file.write_text("x_mm;y_mm;z_mm\n1,234;0;400\n")
    with pytest.warns(pieper.PieperWarning, match=r"commas stand before decimals: 1,234 is 1\.234"):
        (poses,) = PoseFile(str(file), Units()).blocks()
    assert poses[0, 0, 3] == pytest.approx(0.001234)


def test_measurements_are_read_the_same_way(run, tmp_path):
    q = np.radians(np.random.default_rng(3).uniform(-100, 100, (30, 6)))
    x = ARM.fk(q)[:, :3, 3] * 1e3
    heads = [f"q{i}_deg" for i in range(1, 7)] + ["x_mm", "y_mm", "z_mm"]
    rows = [[f"{v:.9f}" for v in (*np.degrees(a), *b)] for a, b in zip(q, x, strict=True)]
    points, commas, both = (tmp_path / f"{name}.csv" for name in ("points", "commas", "both"))
    points.write_text("\n".join(map(",".join, [heads, *rows])))
    commas.write_text("\n".join(";".join(row).replace(".", ",") for row in [heads, *rows]))
    both.write_text("# two signs\n\n" + ";".join(heads) + "\n" + ";".join(rows[0]).replace(".", ",", 1))
    words = ("--kind", "position", "--json")
    expected = run("calibrate", ARM.name, points, *words)
    assert expected[0] == 0
    assert run("calibrate", ARM.name, commas, *words)[1] == expected[1]
    status, _, said = run("calibrate", ARM.name, both, *words)
    assert status == 2 and "line 4" in said and "nobody can tell" in " ".join(said.split())


@pytest.mark.parametrize("words", [("ik", ARM.name, "350", "0", "400"), ("fk", ARM.name, "@joints.csv")])
@pytest.mark.parametrize(("file", "said"), [("-", "names no file"), ("rows.png", "a table is written as .csv")])
def test_a_table_is_not_written_into_what_is_none(run, tmp_path, monkeypatch, words, file, said):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "joints.csv").write_text("0,10,20,0,30,0\n")
    status, _, complaint = run(*words, "--csv", file)
    assert status == 2 and said in " ".join(complaint.split())
    assert not (tmp_path / file).exists() and run(*words, "--csv", "rows.csv")[0] == 0


def test_a_file_with_a_pose_on_each_line_is_no_pose(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for count, row in ((3, "300 0 400"), (2, "300 0 400 0 0 0"), (4, "300 0 400"), (2, "1 0 0 300 0 1 0 0 0 0 1 400")):
        (tmp_path / "poses.txt").write_text(f"{row}\n" * count)
        # where many are meant they are many, where one is meant they are refused
        assert main(["ik", "denso-vp6242", "@poses.txt"]) == 0
        assert len(capsys.readouterr().out.splitlines()) == count + 1
        assert main(["path", "denso-vp6242", "--from", "@poses.txt", "--to", "350 0 400"]) == 2
        assert f"{count} lines of {len(row.split())} numbers" in (said := capsys.readouterr().err)
        assert "@poses.csv" in said
    # one pose may stand on two lines, a matrix on three: of the first it is said how it was read
    (tmp_path / "pose.txt").write_text("350 0 400\n0 0 0\n")
    assert main(["ik", "denso-vp6242", "@pose.txt"]) == 0
    assert "taken for one pose" in capsys.readouterr().err
    (tmp_path / "pose.txt").write_text("1 0 0 350\n0 1 0 0\n0 0 1 400\n")
    assert main(["ik", "denso-vp6242", "@pose.txt"]) == 0
    assert capsys.readouterr().err == ""
