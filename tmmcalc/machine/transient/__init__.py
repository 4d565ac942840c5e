"""Transient motion: start-up, braking, run-down and load change of one mass or of a chain of masses, in time.

`model` and `scenario` say what moves and what happens to it, `simulate` runs it, `results` is what it leaves.
"""
