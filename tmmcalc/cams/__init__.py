"""Disk cams: laws of motion, profiles, pressure angle, synthesis, forces, strength, optimal design."""
