"""What is known of one train of a search: the conditions that it keeps, its speeds, its plans, its strength."""
