"""Data that were meant otherwise are recognised by how far they are off, and the message says what to do."""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np
import pytest

import pieper
from tests.calibration.planted import ARMS, NOISE, noisy, planted, postures
from tests.calibration.test_calibrate import COUNT, measured

MIRROR = np.array([1.0, -1.0, 1.0])
FRAME, TOOL = pieper.pose(1.0, 2.0, 0.5, rpy=(0.3, 0.5, 1.2)), pieper.pose(0.2, 0.05, 0.08, rpy=(0.4, 0.2, 0))


def case(name, seed=5):
    arm, rng = pieper.load(name), np.random.default_rng(seed)
    q = postures(arm, rng, 67)
    return arm, q, noisy(planted(arm, rng).fk(q), rng), rng


def scaled(Y, many=1e3):
    out = Y.copy()
    out[:, :3, 3] *= many
    return out


def flipped(q):
    out = q.copy()
    out[:, 2] *= -1
    return out


SPOILT = {
    "in degrees": lambda q, Y, rng: (np.degrees(q), Y),
    "in millimetres": lambda q, Y, rng: (q, scaled(Y)),
    "in degrees and what was measured is in millimetres": lambda q, Y, rng: (np.degrees(q), scaled(Y)),
    "the other way": lambda q, Y, rng: (flipped(q), Y),
    "shuffled": lambda q, Y, rng: (q[rng.permutation(len(q))], Y),
    "out of step|shuffled": lambda q, Y, rng: (np.roll(q, 2, 0), Y),
    "another frame": lambda q, Y, rng: (q, FRAME @ Y),
    "seen from the tool": lambda q, Y, rng: (q, np.linalg.inv(Y)),
    "another point or frame of the tool": lambda q, Y, rng: (q, Y @ TOOL),
    "another frame and of another point or frame of the tool": lambda q, Y, rng: (q, FRAME @ Y @ TOOL),
    "are exchanged": lambda q, Y, rng: (q[:, [0, 2, 1, *range(3, q.shape[1])]], Y),
    "move the other way": lambda q, Y, rng: (q * ([1, -1, 1, -1] + [1] * (q.shape[1] - 4)), Y),
    "the zero of .* lies -90 deg away": lambda q, Y, rng: (q + np.eye(q.shape[1])[1] * np.pi / 2, Y),
}


@pytest.mark.parametrize("words", SPOILT)
@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242", "puma-560", "kuka-lbr-iiwa-14-r820"])
def test_a_wrong_reading_is_named(name, words):
    arm, q, Y, rng = case(name)
    q, Y = SPOILT[words](q, Y, rng)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pieper.PieperWarning)
        with pytest.raises(pieper.InputError, match=words):
            arm.calibrate(q, Y, sigma=NOISE)


SLIDING = ["adept-cobra-600", "stanford-arm", "rrp-wrist", "epson-g6-651s"]


def as_controllers_say(arm, q, T, degrees, slides, millimetres):
    """Return joints and poses with angles in degrees, slides in mm and places in mm, each where that is asked."""
    turned = np.degrees(q) if degrees else q
    return np.where(arm.chain.prismatic, q * (1e3 if slides else 1), turned), scaled(T) if millimetres else T


@pytest.mark.parametrize("units", [u for u in np.ndindex(2, 2, 2) if any(u)])
@pytest.mark.parametrize("name", SLIDING)
def test_every_mixture_of_units_is_named_and_its_cure_works(name, units):
    arm, rng = pieper.load(name), np.random.default_rng(9)
    q = rng.uniform(*np.clip(arm.limits, -2.8, 2.8).T, (60, arm.n))
    T = arm.fk(q)
    told, Y = as_controllers_say(arm, q, T, *units)
    d, s, m = units
    words = ["the joint angles are in degrees"] * d
    lengths = " and ".join(["the slides"] * s + ["what was measured"] * m)
    words += [f"{lengths} {'are' if s else 'is'} in millimetres"] * bool(lengths)
    far = np.linalg.norm(Y[:, :3, 3] - np.array([0.3, 0.1, 0.05]) * (1e3 if m else 1), axis=1)
    for kind, data in (("pose", Y), ("position", Y[:, :3, 3]), ("distance", far)):
        with pytest.raises(pieper.InputError, match=" and ".join(words)) as refused:
            arm.calibrate(told, data, kind=kind)
        assert refused.value.left < 1e-9
        assert ("in degrees" in str(refused.value)) == d and ("in millimetres" in str(refused.value)) == (s or m)


#: Lengths as they may come, their factor to metres, and what a message says of them.
LENGTHS = {
    "in micrometres": 1e-6,
    "in centimetres": 1e-2,
    "in inches": 0.0254,
    "in metres that were taken for millimetres": 1e3,
}


@pytest.mark.parametrize("kind", ["pose", "position", "distance"])
@pytest.mark.parametrize("words", LENGTHS)
@pytest.mark.parametrize("name", ["denso-vp6242", "fanuc-m-710ic-50", "epson-g6-651s", "stanford-arm"])
def test_lengths_of_another_unit_are_recognised_by_their_size_and_the_cure_works(name, words, kind):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    q = rng.uniform(*np.clip(arm.limits, -2.8, 2.8).T, (60, arm.n))
    T = arm.fk(q)
    meant = {"pose": T, "position": T[:, :3, 3], "distance": np.linalg.norm(T[:, :3, 3] - [0.3, 0.1, 0.05], axis=1)}
    told = meant[kind] / LENGTHS[words] if kind != "pose" else T.copy()
    if kind == "pose":
        told[:, :3, 3] /= LENGTHS[words]
    with pytest.raises(pieper.InputError, match=f"what was measured is {words}") as refused:
        arm.calibrate(q, told, kind=kind)
    assert refused.value.left < 1e-9
    factor = {"in micrometres": "1,000,000", "in centimetres": "100", "in inches": "0.0254"}.get(words, "1000")
    assert str(refused.value).endswith(f"the measured lengths by {factor}.")


@pytest.mark.parametrize("slides", [1.0, 1e-3])
@pytest.mark.parametrize("turns", [1.0, np.pi / 180])
def test_si_units_that_were_taken_for_degrees_and_millimetres_are_named(turns, slides):
    arm, rng = pieper.load("epson-g6-651s"), np.random.default_rng(3)
    q = rng.uniform(*np.clip(arm.limits, -2.8, 2.8).T, (60, arm.n))
    T = arm.fk(q)
    if turns == slides == 1.0:
        assert arm.calibrate(q, T).held_out.nominal_metres < 1e-9
        return
    with pytest.raises(pieper.InputError) as refused:
        arm.calibrate(q * np.where(arm.chain.prismatic, slides, turns), T)
    said = str(refused.value)
    assert refused.value.left < 1e-9
    assert ("radians that were taken for degrees" in said) == (turns != 1.0)
    assert ("the slides are in metres that were taken for millimetres" in said) == (slides != 1.0)


@pytest.mark.parametrize("name", ["adept-cobra-600", "denso-vp6242"])
def test_units_and_a_frame_are_named_at_once_and_cure(name):
    arm, rng = pieper.load(name), np.random.default_rng(4)
    q = rng.uniform(*np.clip(arm.limits, -2.8, 2.8).T, (60, arm.n))
    T = FRAME @ arm.fk(q)
    told, Y = as_controllers_say(arm, q, T, True, True, True)
    with pytest.raises(pieper.InputError, match=r"in degrees and .* in millimetres, and .* another frame") as refused:
        arm.calibrate(told, Y, sigma=NOISE)
    fit = arm.with_base(refused.value.frame @ arm.base).calibrate(q, T, sigma=NOISE)
    assert fit.held_out.nominal_metres < 1e-9


@pytest.mark.parametrize("name", SLIDING)
def test_no_cure_is_given_that_leaves_more_than_an_arm_can_miss(name):
    arm, rng = pieper.load(name), np.random.default_rng(4)
    q = rng.uniform(*np.clip(arm.limits, -2.8, 2.8).T, (60, arm.n))
    p = arm.fk(q)[:, :3, 3]
    # slides in feet, places in feet: units that are not tried
    told = np.where(arm.chain.prismatic, q / 0.3048, np.degrees(q))
    for data in (p * 1e6, p / 0.3048):
        with pytest.raises(pieper.InputError) as refused:
            arm.calibrate(told, data, kind="position")
        assert "left" not in refused.value.data or refused.value.left < arm.chain.length


@pytest.mark.parametrize("joint", range(6))
def test_the_joint_whose_sense_is_wrong_is_named(joint):
    arm, q, Y, _ = case("universal-robots-ur5e")
    q[:, joint] *= -1
    with pytest.raises(pieper.InputError, match="the other way") as refused:
        arm.calibrate(q, Y, sigma=NOISE)
    assert refused.value.joint == arm.joint_names[joint]


def test_a_mirror_is_named_where_positions_or_rotations_show_it():
    arm, q, Y, _ = case("denso-vp6242")
    with pytest.raises(pieper.InputError, match="left-handed"):
        arm.calibrate(q, Y[:, :3, 3] * MIRROR, kind="position")
    with pytest.raises(pieper.InputError, match="left-handed"):
        arm.calibrate(q, Y @ np.diag([1.0, 1.0, -1.0, 1.0]))


def test_another_frame_is_handed_over_and_cures():
    arm, q, Y, _ = case("denso-vp6242")
    with pytest.raises(pieper.InputError, match="another frame") as refused:
        arm.calibrate(q, FRAME @ Y, sigma=NOISE)
    fit = arm.with_base(refused.value.frame @ arm.base).calibrate(q, FRAME @ Y, sigma=NOISE)
    assert fit.held_out.metres < 2e-4


@pytest.mark.parametrize("name", [name for name in ARMS if name != "adept-cobra-600"])
def test_a_frame_and_a_tool_are_handed_over_together_and_cure(name):
    """A SCARA's axes are parallel: no turn between its poses shows how the frame lies."""
    arm, q, Y, _ = case(name)
    whole = FRAME @ Y @ TOOL
    for kind, data in (("pose", whole), ("position", whole[:, :3, 3])):
        with pytest.raises(pieper.InputError, match="another frame and of another point") as refused:
            arm.calibrate(q, data, kind=kind, sigma=NOISE)
        cured = arm.with_base(refused.value.frame @ arm.base).with_tool(arm.tool @ refused.value.tool)
        assert cured.calibrate(q, data, kind=kind, sigma=NOISE).held_out.metres < 2e-4


def test_a_miss_is_told_in_metres_and_radians_apart():
    arm, q, Y, _ = case("denso-vp6242")
    with pytest.raises(pieper.InputError, match=r"m and [\d.]+ rad \(median\)") as refused:
        arm.calibrate(flipped(q), Y, sigma=NOISE)
    apart = np.linalg.norm(arm.fk(flipped(q))[:, :3, 3] - Y[:, :3, 3], axis=1)
    assert refused.value.misfit == pytest.approx(np.median(apart), rel=1e-9)


@pytest.mark.parametrize("rows", [(0.4, 0.3), (0.4, 0.3, 0.1)])
@pytest.mark.parametrize("point", [(0.5, 0.5, -1.0), (0.5, 0.5, 0.0), (0.0, 0.0, 0.3)])
def test_a_planar_arm_may_be_measured_from_off_its_plane(rows, point):
    arm = pieper.Arm.from_dh([pieper.DH(a) for a in rows], convention="standard", limits=[(-3, 3)] * len(rows))
    q = np.random.default_rng(2).uniform(-3, 3, (80, len(rows)))
    distances = np.linalg.norm(arm.fk(q)[:, :3, 3] - point, axis=1)
    fit = arm.calibrate(q, distances, kind="distance", sigma=5e-5)
    assert fit.held_out.nominal_metres < 1e-12 and fit.held_out.metres < 1e-12


def test_too_few_and_identical_poses_say_how_many_are_needed():
    arm, q, Y, _ = case("denso-vp6242")
    with pytest.raises(pieper.InputError, match="at least 5 different poses"):
        arm.calibrate(q[:5], Y[:5])
    with pytest.raises(pieper.InputError, match="only 1 is different"):
        arm.calibrate(np.repeat(q[:1], 40, 0), np.repeat(Y[:1], 40, 0))


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"kind": "angle"}, "must be 'pose'"),
        ({"loss": "cauchy"}, "must be 'linear' or 'huber'"),
        ({"joint_terms": ("bending",)}, "it may name 'gain'"),
        ({"hold": ("joint_9",)}, "it may name 'joint_1'"),
        ({"sigma": (0.0, 1e-4)}, "positive and at least"),
        ({"sigma": 1e-300}, "positive and at least 1e-12"),
        ({"sigma": "small"}, "metres, radians"),
        ({"holdout": 1.0}, "below 1"),
        ({"kind": "position"}, "shape"),
    ],
)
def test_impossible_words_are_refused(said, words):
    arm, q, Y, _ = case("denso-vp6242")
    with pytest.raises(pieper.InputError, match=words):
        arm.calibrate(q, Y, **said)


def test_numbers_that_are_none_are_refused():
    arm, q, Y, _ = case("denso-vp6242")
    with pytest.raises(pieper.InputError, match="finite"):
        arm.calibrate(q, np.full((67, 3), np.nan), kind="position")
    with pytest.raises(pieper.InputError, match="67 joint vectors"):
        arm.calibrate(q, Y[:60])
    with pytest.raises(pieper.InputError, match="positive"):
        arm.calibrate(q, -np.ones(67), kind="distance")
    with pytest.raises(pieper.InputError, match="one row a pose"):
        arm.calibrate(q[0], Y[:1])
    with pytest.raises(pieper.InputError, match="candidates"):
        arm.choose_poses(100, q)


@pytest.mark.parametrize("kind", ["distance", "plane"])
@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242", "stanford-arm"])
def test_single_numbers_are_read_right_too(name, kind):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    q = postures(arm, rng, COUNT[kind])
    Y = measured(kind, planted(arm, rng).fk(q), rng)
    flip = np.array([1.0, 1, -1, 1, 1, 1])
    cases = {
        "in degrees": (np.where(arm.chain.prismatic, q, np.degrees(q)), Y),
        "is in millimetres": (q, Y * 1e3),
        "the other way": (q * flip, Y),
        "3 rows out of step": (np.roll(q, 3, 0), Y),
        "do not belong together": (q[rng.permutation(len(q))], Y),
        "only 1 is different": (np.repeat(q[:1], len(q), 0), np.repeat(Y[:1], len(q), 0)),
        "are needed": (q[:8], Y[:8]),
    }
    for words, (a, b) in cases.items():
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", pieper.PieperWarning)
            with pytest.raises(pieper.InputError, match=words):
                arm.calibrate(a, b, kind=kind, sigma=NOISE)


@pytest.mark.parametrize(("name", "joint"), [("denso-vp6242", 0), ("adept-cobra-600", 1)])
def test_senses_that_distances_do_not_tell_apart_are_both_named(name, joint):
    arm, rng = pieper.load(name), np.random.default_rng(3)
    q = rng.uniform(*np.clip(arm.limits, -2.8, 2.8).T, (90, arm.n))
    far = np.linalg.norm(arm.fk(q)[:, :3, 3] - [0.3, 0.4, 0.1], axis=1)
    q[:, joint] *= -1
    with pytest.raises(pieper.InputError, match="does not show which") as refused:
        arm.calibrate(q, far, kind="distance")
    assert arm.joint_names[joint] in refused.value.data["alike"] and len(refused.value.data["alike"]) > 1


def test_heights_that_are_noise_alone_are_a_plane_that_was_touched():
    arm, rng = pieper.load("universal-robots-ur5e"), np.random.default_rng(8)
    flat = [pieper.pose(*rng.uniform([-0.5, 0.2, 0.1], [0.5, 0.6, 0.1]), rpy=(np.pi, 0.2, a)) for a in range(120)]
    q = np.array([rows[0] for rows in (arm.ik(T).q for T in flat) if len(rows)])
    for heights in (None, rng.normal(0, NOISE[0], len(q))):
        assert arm.calibrate(q, heights, kind="plane", sigma=NOISE).spread < 1.5


@pytest.mark.parametrize("kind", ["frame", "tool"])
def test_a_frame_is_named_of_an_arm_that_is_itself_millimetres_off_and_its_cure_works(kind):
    arm, q, _, rng = case("denso-vp6242")
    model = planted(arm, rng)
    model = replace(model, home=model.home @ pieper.pose(0.01, -0.005, 0.005, rotvec=(5e-3, 1e-2, -5e-3)))
    X = pieper.pose(1, 2, 3, rpy=(0.3, 0.2, 1)) if kind == "frame" else pieper.pose(0.1, 0.1, 0.15, rpy=(0.1, 0.4, 1))
    Y = noisy(model.fk(q), rng)
    Y = X @ Y if kind == "frame" else Y @ X
    with pytest.raises(pieper.InputError, match="frame") as refused:
        arm.calibrate(q, Y)
    if kind == "frame":
        arm = arm.with_base(refused.value.frame @ arm.base)
    else:
        arm = arm.with_tool(arm.tool @ refused.value.tool)
    assert arm.calibrate(q, Y).held_out.metres < 3e-4


def test_noise_that_was_said_far_too_large_is_told():
    arm, q, Y, _ = case("denso-vp6242")
    assert "Was sigma meant in other units" in arm.calibrate(q, Y, sigma=(0.05, 0.01)).explain()
    assert "Was sigma" not in arm.calibrate(q, Y, sigma=NOISE).explain()


def test_directions_that_are_not_seen_are_said_in_the_base_frame():
    arm, q, _, rng = case("denso-vp6242")
    q[:, 3:] = q[0, 3:]
    told = arm.calibrate(q, noisy(planted(arm, rng).fk(q), rng)).explain()
    assert " tilt " in told and "in the base frame with all joints at zero" in told


@pytest.mark.parametrize(("unit", "many"), [("decimetres", 10.0), ("centimetres", 100.0), ("inches", 1 / 0.0254)])
@pytest.mark.parametrize("name", ["universal-robots-ur5e", "denso-vp6242"])
def test_an_arm_of_another_size_is_refused_with_the_unit(name, unit, many):
    arm, q, Y, _ = case(name)
    for kind, data in (("pose", scaled(Y, many)), ("position", many * Y[:, :3, 3])):
        with pytest.raises(pieper.InputError, match=unit):
            arm.calibrate(q, data, kind=kind, sigma=NOISE)


def test_postures_that_never_touched_the_plane_do_not_shrink_the_arm_to_a_point():
    arm, q, _, _ = case("universal-robots-ur5e")
    with pytest.raises(pieper.InputError, match="shrunk to a point"):
        arm.calibrate(q, None, kind="plane", sigma=1e-4)


def test_an_arm_whose_axes_turned_to_explain_the_data_is_refused():
    arm, q, Y, _ = case("universal-robots-ur5e", 0)
    with pytest.raises(pieper.InputError, match=r"another arm|belong together"):
        arm.calibrate(q + 20.0, Y, sigma=NOISE)


@pytest.mark.parametrize("name", ARMS)
def test_zeros_a_third_of_a_radian_off_and_a_longer_tool_are_no_other_arm(name):
    arm, q, Y, rng = case(name)
    off = rng.uniform(-0.35, 0.35, arm.n) * np.where(arm.chain.prismatic, 0.1, 1.0)
    longer = Y @ pieper.pose(0.02, 0.01, 0.15)
    assert arm.calibrate(q + off, longer, sigma=NOISE).held_out.metres < 5e-4


def test_lengths_said_far_too_noisy_are_told_though_turns_are_right():
    arm, q, Y, _ = case("universal-robots-ur5e")
    assert "Was sigma meant in other units" in arm.calibrate(q, Y, sigma=(50 * NOISE[0], NOISE[1])).explain()
    assert "Was sigma meant in other units" not in arm.calibrate(q, Y, sigma=NOISE).explain()
