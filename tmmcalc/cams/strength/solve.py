"""The stage of the requirements: every one a named margin, its extremes over the whole turn."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import TYPE_CHECKING

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.state import state
from tmmcalc.cams.forces.turn import at_rows, loads_of
from tmmcalc.cams.forces.turnforces import turn_forces
from tmmcalc.cams.strength.case import Case, case_of
from tmmcalc.cams.strength.errors import Positioned, strength_errors
from tmmcalc.cams.strength.formulas import shaft_by_strength, whole
from tmmcalc.cams.strength.profilemargins import shape_margins
from tmmcalc.cams.strength.results import OK, CamStrength, Margin, Rolling, ShaftFound
from tmmcalc.cams.strength.roller import contact_margin, roller_unit, rolling_of, slip_margin, unit_margins
from tmmcalc.cams.strength.rows import rows_of
from tmmcalc.cams.strength.shaftstem import shaft_margins, shaft_of, stem_margins
from tmmcalc.cams.task import CamTask
from tmmcalc.core.notes import Note, Phrase, Said, held

if TYPE_CHECKING:
    from tmmcalc.machine.motion import Motion

FAULTS = {  # the gravest first
    "undercut": "the profile is undercut, or nearly so",
    "tool_interference": "the tool is too large",
    "slip": "the roller slips",
    "exceeded": "the limit is exceeded",
}


def solve_strength(
    task: CamTask, follower: Follower, cam_forces: CamForces | None = None, motion: Motion | None = None
) -> CamStrength:
    """All requirements of a follower on its cam, at the speed of the machine if it is known.

    ``cam_forces`` are the forces of the same task, if they are known. Raises what `solve_forces` raises.
    """
    task = task.at_speed(motion)
    loads = loads_of(task, "cam_strength")
    spring = cam_forces.spring if cam_forces else solve_spring(task, loads)
    case = case_of(task, follower, loads, turn_forces(task, follower, loads, spring))
    unit, shaft = roller_unit(case), shaft_of(case)
    rolling = rolling_of(case, unit)
    margins = (
        slip_margin(case, unit, rolling),
        *shape_margins(case),
        *unit_margins(case, unit),
        *shaft_margins(case, shaft),
        *stem_margins(case),
        contact_margin(case),
    )
    rows = cam_forces.positions if cam_forces else task.positions
    points = at_rows(task, loads, rows)
    now = state(case.course.carried, points)
    found = rows_of(case, rolling, points, now)
    bend, decisive = case.bend, {verdict for verdict, _ in _decisive(margins)}
    sharpest = 1 / bend.largest if bend.largest > 0 else None
    return CamStrength(
        follower=follower,
        positions=rows,
        ends=tuple(task.program.starts.tolist()),
        touching=found.touching,
        curvature=found.curvature,
        run=found.run,
        slip=found.slip,
        stress=found.stress,
        reduced=found.reduced,
        bending=found.bending,
        pressure=found.pressure,
        convex=max(bend.least, 0.0) if case.flat else sharpest,
        convex_phi=bend.least_phi if case.flat else bend.largest_phi,
        concave=-1 / bend.least if bend.least < 0 and not case.flat else None,
        concave_phi=bend.least_phi,
        unit=unit,
        rolling=rolling,
        shaft=shaft,
        margins=margins,
        verdict=next((fault for fault in FAULTS if fault in decisive), OK),  # the gravest
        notes=tuple(_notes(case, margins, rolling, shaft)),
        error=strength_errors(case, rolling, Positioned(points, rows.piece, now, found), margins, shaft, spring),
    )


def _decisive(margins: tuple[Margin, ...]) -> Iterator[tuple[str, Margin]]:
    """Margins that are not kept, in their order."""
    for each in margins:
        if not each.advice and each.verdict not in (OK, "not judged"):
            yield each.verdict, each


def _notes(
    case: Case, margins: tuple[Margin, ...], rolling: Rolling | None, shaft: ShaftFound | None
) -> Iterator[Said]:
    for verdict, each in _decisive(margins):
        text = FAULTS[verdict]
        if each.phi is not None:
            text = Phrase("{fault} at phi = {phi:.6g} deg", fault=text, phi=degrees(each.phi))
        if each.why:
            text = Phrase("{fault} ({why})", fault=text, why=each.why)
        yield Note("warning", text, each.name, each.value, each.limit, each.unit, each.symbol)
    for each in margins:
        if each.advice and each.verdict != OK:
            text = Phrase(
                "{formula} asks for at most {value:.6g} mm", formula=each.formula, value=1e3 * (each.limit or 0.0)
            )
            yield Note("note", text, each.name, each.value, each.limit, each.unit, each.symbol)
    if not case.touches:
        yield "warning: nothing presses the follower on the cam in a part of the turn, so slip and stress have gaps"
    yield from _shaft_notes(case, shaft)
    if case.task.turning is not None and rolling is not None:
        yield (
            "note: the cam's speed varies, so A is (omega^2 A + eps (v - r2))/omega_m^2, v the speed of the pitch "
            "curve: what the roller accelerates by"
        )


def _shaft_notes(case: Case, shaft: ShaftFound | None) -> Iterator[Said]:
    """What friction adds to the torque, where that asks for a thicker shaft."""
    if shaft is None or shaft.moment_rubbed is None or case.task.requirements.bending is None:
        return
    radius = float(whole(shaft_by_strength(shaft.moment_rubbed, case.task.requirements.bending)))
    if radius > shaft.radius:
        text = (
            "with the torque that friction adds M_E reaches {moment:.6g} N*m, which asks for a shaft radius of "
            "{limit:.6g} mm"
        )
        rubbed = shaft.moment_rubbed
        yield held("note", text, shaft.radius, radius, "m", shown="mm", name="shaft radius", moment=rubbed)
