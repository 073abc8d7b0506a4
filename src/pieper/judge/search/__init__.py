"""The search for the one slip that explains a wrong claim."""
