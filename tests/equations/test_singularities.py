"""The Jacobian as equations, its determinant in factors, and the singular configurations read off."""

import numpy as np
import pytest

import pieper
from pieper.algebra.determinant import expand
from pieper.algebra.harmonic import Poly, trig

ARMS = pieper.catalog()
#: One arm of each build; the others repeat these determinants with other lengths.
BUILDS = """
    denso-vp6242 denso-vs6577-controller fanuc-r2000ic-165f unimation-puma-560 universal-robots-ur5e stanford-arm
    rrp-wrist
    three-r adept-cobra-600 dfrobot-rob0036 dfrobot-rob0036-as-printed motoman-ea1400n motoman-hc10 kinova-jaco-j2n6
    kuka-lbr-iiwa-14-r820 franka-panda
""".split()


@pytest.mark.parametrize("name", ARMS)
def test_every_entry_of_the_jacobian_agrees_with_the_numeric_one(name):
    arm = pieper.load(name)
    for angles in ("theta", "q") if arm.description.coupling is None else ("theta",):
        assert arm.symbolic.jacobian(angles=angles).check(20).worst < 1e-11


@pytest.mark.parametrize("name", BUILDS)
def test_the_factored_determinant_and_every_singular_configuration_hold(name):
    found = pieper.load(name).symbolic.singularities(task="pose")
    assert found.check(20).worst < 1e-7


def test_the_three_singularities_of_a_spherical_wrist_arm_are_named():
    found = pieper.load("denso-vp6242").symbolic.singularities()
    assert found.determinant.text() == "a2*s5*(d4*c3 + a3*s3)*(a2*c2 + a3*c23 - d4*s23)"
    kinds = {s.kind: s for s in found.configurations}
    assert set(kinds) == {"shoulder", "elbow", "wrist"}
    assert "lies on axis 1" in kinds["shoulder"].words[0]
    assert np.degrees(kinds["elbow"].where) == pytest.approx([-109.653824, 70.346176])
    assert "Axes 4 and 6 lie on one line" in kinds["wrist"].words[0]


def test_an_offset_wrist_is_said_not_to_factor():
    found = pieper.load("motoman-ea1400n").symbolic.singularities(task="pose")
    assert "does not factor" in found.text()


def test_a_table_whose_first_axes_coincide_is_said_to_be_singular_always():
    found = pieper.load("dfrobot-rob0036-as-printed").symbolic.singularities(task="pose")
    assert "identically zero" in found.text()


def test_products_of_one_group_become_sums_of_angles():
    c2, s2 = trig("c", {2: 1}, 2), trig("s", {2: 1}, 2)
    c3, s3 = trig("c", {3: 1}, 2), trig("s", {3: 1}, 2)
    assert c2 * c3 - s2 * s3 == trig("c", {2: 1, 3: 1}, 2)
    assert c2 * c2 + s2 * s2 == Poly.number(1)
    assert expand([[c2, -s2], [s2, c2]]) == Poly.number(1)


def test_an_arm_without_any_special_geometry_is_told_so_and_its_equations_hold():
    rng = np.random.default_rng(4)
    rows = [
        pieper.DH(a=rng.uniform(0.1, 0.5), alpha=rng.uniform(-1.4, 1.4), d=rng.uniform(0.1, 0.5), theta=0.0)
        for _ in range(6)
    ]
    arm = pieper.Arm.from_dh(rows, convention="standard", joint_types="RRRRRR", name="general")
    singular = arm.symbolic.singularities()
    assert singular.square and singular.minors is None and singular.determinant is None
    assert "too long to print" in singular.text()
    assert arm.symbolic.jacobian().check(20).worst < 1e-12
    assert not arm.symbolic.ik().closed and "degree 16" in arm.symbolic.ik().text()
