"""Pick and place with the arm of the LabVIEW study, a DFRobot ROB0036: a program, its motion and a file of it.

The arm has five joints and a gripper. Its table prints no limits, so those of a small servo are taken: 60 degrees in
0.2 s.
"""

import numpy as np

import pieper

arm = pieper.load("dfrobot-rob0036")
limits = pieper.Limits(speed=np.radians(300), acceleration=np.radians(1500), jerk=np.radians(15000), tool_speed=0.5)

down = dict(rpy=(180, 0, 0), degrees=True)
pick, place = pieper.pose(0.12, 0.05, 0.0, **down), pieper.pose(0.10, -0.08, 0.02, **down)
above = pieper.pose(0, 0, 0.05)
home = arm.ik(pieper.pose(0.13, 0.0, 0.08, **down)).nearest(np.radians([0, 60, -60, -60, 0]))

program = pieper.Program(arm, limits, start=home)
program.move_j(above @ pick, blend=0.01).move_l(pick, speed=0.05)
program.gripper(1.0).wait(0.4)
program.move_l(above @ pick, speed=0.1, blend=0.02).move_l(above @ place, blend=0.02).move_l(place, speed=0.05)
program.gripper(0.0).wait(0.2)
program.move_l(above @ place, speed=0.1).move_j(home)

motion = program.motion(rate=200)
print(program.explain())
for time, kind, value in motion.events:
    print(f"{time:7.3f} s  {kind} {value}")
print(f"closest to a limit: {motion.margin:.4f}; {len(motion.t)} samples")

program.write("pick_and_place.csv", dialect="csv", rate=200)
targets = pieper.read_program("pick_and_place.csv")
print(f"read back: {len(targets)} points, the last one {np.degrees(targets[-1].q).round(3)} deg")
