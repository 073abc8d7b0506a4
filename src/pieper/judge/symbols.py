"""Names of the symbols that a claims file defines: how they are spelled, and which must be read first."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

import numpy as np

from pieper.algebra.expression import Call, Expr, Mul
from pieper.algebra.parser import parse
from pieper.algebra.parser_words import FUNCTION_NAMES, FUNCTIONS
from pieper.errors import InputError
from pieper.kinematics.arrays import Array
from pieper.tolerances import JUDGED_HOLDS


def in_order(symbols: Mapping[str, str], outside: Collection[str] = ()) -> dict[str, str]:
    """Symbols so that each stands after those it uses.

    Args:
        symbols: Name and formula of each.
        outside: Names that mean something outside, which a formula may use for what is defined here under them.

    Raises:
        InputError: Symbols are defined by themselves.
    """
    uses = {
        name: set(re.findall(r"[A-Za-z]\w*'*", plain(body))) & set(symbols) - ({name} & set(outside))
        for name, body in symbols.items()
    }
    out: dict[str, str] = {}
    while len(out) < len(symbols):
        ready = [name for name in symbols if name not in out and uses[name] <= set(out)]
        if not ready:
            circle = _circle({name: uses[name] - set(out) for name in symbols if name not in out})
            said = ", ".join(f"{name} = {symbols[name]}" for name in circle)
            raise InputError(f"{circle[0]}: defined by itself: {said}", symbol=circle[0])
        out[ready[0]] = symbols[ready[0]]
    return out


def _circle(uses: Mapping[str, set[str]]) -> list[str]:
    """Names of which each uses the next and the last the first; every one uses some other."""
    way = [next(iter(uses))]
    while True:
        following = min(uses[way[-1]])
        if following in way:
            return way[way.index(following) :]
        way.append(following)


def refuse(name: str, joints: int, letters: Collection[str] = ()) -> Expr | None:
    """Refuse a name that means something in every formula about an arm.

    Args:
        name: The name, without marks.
        joints: How many joints the arm has.
        letters: Its lengths and the letters of its pose.

    Returns:
        The sine or cosine that the name is, for a page that finds s5 goes on with what it found; None for other names.

    Raises:
        InputError: A function, a joint, a unit or a letter of the arm is called so.
    """
    meaning = "a letter of this arm" if name in letters else ""
    node = None
    if name.lower() in FUNCTION_NAMES or name.lower() in FUNCTIONS:
        meaning = "a function"
    else:
        try:
            node = parse(name, (), joints)
        except InputError:
            node = None
    if node is not None and not isinstance(node, (Call, Mul)):  # c1s2 is a product where nobody says what else
        meaning = "a joint's angle" if node.symbols() else "a number or a unit"
    if meaning:
        told = f"the symbol {name!r} already means something: {meaning}; choose another name"
        raise InputError(told, symbol=name)
    return node if isinstance(node, Call) else None


def refuse_another(name: str, node: Expr, given: Array, right: Array) -> None:
    """Refuse a sine or cosine that is defined by joints to be another one; its sign is that of a branch.

    Args:
        name: What it is called.
        node: Its definition.
        given: The definition's values, (K,).
        right: Those of the sine or cosine, (K,).
    """
    if not np.allclose(np.abs(given), np.abs(right), rtol=0, atol=JUDGED_HOLDS):
        raise InputError(
            f"the symbol {name!r} already means something: the {'cosine' if name[0] in 'cC' else 'sine'} of joints, "
            f"and {node} is another thing; write it as a claim, or choose another name",
            symbol=name,
        )


def plain(name: str) -> str:
    """Return a symbol's name as formulas hold it, without the marks of subscripts."""
    return name.translate(str.maketrans("", "", "_{}"))
