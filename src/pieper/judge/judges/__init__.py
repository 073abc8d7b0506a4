"""One judge a kind of claim."""
