"""What a researcher would write: many poses in one call, columns, a file, workers that get the plan by pickle."""

import pickle
import sys
from pathlib import Path

import numpy as np

import pieper

folder = Path(sys.argv[1])
rng = np.random.default_rng(1)
arm = pieper.load("kuka-kr6-r700-sixx")
q = rng.uniform(arm.limits[:, 0], arm.limits[:, 1], (20_000, arm.n))
Ts = arm.fk(q)

many = arm.ik_many(Ts, near=q)
print(many)
assert many.has_nearest.all()
assert float(np.abs(many.nearest - q).max()) < 1e-6

pose_index, rows = many.rows()
counts = np.bincount(pose_index, minlength=len(Ts))
print("solutions a pose:", dict(zip(*np.unique(counts, return_counts=True), strict=True)))
singular = many.status == pieper.Status.SINGULAR
print(f"{int(singular.sum())} singular poses, {len(rows)} rows")

many.save(folder / "rows.npz")
columns = many.columns(degrees=True)
print(list(columns))

again = pickle.loads(pickle.dumps(arm))
assert np.array_equal(again.ik(Ts[0]).q, arm.ik(Ts[0]).q)
manipulability = np.sqrt(np.linalg.det(arm.jacobian(q) @ np.swapaxes(arm.jacobian(q), -1, -2)))
print(f"manipulability {manipulability.min():.2e} to {manipulability.max():.2e}")
