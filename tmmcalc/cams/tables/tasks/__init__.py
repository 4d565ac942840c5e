"""From the tables of the cam room to the plain values that its theory takes."""
