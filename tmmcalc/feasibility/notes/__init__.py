"""What the note tells of constraints."""
