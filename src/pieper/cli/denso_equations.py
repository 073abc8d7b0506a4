"""The forward equations that the Denso study prints, in its own notation, as claims for the judge.

Source: M. E. Kutuk, M. T. Das, L. C. Dulger, Forward and Inverse Kinematics Analysis of Denso Robot, Eq. (5) to (7).
"""

from __future__ import annotations

#: Entry -> (number of the equation, formula as printed). C1 is cos(theta1), S2 is sin(theta2).
PRINTED = {
    "nx": (
        "5",
        "-S6(C4S1 + S4(C1C2C3 - C1S2S3)) - C6(C5(S1S4 - C4(C1C2C3 - C1S2S3)) + S5(C1C2S3 + C1C3S2))",
    ),
    "ny": (
        "5",
        "S6(C1C4 + S4(S1S2S3 - C2C3S1)) + C6(C5(C1S4 - C4(S1S2S3 - C2C3S1)) - S5(C2S1S3 + C3S1S2))",
    ),
    "nz": ("5", "C6(S5(C2C3 - S2S3) + C4C5(C2S3 + C3S2)) - S4S6(C2S3 + C3S2)"),
    "ox": (
        "6",
        "S6(C5(S1S4 - C4(C1C2C3 - C1S2S3)) + S5(C1C2S3 + C1C3S2)) - C6(C4S1 + S4(C1C2C3 - C1S2S3))",
    ),
    "oy": (
        "6",
        "C6(C1C4 + S4(S1S2S3 - C2C3S1)) - S6(C5(C1S4 - C4(S1S2S3 - C2C3S1)) - S5(C2S1S3 + C3S1S2))",
    ),
    "oz": ("6", "-S6(S5(C2C3 - S2S3) + C4C5(C2S3 + C3S2)) - C6S4(C2S3 + C3S2)"),
    "ax": ("7", "S5(S1S4 - C4(C1C2C3 - C1S2S3)) - C5(C1C2S3 + C1C3S2)"),
    "ay": ("7", "-S5(C1S4 - C4(S1S2S3 - C2C3S1)) - C5(C2S1S3 + C3S1S2)"),
    "az": ("7", "C5(C2C3 - S2S3) - C4S5(C2S3 + C3S2)"),
    "Px": (
        "7",
        "d6(S5(S1S4 - C4(C1C2C3 - C1S2S3)) - C5(C1C2S3 + C1C3S2)) - d4(C1C2S3 + C1C3S2) + a2C1C2 + a3C1C3 - a3C1S2S3",
    ),
    "Py": (
        "7",
        "a2C2S1 - d6(S5(C1S4 - C4(S1S2S3 - C2C3S1)) + C5(C2S1S3 + C3S1S2)) - d4(C2S1S3 + C3S1S2) + a3C2C3S1 - a3S1S2S3",
    ),
    "Pz": (
        "7",
        "d1 + d4(C2C3 - S2S3) + d6(C5(C2C3 - S2S3) - C4S5(C2S3 + C3S2)) + a2S2 + a3C2S3 + a3C3S2",
    ),
}
#: The one entry that is wrong, and the term that lost a factor.
LOST = {"entry": "Px", "printed": "a3C1C3", "right": "a3C1C2C3"}

_ARM = """
title = "Denso VP-6242: the forward equations as printed"
[arm]
name = "Denso VP-6242, Table 1"
convention = "standard"
length_unit = "m"
columns = ["theta", "d", "a", "alpha"]
rows = [
  ["q1", "d1", 0, "pi/2"], ["q2", 0, "a2", 0], ["q3", 0, "a3", "-pi/2"],
  ["q4", "d4", 0, "pi/2"], ["q5", 0, 0, "-pi/2"], ["q6", "d6", 0, 0],
]
values = { d1 = 0.125, a2 = 0.21, a3 = -0.075, d4 = 0.21, d6 = 0.07 }
"""


def claims() -> str:
    """Return a claims file (TOML) with the twelve entries as printed, and P_x once more with its C2 restored."""
    formulas = [(entry, entry, formula) for entry, (_, formula) in PRINTED.items()]
    mended = PRINTED[LOST["entry"]][1].replace(LOST["printed"] + " ", LOST["right"] + " ")
    formulas.append((f"{LOST['entry']} mended", LOST["entry"], mended))
    body = "".join(
        f'\n[[claim]]\nid = "{name}"\nkind = "entry"\nof = "{entry}"\nis = "{formula}"\n'
        for name, entry, formula in formulas
    )
    return _ARM + body
