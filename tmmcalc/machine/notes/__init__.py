"""What the note says of machines: reduction, motion, flywheel, balance."""
