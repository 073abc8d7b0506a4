"""What a student would write: the table of a book, why it can be solved, the equations, where it is singular."""

from math import pi

import pieper

rows = [
    pieper.DH(a=0, alpha=pi / 2, d=0.4),
    pieper.DH(a=0.5),
    pieper.DH(a=0.3),
]
arm = pieper.Arm.from_dh(rows, convention="standard", name="book", joint_names=["turn", "shoulder", "elbow"])

print(arm.plan.explain())
T = arm.fk([0.3, 0.5, -0.8])
solutions = arm.ik(T)
for solution in solutions:
    print(solution.label, [round(float(value), 4) for value in solution.q], f"off by {solution.residual[0]:.1e} m")
assert len(solutions) == 4

print(arm.symbolic.ik().text())
singular = arm.symbolic.singularities(task="position")
for configuration in singular.configurations:
    print(configuration.kind, *configuration.words)
print(arm.symbolic.fk().check(50).what)
