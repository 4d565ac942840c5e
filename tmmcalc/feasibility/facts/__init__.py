"""What the results of the feasibility stages tell people: the documents of each stage."""
