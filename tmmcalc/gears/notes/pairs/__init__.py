"""What the note says of the wheels of a pair and of a wheel alone: sizes, contact, conditions, measures."""
