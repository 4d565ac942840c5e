"""Planar linkages: structure, kinematics of dyads, assembly intervals, extremes, quality."""
