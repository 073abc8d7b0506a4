"""pieper: give it a DH table and it gives back everything that can be known about how that arm moves."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pieper import jax, torch
    from pieper.arm import Arm
    from pieper.arms import catalog, find_arms, load, ur_calibrated
    from pieper.cell import Cell
    from pieper.collision.scene import Scene
    from pieper.collision.swept import Clearance, Swept
    from pieper.description.dh import DH, Actuator
    from pieper.description.quantity import evaluate
    from pieper.description.shapes import Body, Box, Capsule, Convex, Cylinder
    from pieper.document.writing import whole_file
    from pieper.errors import InputError, NoSolutionError, PieperError, PieperWarning, PlanError
    from pieper.judge import Judgement, check, guess_claims
    from pieper.kinematics.spoken import pose, read_pose
    from pieper.kinematics.spoken_many import poses
    from pieper.motion.dialects.files import read_program
    from pieper.motion.highest_speed import fastest_constant_speed
    from pieper.motion.limits import Limits
    from pieper.motion.motion import Motion
    from pieper.motion.path import line
    from pieper.motion.program import Program
    from pieper.motion.program_file import load_program, save_program
    from pieper.motion.recorded import read_motion
    from pieper.motion.route.arcs import Arc
    from pieper.motion.route.freedom import Freedom, Verdict
    from pieper.motion.route.result import Route
    from pieper.motion.sequence import move, sequence
    from pieper.motion.time_law import time_law
    from pieper.motion.track import Track
    from pieper.presentation import plot, sections
    from pieper.presentation.report import report, write_report
    from pieper.solver.batch import PoseSolutions, SolutionBatch
    from pieper.solver.plan.plan import Plan
    from pieper.solver.results import Solutions, Status
    from pieper.solver.singular.self_motion import SelfMotion

    workbench: Any

__version__ = "0.1.0"

#: What is imported when it is first asked for: a name and the module that has it, or that it is.
_LATER = {
    "Arm": "pieper.arm",
    "DH": "pieper.description.dh",
    "Actuator": "pieper.description.dh",
    "InputError": "pieper.errors",
    "NoSolutionError": "pieper.errors",
    "PieperError": "pieper.errors",
    "PieperWarning": "pieper.errors",
    "Plan": "pieper.solver.plan.plan",
    "PlanError": "pieper.errors",
    "PoseSolutions": "pieper.solver.batch",
    "SolutionBatch": "pieper.solver.batch",
    "Solutions": "pieper.solver.results",
    "Status": "pieper.solver.results",
    "catalog": "pieper.arms",
    "find_arms": "pieper.arms",
    "line": "pieper.motion.path",
    "load": "pieper.arms",
    "ur_calibrated": "pieper.arms",
    "Arc": "pieper.motion.route.arcs",
    "Cell": "pieper.cell",
    "Freedom": "pieper.motion.route.freedom",
    "Route": "pieper.motion.route.result",
    "Verdict": "pieper.motion.route.freedom",
    "Body": "pieper.description.shapes",
    "Box": "pieper.description.shapes",
    "Capsule": "pieper.description.shapes",
    "Clearance": "pieper.collision.swept",
    "Convex": "pieper.description.shapes",
    "Cylinder": "pieper.description.shapes",
    "Scene": "pieper.collision.scene",
    "Swept": "pieper.collision.swept",
    "Judgement": "pieper.judge",
    "Limits": "pieper.motion.limits",
    "Motion": "pieper.motion.motion",
    "Track": "pieper.motion.track",
    "Program": "pieper.motion.program",
    "SelfMotion": "pieper.solver.singular.self_motion",
    "check": "pieper.judge",
    "guess_claims": "pieper.judge",
    "evaluate": "pieper.description.quantity",
    "fastest_constant_speed": "pieper.motion.highest_speed",
    "jax": "pieper.jax",
    "load_program": "pieper.motion.program_file",
    "move": "pieper.motion.sequence",
    "plot": "pieper.presentation.plot",
    "pose": "pieper.kinematics.spoken",
    "poses": "pieper.kinematics.spoken_many",
    "read_motion": "pieper.motion.recorded",
    "read_pose": "pieper.kinematics.spoken",
    "read_program": "pieper.motion.dialects.files",
    "report": "pieper.presentation.report",
    "save_program": "pieper.motion.program_file",
    "sections": "pieper.presentation.sections",
    "sequence": "pieper.motion.sequence",
    "time_law": "pieper.motion.time_law",
    "torch": "pieper.torch",
    "whole_file": "pieper.document.writing",
    "workbench": "pieper.workbench",
    "write_report": "pieper.presentation.report",
}
_MODULES = ("jax", "plot", "sections", "torch", "workbench")

__all__ = [
    "DH",
    "Actuator",
    "Arc",
    "Arm",
    "Freedom",
    "Body",
    "Box",
    "Capsule",
    "Cell",
    "Clearance",
    "Convex",
    "Cylinder",
    "InputError",
    "Judgement",
    "Limits",
    "Motion",
    "NoSolutionError",
    "PieperError",
    "PieperWarning",
    "Plan",
    "PlanError",
    "PoseSolutions",
    "Program",
    "Route",
    "Scene",
    "SelfMotion",
    "SolutionBatch",
    "Solutions",
    "Status",
    "Swept",
    "Track",
    "Verdict",
    "catalog",
    "check",
    "guess_claims",
    "evaluate",
    "fastest_constant_speed",
    "find_arms",
    "jax",
    "line",
    "load",
    "load_program",
    "move",
    "plot",
    "pose",
    "poses",
    "read_motion",
    "read_pose",
    "read_program",
    "report",
    "save_program",
    "sections",
    "sequence",
    "time_law",
    "torch",
    "ur_calibrated",
    "whole_file",
    "workbench",
    "write_report",
]


def __getattr__(name: str) -> Any:
    """Import a name of `_LATER` when it is first asked for, and keep it."""
    if name not in _LATER:
        raise AttributeError(f"module 'pieper' has no attribute {name!r}")
    module = import_module(_LATER[name])
    value = globals()[name] = module if name in _MODULES else getattr(module, name)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
