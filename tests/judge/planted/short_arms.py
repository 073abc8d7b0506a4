"""Arms with fewer than six joints, each with right formulas typed by hand."""

# ruff: noqa: E501 (a formula is read in one line)
from __future__ import annotations

from math import pi

from .arm import H, PlantedArm, Row

RR = PlantedArm(
    "two links",
    "standard",
    (Row("R", "a1", 0, ""), Row("R", "a2", 0, "")),
    {"a1": 0.43, "a2": 0.31},
    {"px": "a1*c1 + a2*c12", "py": "a1*s1 + a2*s12", "r11": "c12", "r21": "s12", "r12": "-s12"},
    (
        (2, "pm(acos((px**2 + py**2 - a1**2 - a2**2)/(2*a1*a2)))"),
        (
            2,
            "atan2(pm(sqrt(1 - ((px**2 + py**2 - a1**2 - a2**2)/(2*a1*a2))**2)), (px**2 + py**2 - a1**2 - a2**2)/(2*a1*a2))",
        ),
        (1, "atan2(py, px) - atan2(a2*s2, a1 + a2*c2)"),
        (1, "atan2(py*(a1 + a2*c2) - px*a2*s2, px*(a1 + a2*c2) + py*a2*s2)"),
        (1, "atan2(py, px) + pm(acos((px**2 + py**2 + a1**2 - a2**2)/(2*a1*sqrt(px**2 + py**2))))"),
    ),
)
RRR = PlantedArm(
    "three links",
    "standard",
    (Row("R", "a1", 0, ""), Row("R", "a2", 0, ""), Row("R", "a3", 0, "")),
    {"a1": 0.51, "a2": 0.37, "a3": 0.19},
    {"px": "a1*c1 + a2*c12 + a3*c123", "py": "a1*s1 + a2*s12 + a3*s123", "r11": "c123", "r21": "s123"},
    (
        (2, "pm(acos(((px - a3*r11)**2 + (py - a3*r21)**2 - a1**2 - a2**2)/(2*a1*a2)))"),
        (1, "atan2(py - a3*r21, px - a3*r11) - atan2(a2*s2, a1 + a2*c2)"),
        (3, "atan2(r21, r11) - theta1 - theta2"),
    ),
    "pose",
)
SCARA = PlantedArm(
    "scara",
    "standard",
    (Row("R", "a1", 0, "d1"), Row("R", "a2", pi, ""), Row("P", "", 0, ""), Row("R", "", 0, "d4")),
    {"d1": 0.387, "a1": 0.325, "a2": 0.275, "d4": 0.05},
    {
        "px": "a1*c1 + a2*c12",
        "py": "a1*s1 + a2*s12",
        "pz": "d1 - b3 - d4",
        "r11": "cos(theta1 + theta2 - theta4)",
        "r21": "s12*c4 - c12*s4",
    },
    (
        (2, "pm(acos((px**2 + py**2 - a1**2 - a2**2)/(2*a1*a2)))"),
        (1, "atan2(py, px) - atan2(a2*s2, a1 + a2*c2)"),
        (3, "d1 - d4 - pz"),
        (4, "theta1 + theta2 - atan2(r21, r11)"),
    ),
    "pose",
)
ELBOW = PlantedArm(
    "elbow",
    "standard",
    (Row("R", "", H, "d1"), Row("R", "a2", 0, ""), Row("R", "a3", 0, "")),
    {"d1": 0.3, "a2": 0.41, "a3": 0.33},
    {"px": "c1*(a2*c2 + a3*c23)", "py": "s1*(a2*c2 + a3*c23)", "pz": "d1 + a2*s2 + a3*s23", "r13": "s1", "r31": "s23"},
    (
        (3, "pm(acos((px**2 + py**2 + (pz - d1)**2 - a2**2 - a3**2)/(2*a2*a3)))"),
        (2, "atan2(pz - d1, px*c1 + py*s1) - atan2(a3*s3, a2 + a3*c3)"),
        (2, "atan2((pz - d1)*(a2 + a3*c3) - (px*c1 + py*s1)*a3*s3, (px*c1 + py*s1)*(a2 + a3*c3) + (pz - d1)*a3*s3)"),
    ),
)
OFFSET = PlantedArm(
    "elbow with a shoulder",
    "standard",
    (Row("R", "a1", -H, "d1"), Row("R", "a2", 0, "d2"), Row("R", "a3", 0, "")),
    {"a1": 0.12, "d1": 0.36, "a2": 0.45, "d2": 0.09, "a3": 0.29},
    {
        "px": "c1*(a1 + a2*c2 + a3*c23) - d2*s1",
        "py": "s1*(a1 + a2*c2 + a3*c23) + d2*c1",
        "pz": "d1 - a2*s2 - a3*s23",
        "r11": "c1*c23",
        "r12": "-c1*s23",
        "r22": "-s1*s23",
        "r32": "-c23",
    },
    ((2, "atan2(d1 - pz, px*c1 + py*s1 - a1) - atan2(a3*s3, a2 + a3*c3)"),),
)
POLAR = PlantedArm(
    "polar",
    "standard",
    (Row("R", "", -H, "d1"), Row("R", "", H, "d2"), Row("P", "", 0, "")),
    {"d1": 0.4, "d2": 0.15},
    {"px": "b3*c1*s2 - d2*s1", "py": "b3*s1*s2 + d2*c1", "pz": "d1 + b3*c2", "r11": "c1*c2", "r31": "-s2", "r33": "c2"},
    (
        (3, "(pz - d1)*c2 + (px*c1 + py*s1)*s2"),
        (1, "atan2(py, px) - atan2(d2, pm(sqrt(px**2 + py**2 - d2**2)))"),
    ),
)
CYLINDER = PlantedArm(
    "cylindrical",
    "standard",
    (Row("R", "", 0, "d1"), Row("P", "", -H, ""), Row("P", "", 0, "")),
    {"d1": 0.25},
    {"px": "-b3*s1", "py": "b3*c1", "pz": "d1 + b2", "r11": "c1", "r13": "-s1"},
    ((2, "pz - d1"), (3, "py*c1 - px*s1")),
)
GANTRY = PlantedArm(
    "gantry with a turn",
    "standard",
    (Row("P", "", -H, ""), Row("P", "", -H, "", -H), Row("P", "", 0, ""), Row("R", "a4", 0, "d4")),
    {"a4": 0.2, "d4": 0.1},
    {"px": "b3 + d4", "py": "b2 - a4*s4", "pz": "b1 + a4*c4"},
    (),
)
WRIST4 = PlantedArm(
    "four joints, tool held",
    "standard",
    (Row("R", "", H, "d1"), Row("R", "a2", 0, ""), Row("R", "a3", 0, ""), Row("R", "a4", 0, "")),
    {"d1": 0.21, "a2": 0.35, "a3": 0.28, "a4": 0.11},
    {
        "px": "c1*(a2*c2 + a3*c23 + a4*c234)",
        "py": "s1*(a2*c2 + a3*c23 + a4*c234)",
        "pz": "d1 + a2*s2 + a3*s23 + a4*s234",
        "r31": "s234",
        "r32": "c234",
        "r11": "c1*c234",
        "r22": "-s1*s234",
    },
    (
        (3, "pm(acos(((px*c1 + py*s1 - a4*r32)**2 + (pz - d1 - a4*r31)**2 - a2**2 - a3**2)/(2*a2*a3)))"),
        (4, "atan2(r31, r32) - theta2 - theta3"),
        (2, "atan2(pz - d1 - a4*r31, px*c1 + py*s1 - a4*r32) - atan2(a3*s3, a2 + a3*c3)"),
    ),
    "pose",
)
FIVE = PlantedArm(
    "five joints",
    "standard",
    (
        Row("R", "a1", H, "d1"),
        Row("R", "a2", 0, ""),
        Row("R", "a3", 0, ""),
        Row("R", "", H, "", H),
        Row("R", "", 0, "d5"),
    ),
    {"a1": 0.033, "d1": 0.147, "a2": 0.155, "a3": 0.135, "d5": 0.218},
    {
        "px": "c1*(a1 + a2*c2 + a3*c23 + d5*c234)",
        "py": "s1*(a1 + a2*c2 + a3*c23 + d5*c234)",
        "pz": "d1 + a2*s2 + a3*s23 + d5*s234",
        "r33": "s234",
        "r13": "c1*c234",
        "r31": "c234*c5",
        "r32": "-c234*s5",
    },
    (
        (4, "atan2(r33, c1*r13 + s1*r23) - theta2 - theta3"),
        (5, "atan2(s1*r11 - c1*r21, s1*r12 - c1*r22)"),
        (
            3,
            "pm(acos(((c1*px + s1*py - a1 - d5*(c1*r13 + s1*r23))**2 + (pz - d1 - d5*r33)**2 - a2**2 - a3**2)/(2*a2*a3)))",
        ),
    ),
    "pose",
)
RPR = PlantedArm(
    "turn, slide, turn",
    "standard",
    (Row("R", "", H, ""), Row("P", "", -H, ""), Row("R", "a3", 0, "")),
    {"a3": 0.22},
    {"px": "b2*s1 + a3*c13", "py": "-b2*c1 + a3*s13", "r11": "c13", "r21": "s13"},
    (
        (1, "atan2(pm(px - a3*r11), pm(a3*r21 - py))"),
        (2, "s1*(px - a3*r11) - c1*(py - a3*r21)"),
        (3, "atan2(r21, r11) - theta1"),
    ),
    "pose",
)
CRAIG3 = PlantedArm(
    "three links, Craig",
    "modified",
    (Row("R", "", 0, ""), Row("R", "L1", 0, ""), Row("R", "L2", 0, "")),
    {"L1": 0.4, "L2": 0.3},
    {"px": "L1*c1 + L2*c12", "py": "L1*s1 + L2*s12", "r11": "c123", "r12": "-s123"},
    (
        (2, "pm(acos((px**2 + py**2 - L1**2 - L2**2)/(2*L1*L2)))"),
        (1, "atan2(py, px) - atan2(L2*s2, L1 + L2*c2)"),
        (3, "atan2(r21, r11) - theta1 - theta2"),
    ),
    "pose",
)
WRIST = PlantedArm(
    "wrist alone",
    "standard",
    (Row("R", "", -H, ""), Row("R", "", H, ""), Row("R", "", 0, "d3")),
    {"d3": 0.1},
    {
        "r11": "c1*c2*c3 - s1*s3",
        "r12": "-c1*c2*s3 - s1*c3",
        "r13": "c1*s2",
        "r21": "s1*c2*c3 + c1*s3",
        "r23": "s1*s2",
        "r31": "-s2*c3",
        "r32": "s2*s3",
        "r33": "c2",
        "px": "d3*c1*s2",
        "pz": "d3*c2",
    },
    (
        (2, "atan2(pm(sqrt(r13**2 + r23**2)), r33)"),
        (2, "pm(acos(r33))"),
        (1, "atan2(sign(s2)*r23, sign(s2)*r13)"),
        (3, "atan2(sign(s2)*r32, -sign(s2)*r31)"),
    ),
    "pose",
)
SKEW = PlantedArm(
    "orthogonal three joints",
    "standard",
    (Row("R", "a1", H, ""), Row("R", "a2", H, "d2"), Row("R", "a3", 0, "")),
    {"a1": 0.2, "a2": 0.35, "d2": 0.14, "a3": 0.27},
    {
        "px": "c1*(a1 + a2*c2 + a3*c2*c3) + s1*(d2 + a3*s3)",
        "py": "s1*(a1 + a2*c2 + a3*c2*c3) - c1*(d2 + a3*s3)",
        "pz": "a2*s2 + a3*s2*c3",
        "r31": "s2*c3",
        "r13": "c1*s2",
    },
    (),
)


def two_links(a1: float, a2: float) -> str:
    """Return the arm of a claims file: two links in a plane, m."""
    return f"""
[arm]
name = "two links"
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [["q1", 0, "a1", 0], ["q2", 0, "a2", 0]]
values = {{ a1 = {a1}, a2 = {a2} }}
"""
