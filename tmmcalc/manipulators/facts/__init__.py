"""What the results of the manipulator stages tell people: the documents of each stage."""
