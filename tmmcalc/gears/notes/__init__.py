"""What the note tells of gears: a module for each stage, and what several of them share."""
