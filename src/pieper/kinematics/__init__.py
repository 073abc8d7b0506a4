"""Poses, the chain of axes, forward kinematics and the geometry of axes."""
