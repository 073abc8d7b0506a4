"""How much a second direction resists, of arms of any number of joints."""

import numpy as np
import pytest

import pieper
from oracle.joints import random_joints, scaled
from pieper.solver.singular.trace import second_smallest


@pytest.mark.parametrize("joints", [3, 5, 6, 7, 8, 9])
def test_it_is_the_last_but_one_of_the_singular_values_with_zeros_beyond_the_sixth(joints):
    rng = np.random.default_rng(joints)
    rows = [pieper.DH(rng.uniform(0.1, 0.4), rng.uniform(0.3, 1.4), 0.1, 0.0) for _ in range(joints)]
    chain = pieper.Arm.from_dh(rows, convention="standard").chain
    for q in random_joints(chain, rng, 5):
        values = np.sqrt(np.maximum(np.linalg.eigvalsh(scaled(chain, q).T @ scaled(chain, q))[::-1], 0.0))
        assert abs(second_smallest(chain, q) - values[joints - 2] / values[0]) < 1e-7
