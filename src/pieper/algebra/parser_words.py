"""The words of the formula language: how signs may be spelled, what a token is, what functions are called."""

from __future__ import annotations

import re

FUNCTIONS = {  # name: how many values it takes
    **dict.fromkeys(("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "sign", "abs"), 1),
    **dict.fromkeys(("atan2", "hypot"), 2),
}
SPELLING = {
    "\u00b1": "+-",
    "\u2213": "-+",
    "\u2212": "-",
    "\u2013": "-",
    "\u00b7": "*",
    "\u00d7": "*",
    "\u03c0": " pi ",
    "\u221a": " sqrt ",
    "\u00b0": " deg ",
    "\u00b2": "^2",
    "\u03b8": "theta",
    "\u03c6": "phi",
    "\u03b3": "gamma",
    "\u03b2": "beta",
    "\u03b1": "alpha",
    "\u2032": "'",
}
TOKEN = re.compile(
    r"(?P<space>\s+)|(?P<num>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+(?![A-Za-z\d]))?)"
    r"|(?P<trig>[cCsS](?:_?q_?\d)+(?![A-Za-z\d]))|(?P<name>[A-Za-z]+(?:_?\{[A-Za-z\d]+\}|(?:_?\d+)|_[A-Za-z]+\d*)?'*)"
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
    "cosine": "cos",
    "sine": "sin",
}
INVERSE = {"sin": "asin", "cos": "acos", "tan": "atan"}
JOINT_NAME = re.compile(r"(?:theta|th|q|t)(\d+)$")
TRIG_NAME = re.compile(r"([cCsS])((?:q?\d)+)$")
