"""What a page of one's own is made of: a document, its blocks, sections about an arm, and the file at the end."""

from __future__ import annotations

from pathlib import Path

from pieper.document.blocks import Code, Document, Emphasis, Heading, Listing, Paragraph, Picture
from pieper.document.formulas import in_line
from pieper.document.html import page as html_page
from pieper.document.json import blocks as as_data
from pieper.document.writing import write_whole
from pieper.drawing.style import MM, picture
from pieper.presentation.sections_arm import (
    add_arm,
    add_derivation,
    add_forward,
    add_plan,
    add_reach,
    add_singularities,
    attempt,
    fixed,
    joint_value,
)
from pieper.presentation.sections_motion import add_motion, add_solutions, add_track, scientific

__all__ = [
    "MM",
    "Code",
    "Document",
    "Emphasis",
    "Heading",
    "Listing",
    "Paragraph",
    "Picture",
    "add_arm",
    "add_derivation",
    "add_forward",
    "add_motion",
    "add_plan",
    "add_reach",
    "add_singularities",
    "add_solutions",
    "add_track",
    "as_data",
    "attempt",
    "fixed",
    "in_line",
    "joint_value",
    "picture",
    "scientific",
    "write_figures",
    "write_page",
]


def write_page(page: Document, out: Path) -> Path:
    """Write a document as one HTML file, whole or not at all, and return its place."""
    return write_whole(out, html_page(page))


def write_figures(page: Document, folder: Path) -> list[Path]:
    """Write every figure of a document as .png and .svg into a folder, made when missing; return the files."""
    folder.mkdir(exist_ok=True)
    pictures = [block for block in page.blocks if isinstance(block, Picture)]
    written = [write_whole(folder / f"{one.name}.png", one.drawing.png()) for one in pictures]
    return written + [write_whole(folder / f"{one.name}.svg", one.drawing.svg()) for one in pictures]
