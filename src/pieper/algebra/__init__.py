"""Expressions, polynomials, their arithmetics, and formulas read and written."""
