"""One pose, all its solutions: each with its posture, its limits and what forward kinematics says of it."""

import numpy as np

import pieper

arm = pieper.load("denso-vp6242")
T = np.eye(4)
T[:3, 3] = 0.35, 0.0, 0.4

sols = arm.ik(T)
print(arm.plan.explain(), "\n")
print(sols.why)
for q, label, inside in zip(sols.all_q, sols.all_labels, sols.in_limits, strict=True):
    miss = np.abs(arm.fk(q) - T).max()
    print(np.round(np.degrees(q), 3), label, "inside" if inside else "outside the limits", f"(off by {miss:.1e})")

q_now = np.radians([10, 60, -140, 0, 90, 0])
print("nearest to where the arm is:", np.round(np.degrees(sols.nearest(q_now)), 3))
