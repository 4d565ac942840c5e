"""Criteria of choice among trains: mass, inertia, size, efficiency; Pareto front, ranking, comparison."""
