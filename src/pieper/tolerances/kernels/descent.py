"""Of the descent to the nearest posture (relative to the largest eigenvalue; rad; lengths of the arm)."""

#: Damping at first,
DESCENT_DAMPING = 1e-3
#: at least,
DESCENT_LEAST_DAMPING = 1e-14
#: and at most: there a row rests.
DESCENT_MOST_DAMPING = 1e4
#: its factors where a step helped,
DESCENT_SHRINK = 0.1
#: and where not.
DESCENT_GROW = 8.0
#: Longest step (rad; lengths).
DESCENT_LONGEST = 0.8
#: A shorter step is none.
DESCENT_SETTLED = 1e-9
#: Eigenvalues are kept above this part of the largest.
DESCENT_FLAT = 1e-13
#: Part of a symmetric matrix off its diagonal, squared, below which Jacobi's rotations have found its eigenvalues well
#: enough for a step: where they matter to the last digit, at a minimum, none is below zero and none is asked for.
JACOBI_DONE = 1e-9
