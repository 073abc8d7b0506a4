"""The site: `make docs`. Pages are Markdown; pictures are drawn while it is built, by the code on the page."""

from __future__ import annotations

import os
import sys
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")
HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))

import pieper  # noqa: E402
from pieper.document import identity  # noqa: E402

project = "pieper"
author = "the authors of pieper"
html_show_copyright = False
version = release = pieper.__version__
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "drawn"]
exclude_patterns = ["**/README.md"]
html_theme = "furo"
html_title = f"pieper {release}"
html_static_path: list[str] = []
# colours, letters and icon are those of the workbench and of reports
html_favicon = html_logo = str(identity.ICON)
html_theme_options = {
    f"{theme}_css_variables": {
        "color-brand-primary": identity.colour("accentInk", theme),
        "color-brand-content": identity.colour("accentInk", theme),
        "font-stack": identity.identity()["type"]["sans"],
        "font-stack--monospace": identity.identity()["type"]["mono"],
    }
    for theme in ("light", "dark")
}
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
autodoc_typehints = "description"
autodoc_member_order = "bysource"
napoleon_google_docstring, napoleon_numpy_docstring = True, False
napoleon_use_rtype, napoleon_use_ivar = False, True
# shapes in docstrings, such as (n,), are no names
suppress_warnings = ["ref.python"]
# what is no language of its own on these pages is shown as it is
highlight_language = "none"
nitpicky = False
