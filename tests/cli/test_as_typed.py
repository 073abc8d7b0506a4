"""Sentences of the library say options and units as they are typed."""

import re

import pytest

MAP = ["map", "denso-vp6242", "--step", "100"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["fk", "denso-vp6242", "0", "0", "0", "0", "0", "1e5"], "makes many whole turns.* the unit that --angle says"),
        ([*MAP, "--box", "500 -500 -500 500 0 700"], "--box: x0 must be less than x1"),
        ([*MAP, "--box", "-500 500 -500 500 0 700", "--workers", "-3"], "--workers takes none .0. or more, got -3"),
        ([*MAP, "--box", "-500 500 -500 500 0", "--workers", "2"], "--box takes six numbers .*got 5"),
        ([*MAP, "--box", "-500 500 -500 500 0 700", "--orientations", "12"], "--orientations takes two whole numbers"),
        (["map", "dobot-mg400", "--box", "-500 500 -500 500 0 700", "--step", "200"], "ask in Python, where arm.reach"),
        ([*MAP[:2], "--step", "0.5", "--box", "-500 500 -500 500 0 700"], "give --out DIR, a larger --step"),
        (["code", "panda", "--to", "c", "--out", "-"], "--out takes the name of a file"),
    ],
)
def test_a_sentence_says_what_was_typed(run, words, said):
    _, _, err = run(*words)
    assert re.search(said, " ".join(err.split())) and "store=" not in err and "radians(" not in err
