"""The least size of a cam under a flat face: the profile stays convex; how far the face has to reach."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.notes.lexicon import Told, degrees_of, mm, number, of_motion
from tmmcalc.cams.synthesis.results import Convexity, Synthesis
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Display, Lexicon, Paragraph, Place
from tmmcalc.report.telling import lines

LEAST, NEEDED = "F_{min} = DeltaS + S''", "S_{0min} = r_m - F_{min}"
KEPT = 1e-9  # relative: a limit that is just reached is kept
REACH = {
    1: ("b_l = S'_{max} + Delta_b", "b_r = -S'_{min} + Delta_b"),
    -1: ("b_l = -S'_{min} + Delta_b", "b_r = S'_{max} + Delta_b"),
}


def told_face(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """The least start distance by the convexity, what is taken, the reach of the face."""
    found = result.convexity
    assert found is not None
    yield Paragraph(
        tr(
            "The pressure angle of a flat face across the stem is zero. The size of the cam follows from its profile, "
            "which has to be convex everywhere:"
        )
    )
    yield Display(read("rho = S_0 + DeltaS + S'' >= r_m"))
    lexicon |= told.named(_quantities(told, found))
    yield from lines((LEAST,), [_least(told, found, lexicon)], told.words)
    yield from lines((NEEDED,), [Place("", lexicon)])
    size = number(lexicon["S_0"])
    said = {
        "given": tr("The given distance $S_0$ = {size} mm is kept.", size=size),
        "convexity": tr("The least distance is taken: $S_0$ = {size} mm.", size=size),
        "shaft": tr("The radius of the camshaft asks for more: $S_0$ = {size} mm.", size=size),
    }
    yield Paragraph(said[result.governs])
    if result.follower.start < found.needed * (1 - KEPT):
        yield Paragraph(tr("It is less than the convexity of the profile asks for."))
    yield from lines(("rho_{min} = S_0 + F_{min}",), [Place("", lexicon)])
    yield Paragraph(
        tr("The contact stands at $-S'$ from the axis of the stem; the face has to reach it on both sides:")
    )
    yield from lines(REACH[told.follower.sense], [Place("", lexicon)])


def _least(told: Told, found: Convexity, lexicon: Lexicon) -> Place:
    """The place at which F is least, on the side of a jump that has it."""
    phi = found.least.phi
    program = told.task.program
    near = np.flatnonzero((program.edges[:-1] <= phi + 1e-9) & (phi - 1e-9 <= program.edges[1:]))
    every = program.at(np.full(near.size, phi), near)
    y, _, second, _ = every[:, np.argmin(every[0] + every[2])].tolist()
    own = of_motion(told, 0)
    at = {"<dy>": mm(y, own["<dy>"].meaning), "<y>''": mm(second, own["<y>''"].meaning)}
    return Place(tr("at φ = {angle}°", angle=degrees_of(phi)), lexicon | told.named(at))


def _quantities(told: Told, found: Convexity) -> Lexicon:
    extremes = {(each.order, each.value > 0): each.value for each in told.law.extremes}
    return {
        "F_{min}": mm(found.least.value, tr("least sum of the displacement and the analogue of acceleration")),
        "S_{0min}": mm(found.needed, tr("least distance by the convexity of the profile")),
        "rho_{min}": mm(found.radius, tr("least radius of curvature of the profile")),
        "S'_{max}": mm(max(extremes.get((1, True), 0.0), 0.0), tr("largest analogue of velocity")),
        "S'_{min}": mm(min(extremes.get((1, False), 0.0), 0.0), tr("least analogue of velocity")),
        "b_l": mm(found.left, tr("reach of the face to the left of its axis")),
        "b_r": mm(found.right, tr("reach of the face to the right of its axis")),
        "Delta_b": mm(found.margin, tr("margin of the face")),
    }
