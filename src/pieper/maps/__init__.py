"""Maps: a space filled with answers, tile by tile, on one machine or many."""
