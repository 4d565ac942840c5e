"""Optimal design: the lowest mechanism that keeps every constraint, and the blocking contour in the plane of S0 and r2.

``scene`` holds what does not depend on the sizes at the ``nodes`` of the turn; ``extremes`` finds the largest values
over the turn (by ``peaks``), ``margins`` sets them against the limits: the constraints as functions of S0, r2 and H2;
``guide`` turns them into a range of guide lengths, by which ``steps`` searches whole steps, while ``slipping`` takes
out what slips at any height and ``beyond`` looks far out where nothing is found; ``least`` finds the continuous
optimum; ``contour`` gives the region over the ``plane`` of S0 and r2, its ``border`` and the single ``curves``,
``section`` what goes along r2; ``relax`` re-solves for looser limits, ``game`` for other laws, springs, materials and
rollers; ``flat`` is the chart of a flat-faced follower; ``solve`` puts them together.
"""
