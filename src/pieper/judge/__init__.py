"""What somebody else's equations are worth."""
