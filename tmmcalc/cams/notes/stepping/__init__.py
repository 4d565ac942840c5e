"""The parts of the note on an indexing drive: its quantities, its limits, its flanks, its efficiency."""
