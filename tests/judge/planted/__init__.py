"""Slips planted into right claims about twenty arms, made without looking at how the judge looks for them."""
