"""What the results of the linkage stages tell people: the documents of each stage."""
