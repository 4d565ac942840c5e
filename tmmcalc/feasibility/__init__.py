"""Feasibility logic: named inequalities on the results of stages, combined by and, or, not."""
