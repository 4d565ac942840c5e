"""What the results of the gear stages tell people: the documents of each stage."""
