"""The words of the formula language: how signs may be spelled, what a token is, what functions are called."""

from __future__ import annotations

import re

from pieper.algebra.expression import Call, Div, Expr, Mul, PiFraction, Power
from pieper.algebra.formula import number

FUNCTIONS = {  # name: how many values it takes
    **dict.fromkeys(("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "sign", "abs"), 1),
    **dict.fromkeys(("atan2", "hypot", "mod", "fmod", "pow"), 2),
    **dict.fromkeys(("deg2rad", "rad2deg", "wrap"), 1),
}
DEGREES = {"sind", "cosd", "tand", "asind", "acosd", "atand", "atan2d"}  # MATLAB's functions of degrees
TOKEN = re.compile(
    r"(?P<space>\s+)|(?P<num>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+(?![A-Za-z\d]))?)"
    r"|(?P<trig>[cCsS](?:_?q_?\d)+(?![A-Za-z\d]))|(?P<name>(?:atan2d|deg2rad|rad2deg|wrap[Tt]o[Pp]i)(?=\s*\()|[A-Za-z]+(?:_?\{[A-Za-z\d]+\}|(?:_?\d+)|_[A-Za-z]+\d*)?'*)"
    r"|(?P<pm>\+/?-|-/?\+)|(?P<op>\*\*|[-+*/^()\[\]{},=])"
)
FUNCTION_NAMES = {
    **{f: f for f in FUNCTIONS},
    "arctan": "atan",
    "arctan2": "atan2",
    "arcsin": "asin",
    "arccos": "acos",
    "arctg": "atan",
    "sgn": "sign",
    "absolute": "abs",
    "fabs": "abs",
    "arctand": "atand",
    "arccosd": "acosd",
    "arcsind": "asind",
    "cosine": "cos",
    "sine": "sin",
    "power": "pow",
    "rem": "fmod",
    "wraptopi": "wrap",
    "wrap2pi": "wrap",
    "radians": "deg2rad",
    "degrees": "rad2deg",
}
INVERSE = {"sin": "asin", "cos": "acos", "tan": "atan"}
JOINT_NAME = re.compile(r"(?:theta|th|q|t)(\d+)$")
TRIG_NAME = re.compile(r"([cCsS])((?:q?\d)+)$")


def called(name: str, args: list[Expr]) -> Expr:
    """A function of some values as an expression; what programs call a power or degrees is written with operations."""
    degree = Div(PiFraction(1), number(180))
    if name == "pow":
        return Power(*args)
    if name == "deg2rad":
        return Mul.of(*args, degree)
    if name == "rad2deg":
        return Div(args[0], degree)
    if name == "wrap":
        return Call("atan2", Call("sin", args[0]), Call("cos", args[0]))
    return Call(name, *args)
