"""A length that has a name and is zero for this arm is varied like the others: what holds by it alone says so."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import pieper

LENGTHS = {"l1": 0.35, "l2": 0.4, "l3": 0.3, "e1": 0.12, "e2": 0.21}
RIGHT = {
    "Px": ["c1 e1", "c1 l2 c2", "c1 l3 c23", "e2 s1"],
    "Py": ["s1 e1", "s1 l2 c2", "s1 l3 c23", "-e2 c1"],
    "Pz": ["l1", "l2 s2", "l3 s23"],
}


def table(zero: tuple[str, ...], unit: str = "m") -> str:
    """A three-link arm with two offsets, some of its lengths zero."""
    size = 1000 if unit == "mm" else 1
    values = ", ".join(f"{name} = {0.0 if name in zero else size * value}" for name, value in LENGTHS.items())
    return f"""[arm]
convention = "standard"
length_unit = "{unit}"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", "l1", "e1", "90 deg"], ["q2", "e2", "l2", 0], ["q3", 0, "l3", 0]]
values = {{ {values} }}
"""


def entry(arm: str, of: str, formula: str):
    """The verdict on an entry."""
    (found,) = pieper.check(f'{arm}\n[[claim]]\nkind = "entry"\nof = "{of}"\nis = "{formula}"\n').verdicts
    return found


def place(formula: str, q: np.ndarray, lengths: dict[str, float]) -> float:
    """A formula's value by Python itself."""
    t1, t2, t3 = q
    names = {"s1": np.sin(t1), "c1": np.cos(t1), "s2": np.sin(t2), "c2": np.cos(t2)}
    names |= {"s23": np.sin(t2 + t3), "c23": np.cos(t2 + t3)}
    return eval(formula.replace(" ", "*").replace("*+*", "+").replace("*-*", "-"), {}, {**names, **lengths})


def dh(q: np.ndarray, m: dict[str, float]) -> np.ndarray:
    """Where the arm's tool is, by its matrices multiplied out."""
    T = np.eye(4)
    for theta, d, a, alpha in ((q[0], m["l1"], m["e1"], np.pi / 2), (q[1], m["e2"], m["l2"], 0), (q[2], 0, m["l3"], 0)):
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        T = T @ [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    return T[:3, 3]


@pytest.mark.parametrize("zero", [(), ("e1",), ("e2",), ("e1", "e2"), ("l1", "e2")])
@pytest.mark.parametrize("unit", ["m", "mm"])
def test_only_the_formula_for_any_lengths_holds_for_any_lengths(zero, unit):
    """Terms are lost or turned about; the truth is plain NumPy with every length given a value."""
    rng = np.random.default_rng(8)
    arm = table(zero, unit)
    for of, terms in RIGHT.items():
        choices = [(1, 0, -1) if any(name in term for name in zero) else (1,) for term in terms]
        for signs in itertools.product(*choices):
            kept = [f"{sign}*{term}" for sign, term in zip(signs, terms, strict=True) if sign]
            formula = " + ".join(kept).replace("1*-", "-").replace("-1*", "-").replace("1*", "").replace("+ --", "+ ")
            q = rng.uniform(-3, 3, 3)
            right = dh(q, LENGTHS)["xyz".index(of[1])]
            true = np.isclose(place(" + ".join(kept), q, LENGTHS), right)
            found = entry(arm, of, formula.replace("--", ""))
            assert found.holds == true, (of, formula, found.sentence)
            if true:
                assert "for any lengths" in found.sentence
            else:
                assert found.partly and "only because" in found.sentence
                assert all(f"{name} = 0" not in found.sentence for name in LENGTHS if name not in zero)


def test_the_slip_is_explained_with_the_length_that_is_zero():
    found = entry(table(("e2",)), "Px", "c1 (e1 + l2 c2 + l3 c23) - e2 s1")
    assert found.slip == "sign" and found.reading == "c1 (e1 + l2 c2 + l3 c23) + e2 s1"
    assert "e2 = 0." in dict(found.details)["counter-example"]
    found = entry(table(("e2",)), "Px", "c1 (e1 + l2 c2 + l3 c23)")
    assert found.slip == "missing term" and "only because e2 = 0" in found.sentence


def test_numbers_are_about_this_arm_and_its_zeros():
    assert entry(table(("e1", "e2")), "Px", "c1 (0.4 c2 + 0.3 c23)").holds
    assert entry(table(("e1", "e2")), "Px", "c1 (0.4 c2 + 0.3 s23)").wrong


@pytest.mark.parametrize(
    ("claim", "status"),
    [
        ('kind = "equation"\nis = "px s1 - py c1 = e2"', "holds"),
        ('kind = "equation"\nis = "px s1 - py c1 = -e2"', "holds only in part"),
        ('kind = "determinant"\nis = "l2 l3 s3 (e1 + l2 c2 + l3 c23)"', "holds"),
        ('kind = "determinant"\nis = "l2 l3 s3 (l2 c2 + l3 c23)"', "holds only in part"),
        ('kind = "jacobian"\nof = "J[1,1]"\nis = "-s1 (e1 + l2 c2 + l3 c23) + e2 c1"', "holds"),
        ('kind = "jacobian"\nof = "J[1,1]"\nis = "-s1 (e1 + l2 c2 + l3 c23) - e2 c1"', "holds only in part"),
        ('kind = "matrix"\nof = "P02"\nis = [["c1 (e1 + l2 c2) + e2 s1"], [""], ["l1 + l2 s2"]]', "holds"),
        ('kind = "matrix"\nof = "P02"\nis = [["c1 (e1 + l2 c2) - e2 s1"], [""], ["l1 + l2 s2"]]', "holds only in part"),
        (
            'kind = "joint"\njoint = 1\ntask = "position"\n'
            'is = "atan2(py, px) + atan2(e2, +-sqrt(px^2 + py^2 - e2^2))"',
            "holds",
        ),
        (
            'kind = "joint"\njoint = 1\ntask = "position"\n'
            'is = "atan2(py, px) - atan2(e2, +-sqrt(px^2 + py^2 - e2^2))"',
            "holds only in part",
        ),
    ],
)
def test_every_kind_of_formula_varies_the_zeros(claim, status):
    (found,) = pieper.check(f"{table(('e1', 'e2'))}\n[[claim]]\n{claim}\n").verdicts
    assert found.status == status, found.sentence


@pytest.mark.parametrize(
    ("formula", "status"),
    [
        ("c1 (a2 c2 + a3 c23) - c1 s23 d4 + d6 ax", "holds"),
        ("c1 (a1 + a2 c2 + a3 c23) - c1 s23 d4 + d6 ax", "holds"),
        ("c1 (-a1 + a2 c2 + a3 c23) - c1 s23 d4 + d6 ax", "holds only in part"),
        ("c1 (a2 c2 + a3 c23) - c1 s23 d4 + d6 ax + d2 s1", "holds"),
        ("c1 (a2 c2 + a3 c23) - c1 s23 d4 + d6 ax - d2 s1", "holds only in part"),
    ],
)
def test_a_catalogue_arm_s_zeros_are_varied_where_a_formula_names_them(formula, status):
    assert entry('[arm]\nrobot = "denso-vp6242"\n', "Px", formula).status == status


def test_a_number_of_the_table_that_is_zero_has_its_name_too():
    arm = table(()).replace('"e1"', "0").replace(f"e1 = {LENGTHS['e1']}, ", "")
    assert entry(arm, "Px", "c1 (l2 c2 + l3 c23) + e2 s1").holds
    assert entry(arm, "Px", "c1 (a1 + l2 c2 + l3 c23) + e2 s1").holds
    assert entry(arm, "Px", "c1 (l2 c2 + l3 c23 - a1) + e2 s1").partly
