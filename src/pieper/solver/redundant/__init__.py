"""Arms with spare joints: slices, self-motions, the arm angle."""
