"""Of calibration."""

#: By how much an axis of a built arm plausibly departs from the nominal one (rad; per length of the arm): a few
#: millimetres a metre. What, so large, changes all measurements together by less than their noise, is not seen.
PLAUSIBLE_DEPARTURE = 2e-3
#: The same of a gear's ratio and of what couples two joints.
PLAUSIBLE_GEAR = 1e-3
#: A measurement this many times its noise off is no noise: of 1e8 Gaussian ones not one is.
OUTLIER = 6.0
#: Huber's threshold, in noises: 95 % efficient where there are no outliers (Huber, 1981).
HUBER = 1.345
#: A fit is done when no number moves by more than this part of its plausible size,
CALIBRATED = 1e-9
#: or after so many steps; from millimetres away three to five are usual.
CALIBRATION_STEPS = 60
#: A wrong reading of the data (degrees, millimetres, a joint's sense) is named when it leaves this part of the misfit.
MISREAD = 0.2
#: Data that miss the nominal arm by less than this part of its length are not suspected of a wrong reading.
SUSPICIOUS = 0.03
#: A reading that leaves more than this (per length of the arm; of poses rad are added) explains nothing.
CURED = 0.3
#: Where a fitted arm misses what was measured by more than this part of how much it varies, it explains nothing:
#: measurements that belong to the joints leave a hundredth at most.
EXPLAINS_NOTHING = 0.3
#: A fitted arm this many times as large or as small as the nominal one, by the spread of its tool's places, is another
#: arm: arms as built are within a hundredth.
ANOTHER_SIZE = 1.5
#: The same of the angle between neighbouring axes (rad): built ones are within half a degree.
ANOTHER_ANGLE = 0.25
#: What is so many times smaller than the nominal arm is said to be a point.
SAID_AS_A_POINT = 1e-3
#: A size this near a whole unit's, relative, is that unit's.
ONE_UNIT = 0.05
#: The noise (m, rad) that a fit begins with where none is said.
FIRST_NOISE = (1e-4, 2e-4)
#: Noise (m, rad) below which there is none: rounding.
LEAST_NOISE = 1e-12
#: Joint vectors this near (rad or m) are one and the same measurement repeated.
SAME_MEASUREMENT = 1e-6
#: Noise (m, rad) that is assumed where none is said.
USUAL_NOISE = (5e-5, 1e-4)
#: Turns (rad) up to which the derivative of a rotation vector is its series.
TURN_SERIES = 1e-3
#: Below this angle (rad) the exponential's coefficients are taken from their series.
EXPONENTIAL_SERIES = 1e-4
#: A step is taken where the cost grows by no more than this, relative,
COST_NO_WORSE = 1e-9
#: and absolute: rounding.
COST_ROUNDING = 1e-12
#: What is left of the residuals, as a part of the noise that was said, below which it was said far too large.
FAR_LESS = 0.2
#: Poses held out that are enough for that to be no chance.
ENOUGH_HELD = 5
#: Noise (m, rad) found in the data below which they are made and not measured.
NO_NOISE = 1e-8
#: A number of which the measurements see less than this part has no error that is its own.
MOSTLY_SEEN = 0.5
#: Of rows that may be said in two units this part must be explained by one or the other.
MOST_ROWS = 0.9
#: A row that misses the nominal arm so many times as far as rows usually do, and by more than what is suspicious, is no
#: noise of that arm.
FAR_BEYOND = 10.0
