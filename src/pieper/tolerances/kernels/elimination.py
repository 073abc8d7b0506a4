"""Of the elimination for any six joints (scaled lengths; rad)."""

#: What polishing must leave of the miss: 1e-15 unless singular.
GENERAL_VERIFIED = 1e-11
#: Solutions closer than this are one;
GENERAL_SAME = 1e-7
#: near a singular pose those closer than rounding over sigma, at most this.
GENERAL_SAME_MOST = 4e-7
#: The rounding that is meant there, beside what a polished row still misses by.
GENERAL_RESOLVED = 3e-15
#: Singular values are not told apart below this.
GENERAL_LEAST_SIGMA = 1e-12
#: Imaginary part below which a complex pair is tried as a double root,
GENERAL_NEARLY_REAL = 2e-3
#: and below which it is tried again, with time.
GENERAL_TRY_AGAIN = 2e-4
#: A nearly real pair of eigenvalues belongs to a solution that lies within this many of its imaginary parts: a root of
#: several solutions splits into pairs about it.
GENERAL_SPLIT = 4.0
#: A determinant this much smaller than usual at all angles: the elimination is singular at the pose.
GENERAL_VANISHING = 1e-13
#: One this much smaller than usual marks the pose for a second look.
GENERAL_MARKED = 1e-12
#: One this much smaller is no witness that nothing is missing: two eigenvalues that coincide come as a pair whose
#: imaginary part, the root of 1e-16 over this, must stay well below what is tried as a double root.
GENERAL_TRUSTED = 1e-7
#: The same of a further elimination, asked only whether it finds more: the root is still below what is tried.
GENERAL_WITNESS = 1e-10
#: A pair of complex eigenvalues between which the determinant is this many times what rounding has left of it is one.
GENERAL_PROVEN = 1e2
#: The same where two eliminations say it independently of each other.
GENERAL_COUNTED = 1e1
#: By how much eigenvalues may fail to reproduce the determinant around the circle, of its largest: one that is off by
#: what makes a double root more than nearly real changes it by the square of that; others leave 1e-12.
GENERAL_STRAYED = 1e-7
#: Noise of an elimination, relative, below which no second opinion is asked for.
GENERAL_QUIET = 1e-13
#: An eigenvalue farther from its root than this was computed badly.
GENERAL_ACCURATE = 1e-5
#: Smallest singular value under which a solution is flagged,
GENERAL_DEGENERATE = 1e-6
#: and under which multiplicities are beyond counting.
GENERAL_UNCOUNTED = 1e-7
#: Real eigenvalues this close are one root twice,
GENERAL_ONE_ROOT = 1e-5
#: where the singular value is below this: twins of a fold stand farther apart than polishing resolves above it, and one
#: solution met from two such eigenvalues has kept another from being found.
GENERAL_MERGED = 2e-6
#: What rounding leaves of the determinant where its signs are counted, relative to the sum of its coefficients.
SIGN_NOISE = 1e-13
#: Without roots it must stay farther from zero than this part of its largest coefficient on the same sixteenth of the
#: circle: a pair of roots 2e-3 from the real line, which poses beside may bring onto it, comes nearer.
SIGN_APART = 1e-3
#: A way of elimination noisier than this on test poses is of no use.
GENERAL_NOISIEST = 1e-6
#: Noise below this is as good as none.
GENERAL_PERFECT = 1e-15
#: By how much the first nearby arm is another one; big enough that special geometry is gone,
GENERAL_NEARBY = 1e-3
#: and the second.
GENERAL_NEARBY_TOO = 3e-4
#: Two roots that such a change makes complex are no farther from the real line than a few times its root.
GENERAL_BLIND = 0.1
#: Polishing ends at this miss,
POLISH_DONE = 3e-16
#: at this one where the pose is regular,
POLISH_DONE_REGULAR = 2e-15
#: by its smallest pivot,
POLISH_REGULAR = 1e-3
#: and at this one when steps halve it no more.
POLISH_STALLED = 1e-14
#: A lane that misses by more after eight steps is lost.
POLISH_LOST = 0.05
#: Longest step of a joint.
POLISH_LONGEST_STEP = 0.4
#: Pivots are kept above this, so that a step at a singular pose stays finite,
POLISH_PIVOT = 1e-15
#: and above this when the smallest singular value is estimated.
POLISH_SIGMA_PIVOT = 1e-30
#: Pivots of a null vector are kept above this part of the largest.
NULL_PIVOT = 1e-17
#: Relative determinant above which a sliding role is solved for with its square.
SLIDE_ROLE = 1e-12
#: Determinant of three slides below which they depend on each other.
THREE_SLIDES_DEPEND = 1e-10
#: By how much their turns may fail to reach an orientation.
THREE_SLIDES_REACH = 1e-12
#: Squared sine between the outer turning axes below which they are in line.
THREE_SLIDES_IN_LINE = 1e-20
#: Squares below this are no column to reflect; larger ones can be divided by.
HOUSEHOLDER_ZERO = 1e-290
#: Pivots of the companion matrix are kept above this.
PENCIL_PIVOT = 1e-280
#: A slide's ratio is kept from a divisor below this.
INFINITE_LENGTH = 1e-200
#: A matrix of this norm has no eigenvalues worth having.
EIGENVALUE_OVERFLOW = 1e290
#: How far to the side of a pose at which the elimination is singular it is solved instead (lengths of the scale; rad):
#: solutions move by that much, or by its root where two merge.
GENERAL_BESIDE = (1e-3, 3e-3, 3e-4, 1e-2, 1e-3, 3e-3, 1e-4, 3e-2, 1e-5, 1e-2, 1e-6, 1e-3)
