"""Tooth profiles: involute and fillet, whole teeth and wheels, rings, meshes, rack positions, and their files."""
