"""Classify an arm once, and decide how it is solved."""
