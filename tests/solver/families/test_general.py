"""The general six-joint solver: nothing missed, nothing made up, every joint order, honest flags."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from oracle.joints import around, difference
from pieper.errors import PlanError
from pieper.kinematics.chain import Chain
from pieper.kinematics.forward import fk
from pieper.kinematics.pose import inverse
from pieper.solver.families import general
from pieper.solver.native import SixJointSolver

UNCERTAIN, OUT_OF_REACH, DEGENERATE = 2, 4, 1
FREE = np.tile([-np.inf, np.inf], (6, 1))

#: d, a, alpha. UR5e: the maker's table; EA1400N: Seed et al.; CRX-10iA: Abbes and Poisson (2024).
UR5E = [
    (0.1625, 0, np.pi / 2),
    (0, -0.425, 0),
    (0, -0.3922, 0),
    (0.1333, 0, np.pi / 2),
    (0.0997, 0, -np.pi / 2),
    (0.0996, 0, 0),
]
EA1400N = [
    (0.45, 0.15, np.pi / 2),
    (0, 0.57, np.pi),
    (0, 0.2, np.pi / 2),
    (0.64, 0, np.pi / 2),
    (0, 0.03, np.pi / 2),
    (0.2, 0, 0),
]
CRX10IA = [
    (0, 0, -np.pi / 2),
    (0, 0.54, 0),
    (0, 0, -np.pi / 2),
    (0.54, 0, np.pi / 2),
    (-0.15, 0, -np.pi / 2),
    (0.16, 0, np.pi),
]


def dh_link(d: float, a: float, alpha: float, theta: float = 0.0) -> np.ndarray:
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1.0]])


def chain_of(rows: list, kinds: str = "RRRRRR") -> Chain:
    links = np.array([np.eye(4)] + [dh_link(*row) for row in rows])
    return Chain.of(links, np.array([kind == "P" for kind in kinds]))


def random_chain(rng: np.random.Generator, kinds: str) -> Chain:
    rows = [(*rng.uniform(-0.5, 0.5, 2), *rng.uniform(-np.pi, np.pi, 2)) for _ in range(6)]
    return chain_of(rows, kinds)


def solver_of(chain: Chain) -> SixJointSolver:
    return SixJointSolver(chain, general.prepare(chain), FREE)


def draw(chain: Chain, rng: np.random.Generator, count: int) -> np.ndarray:
    return rng.uniform(-1, 1, (count, 6)) * np.where(chain.prismatic, chain.length, np.pi)


def nearest(chain: Chain, q: np.ndarray, valid: np.ndarray, made: np.ndarray) -> np.ndarray:
    return np.where(valid, difference(chain, q, made[:, None]), np.inf).min(-1)


def worst_closure(chain: Chain, q: np.ndarray, valid: np.ndarray, T: np.ndarray) -> float:
    return float(np.where(valid, np.abs(fk(chain, q) - T[:, None]).max((-1, -2)), 0).max())


def calibrated_ur5e(error: float) -> Chain:
    return chain_of(np.array(UR5E) + error * np.random.default_rng(3).uniform(-1, 1, (6, 3)))


ARMS = {
    "EA1400N": chain_of(EA1400N),
    "CRX-10iA": chain_of(CRX10IA),
    "UR5e": chain_of(UR5E),
    "UR5e + 1e-3": calibrated_ur5e(1e-3),
    "UR5e + 1e-6": calibrated_ur5e(1e-6),
    "random": random_chain(np.random.default_rng(7), "RRRRRR"),
}


@pytest.mark.parametrize("name", ARMS)
def test_the_joint_vector_that_made_a_pose_is_found_and_everything_found_closes(name):
    chain = ARMS[name]
    made = draw(chain, np.random.default_rng(1), 2000)
    T = fk(chain, made)
    q, valid, _, flag = solver_of(chain).many(T, 1)
    assert nearest(chain, q, valid, made).max() < 1e-6
    assert worst_closure(chain, q, valid, T) < 1e-11
    away_from_singular = (flag & DEGENERATE) == 0
    assert (valid.sum(1)[away_from_singular] % 2 == 0).all()
    assert (flag & UNCERTAIN).mean() < 1e-3
    assert (q[~valid] == 0).all()


def orders(most: int) -> list[str]:
    kinds = []
    for count in range(most + 1):
        for places in itertools.combinations(range(6), count):
            kinds.append("".join("P" if i in places else "R" for i in range(6)))
    return kinds


@pytest.mark.parametrize("kinds", orders(3))
def test_every_order_of_revolute_and_prismatic_joints_is_solved(kinds):
    chain = random_chain(np.random.default_rng(sum(map(ord, kinds)) + kinds.find("P")), kinds)
    made = draw(chain, np.random.default_rng(2), 60)
    spec = general.prepare(chain)
    q, valid, _, _ = SixJointSolver(chain, spec, FREE).many(fk(chain, made), 1)
    assert nearest(chain, q, valid, made).max() < 1e-6
    assert valid.sum(1).max() <= spec.info["max_solutions"]


def test_sets_of_two_hidden_joints_and_of_the_reversed_chain_are_the_same():
    chain = ARMS["EA1400N"]
    T = fk(chain, draw(chain, np.random.default_rng(4), 300))
    q, valid, _, _ = solver_of(chain).many(T, 1)
    back = chain.reversed()
    p, seen, _, _ = solver_of(back).many(np.ascontiguousarray(inverse(T)), 1)
    assert (valid.sum(1) == seen.sum(1)).all()
    for i in range(len(T)):
        ours, theirs = q[i][valid[i]], p[i][seen[i]][:, ::-1]
        assert difference(chain, ours[:, None], theirs[None]).min(1).max() < 1e-6


def test_scale_base_tool_and_slid_frames_change_nothing():
    chain = ARMS["random"]
    rng = np.random.default_rng(5)
    made = draw(chain, rng, 200)
    links = chain.links.copy()
    links[0] = dh_link(3.0, -2.0, 0.3, 1.0) @ links[0]
    links[6] = links[6] @ dh_link(0.4, 0.2, -1.0, 2.0)
    slide = np.eye(4)
    slide[2, 3] = 40.0
    links[2], links[3] = links[2] @ slide, inverse(slide) @ links[3]
    links[:, :3, 3] *= 1000.0
    other = Chain.of(links, chain.prismatic)
    q, valid, _, _ = solver_of(chain).many(fk(chain, made), 1)
    p, seen, _, _ = solver_of(other).many(fk(other, made), 1)
    assert (valid.sum(1) == seen.sum(1)).all()
    assert nearest(other, p, seen, made).max() < 1e-6


def test_one_pose_and_many_poses_agree():
    chain = ARMS["EA1400N"]
    solver = solver_of(chain)
    T = fk(chain, draw(chain, np.random.default_rng(6), 20))
    q, valid, _, flag = solver.many(T, 1)
    for i in range(len(T)):
        rows, _, _, bits = solver.one(T[i])
        assert np.allclose(rows, q[i][valid[i]], rtol=0, atol=1e-12)
        assert bits == flag[i]


@pytest.mark.parametrize("name", ["EA1400N", "UR5e + 1e-3", "random"])
def test_a_pose_comes_to_the_same_digits_alone_as_among_others(name):
    chain = ARMS[name]
    T = fk(chain, draw(chain, np.random.default_rng(4), 200))
    many = solver_of(chain).many
    whole = many(T, 1)
    for size in (1, 2, 3, 7):  # alone, and with groups of lanes that are not full
        parts = [many(T[first : first + size], 1) for first in range(0, len(T), size)]
        for k, field in enumerate(whole):
            assert np.array_equal(np.concatenate([part[k] for part in parts]), field)


def test_out_of_reach_is_said_and_not_guessed():
    chain = ARMS["EA1400N"]
    T = fk(chain, draw(chain, np.random.default_rng(8), 20))
    T[:, :3, 3] += 10.0
    _, valid, _, flag = solver_of(chain).many(T, 1)
    assert not valid.any()
    assert (flag == OUT_OF_REACH).all()


def test_both_of_two_close_solutions_survive_next_to_a_singular_posture():
    chain = ARMS["random"]
    rng = np.random.default_rng(9)
    solver = solver_of(chain)
    made = []
    for start, way in zip(draw(chain, rng, 40), rng.normal(size=(40, 6)), strict=True):
        steps = start + np.linspace(0, 1, 9)[:, None] * way
        signs = np.sign([det(chain, q) for q in steps])
        for i in np.flatnonzero(signs[1:] * signs[:-1] < 0)[:1]:
            lo, hi = steps[i], steps[i + 1]
            for _ in range(60):
                middle = (lo + hi) / 2
                lo, hi = (middle, hi) if np.sign(det(chain, middle)) == signs[i] else (lo, middle)
            for size in 10.0 ** rng.uniform(-8, -2, 10):
                made.append(lo + size * rng.normal(size=6) / 2.5)
    made = around(np.array(made))
    assert len(made) > 100
    q, valid, _, _ = solver.many(fk(chain, made), 1)
    assert nearest(chain, q, valid, made).max() < 1e-6


@pytest.mark.parametrize("name", ["random", "UR5e + 1e-3", "UR5e"])
def test_poses_that_wait_for_the_eigenvalues_come_back_to_their_places(name):
    """Those the signs of the determinant leave in doubt: roots that merge or have just gone, round postures."""
    chain, rng = ARMS[name], np.random.default_rng(11)
    made = draw(chain, rng, 150)
    made[::3] = np.round(made[::3] / (np.pi / 4)) * (np.pi / 4) + 10.0 ** rng.uniform(-6, -2, (50, 1))
    T = fk(chain, made)
    T[1::3, :3, 3] *= rng.uniform(1, 3, (50, 1))  # some out of reach
    solver = solver_of(chain)
    q, valid, _, flag = solver.many(T, 1)
    order = rng.permutation(len(T))
    again = solver.many(np.ascontiguousarray(T[order]), 1)
    assert (again[1] == valid[order]).all()
    assert (again[3] == flag[order]).all()
    assert np.abs(again[0] - q[order]).max() < 1e-9
    for i in range(0, len(T), 5):
        alone = solver.many(T[i : i + 1], 1)
        assert (alone[1][0] == valid[i]).all()
        assert alone[3][0] == flag[i]
        assert np.abs(alone[0][0] - q[i]).max() < 1e-9
    assert (0 < valid.any(1).mean() < 1) or name != "random"


def det(chain: Chain, q: np.ndarray) -> float:
    from pieper.kinematics.forward import jacobian

    return float(np.linalg.det(jacobian(chain, q)))


@pytest.mark.parametrize(("kinds", "word"), [("PPPPRR", "four or more slides"), ("RRRRRR", "depend on each other")])
def test_arms_beyond_six_independent_motions_are_refused_with_the_reason(kinds, word):
    rng = np.random.default_rng(10)
    chain = random_chain(rng, kinds)
    if kinds == "RRRRRR":  # all six axes parallel
        chain = chain_of([(0.1, 0.3, 0.0)] * 6)
    with pytest.raises(PlanError, match=word):
        general.prepare(chain, general.match(chain, None))


def test_the_choice_of_the_hidden_joint_is_reported_best_first():
    info = general.prepare(ARMS["UR5e"]).info
    assert info["certified"]
    assert info["hidden_joint"] in range(1, 7)
    assert info["noise"] < 1e-12
    assert [way["rank"] for way in info["ways"]] == sorted(way["rank"] for way in info["ways"])
