"""From the tables of the gear room to the plain values that its theory takes."""
