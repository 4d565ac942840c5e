"""Given loads of a linkage: what acts on which link, at any position of the input."""
