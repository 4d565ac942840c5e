"""What the note says of machines: reduction of forces and masses, motion and flywheel, balance."""
