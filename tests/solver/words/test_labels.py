"""Posture labels: each names one solution of a pose, and changes on a singularity only."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.arms.known import free
from oracle.joints import random_joints
from pieper.kinematics.newton import determinant
from pieper.solver.words.labels import posture_words

#: Arms whose solutions differ in words: by family and by kind of first joints.
NAMED = [
    "denso-vp6242",
    "fanuc-r2000ic-165f",
    "unimation-puma-560",
    "universal-robots-ur5e",
    "universal-robots-ur3",
    "stanford-arm",
    "rrp-wrist",
    "adept-cobra-600",
    "dfrobot-rob0036",
]


@pytest.mark.parametrize("name", NAMED)
def test_every_solution_of_a_pose_has_a_label_of_its_own(name):
    arm = free(name)
    for T in arm.fk(random_joints(arm, np.random.default_rng(1), 40)):
        labels = arm.ik(T).all_labels
        assert len(set(labels)) == len(labels) > 1, labels


@pytest.mark.parametrize("name", [n for n in NAMED if n not in ("adept-cobra-600", "dfrobot-rob0036")])
def test_a_label_changes_where_the_determinant_vanishes_and_nowhere_else(name):
    arm = free(name)
    rng = np.random.default_rng(2)
    changes = 0
    for start, end in zip(random_joints(arm, rng, 6), random_joints(arm, rng, 6), strict=True):
        line = start + np.linspace(0, 1, 1501)[:, None] * (end - start)
        words = [set(label.split(", ")) for label in posture_words(arm.plan, line)]
        value = determinant(arm.chain, line)
        det, vanishing = np.sign(value), np.abs(value) < 1e-6 * np.abs(value).max()
        for i in range(len(line) - 1):
            # who turns about to face the wrist at the shoulder's singularity sees the elbow on the other side as well
            changed = words[i + 1] != words[i]
            changes += changed
            # where the slide is drawn in, two factors of the determinant vanish at once
            assert (det[i] != det[i + 1]) == changed or vanishing[i : i + 2].any(), (line[i], words[i], words[i + 1])
    assert changes


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("universal-robots-ur5e", {"front", "rear", "elbow up", "elbow down", "wrist flip", "wrist no flip"}),
        ("stanford-arm", {"front", "rear", "slide out", "slide back", "wrist flip", "wrist no flip"}),
        ("adept-cobra-600", {"elbow left", "elbow right"}),
        ("kuka-lbr-iiwa-14-r820", {f"{w} {f}" for w in ("shoulder", "elbow", "wrist") for f in ("flip", "no flip")}),
    ],
)
def test_labels_are_made_of_the_words_that_fit_the_arm(name, words):
    arm = free(name)
    said = posture_words(arm.plan, random_joints(arm, np.random.default_rng(3), 200))
    assert set(", ".join(said).split(", ")) == words


def test_the_elbow_of_a_scara_arm_is_left_or_right_as_seen_from_above():
    arm = free("adept-cobra-600")
    bent = np.array([[0.3, 0.8, 0.1, 0.0], [0.3, -0.8, 0.1, 0.0]])
    # the second link turned to the left (counterclockwise) leaves the elbow on the right
    assert posture_words(arm.plan, bent) == ["elbow right", "elbow left"]


@pytest.mark.parametrize("name", ["jaka-zu30", "jaka-zu20"])
def test_last_axes_that_pass_each_other_by_a_hair_leave_every_row_its_own_label(name):
    arm, rng = free(name), np.random.default_rng(0)
    for q in rng.uniform(-3, 3, (40, 6)):
        labels = arm.ik(arm.fk(q)).labels
        assert len(set(labels)) == len(labels)
