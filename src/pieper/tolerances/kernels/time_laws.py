"""Of the fastest motion along a path."""

#: Relative rounding of a set's ends.
SET_ROUNDING = 1e-12
#: Part of its room that a row's acceleration may move and still count as rounding.
ROW_FLAT = 1e-12
#: The square of the path's speed where nothing bounds it.
FASTEST = 1e18
