"""Optimal design: the lowest mechanism that keeps every constraint, and the blocking contour in the plane of S0 and r2.

``scene`` holds what does not depend on the sizes at the ``nodes`` of the turn; ``extremes`` finds the largest values
over the turn (by ``peaks``), ``margins`` sets them against the limits: the constraints as functions of S0, r2 and H2;
``guidelength`` turns them into a range of guide lengths, by which ``wholesteps`` searches whole steps, while
``slipbounds`` takes out what slips at any height and ``firstfeasible`` looks far out where nothing is found;
``leastheight`` finds the continuous optimum; ``contour`` gives the region over the ``plane`` of S0 and r2 with its
border and the single ``curves``, ``section`` what goes along r2; ``relaxation`` re-solves for looser limits,
``options`` for other laws, springs, materials and rollers; ``flatface`` is the chart of a flat-faced follower;
``solve`` puts them together.
"""
