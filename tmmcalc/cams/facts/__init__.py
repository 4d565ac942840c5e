"""What the results of the cam stages tell people: the documents of each stage."""
