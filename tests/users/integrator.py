"""What an integrator would write: why a pose fails, where a line stops and what cures it, a program, code to keep."""

import sys
from pathlib import Path

import numpy as np

import pieper

folder = Path(sys.argv[1])
arm = pieper.load("denso-vp6242")


def reachable(T: "np.typing.NDArray[np.float64]") -> bool:
    """Say what is wrong with a pose, or nothing."""
    solutions = arm.ik(T)
    if solutions.status in (pieper.Status.SOLVED, pieper.Status.SINGULAR):
        return True
    print(solutions.status.name, solutions.why)
    closest = solutions.closest
    print(f"nearest posture misses it by {closest.metres * 1e3:.1f} mm and {np.degrees(closest.radians):.2f} deg")
    return False


assert reachable(pieper.pose(350, 0, 400, mm=True))
assert not reachable(pieper.pose(900, 0, 400, mm=True))

sideways = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
path = pieper.line(pieper.pose(0.2, 0.1, 0.5, R=sideways), pieper.pose(0.35, 0.0, 0.4, R=sideways), n=50)
track = arm.follow(path)
print(track.explain())
stop = track.stop
assert stop is not None
print(f"{stop.cause} at {stop.metres * 1e3:.1f} mm")
for cure in track.cures:
    print(cure.kind, cure.words)
    assert cure.track.complete

limits = pieper.Limits(speed=np.full(6, 3.0), acceleration=np.full(6, 15.0))
start = arm.ik(pieper.pose(350, 0, 400, mm=True)).q[0]
program = pieper.Program(arm, limits, start=start)
program.move_l(pieper.pose(300, 50, 450, mm=True), speed=0.2)
program.wait(0.5)
motion = program.motion()
motion.save(folder / "motion.csv", degrees=True)
print(f"{motion.duration:.2f} s, {len(motion.t)} samples")
print(arm.code("c", folder / "denso.c", name="denso"))
