"""The search for tooth numbers: every set within the stated limits, and why the others fall away."""
