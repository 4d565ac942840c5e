"""What the note tells of manipulators."""
