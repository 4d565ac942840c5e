"""What the results of the machine stages tell people: the documents of each stage."""
