"""The catalogue: every arm has a source, and every pose known from elsewhere comes out of its table."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pieper
from benchmarks import kept
from benchmarks.measure.catalogue import fingerprint
from benchmarks.pages import arms as page_of_arms
from oracle.joints import turns_apart
from oracle.products import product
from pieper.description import catalog, catalog_index
from pieper.errors import InputError

NAMES = catalog.names()
#: The first check of every arm that `tests.tools.new_arm` made.
OWN = "joint origins and axes of the source, multiplied one by one, no DH table involved"
MADE = [name for name in NAMES if OWN in Path(catalog.path_of(name)).read_text(encoding="utf-8")]
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


def test_there_are_at_least_a_hundred_and_fifty_arms_beyond_the_papers():
    assert len(set(NAMES) - set(PAPERS)) >= 150


def test_most_checks_are_tighter_than_a_nanometre():
    tolerances = [check.tolerance for name in set(NAMES) - set(MADE) for check in catalog.load(name).checks]
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
        ("iiwa 14", "kuka-lbr-iiwa-14-r820"),
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


@pytest.mark.parametrize("name", MADE)
def test_what_was_made_of_a_urdf_is_held_against_a_second_source(name):
    arm = catalog.load(name)
    sources = {check.source for check in arm.checks}
    assert OWN in sources and len(sources) >= 2
    assert all(check.tolerance <= 0.0305 for check in arm.checks)


@pytest.mark.parametrize("name", MADE)
def test_an_arm_from_a_urdf_finds_its_own_postures_again(name):
    arm = pieper.load(name)
    lower, upper = np.clip(arm.limits, -3, 3).T
    q = lower + np.random.default_rng(5).uniform(0, 1, (12, arm.n)) * (upper - lower)
    T = arm.fk(q)
    if arm.plan.redundancy:
        assert all(len(arm.ik(pose).all_q) for pose in T[:2])
        return
    found = arm.ik_many(T, threads=1)
    gap = turns_apart(found.q, q[:, None]).max(-1)
    assert ((gap < 1e-6) & found.valid).any(1).all()
    # of five joints the task may be a position and the tool's axis, which is what counts then
    close = arm.plan.residual(
        found.q[found.valid], np.broadcast_to(T[:, None], (*found.valid.shape, 4, 4))[found.valid]
    )
    assert close.max() < 1e-8 * max(1.0, np.abs(T[:, :3, 3]).max())


def test_an_arm_is_said_by_its_maker_joints_payload_and_reach():
    names = [arm.name for arm in pieper.find_arms(maker="kuka", joints="7R")]
    assert "kuka-lbr-iiwa-7-r800" in names and all(n.startswith("kuka") and pieper.load(n).n == 7 for n in names)
    strong = pieper.find_arms("abb", payload=100, reach=2.6)
    assert strong and all(arm.payload >= 100 and arm.reach >= 2.6 and arm.manufacturer == "ABB" for arm in strong)
    assert {arm.name for arm in pieper.find_arms()} == set(NAMES)
    assert pieper.find_arms(joints=3) == pieper.find_arms(joints="3R")


@pytest.mark.parametrize("said", [{"joints": "x"}, {"joints": 0}, {"payload": -1.0}, {"reach": float("nan")}])
def test_a_search_that_cannot_be_read_is_refused(said):
    with pytest.raises(InputError, match=next(iter(said))):
        pieper.find_arms(**said)


def test_the_index_is_that_of_the_files():
    arms = [catalog.load(name) for name in NAMES]
    assert Path(catalog_index.FILE).read_text(encoding="utf-8") == catalog_index.text_of(arms)


@pytest.mark.parametrize(
    "asked",
    [
        "import pieper; assert len(pieper.find_arms(joints=6)) > 100",
        "from pieper.description import catalog; assert len(catalog.names()) > 40",
    ],
    ids=["searching", "listing the names"],
)
def test_finding_an_arm_opens_no_robot_file(asked):
    said, asked = asked.split("; ")
    code = (
        f"import sys; {said}\n"
        "sys.addaudithook(lambda event, args: (event == 'open' and str(args[0]).endswith('.toml')) and sys.exit(3))\n"
        f"{asked}"
    )
    source = Path(catalog.__file__).parents[2]
    assert subprocess.run([sys.executable, "-c", code], cwd=source, check=False).returncode == 0


def test_the_page_of_arms_is_of_these_arms():
    """The cure: python -m benchmarks.measure.catalogue, then make pages."""
    rows = {row["arm"]: row["sha256"] for row in kept.read("catalogue")["rows"]}
    assert sorted(rows) == sorted(NAMES)
    assert [name for name in NAMES if fingerprint(pieper.load(name)) != rows[name]] == []
    assert (kept.DOCS / "arms.md").read_text(encoding="utf-8") == page_of_arms.page()
