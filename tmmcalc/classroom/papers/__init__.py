"""What is printed for a class: task sheets, solutions, the page of keys, sheets of results."""
