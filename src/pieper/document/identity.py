"""One identity for the workbench, reports, figures and the site: colours, type, wordmark and icon, out of one file."""

from __future__ import annotations

import base64
import json
import re
from functools import cache
from pathlib import Path
from typing import Any, Literal

_HERE = Path(__file__).parent
#: The icon of pages and tabs.
ICON = _HERE / "icon.svg"
#: The file that all of it stands in; the workbench's page is built from it too.
SOURCE = _HERE / "identity.json"


@cache
def identity() -> dict[str, Any]:
    """Return what the file says."""
    return json.loads(SOURCE.read_text(encoding="utf-8"))


def colour(name: str, theme: Literal["light", "dark"] = "light") -> str:
    """Return a colour by its name, as #rrggbb."""
    return identity()[theme]["colours"][name]


def curves(theme: Literal["light", "dark"] = "light") -> tuple[str, ...]:
    """Return the colours of curves, which the colour-blind can tell apart (after Okabe and Ito, 2008)."""
    return tuple(identity()[theme]["curves"])


def axes() -> tuple[str, str, str]:
    """Return the colours of the x, y and z axes of a frame."""
    x, y, z = identity()["axes"]
    return x, y, z


def custom_properties(theme: Literal["light", "dark"] = "light") -> str:
    """Return colours and type as custom properties of CSS: --accent-ink, --sans and so on."""
    named = {**identity()[theme]["colours"], **identity()["type"]}
    return " ".join(f"--{re.sub('[A-Z]', lambda m: '-' + m.group().lower(), k)}: {v};" for k, v in named.items())


def both_themes() -> str:
    """Return the custom properties of both themes as rules of CSS, of which the reader's screen chooses."""
    return (
        f":root {{ color-scheme: light dark; {custom_properties()} }}\n"
        f"  @media (prefers-color-scheme: dark) {{ :root {{ {custom_properties('dark')} }} }}"
    )


def icon_address() -> str:
    """Return the icon as an address that needs no file beside the page."""
    return "data:image/svg+xml;base64," + base64.b64encode(ICON.read_bytes()).decode("ascii")
