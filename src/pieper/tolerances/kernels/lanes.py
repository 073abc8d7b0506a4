"""Of numbers in vector lanes, and of elementary functions."""

#: Angles beyond this (rad) are reduced by the C library: n times a piece of pi/2 is no longer exact.
REDUCTION_LIMIT = 1e6
#: What an angle of two numbers is off by at most (rad), as lanes/math.hpp adds up; 4.9e-16 was seen.
ANGLE_ERROR = 8e-16
#: Half a unit in the last place of numbers between pi and 2 pi (rad): what each rounding of a joint's angle adds.
TURN_ROUNDING = 8.9e-16
#: The smallest number above zero: added where 0 / 0 would be NaN and 0 is meant.
LEAST_NUMBER = 4.9e-324
#: Stands for what is larger than any number of an arm, in lanes, where infinities would make NaN.
ENDLESS = 1e300
#: A score or distance from here on was `ENDLESS`.
NEARLY_ENDLESS = 1e299
#: A sine above this is not zero: an angle may be divided by it.
SINE_LEAST = 1e-150
