"""What the tables of the room give, told for the task: of each table the data by which its stages are solved."""
