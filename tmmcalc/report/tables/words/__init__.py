"""What is said of faults in the table of sheets, by key."""
