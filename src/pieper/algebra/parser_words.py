"""The words of the formula language: how signs may be spelled, what a token is, what functions are called."""

from __future__ import annotations

import re

FUNCTIONS = {  # name: how many values it takes
    **dict.fromkeys(("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "sign", "abs"), 1),
    **dict.fromkeys(("atan2", "hypot"), 2),
}
DEGREES = {"sind", "cosd", "tand", "asind", "acosd", "atand", "atan2d"}  # MATLAB's functions of degrees
TOKEN = re.compile(
    r"(?P<space>\s+)|(?P<num>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+(?![A-Za-z\d]))?)"
    r"|(?P<trig>[cCsS](?:_?q_?\d)+(?![A-Za-z\d]))|(?P<name>atan2d(?=\s*\()|[A-Za-z]+(?:_?\{[A-Za-z\d]+\}|(?:_?\d+)|_[A-Za-z]+\d*)?'*)"
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
}
INVERSE = {"sin": "asin", "cos": "acos", "tan": "atan"}
JOINT_NAME = re.compile(r"(?:theta|th|q|t)(\d+)$")
TRIG_NAME = re.compile(r"([cCsS])((?:q?\d)+)$")
