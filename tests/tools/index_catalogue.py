"""Write the index of the catalogue anew from its files: python -m tests.tools.index_catalogue."""

from __future__ import annotations

from pathlib import Path

from pieper.description import catalog, catalog_index


def main() -> None:
    """Write the index."""
    text = catalog_index.text_of([catalog.load(name) for name in catalog.names()])
    Path(catalog_index.FILE).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
