"""Names of the symbols that a claims file defines: how they are spelled, and which must be read first."""

from __future__ import annotations

import re
from collections.abc import Mapping


def in_order(symbols: Mapping[str, str]) -> dict[str, str]:
    """Symbols so that each stands after those it uses; what goes in circles stays where it is."""
    uses = {
        name: set(re.findall(r"[A-Za-z]\w*'*", plain(body))) & set(symbols) - {name} for name, body in symbols.items()
    }
    out: dict[str, str] = {}
    while len(out) < len(symbols):
        ready = [name for name in symbols if name not in out and uses[name] <= set(out)]
        out.update({name: symbols[name] for name in ready[:1] or [n for n in symbols if n not in out][:1]})
    return out


def plain(name: str) -> str:
    """Return a symbol's name as formulas hold it, without the marks of subscripts."""
    return name.translate(str.maketrans("", "", "_{}"))
