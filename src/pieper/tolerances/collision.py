"""Of collision in Python (m)."""

#: How near to the margin a distance may stay undecided in a look at a whole path, m, where nothing else is said.
CLEARANCE_GAP = 1e-6
#: What coal is told to stop at, m, and how far off what it says is taken to be: ten times what was seen of hulls.
HULL_STEP, HULL_ROUNDING = 1e-10, 1e-8
#: What is returned where there is nothing to keep apart from, m: farther than anything.
NOTHING_NEAR = 1e9
#: Bodies are guessed for arms of no less than this, m.
SHORTEST_ARM = 1e-3
