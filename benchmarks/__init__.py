"""Measurements: `measure` takes them, `results` keeps them, `pages` writes what people read from them."""
