"""What the results of the extras stages tell people: the documents of each stage."""
