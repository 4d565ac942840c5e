"""From the tables of the vibration room to the plain values that its theory takes."""
