"""An exported solver: a file of C for a controller, compiled, tested, and its answers drawn beside the library's."""

import shutil
import subprocess
from pathlib import Path

import pieper

arm = pieper.load("universal-robots-ur5e")
source = arm.code("c", "ur5e.c", name="ur5e")
print(f"{source}: {source.stat().st_size / 1e3:.0f} kB of C99, no allocation, no library but the C one")
for line in source.read_text().splitlines()[1:6]:
    print("  ", line)

if shutil.which("gcc"):
    subprocess.run(["gcc", "-std=c99", "-Os", "-Dur5e_MAIN", "-o", "ur5e", source, "-lm"], check=True)
    print(subprocess.run(["./ur5e"], capture_output=True, text=True, check=True).stdout.strip())
    print(f"compiled for size: {Path('ur5e').stat().st_size / 1e3:.0f} kB with its self-test")

arm.code("javascript", "ur5e.mjs")
arm.code("c++", "ur5e.hpp", name="ur5e")
sols = arm.ik(arm.fk([0.3, -1.2, 1.4, -0.5, 0.9, 0.2]))
print(f"{len(sols)} solutions of one pose, as ur5e_ik finds them")
pieper.plot.save_figure(pieper.plot.solutions_figure(arm, sols), "solutions.png")
