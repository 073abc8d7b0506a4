"""The catalogue: every arm has a source, and every pose known from elsewhere comes out of its table."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from oracle.products import product
from pieper.description import catalog
from pieper.errors import InputError

NAMES = catalog.names()
PAPERS = (
    "denso-vp6242",
    "dfrobot-rob0036",
    "dfrobot-rob0036-as-printed",
    "rrp-wrist",
    "motoman-ea1400n",
    "three-r",
    "denso-vs6577",
    "fanuc-r2000ic-165f",
)


@pytest.mark.parametrize("name", NAMES)
def test_every_check_pose_comes_out_of_the_table(name):
    arm = catalog.load(name)
    assert arm.checks, f"{name} has no check pose"
    for check in arm.checks:
        known = np.isfinite(check.T[:3])
        assert known.any() and check.source
        miss = np.abs(product(arm, check.q)[:3] - check.T[:3])[known].max()
        assert miss <= check.tolerance, f"{name}: {miss:.3g} off what is known from: {check.source}"


@pytest.mark.parametrize("name", NAMES)
def test_every_file_is_named_after_its_arm_and_says_its_source(name):
    arm = catalog.load(name)
    assert arm.name == name
    assert len(arm.source) > 10
    assert "/" not in name and name == name.lower()


@pytest.mark.parametrize("name", NAMES)
def test_every_arm_has_a_named_posture_of_its_own_size(name):
    arm = catalog.load(name)
    assert "zero" in arm.postures
    assert all(q.shape == (arm.n,) for q in arm.postures.values())


@pytest.mark.parametrize("name", PAPERS)
def test_the_arms_of_the_five_papers_are_there(name):
    assert name in NAMES


def test_there_are_at_least_forty_arms_beyond_the_papers():
    assert len(set(NAMES) - set(PAPERS)) >= 40


def test_most_checks_are_tighter_than_a_nanometre():
    tolerances = [check.tolerance for name in NAMES for check in catalog.load(name).checks]
    assert np.mean(np.array(tolerances) <= 1e-9) > 0.9


def test_the_denso_limits_are_those_of_the_table_not_of_the_controller():
    limits = np.degrees(catalog.load("denso-vp6242").limits)
    assert np.allclose(limits[1], [-30, 210]) and np.allclose(limits[2], [-250, -110])


def test_departures_from_a_paper_are_said_in_the_file():
    for name in ("denso-vp6242", "denso-vs6577", "dfrobot-rob0036", "fanuc-r2000ic-165f"):
        assert catalog.load(name).departures


def test_the_sixth_servo_of_the_dfrobot_arm_is_a_gripper():
    arm = catalog.load("dfrobot-rob0036")
    assert arm.n == 5 and arm.actuator is not None and arm.actuator.name == "gripper"


def test_the_seed_003_postures_are_told_in_controller_angles():
    arm = catalog.load("denso-vs6577-controller")
    theta = catalog.load("denso-vs6577")
    q = arm.postures["P1"]
    there = product(arm, q) @ np.linalg.inv(arm.tool)
    assert np.allclose(there, product(theta, arm.sign * q + arm.offset), atol=1e-12)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("DENSO VP6242", "denso-vp6242"),
        ("ur5e", "universal-robots-ur5e"),
        ("ur5", "universal-robots-ur5"),
        ("panda", "franka-panda"),
        ("iiwa", "kuka-lbr-iiwa-14-r820"),
        ("puma560", "unimation-puma-560"),
    ],
)
def test_a_part_that_one_arm_alone_has_is_enough(typed, meant):
    assert catalog.load(typed).name == meant


def test_a_part_that_several_arms_have_lists_them():
    with pytest.raises(InputError, match="abb-irb140.*say which"):
        catalog.load("abb")


@pytest.mark.parametrize(("typed", "meant"), [("denso-vp6224", "denso-vp6242"), ("ur5x", "universal-robots-ur5e")])
def test_an_unknown_name_gets_the_nearest_ones(typed, meant):
    with pytest.raises(InputError, match=f"no arm.*{meant}"):
        catalog.load(typed)


def test_a_name_cannot_lead_out_of_the_catalogue():
    with pytest.raises(InputError, match="no arm"):
        catalog.load("../../errors")


def test_listing_the_names_opens_no_file():
    code = (
        "import sys; from pieper.description import catalog\n"
        "sys.addaudithook(lambda event, args: (event == 'open' and str(args[0]).endswith('.toml')) and sys.exit(3))\n"
        "assert len(catalog.names()) > 40"
    )
    source = Path(catalog.__file__).parents[2]
    assert subprocess.run([sys.executable, "-c", code], cwd=source, check=False).returncode == 0
