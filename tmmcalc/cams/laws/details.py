"""What a note says of a law by phase: its coefficients, what they are multiplied by, its peaks and their places.

    y = h s(k),  y' = +-m1 s'(k),  y'' = m2 s''(k),  y''' = +-m3 s'''(k)   m_j = h/phi_i^j    (5.4, 5.5, 5.9, 5.10)

On the rise k runs from 0 to 1, on the return from 1 to 0, which turns the signs of y' and y'''.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.cams.laws.constants import WIDEST, constants, first_of, sampled
from tmmcalc.cams.laws.law import Law, Values
from tmmcalc.cams.program import Phase, Program
from tmmcalc.core.numerics.panels import panels
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.cams.lawresult import LawResult
    from tmmcalc.cams.room import CamTables


@record
class PhaseLaw:
    """The law of one phase; t = k less the begin of the piece: s = c0 + c1 t + c2 t^2 + ... + A sin(w t + p)."""

    law: str = quantity("law", "law of the phase")
    angle: float = quantity("phi_phase[rad]", "angle of the phase", symbol="phi_i")
    breaks: Values = quantity("k_pieces", "k at which pieces of the law begin, and its end")  # (P + 1,)
    coefficients: Values = quantity("c", "coefficients of the powers of t, ascending, a row a piece")  # (P, D + 1)
    amplitude: Values = quantity("A", "amplitude of the harmonic of each piece")  # (P,)
    frequency: Values = quantity("w", "frequency of the harmonic of each piece [rad]")  # (P,)
    lead: Values = quantity("p", "phase of the harmonic of each piece [rad]")  # (P,)
    rising: float = quantity("s2_max", "largest s''")
    rising_at: float = quantity("k_s2_max", "k of the largest s''")


@record
class StemPhase:
    """A phase of a follower that is translated: what its law is multiplied by, and its peaks."""

    stroke: float = quantity("h[m]", "stroke of the follower", source="(5.4)")
    m1: float = quantity("m1[m]", "what s' is multiplied by, h/phi_i", symbol="m_1", source="(5.4)")
    m2: float = quantity("m2[m]", "what s'' is multiplied by, h/phi_i^2", symbol="m_2", source="(5.5)")
    m3: float = quantity("m3[m]", "what s''' is multiplied by, h/phi_i^3", symbol="m_3")
    slope: float = quantity("S1_peak[m]", "S' of largest size in the phase, with its sign")
    slope_at: float = quantity("S1_peak_at_phi[rad]", "angle of the cam at the peak of S'")
    most: float = quantity("S2_max[m]", "largest S'' in the phase")
    most_at: float = quantity("S2_max_at_phi[rad]", "angle of the cam at the largest S''")
    least: float = quantity("S2_min[m]", "least S'' in the phase")
    least_at: float = quantity("S2_min_at_phi[rad]", "angle of the cam at the least S''")
    velocity: float | None = quantity("v_peak[m/s]", "velocity at the peak of S'")  # None: no speed
    speeding: float | None = quantity("a_max[m/s^2]", "largest acceleration in the phase")
    slowing: float | None = quantity("a_min[m/s^2]", "least acceleration in the phase")


@record
class RockerPhase:
    """A phase of a rocker: what its law is multiplied by, and its peaks."""

    stroke: float = quantity("psi_m[rad]", "swing of the rocker", source="(5.4)")
    m1: float = quantity("m1", "what s' is multiplied by, psi_m/phi_i", symbol="m_1", source="(5.4)")
    m2: float = quantity("m2", "what s'' is multiplied by, psi_m/phi_i^2", symbol="m_2", source="(5.5)")
    m3: float = quantity("m3", "what s''' is multiplied by, psi_m/phi_i^3", symbol="m_3")
    slope: float = quantity("psi1_peak", "psi' of largest size in the phase, with its sign")
    slope_at: float = quantity("psi1_peak_at_phi[rad]", "angle of the cam at the peak of psi'")
    most: float = quantity("psi2_max", "largest psi'' in the phase")
    most_at: float = quantity("psi2_max_at_phi[rad]", "angle of the cam at the largest psi''")
    least: float = quantity("psi2_min", "least psi'' in the phase")
    least_at: float = quantity("psi2_min_at_phi[rad]", "angle of the cam at the least psi''")
    velocity: float | None = quantity("omega_peak[rad/s]", "angular velocity at the peak of psi'")  # None: no speed
    speeding: float | None = quantity("eps_max[rad/s^2]", "largest angular acceleration in the phase")
    slowing: float | None = quantity("eps_min[rad/s^2]", "least angular acceleration in the phase")


def law_details(spec: CamTables, results: Mapping[str, Any]) -> Mapping[str, PhaseLaw | StemPhase | RockerPhase]:
    """Laws and peaks of a scene whose stage ``cam_law`` is done: ``rise_law``, ``rise``, ``return_law``, ``return``."""
    from tmmcalc.cams.tables.tasks.cam import to_cam

    result: LawResult = results["cam_law"]
    found: dict[str, PhaseLaw | StemPhase | RockerPhase] = {}
    for kind, (law, motion) in phase_laws(to_cam(spec).program, result.turns, result.speed).items():
        found |= {f"{kind}_law": law, kind: motion}
    return found


def phase_laws(
    program: Program, turns: bool, speed: float | None
) -> Mapping[str, tuple[PhaseLaw, StemPhase | RockerPhase]]:
    """Law and peaks of the moving phases, ``rise`` and ``return``.

    ``turns``: a rocker; ``speed`` [rad/s] of the cam, None: nothing in time.
    """
    return {
        phase.kind: _phase_law(turns, phase, phase.law, begin, speed)
        for begin, phase in zip(program.starts.tolist(), program.phases, strict=False)
        if phase.law is not None
    }


def _phase_law(
    turns: bool, phase: Phase, law: Law, begin: float, speed: float | None
) -> tuple[PhaseLaw, StemPhase | RockerPhase]:
    found, stroke, back = constants(law), abs(phase.end - phase.start), phase.end < phase.start
    on = panels(0.0, 1.0, law.breaks, WIDEST)
    rising, rising_at = first_of(on, sampled(law, on)[2])
    m1, m2, m3 = (stroke / phase.angle**order for order in (1, 2, 3))

    def place(k: float) -> float:
        return begin + phase.angle * (1 - k if back else k)

    slope, most, least = (-m1 if back else m1) * found.velocity, m2 * rising, m2 * found.braking
    timed = (None, None, None) if speed is None else (slope * speed, most * speed**2, least * speed**2)
    own = (law.breaks, law.coefficients, law.amplitude, law.frequency, law.phase)
    peaks = (slope, place(found.velocity_at), most, place(rising_at), least, place(found.braking_at))
    kind = RockerPhase if turns else StemPhase
    return PhaseLaw(law.name, phase.angle, *own, rising, rising_at), kind(stroke, m1, m2, m3, *peaks, *timed)
