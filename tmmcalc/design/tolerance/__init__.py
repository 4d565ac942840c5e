"""What tolerances do to results: plain functions on arrays; who evaluates is handed in.

sources.py    dimensions with tolerances, clearances of pairs, what is made alike; their distributions
sampling.py   seeded samples of them, and what statistics tell of results at these, with intervals
linear.py     the same by derivatives: sigma, worst case, the share of every source
worst.py      the worst case in the whole box: by signs that are checked, else by search
yields.py     which samples keep the constraints; what widening or narrowing one source does to that
"""
