"""What the note says of linkages: structure, motion, forces."""
