"""Error against run time: every method that the program has for a stage, beside a reference proved better."""
