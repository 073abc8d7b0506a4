"""What a lab engineer would write: a URDF, the pose the controller shows, the nearest solution, a straight line."""

import sys
from pathlib import Path

import numpy as np

import pieper

folder = Path(sys.argv[1])
pieper.load("universal-robots-ur5e").save(folder / "robot.urdf")

arm = pieper.load(folder / "robot.urdf")
tool = pieper.pose(0, 0, 120, mm=True)
arm = arm.with_tool(tool).with_limits({arm.joint_names[0]: (-3.0, 3.0)})
for note in arm.notes:
    print(note)

T = pieper.pose(400, -200, 250, rotvec=(pi := np.pi, 0, 0), mm=True)
now = np.radians([-20.0, -90.0, 90.0, -90.0, -90.0, 0.0])
solutions = arm.ik(T)
print(solutions)
if len(solutions):
    q = solutions.nearest(now)
    print("go to", np.degrees(q).round(2), "from", np.degrees(now).round(2))
    x, y, z, *angles = pieper.read_pose(arm.fk(q), "rotvec", mm=True)
    print(f"reads {x:.1f} {y:.1f} {z:.1f} mm,", [round(angle, 4) for angle in angles])
    track = arm.follow(pieper.line(arm.fk(q), pieper.pose(0, 0, -50, mm=True) @ arm.fk(q), n=20), start=q)
    print(track.explain())
    track.save(folder / "track.csv", degrees=True, mm=True)
else:
    print(solutions.why)
assert abs(pi - np.pi) < 1e-15
