"""Pages of docs/ that are made from the results, by `make pages`."""
