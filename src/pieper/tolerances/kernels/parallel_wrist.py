"""Of the spherical wrist behind parallel axes (relative to its scale; rad)."""

#: Closer: one representative stands for the self-motion.
SWP_ON_SINGULARITY = 1e-13
#: Closer: flagged, so that the careful look takes place.
SWP_NEAR_SINGULARITY = 1e-7
#: A distance from the edge of reach that is nothing but rounding.
SWP_ROUNDING = 8 * 2.2e-16
#: Half the angle between two roots below which they are flagged.
SWP_NEAR_DOUBLE = 1e-6
#: A reach exceeded by no more than this is the edge of reach.
SWP_OVERSHOOT = 5e-13
#: A reach exceeded by more than this is exceeded by every pose beside: a hundred times what the careful look
#: steps aside.
SWP_BEYOND = 1e-7
#: Squared sine of joint 3 below which cancellation is avoided.
SWP_EDGE_OF_ELBOW = 1e-3
#: Forward kinematics must return the pose this closely.
SWP_VERIFIED = 1e-11
