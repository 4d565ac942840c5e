"""What the note tells of the stages of the extras room."""
