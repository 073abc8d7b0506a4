"""The bound of the distance at postures near one is never undercut: no posture near keeps farther away than it says."""

import numpy as np
import pytest

import pieper
from pieper.collision.levers import at_most

SCENE = pieper.Scene(
    [
        pieper.Box([0.35, 0.1, 0.4], [0.3, 0.4, 0.5]),
        pieper.Capsule([-0.4, 0.0, 0.1], [-0.4, 0.2, 0.9], 0.15),
        pieper.Box([0.0, 0.0, -0.3], [2.0, 2.0, 0.1]),
    ]
)
ARMS = [
    "denso-vp6242",
    "universal-robots-ur5e",
    "stanford-arm",
    "adept-cobra-600",
    "franka-panda",
    "fanuc-lr-mate-200id",
]


@pytest.mark.parametrize("radius", [0.01, 0.1, 0.5])
@pytest.mark.parametrize("name", ARMS)
def test_no_posture_near_is_farther_from_everything_than_the_bound(name, radius):
    arm = pieper.load(name)
    rng = np.random.default_rng([7, ARMS.index(name), int(1000 * radius)])
    model = arm.collision_model(SCENE)
    low, high = np.clip(arm.limits, -3, 3).T
    q = rng.uniform(low, high, (40, arm.n))
    bound = at_most(model, q, np.full(len(q), radius))
    assert (bound < np.inf).all() and (bound >= arm.distance(q, SCENE)).all()
    # as far as the ball allows, towards where the distance grows, and anywhere
    C = np.eye(arm.n) if arm.plan.chain.coupling is None else arm.plan.chain.coupling
    unit = arm.plan.chain.joints.unit
    grow = np.asarray(arm.distance(q, SCENE).gradient) * unit
    moves = rng.normal(size=(60, *q.shape))
    moves[0], moves[1] = grow, -grow
    moves *= radius / np.maximum(np.linalg.norm(moves, axis=-1, keepdims=True), 1e-300)
    nearby = q + np.linalg.solve(C, (moves * unit)[..., None])[..., 0]
    away = np.asarray(arm.distance(nearby.reshape(-1, arm.n), SCENE)).reshape(60, -1)
    assert (away <= bound).all()
    # and it is no vain bound: of the ways that were gone some come near to it
    assert (away - arm.distance(q, SCENE)).max() > 0.05 * (bound - arm.distance(q, SCENE)).min()
