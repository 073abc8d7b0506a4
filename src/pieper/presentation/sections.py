"""What a page of one's own is made of: a document, its blocks, sections about an arm, and the file at the end."""

from __future__ import annotations

from pathlib import Path

from pieper.document.blocks import Code, Document, Heading, Picture
from pieper.document.html_page import page as html_page
from pieper.document.writing import write_whole
from pieper.presentation.sections_arm import (
    MM,
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
from pieper.presentation.style import png

__all__ = [
    "MM",
    "Code",
    "Document",
    "Heading",
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
    "attempt",
    "fixed",
    "joint_value",
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
    written = [write_whole(folder / f"{picture.name}.png", png(picture.figure)) for picture in pictures]
    return written + [write_whole(folder / f"{picture.name}.svg", picture.svg) for picture in pictures]
