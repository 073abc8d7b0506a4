"""Of the careful closed forms (lengths of the arm; rad)."""

#: Forward kinematics misses the pose by no more where a candidate is a solution.
CLOSED_VERIFIED = 1e-12
#: A candidate that misses by less than this makes a pose without solutions uncertain.
CLOSED_NEAR_MISS = 1e-9
#: Candidates that miss by more before polishing belong to a wrong branch.
CLOSED_HOPELESS = 2e-2
#: Joint values beyond this (rad; lengths of the arm) are no candidate.
CLOSED_ENDLESS = 1e6
#: Solutions closer than this are one.
CLOSED_SAME = 3e-8
#: In a flat valley two candidates up to this far apart are one answer.
CLOSED_VALLEY = 0.05
#: Smallest over largest singular value of the scaled Jacobian under which a row is looked at closely.
CLOSED_SINGULAR = 2.5e-7
#: Polishing ends here: the rounding of forward kinematics.
CLOSED_POLISHED = 4e-15
#: A step that halves no more and has come below this was the last one.
CLOSED_STALLED = 1e-14
#: Where a step does not help and less than this is missed, polishing ends.
CLOSED_GOOD_ENOUGH = 5e-14
#: Least damping of a step, of the trace of J^T J: a little above rounding it keeps singular poses finite.
CLOSED_DAMPING = 1e-15
#: Longest step of a joint in polishing (rad; lengths): a tenth of a turn is still the same branch.
CLOSED_LONGEST_STEP = 0.3
#: Damping of the steps along a null direction, where what is left is well conditioned.
ALONE_DAMPING = 1e-16
#: A correction along a null direction has settled when its step is below this.
ALONE_SETTLED = 1e-13
#: Twins at least this far apart are two solutions.
ALONE_TWINS = 1.2e-7
#: Between twins the pose must be missed by more than this: a ridge that rounding cannot hide.
ALONE_RIDGE = 1.2e-13
#: A pose missed by more along a null direction is not held; twice ON_CURVE: what is cleared cannot be traced.
ALONE_HELD = 4e-13
#: Smallest relative singular value that a row may have to stand alone.
ALONE_SIGMA = 1e-14
#: The second smallest one must be at least this: more than one null direction is beyond this look.
ALONE_SECOND = 3e-4
#: Step ahead and behind along a null direction that tells a line from a fold (rad; lengths).
ALONE_STEP = 1e-2
#: A second look farther along where the first was held.
ALONE_FARTHER = 0.3
#: Curvature of a fold, relative, below which its twin is not believed.
ALONE_BENT = 1e-6
#: Damping falls to this part of itself where a step helps,
CLOSED_DAMPING_FALLS = 1e-2
#: and grows by this where it does not.
CLOSED_DAMPING_GROWS = 1e3
