"""The parts of the note on the loaded cam: spring, reactions, requirements, the best sizes."""
