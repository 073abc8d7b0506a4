"""pieper: give it a DH table and it gives back everything that can be known about how that arm moves."""

from pieper.arm import Arm, catalog, load, ur_calibrated
from pieper.description.dh import DH
from pieper.errors import InputError, NoSolutionError, PieperError, PieperWarning, PlanError
from pieper.kinematics.spoken import pose, read_pose
from pieper.motion.path import line
from pieper.solver.results import SolutionBatch, Solutions, Status

__version__ = "0.1.0"

__all__ = [
    "DH",
    "Arm",
    "InputError",
    "NoSolutionError",
    "PieperError",
    "PieperWarning",
    "PlanError",
    "SolutionBatch",
    "Solutions",
    "Status",
    "catalog",
    "line",
    "load",
    "pose",
    "read_pose",
    "ur_calibrated",
]
