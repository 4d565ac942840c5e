"""What the note tells of vibration."""
