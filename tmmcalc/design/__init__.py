"""What is asked of a scene as a function of its numbers: what matters, what tolerances do, what is best.

model.py        results by name as a function of keys of the spec, at any number of places at once
keys.py         the numbers of a spec by their keys, and what steps they take
differences.py  derivatives by differences that are extrapolated, with their errors; kinks, jumps, ends
"""
