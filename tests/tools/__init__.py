"""Tools that look at the tree itself: the law of the house, all checks, small changes that a test must notice."""
