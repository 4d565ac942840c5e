"""What the results of the vibration stages tell people: the documents of each stage."""
