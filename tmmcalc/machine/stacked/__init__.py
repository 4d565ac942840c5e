"""Steady motions of many machines with motors at once.

regimes.py   the machines of stacked cycles on their panels, and the regimes that they settle in
figures.py   unevenness, mean and extreme speeds, power
spots.py     speeds, moments and times at angles
"""
