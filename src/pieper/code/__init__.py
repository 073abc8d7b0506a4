"""Solvers to take away: an arm's closed form and forward kinematics, written in other languages."""
