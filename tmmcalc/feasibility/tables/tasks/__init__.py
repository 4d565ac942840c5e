"""From the tables of the feasibility room to the plain values that its theory takes."""
