"""What is said of faults in the tables of the room, by key."""
