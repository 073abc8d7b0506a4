"""Figures and pages that show results; nothing is computed here that a result does not already hold."""
