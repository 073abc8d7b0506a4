"""Of what is followed with proof along a path (rad; lengths of the arm)."""

#: What may be left of a pose at a point,
FRONT_LEFT = 1e-9
#: the largest pseudo-inverse of the Jacobian that is trusted with it,
FRONT_LOOSE = 500.0
#: and how far off its curve a point may be by both; what is reached is widened by it.
FRONT_OFF = 1e-6
#: What is claimed is taken so much smaller than shown: far above rounding.
FRONT_SAFE = 1 - 1e-6
#: Rounding of a step's size.
FRONT_ROUNDING = 1e-12
#: A pivot of the Jacobian times its transpose below this has lost its grip.
FRONT_PIVOT = 1e-20
#: A smaller step along the path than this is none,
FRONT_SHORTEST = 1e-7
#: nor is one along a curve below this.
FRONT_STILL = 1e-9
#: A search for the largest singular value is kept above zero by this.
FRONT_ABOVE_ZERO = 1e-3
