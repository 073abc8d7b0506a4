"""A sequence of postures in time, and a table of tool positions compared: the study of the Denso VS-6577.

The postures, the times (20 s a leg, 10 s to settle) and both columns of positions are those printed by Khawlaor and
Nakphan (2021), Table 2.
"""

import numpy as np

import pieper
from pieper.motion.sequence import compare, sequence
from pieper.presentation import plot

postures = np.radians([[0] * 6, [-170, -100, -119, -180, -120, -360], [0] * 6, [170, -90, 75, 180, 120, 360], [0] * 6])
motion = sequence(postures, durations=20.0, holds=10.0, rate=50)
print(f"{motion.duration:g} s; postures are reached at", motion.arrivals, "s")

reference = np.array([[0, 790, 597], [96.8, 58.6, 549.0], [0, 790, 597], [0.97, 610.2, 5.51], [0, 790, 597]]) / 1e3
simulated = np.array([[0.01, 793, 594], [96.4, 58.9, 548.6], [0.01, 793, 594], [0.95, 610.18, 5.53], [0.01, 793, 594]])
table = compare(reference, simulated / 1e3)
for row in table.table():
    print("  ".join(f"{cell:>18}" for cell in row))
print("largest errors, percent:", np.round(table.largest_relative, 4))

arm = pieper.load("denso-vs6577-controller")
plot.save_figure(plot.time_figure(motion, arm=arm), "sequence.svg")
