"""The directive `drawn`: a page's code is run while the site is built, and the figure that it leaves is shown under it.

    ```{drawn} name-of-the-picture
    figure = pieper.plot.arm_figure(arm, q)
    ```

The Python blocks that stand above it on the page are run first, each page in a folder of its own.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import tempfile
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

BLOCK = re.compile(r"^```(python|\{drawn\} ([\w-]+))\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def figures(page: Path) -> dict[str, Any]:
    """Run a page from top to bottom and return its figures by name."""
    names: dict[str, Any] = {}
    found: dict[str, Any] = {}
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for block in BLOCK.finditer(page.read_text(encoding="utf-8")):
                with contextlib.redirect_stdout(io.StringIO()):
                    exec(compile(block[3], str(page), "exec"), names)
                if block[2]:
                    found[block[2]] = names["figure"]
        finally:
            os.chdir(before)
    return found


class Drawn(SphinxDirective):
    """Shows the code, and under it the picture."""

    has_content = True
    required_arguments = 1
    pages: ClassVar[dict[str, dict[str, Any]]] = {}

    def run(self) -> list[nodes.Node]:
        """Return the code and the picture."""
        import pieper

        page, name = str(self.env.doc2path(self.env.docname)), self.arguments[0]
        if page not in self.pages:
            self.pages[page] = figures(Path(page))
        folder = Path(self.env.app.outdir) / "_images"
        folder.mkdir(parents=True, exist_ok=True)
        pieper.plot.save_figure(self.pages[page][name], folder / f"{name}.svg")
        depth = self.env.docname.count("/")
        place = f"{'../' * depth}_images/{name}.svg"
        shown = nodes.raw("", f'<img class="drawn" src="{place}" alt="{name}">', format="html")
        code = "\n".join(self.content)
        return [nodes.literal_block(code, code, language="python"), shown]


def setup(app: Sphinx) -> dict[str, Any]:
    """Add the directive."""
    app.add_directive("drawn", Drawn)
    return {"parallel_read_safe": False}
