"""Pencils: how a figure looks, where the parts of an arm are, arms and frames in space."""
