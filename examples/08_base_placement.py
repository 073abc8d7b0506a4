"""A placement: where an arm must stand to reach sixty grasps around a table."""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import pieper

arm = pieper.load("universal-robots-ur5e")
rng = np.random.default_rng(0)
grasps = np.stack(
    [
        pieper.pose(*rng.uniform([-0.4, -0.3, 0.1], [0.4, 0.3, 0.3]), rpy=(np.pi, 0, turn))
        @ pieper.pose(0, 0, 0, rpy=(*rng.uniform(-0.5, 0.5, 2), 0))
        for turn in rng.uniform(-np.pi, np.pi, 60)
    ]
)
x, y = np.linspace(-1.2, 1.2, 25), np.linspace(-1.0, 1.0, 21)
shares = arm.base_places(grasps, x=x, y=y, z=[0.0], yaw=[0.0])[:, :, 0, 0]
i, j = np.unravel_index(shares.argmax(), shares.shape)
print(f"{shares.max():.0%} of the grasps are reached from x = {x[i]:.2f} m, y = {y[j]:.2f} m")

figure = Figure(figsize=(6, 4.6), layout="constrained")
FigureCanvasAgg(figure)
axes = figure.add_subplot()
drawn = axes.pcolormesh(x, y, shares.T, cmap="Blues", vmin=0, vmax=1)
axes.plot(*grasps[:, :2, 3].T, "k.", markersize=4, label="grasps")
axes.plot(x[i], y[j], "o", color="#D55E00", label="best base")
axes.set(xlabel="x of the base, m", ylabel="y of the base, m", aspect="equal")
axes.legend(loc="upper right")
figure.colorbar(drawn, label="share of grasps reached")
figure.savefig("placement.png")
