"""Planted arms are found again, as well as the noise allows; the fitted arm is an arm like any other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper.calibration.calibrate import _held_out, calibrate
from pieper.calibration.model import AxesModel
from tests.calibration.planted import ARMS, NOISE, apart, noisy, planted, postures

TRIALS = 6
COUNT = {"pose": 67, "position": 67, "distance": 134, "plane": 200}


def measured(kind, T, rng):
    if kind == "distance":
        return np.linalg.norm(T[:, :3, 3] - [0.9, 0.3, 0.2], axis=1) + rng.normal(0, NOISE[0], len(T))
    if kind == "plane":
        return T[:, :3, 3] @ [0.6, 0.0, 0.8] - 0.1 + rng.normal(0, NOISE[0], len(T))
    Y = noisy(T, rng)
    return Y if kind == "pose" else Y[:, :3, 3]


@pytest.mark.parametrize("kind", list(COUNT))
@pytest.mark.parametrize("name", ARMS)
def test_the_error_on_held_out_poses_is_what_cramer_and_rao_allow(name, kind):
    arm = pieper.load(name)
    found, allowed = [], []
    for trial in range(TRIALS):
        rng = np.random.default_rng(100 + trial)
        true, q = planted(arm, rng), postures(arm, rng, COUNT[kind])
        fit = arm.calibrate(q, measured(kind, true.fk(q), rng), kind=kind, sigma=NOISE)
        found.append(fit.held_out.metres)
        allowed.append(fit.held_out.predicted_metres)
        assert fit.held_out.metres < 0.25 * fit.held_out.nominal_metres
    assert np.sqrt(np.mean(np.square(found)) / np.mean(np.square(allowed))) < 1.2


@pytest.mark.parametrize("name", ARMS)
def test_the_covariance_is_that_of_many_fits(name):
    """The prediction itself is tried: the true error at new poses, without noise, against the covariance."""
    arm = pieper.load(name)
    squares, predicted = [], []
    for trial in range(12):
        rng = np.random.default_rng(trial)
        true, q, new = planted(arm, rng), postures(arm, rng, 50), postures(arm, rng, 200)
        fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE, holdout=0.0)
        squares.append(np.sum((fit.model.fk(new)[:, :3, 3] - true.fk(new)[:, :3, 3]) ** 2, 1).mean())
        T, twists = fit.model.pose_and_jacobian(new, fit.parameters)
        way, _ = fit.set_up.rows(np.zeros(len(new), int)).derivatives(T, twists)
        predicted.append(np.einsum("nik,kl,nil->n", way, fit.covariance, way).mean())
    assert 0.8 < np.sqrt(np.mean(squares) / np.mean(predicted)) < 1.2


def test_joint_terms_are_found():
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(4)
    terms = ("gain", "coupling", "harmonic")
    true, q, new = planted(arm, rng, terms), postures(arm, rng, 120), postures(arm, rng, 300)
    Y = noisy(true.fk(q), rng)
    errors = []
    for asked in ((), terms):
        fit = arm.calibrate(q, Y, sigma=NOISE, joint_terms=asked)
        errors.append(apart(fit.model.fk(new)[:, :3, 3], true.fk(new)[:, :3, 3], False))
        assert (fit.spread > 1.5) == (asked == ())
    assert errors[1] < 0.2 * errors[0]


def test_noise_is_estimated_where_it_is_not_said():
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(5)
    true, q = planted(arm, rng), postures(arm, rng, 200)
    fit = arm.calibrate(q, noisy(true.fk(q), rng))
    assert fit.sigma == pytest.approx(NOISE, rel=0.15)


@pytest.mark.parametrize("name", ARMS)
def test_outliers_are_named_and_cost_little(name):
    arm = pieper.load(name)
    clean, spoilt = [], []
    for trial in range(TRIALS):
        rng = np.random.default_rng(40 + trial)
        true, q, new = planted(arm, rng), postures(arm, rng, 67), postures(arm, rng, 300)
        Y = noisy(true.fk(q), rng)
        bad = np.sort(rng.choice(67, 5, replace=False))
        Z = Y.copy()
        Z[bad, :3, 3] += rng.normal(0, 5e-3, (5, 3))
        fits = [
            arm.calibrate(q, Y, sigma=NOISE),
            arm.calibrate(q, Z, sigma=NOISE, loss="huber"),
        ]
        for into, fit in zip((clean, spoilt), fits, strict=True):
            into.append(apart(fit.model.fk(new)[:, :3, 3], true.fk(new)[:, :3, 3], False))
        assert fits[1].outliers == tuple(bad.tolist())
        # no fit can do better: it is the one of somebody who knew the bad rows and fitted the others
        good = np.setdiff1d(np.arange(67), np.concatenate([_held_out(q, 0.25), bad]))
        knew = arm.calibrate(q[good], Y[good], sigma=NOISE, holdout=0.0)
        assert np.abs(fits[1].model.fk(new) - knew.model.fk(new)).max() < 1e-7
    assert np.mean(spoilt) < 1.2 * np.mean(clean)


@pytest.mark.parametrize("name", [name for name in ARMS if name not in ("adept-cobra-600", "kuka-lbr-iiwa-14-r820")])
def test_the_calibrated_arm_is_solved_completely(name, tmp_path):
    arm, rng = pieper.load(name), np.random.default_rng(6)
    true, q = planted(arm, rng), postures(arm, rng, 67)
    fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE)
    T = fit.arm.fk(q)
    many = fit.arm.ik_many(T)
    gap = fit.arm.chain.joints.apart(many.q, q[:, None])
    assert (np.where(many.valid, gap, np.inf).min(1) < 1e-8).all()
    assert np.abs(fit.arm.fk(many.q[many.valid]) - np.repeat(T, many.valid.sum(1), 0)).max() < 1e-11
    place = fit.save(tmp_path / "arm.toml")
    assert 'convention = "axes"' in place.read_text()
    again = pieper.load(place)
    assert np.abs(again.fk(q) - T).max() < 1e-12
    assert again.joint_names == arm.joint_names
    assert np.array_equal(again.limits, arm.limits)


@pytest.mark.parametrize("terms", [("gain",), ("gain", "coupling"), ("harmonic",), ("gain", "coupling", "harmonic")])
def test_joint_terms_are_inverted_too(terms):
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(7)
    true, q = planted(arm, rng, terms), postures(arm, rng, 120)
    fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE, joint_terms=terms)
    for posture in q[:4]:
        T = fit.model.fk(posture[None])[0]
        rows = fit.ik(T)
        assert np.abs(fit.model.fk(rows) - T).max() < 1e-10
        assert np.abs(rows - posture).max(1).min() < 1e-8
        assert (rows >= arm.limits[:, 0] - 1e-9).all() and (rows <= arm.limits[:, 1] + 1e-9).all()
    if "harmonic" in terms:
        with pytest.raises(pieper.PlanError, match="harmonics"):
            fit.arm  # noqa: B018
    else:
        assert np.abs(fit.arm.fk(q) - fit.model.fk(q)).max() < 1e-12
        for posture in q[:4]:
            # the same solutions by the arm itself, whose joints are coupled
            found = fit.arm.ik(fit.model.fk(posture[None])[0])
            assert np.abs(found.nearest(posture) - posture).max() < 1e-8


@pytest.mark.parametrize("terms", [("gain",), ("harmonic",)])
def test_joint_terms_of_coupled_joints_are_inverted_too(terms):
    """An axis that an earlier drive carries along comes to lie outside the limits of its own joint's number."""
    arm, rng = pieper.load("fanuc-lr-mate-200id-controller"), np.random.default_rng(6)
    true, q = planted(arm, rng, terms), postures(arm, rng, 120)
    fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE, joint_terms=terms)
    far = [posture for posture in postures(arm, rng, 400) if abs(arm.chain.coupling @ posture)[2] > np.pi][:12]
    assert len(far) == 12
    for posture in (*far, *q[:4]):
        T = fit.model.fk(posture[None])[0]
        rows = fit.ik(T)
        assert np.abs(fit.model.fk(rows) - T).max() < 1e-10
        assert np.abs(rows - posture).max(1).min() < 1e-8


def test_what_cannot_be_seen_is_named_and_stays():
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(8)
    true, q = planted(arm, rng), postures(arm, rng, 150)
    T = true.fk(q)
    pose, position, distance = (
        arm.calibrate(q, measured(kind, T, rng), kind=kind, sigma=NOISE) for kind in ("pose", "position", "distance")
    )
    assert pose.unobservable == ()
    assert [words for words in position.unobservable if words.startswith("orientation of the tool")] != []
    assert any(words.startswith("place of the arm") for words in distance.unobservable)
    assert any(words.startswith("orientation of the arm") for words in distance.unobservable)
    new = postures(arm, rng, 300)
    assert apart(distance.model.fk(new)[:, :3, 3], true.fk(new)[:, :3, 3], True) < 1e-4
    assert "cannot see" in distance.explain()


def test_what_is_held_does_not_move():
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(9)
    true, q = planted(arm, rng), postures(arm, rng, 60)
    fit = arm.calibrate(q, noisy(true.fk(q), rng), hold=("joint_2", "tool"))
    assert np.abs(fit.model.screws[1] - AxesModel.of(arm.chain).screws[1]).max() < 1e-15
    assert np.abs(fit.model.home - arm.chain.home).max() < 1e-15
    assert fit.covariance[4:8].any() == np.False_


def test_the_headline_is_the_error_on_held_out_poses():
    arm, rng = pieper.load("denso-vp6242"), np.random.default_rng(10)
    true, q = planted(arm, rng), postures(arm, rng, 60)
    Y = noisy(true.fk(q), rng)
    fit = arm.calibrate(q, Y, sigma=NOISE)
    assert fit.explain().splitlines()[0].startswith("denso-vp6242: On 15 held-out poses the error is")
    assert fit.rows == (45, 15)
    assert arm.calibrate(q, Y, sigma=NOISE, holdout=0.0).held_out is None


def test_chosen_poses_say_more_than_any_other_few():
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(11)
    candidates, new = postures(arm, rng, 600), postures(arm, rng, 300)
    rows = arm.choose_poses(20, candidates, kind="position", sigma=NOISE)
    assert len(set(rows.tolist())) == 20
    errors = {"chosen": [], "any": []}
    for trial in range(10):
        r = np.random.default_rng(trial)
        true = planted(arm, r)
        for what, which in (("chosen", rows), ("any", r.choice(600, 20, replace=False))):
            q = candidates[which]
            fit = arm.calibrate(q, noisy(true.fk(q), r)[:, :3, 3], kind="position", sigma=NOISE, holdout=0.0)
            errors[what].append(apart(fit.model.fk(new)[:, :3, 3], true.fk(new)[:, :3, 3], False))
    assert np.mean(errors["chosen"]) < 0.95 * np.mean(errors["any"])


def test_of_heights_over_a_level_plane_a_turn_of_the_first_joint_changes_no_choice():
    arm = pieper.load("universal-robots-ur5e")
    candidates = postures(arm, np.random.default_rng(12), 120)
    turned = candidates + [0.7, 0, 0, 0, 0, 0]
    first, again = (arm.choose_poses(8, q, kind="plane", sigma=NOISE[:1]).tolist() for q in (candidates, turned))
    assert first == again


def test_a_fit_needs_to_be_told_how_arms_are_made():
    arm = pieper.load("denso-vp6242")
    q = postures(arm, np.random.default_rng(0), 20)
    assert calibrate(arm, q, arm.fk(q), make=lambda description: description.name).arm == "denso-vp6242-calibrated"


def test_of_a_posture_measured_several_times_all_or_none_is_held_out():
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(5)
    true, few = planted(arm, rng), postures(arm, rng, 24)
    q = np.repeat(few, 5, axis=0)[rng.permutation(120)]
    held = _held_out(q, 0.25)
    assert len(held) == 30
    kept = np.delete(q, held, axis=0)
    assert np.abs(q[held][:, None] - kept[None]).max(-1).min() > 0.01
    # what was repeated says as much about other postures as what was not
    fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE)
    new = postures(arm, rng, 300)
    missed = apart(fit.model.fk(new)[:, :3, 3], true.fk(new)[:, :3, 3], False)
    assert fit.held_out.metres > 0.6 * missed


@pytest.mark.parametrize("terms", [(), ("gain",), ("harmonic",)])
@pytest.mark.parametrize("name", ["universal-robots-ur5e", "adept-cobra-600", "kuka-lbr-iiwa-14-r820"])
def test_a_fit_is_asked_as_an_arm_is(name, terms):
    """Many poses at once, the row nearest to a posture, and a joint to spare held at its own number."""
    arm, rng = pieper.load(name), np.random.default_rng(12)
    true, q = planted(arm, rng, terms), postures(arm, rng, 120)
    fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE, joint_terms=terms)
    asked, held = q[:6], arm.plan.redundancy[:1]
    T = fit.model.fk(asked)
    by_name = {held[0]: asked[:, arm.joint_names.index(held[0])]} if held else None
    which, rows = fit.ik_many(T, redundancy=by_name)
    assert np.abs(fit.model.fk(rows) - T[which]).max() < 1e-9
    if held:
        j = arm.joint_names.index(held[0])
        assert np.abs(rows[:, j] - asked[which, j]).max() < 1e-9
    for i, posture in enumerate(asked):
        one = None if by_name is None else {name: value[i] for name, value in by_name.items()}
        alone = fit.ik(T[i], redundancy=one)
        assert len(alone) == np.count_nonzero(which == i)
        assert np.abs(alone[:, None] - rows[which == i]).max(2).min(1).max() < 1e-9
        assert np.abs(alone - posture).max(1).min() < 1e-7
        if one is not None:
            # by its place, as `Arm.ik` takes it
            assert len(fit.ik(T[i], redundancy=next(iter(one.values())))) == len(alone)
    with pytest.raises(pieper.InputError, match=r"near must be a joint vector \(\d,\) or one a pose"):
        fit.ik_many(T, near=asked[: len(T) // 2], redundancy=by_name)
    of, near = fit.ik_many(T, near=asked, redundancy=by_name)
    assert of.tolist() == list(range(6))
    assert np.abs(near - asked).max() < 1e-7


def test_a_joint_that_others_move_is_not_held_by_its_own_number():
    arm, rng = pieper.load("kuka-lbr-iiwa-14-r820"), np.random.default_rng(12)
    true, q = planted(arm, rng, ("gain", "coupling")), postures(arm, rng, 150)
    fit = arm.calibrate(q, noisy(true.fk(q), rng), sigma=NOISE, joint_terms=("gain", "coupling"))
    with pytest.raises(pieper.PlanError, match="also moves with"):
        fit.ik(fit.model.fk(q[:1])[0], redundancy={arm.joint_names[-1]: 0.1})


@pytest.mark.filterwarnings("error")
def test_a_calibrated_arm_has_the_bodies_of_its_nominal_one_and_guesses_none_far_away():
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(4)
    true, q = planted(arm, rng), postures(arm, rng, 60)
    Y = noisy(true.fk(q), rng)
    fit = arm.calibrate(q, Y, sigma=NOISE)
    # bodies guessed from the table lay along common normals, 300 m across
    plain = arm.distance(q[:20])
    assert np.abs(fit.arm.distance(q[:20]) - plain).max() < 0.02
    bare = replace(arm.description, bodies=(), unmeasured=None)
    told = pieper.Arm(bare).calibrate(q, Y, sigma=NOISE).arm
    assert len(told.bodies) >= len(pieper.Arm(bare).bodies) - 1
    assert np.abs(told.distance(q[:20]) - pieper.Arm(bare).distance(q[:20])).max() < 0.05
    # with something in the elbow's way only what is clear of it
    posture = np.array([0.0, -1.2, 1.4, -0.5, 0.7, 0.0])
    T, elbow = fit.arm.fk(posture), arm.frames(posture)[2, :3, 3]
    wall = pieper.Scene([pieper.Box(pieper.pose(*elbow), (0.1, 0.1, 0.1))])
    rows, clear = fit.ik(T), fit.ik(T, scene=wall)
    kept = np.asarray(fit.arm.distance(rows, wall)) > 0
    assert 0 < len(clear) < len(rows)
    assert np.abs(rows[kept] - clear).max() < 1e-12
