"""Sentences about results: why, posture labels, how far out of reach."""
