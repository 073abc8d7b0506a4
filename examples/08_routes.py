"""A seam with a torch whose roll does not matter: the best route over all branches, and what closes the way."""

import numpy as np

import pieper

arm = pieper.load("abb-irb2400")
torch = pieper.pose(0.05, 0.02, 0.35, rpy=(0, 35, 0), degrees=True)
arm = arm.with_tool(arm.tool @ torch)

# a ring of 0.6 m across, the torch leaning inwards by 30 degrees
angle = np.linspace(0, 2 * np.pi, 61)
out = np.stack([np.cos(angle), np.sin(angle), 0 * angle], -1)
z = -np.cos(np.radians(30)) * np.array([0, 0, 1]) - np.sin(np.radians(30)) * out
x = np.stack([-np.sin(angle), np.cos(angle), 0 * angle], -1)
seam = np.tile(np.eye(4), (61, 1, 1))
seam[:, :3, :3] = np.stack([x, np.cross(z, x), z], -1)
seam[:, :3, 3] = np.array([1.1, 0, 0.6]) + 0.3 * out

held = arm.route(seam)
print(held)
print(held.explain())

route = arm.route(seam, free=pieper.Freedom())
print(route)
print(route.explain())
for other in route.alternatives:
    print(f"starting {other.branch}: cost {other.cost:.4f}")

motion = pieper.time_law(route, pieper.Limits(speed=2.0, acceleration=6.0))
print(f"{motion.duration:.2f} s, closest to a limit: {motion.margin:.3f}")

narrow = arm.with_limits({"joint_1": (-0.2, 0.2)}).route(seam, free=pieper.Freedom())
print(narrow.explain())
