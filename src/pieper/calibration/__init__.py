"""Calibration: the arm as it is, from joint vectors and what was measured at them."""
