"""Positions of six-bars with a dwell in SI, of one linkage or of many at once, from their unknowns."""

from __future__ import annotations

from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.dwell.linkages import Linkages
from tmmcalc.linkage.synthesis.dwell.motion import Unknowns, pose
from tmmcalc.linkage.synthesis.dwell.results import DwellMotion
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.unitforces import unit_forces


def motion_of(
    asked: DwellTask,
    linkages: Linkages,
    labels: tuple[str, ...],
    phi: Real,
    crank: Real,
    state: Unknowns,
    scale: float | Real,
) -> DwellMotion:
    """Positions in SI from unknowns with lengths in parts of l_OB, which are ``scale`` [m].

    Of one linkage angles and unknowns are (n,), of k linkages (n, k) and the scale (k,).
    """
    forces = unit_forces(linkages, crank, state.theta, state.s)
    length = 1.0 if linkages.rocks else scale
    bars = asked.resistance / (scale if linkages.rocks else 1.0)
    b = scale * pose(linkages, crank, state.theta, state.s).b
    return DwellMotion(
        labels,
        phi,
        crank,
        state.theta,
        length * state.s,
        b,
        length * state.ds,
        length * state.dds,
        bars * forces.f3,
        bars * forces.f4,
        bars * forces.r21,
        bars * forces.normal,
        asked.resistance * scale * forces.couple,
        forces.delta,
        asked.resistance * length * forces.moment,
    )
