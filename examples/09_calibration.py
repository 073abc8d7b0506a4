"""A calibration: an arm as it was built, found from fifty measured poses, and solved as it is."""

import numpy as np

import pieper

arm = pieper.load("universal-robots-ur5e")
rng = np.random.default_rng(0)

# The arm as built stands here for a tracker: every axis about a millimetre and a milliradian off.
axes = arm.chain.axes + rng.normal(0, 1e-3, (6, 3))
axes /= np.linalg.norm(axes, axis=1, keepdims=True)
points = arm.chain.points + rng.normal(0, 5e-4, (6, 3))
built = pieper.Arm.from_axes(axes, points, arm.fk(np.zeros(6)), joint_types="RRRRRR", limits=arm.limits)

q = rng.uniform(-2.5, 2.5, (70, 6))
measured = built.fk(q)
measured[:, :3, 3] += rng.normal(0, 5e-5, (70, 3))

fit = arm.calibrate(q, measured, sigma=(5e-5, 1e-5))
print(fit.explain())

T = built.fk([0.3, -1.2, 1.4, -0.5, 0.9, 0.2])
for name, solver in (("nominal", arm), ("calibrated", fit.arm)):
    rows = solver.ik(T).q
    missed = np.linalg.norm(built.fk(rows)[:, :3, 3] - T[:3, 3], axis=1).max()
    print(f"{name:10} {len(rows)} solutions, the arm as built misses by at most {missed * 1e3:.3f} mm")

fit.save("my-ur5e.toml")
pieper.plot.save_figure(pieper.plot.calibration_figure(fit), "calibration.png")
