"""What is said of faults in the tables, by key."""
