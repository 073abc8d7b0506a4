"""From a pose to every joint vector that reaches it."""
