"""An arm of one's own: from a DH table to every solution, and into a robot file."""

from math import pi, radians

import numpy as np

import pieper

arm = pieper.Arm.from_dh(
    [
        pieper.DH(a=0.05, alpha=pi / 2, d=0.40),
        pieper.DH(a=0.45),
        pieper.DH(a=0.04, alpha=pi / 2),
        pieper.DH(alpha=-pi / 2, d=0.42),
        pieper.DH(alpha=pi / 2),
        pieper.DH(d=0.08),
    ],
    convention="standard",
    limits=[(-radians(v), radians(v)) for v in (170, 120, 150, 190, 120, 360)],
    name="my-arm",
)
print(arm.plan.explain())

q = np.radians([20, 40, -30, 50, 60, -70])
sols = arm.ik(arm.fk(q))
print(len(sols), "solutions inside the limits, at most", arm.plan.max_solutions)
print("the posture it came from is among them:", bool((np.abs(sols.q - q).max(1) < 1e-9).any()))
arm.save("my-arm.toml")
