"""A pinion inside a ring: geometry, sliding, interferences."""
