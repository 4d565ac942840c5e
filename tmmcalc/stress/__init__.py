"""Ladders of extremes: a scene is driven toward its edges, and every stage tells where its digits go."""
