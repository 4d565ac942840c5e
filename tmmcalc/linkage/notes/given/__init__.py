"""What the tables of the room give, told for the task: metric, motion of the input, loads."""
