"""Reduced cycles and steady motions of many machines with motors at once; `linkage.stacked` says what differs and why.

reduction.py  reduced moments and inertia of many variants on their panels
records.py    results of single variants, cut out of those of many
regimes.py    the machines of stacked cycles on their panels, and the regimes that they settle in
searches.py   the regimes that a search for the flywheel asks for
figures.py    unevenness, mean and extreme speeds, power
places.py     speeds, moments and times at angles
"""
