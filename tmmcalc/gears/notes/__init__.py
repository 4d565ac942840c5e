"""What the note says of gears: trains with their strength and choice, pairs, contours, profiles, wheels alone."""
