"""Slips planted by code that shares nothing with the judge: its own formulas, its own arithmetic, its own slips."""
