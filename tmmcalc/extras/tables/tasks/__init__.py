"""From the tables of the extras room to the plain values that its theory takes."""
