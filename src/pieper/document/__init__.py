"""A page as data, and its renderers."""
