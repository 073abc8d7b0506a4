"""Arms with six joints, each with right formulas typed by hand."""

# ruff: noqa: E501 (a formula is read in one line)
from __future__ import annotations

from .arm import H, PlantedArm, Row

PUMA = PlantedArm(
    "puma, Craig",
    "modified",
    (
        Row("R", "", 0, ""),
        Row("R", "", -H, ""),
        Row("R", "a2", 0, "d3"),
        Row("R", "a3", -H, "d4"),
        Row("R", "", H, ""),
        Row("R", "", -H, ""),
    ),
    {"a2": 0.4318, "d3": 0.1245, "a3": 0.0203, "d4": 0.4331},
    {
        "px": "c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1",
        "py": "s1*(a2*c2 + a3*c23 - d4*s23) + d3*c1",
        "pz": "-a3*s23 - a2*s2 - d4*c23",
        "r31": "-s23*(c4*c5*c6 - s4*s6) - c23*s5*c6",
        "r33": "s23*c4*s5 - c23*c5",
        "r13": "-c1*(c23*c4*s5 + s23*c5) - s1*s4*s5",
    },
    (
        (1, "atan2(py, px) - atan2(d3, pm(sqrt(px**2 + py**2 - d3**2)))"),
        (
            3,
            "atan2(a3, d4) - atan2((px**2 + py**2 + pz**2 - a2**2 - a3**2 - d3**2 - d4**2)/(2*a2),"
            " pm(sqrt(a3**2 + d4**2 - ((px**2 + py**2 + pz**2 - a2**2 - a3**2 - d3**2 - d4**2)/(2*a2))**2)))",
        ),
        (
            2,
            "atan2((-a3 - a2*c3)*pz - (c1*px + s1*py)*(d4 - a2*s3), (a2*s3 - d4)*pz + (a3 + a2*c3)*(c1*px + s1*py)) - theta3",
        ),
        (
            5,
            "atan2(-r13*(c1*c23*c4 + s1*s4) - r23*(s1*c23*c4 - c1*s4) + r33*s23*c4, -r13*c1*s23 - r23*s1*s23 - r33*c23)",
        ),
        (
            6,
            "atan2(-r11*(c1*c23*s4 - s1*c4) - r21*(s1*c23*s4 + c1*c4) + r31*s23*s4,"
            " r11*((c1*c23*c4 + s1*s4)*c5 - c1*s23*s5) + r21*((s1*c23*c4 - c1*s4)*c5 - s1*s23*s5) - r31*(s23*c4*c5 + c23*s5))",
        ),
    ),
    "pose",
)
DENSO = PlantedArm(
    "six joints, standard",
    "standard",
    (
        Row("R", "", H, "d1"),
        Row("R", "a2", 0, ""),
        Row("R", "a3", -H, ""),
        Row("R", "", H, "d4"),
        Row("R", "", -H, ""),
        Row("R", "", 0, "d6"),
    ),
    {"d1": 0.125, "a2": 0.21, "a3": 0.075, "d4": 0.22, "d6": 0.07},
    {
        "r33": "c23*c5 - s23*c4*s5",
        "pz": "d1 + a2*s2 + a3*s23 + d4*c23 + d6*(c23*c5 - s23*c4*s5)",
        "px": "c1*(a2*c2 + a3*c23 - d4*s23) + d6*(s1*s4*s5 - c1*(s23*c5 + c23*c4*s5))",
    },
    (
        (5, "pm(acos(c23*r33 - s23*(c1*r13 + s1*r23)))"),
        (4, "atan2(sign(s5)*(s1*r13 - c1*r23), -sign(s5)*(c23*(c1*r13 + s1*r23) + s23*r33))"),
        (2, "atan2(pz - d6*r33 - d1, c1*(px - d6*r13) + s1*(py - d6*r23)) - atan2(a3*s3 + d4*c3, a2 + a3*c3 - d4*s3)"),
    ),
    "pose",
)
STANFORD = PlantedArm(
    "Stanford's arm",
    "standard",
    (
        Row("R", "", -H, ""),
        Row("R", "", H, "d2"),
        Row("P", "", 0, ""),
        Row("R", "", -H, ""),
        Row("R", "", H, ""),
        Row("R", "", 0, "d6"),
    ),
    {"d2": 0.154, "d6": 0.26},
    {
        "px": "b3*c1*s2 - d2*s1 + d6*(c1*(c2*c4*s5 + s2*c5) - s1*s4*s5)",
        "py": "b3*s1*s2 + d2*c1 + d6*(s1*(c2*c4*s5 + s2*c5) + c1*s4*s5)",
        "pz": "b3*c2 + d6*(c2*c5 - s2*c4*s5)",
        "r33": "c2*c5 - s2*c4*s5",
        "r31": "-s2*(c4*c5*c6 - s4*s6) - c2*s5*c6",
    },
    (
        (1, "atan2(py - d6*r23, px - d6*r13) - atan2(d2, pm(sqrt((px - d6*r13)**2 + (py - d6*r23)**2 - d2**2)))"),
        (3, "s2*(c1*(px - d6*r13) + s1*(py - d6*r23)) + c2*(pz - d6*r33)"),
        (4, "atan2(sign(s5)*(c1*r23 - s1*r13), sign(s5)*(c2*(c1*r13 + s1*r23) - s2*r33))"),
    ),
    "pose",
)
UR = PlantedArm(
    "three parallel axes",
    "standard",
    (
        Row("R", "", H, "d1"),
        Row("R", "-a2", 0, ""),
        Row("R", "-a3", 0, ""),
        Row("R", "", H, "d4"),
        Row("R", "", -H, "d5"),
        Row("R", "", 0, "d6"),
    ),
    {"d1": 0.0892, "a2": 0.425, "a3": 0.3922, "d4": 0.1092, "d5": 0.0947, "d6": 0.0823},
    {
        "r33": "-s234*s5",
        "pz": "d1 - a2*s2 - a3*s23 - d5*c234 - d6*s234*s5",
        "px": "d4*s1 + d6*(c5*s1 - c1*c234*s5) - c1*(a2*c2 + a3*c23 - d5*s234)",
        "r13": "s1*c5 - c1*c234*s5",
    },
    (
        (5, "pm(acos((px*s1 - py*c1 - d4)/d6))"),
        (6, "atan2(sign(s5)*(c1*r22 - s1*r12), sign(s5)*(s1*r11 - c1*r21))"),
        (1, "atan2(py - d6*r23, px - d6*r13) + pi/2 + pm(acos(d4/sqrt((px - d6*r13)**2 + (py - d6*r23)**2)))"),
    ),
    "pose",
)
KUKA = PlantedArm(
    "offset shoulder, standard",
    "standard",
    (
        Row("R", "a1", -H, "d1"),
        Row("R", "a2", 0, ""),
        Row("R", "a3", -H, ""),
        Row("R", "", H, "d4"),
        Row("R", "", -H, ""),
        Row("R", "", 0, "d6"),
    ),
    {"a1": 0.025, "d1": 0.4, "a2": 0.455, "a3": 0.035, "d4": 0.42, "d6": 0.08},
    {
        "r33": "-c23*c5 + s23*c4*s5",
        "pz": "d1 - a2*s2 - a3*s23 - d4*c23 + d6*(s23*c4*s5 - c23*c5)",
    },
    (
        (
            2,
            "atan2(d1 - (pz - d6*r33), c1*(px - d6*r13) + s1*(py - d6*r23) - a1) - atan2(a3*s3 + d4*c3, a2 + a3*c3 - d4*s3)",
        ),
        (5, "pm(acos(-s23*(c1*r13 + s1*r23) - c23*r33))"),
    ),
    "pose",
)
YASKAWA = PlantedArm(
    "offset elbow, Craig",
    "modified",
    (
        Row("R", "", 0, "d1"),
        Row("R", "a1", -H, "", -H),
        Row("R", "a2", 0, ""),
        Row("R", "a3", -H, "d4"),
        Row("R", "", H, ""),
        Row("R", "", -H, "d6"),
    ),
    {"d1": 0.33, "a1": 0.04, "a2": 0.445, "a3": 0.04, "d4": 0.44, "d6": 0.08},
    {
        "pz": "d1 + a2*c2 + a3*c23 - d4*s23 - d6*(s23*c5 + c23*c4*s5)",
        "r33": "-s23*c5 - c23*c4*s5",
    },
    ((5, "pm(acos(c23*(c1*r13 + s1*r23) - s23*r33))"),),
    "pose",
)
