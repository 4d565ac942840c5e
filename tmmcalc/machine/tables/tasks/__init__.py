"""From the tables of the machine room to the plain values that its theory takes."""
