"""What is asked of a scene as a function of its numbers: what matters, what tolerances do, what is best.

model.py        results by name as a function of keys of the spec, at any number of places at once
sizes.py        how large the numbers of a spec are, and which of them take a small step
differences.py  derivatives by differences that are extrapolated, with their errors; kinks, jumps, ends
"""
