"""Tables of the spec of what a class is given and asked."""
