"""From the tables of the manipulator room to the plain values that its theory takes."""
