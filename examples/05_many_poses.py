"""A hundred thousand poses at once: which can be reached, and how often in how many ways."""

import time

import numpy as np

import pieper

arm = pieper.load("denso-vp6242")
rng = np.random.default_rng(0)
T = np.tile(np.eye(4), (100_000, 1, 1))
T[:, :3, 3] = rng.uniform([-0.5, -0.5, -0.3], [0.5, 0.5, 0.7], (len(T), 3))

begun = time.perf_counter()
many = arm.ik_many(T)
took = time.perf_counter() - begun
print(f"{len(T):,} poses in {took * 1e3:.0f} ms")
for status in pieper.Status:
    print(f"{status.name:15} {np.count_nonzero(many.status == status):7,}")
print("solutions inside the limits:", dict(zip(*np.unique(many.in_limits.sum(1), return_counts=True), strict=True)))
