"""Of the command line and the workbench: what is remarked upon, and what numbers may be typed."""

#: A position this small (m) in millimetres was probably meant in metres.
SUSPICIOUSLY_SMALL = 2.5e-3
#: A posture of the study is one of its solutions when it is this near, rad.
STUDY_SAME = 1e-6
#: Samples a second, at least.
SLOWEST_RATE = 1e-3
#: What the page sends is no number of an arm beyond this (m; rad).
LARGEST_NUMBER = 1e7
#: A move whose joints or pose differ by less from where the arm is (rad, m) is none.
NO_MOVE = 1e-9
#: By how much (m, rad) a spline that stands for a route may leave it.
ROUTE_STRAYS_M, ROUTE_STRAYS_RAD = 2e-4, 2e-3
