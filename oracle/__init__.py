"""The slow, independent judge that tests and benchmarks import: it shares nothing with the library's solvers.

`model` is an arm as plain matrices, `starts` the multi-start search, `homotopy` sixteen complex paths, `verdict` and
`whole` hold an arm's answers against what was found, `arms` makes the arms that are judged.
"""

from oracle.model import TASKS, Machine, elementary, equations, exact_residual, forward, gap, locked, machine, polish
from oracle.starts import Found, build, compiled_newton, damped_newton, load, search
from oracle.verdict import Verdict, blur, judge
from oracle.whole import DOUBLE, Compared, compare, whole_set

__all__ = [
    "DOUBLE",
    "TASKS",
    "Compared",
    "Found",
    "Machine",
    "Verdict",
    "blur",
    "build",
    "compare",
    "compiled_newton",
    "damped_newton",
    "elementary",
    "equations",
    "exact_residual",
    "forward",
    "gap",
    "judge",
    "load",
    "locked",
    "machine",
    "polish",
    "search",
    "whole_set",
]
