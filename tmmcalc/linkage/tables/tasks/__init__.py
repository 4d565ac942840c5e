"""From the tables of the linkage room to the plain values that its theory takes."""
