"""Machines: work and power, motors, steady and transient motion, flywheels, balancing of rotors and engines.

This room knows no links: a linkage comes as its reduced moment and reduced inertia over a cycle (`cycle`).
"""
