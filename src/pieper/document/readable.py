"""What can be read: an object with a page, which prints itself in every notation."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

from pieper.document import html, json, latex, markdown, text
from pieper.document.blocks import Document


class Readable(ABC):
    """An object whose page says what it is."""

    @property
    @abstractmethod
    def page(self) -> Document:
        """Sentences and formulas in reading order."""

    def text(self) -> str:
        """Return the page as plain text."""
        return text.fragment(self.page)

    def latex(self) -> str:
        """Return the page as the inside of a LaTeX document (amsmath)."""
        return latex.fragment(self.page)

    def mathml(self) -> str:
        """Return the page as HTML elements with MathML, nothing fetched and no script."""
        return html.fragment(self.page)

    def markdown(self) -> str:
        """Return the page as Markdown."""
        return markdown.fragment(self.page)

    def json(self) -> dict[str, Any]:
        """Return the page as plain data, one dict a block."""
        return json.fragment(self.page)
