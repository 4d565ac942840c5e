"""What the cam asks of the shaft that drives it, told after its forces: inertia and moments reduced to that shaft.

The forces are those of the given speed; the reduction of the machine has their moments by the same letters.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.notes.lexicon import angle, degrees_of, of_task
from tmmcalc.cams.notes.loaded.quantities import Loaded, loaded_of
from tmmcalc.cams.notes.loaded.reactions import EVEN, pressed
from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.attached import Attached
from tmmcalc.machine.pictures.words import cause_name
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given, value_of
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import lines, named, tabulated

LETTERS = {"cam force": "M_cQ", "cam weight": "M_cG", "cam spring": "M_cs", "cam friction": "M_cF"}
STEM_INERTIA = "J_c = m_T*S'**2<u2>/10**6", "J'_c = 2*m_T*S'*S''<u3>/10**6"
ROCKER_INERTIA = "J_c = J_T*psi'**2<u2>", "J'_c = 2*J_T*psi'*psi''<u3>"
STEM = {
    "cam force": "M_cQ = Q*S'<u>/10**3",
    "cam weight": "M_cG = G*S'<u>/10**3",
    "cam spring": "M_cs = -(Q_0 + c*DeltaS)*S'<u>/10**3",
    "cam friction": "M_cF = -abs(R*S')*mu<u>/10**3",
}
ROCKER = {
    "cam force": "M_cQ = M_Q*psi'<u>",
    "cam spring": "M_cs = -(M_0 + c*Deltapsi)*psi'<u>",
    "cam friction": "M_cF = -abs(R*psi')*mu*l_2<u>/10**3",
}
ANGLE = "phi_1 = phi_r + phi<over>"
ASKED = "M_c = J'_c*omega_1**2/2"
PLAIN, GEARED = (
    {"u": "", "u2": "", "u3": "", "over": ""},
    {"u": "*u_c", "u2": "*u_c**2", "u3": "*u_c**3", "over": "/u_c"},
)


def told_load(order: Order) -> Iterator[Block]:
    """The reduced inertia and moments at the shown positions, the torque that is asked, works."""
    found: Attached = order.results["cam_load"] if "cam_load" in order.results else order.solved("cam_load")
    of = loaded_of(order)
    mean = of._replace(told=of.told._replace(task=to_cam(order.spec)))
    words = PLAIN if found.ratio == 1 else GEARED
    inertia, formulas = (ROCKER_INERTIA, ROCKER) if mean.turns else (STEM_INERTIA, STEM)
    causes = [cause.name for cause in found.causes]
    yield Heading(tr("The cam as a load of the shaft"), 3)
    yield Paragraph(_driven(found))
    places = [_place(mean, found, row) for row in mean.told.rows]
    yield from lines((ANGLE, *inertia), places, words)
    yield from _even(of, mean, places)
    yield Paragraph(tr("The forces on the follower give these moments on the shaft, which drive it where positive:"))
    for cause in causes:
        yield from lines((formulas[cause],), places, words)
    yield Paragraph(
        tr("The torque that the cam asks of the shaft at this angular velocity is largest and least at these angles:")
    )
    text = ASKED + "".join(f" - {LETTERS[cause]}" for cause in causes)
    yield from lines((text,), [_at(found, each, text) for each in found.torque], words)
    peak = max(found.torque, key=lambda each: abs(each.value))
    yield Result(
        "M_c",
        Given(
            abs(peak.value), "N*m", tr("largest torque that the cam asks of the shaft at the given angular velocity")
        ),
    )
    yield from _works(found)


def _even(of: Loaded, mean: Loaded, places: Sequence[Place]) -> Iterator[Block]:
    """Why R is another one than in the forces, and how it is found, where friction is reduced of an uneven motion."""
    if of.task.turning is None or not of.carried.rubs:
        return
    yield Paragraph(
        tr(
            "Friction is reduced at the given angular velocity, at which the shaft turns evenly. So the inertia force "
            "is without $eps$, and $R$ differs from that of the uneven motion above:"
        )
    )
    given = of.named(of_task(of.told))
    own = [place._replace(lexicon=place.lexicon | given) for place in places]
    yield from mean.lines(EVEN, own)
    yield from pressed(mean, own)


def _driven(found: Attached) -> str:
    """How the shaft drives the cam."""
    if found.ratio == 1:
        return tr("The cam turns with the input shaft; its follower is reduced to that shaft.")
    return tr(
        "The cam turns $u_c$ times as fast as the input shaft; its follower is reduced to that shaft. The cam is in "
        "the same place again after {turns} turns of the shaft.",
        turns=found.turns,
    )


def _place(mean: Loaded, found: Attached, row: int) -> Place:
    """A row of the cam with what its follower is on the shaft."""
    task = mean.task
    theta = task.begin + float(mean.told.law.positions.phi[row]) / task.ratio
    begin = {
        "phi_r": angle(task.begin, tr("angle of the input shaft at which the rise begins")),
        "phi_1": angle(theta, tr("angle of the input shaft")),
    }
    return Place(mean.told.labelled(row), mean.at(mean.row(row)) | named(_reduced(found, theta) | begin))


def _reduced(found: Attached, theta: float, before: bool = False) -> Lexicon:
    """Inertia and moments at an angle of the shaft, at a jump after it or before."""
    at = np.array([theta % found.period])

    def here(values: Values) -> float:
        return float(found.panels.at(values, at, before=before)[0])

    own = {
        "u_c": Given(found.ratio, "", tr("speed of the cam over that of the input shaft")),
        "omega_1": Given(found.speed, "rad/s", tr("given angular velocity of the input shaft")),
        "J_c": Given(here(found.inertia), "kg*m^2", tr("reduced moment of inertia of the follower")),
        "J'_c": Given(here(found.slope), "kg*m^2", tr("its derivative by the angle of the input shaft")),
    }
    meanings = {
        "cam force": tr("moment of the technological load of the follower"),
        "cam weight": tr("moment of the weight of the follower"),
        "cam spring": tr("moment of the return spring"),
        "cam friction": tr("moment of the friction of the follower"),
    }
    for cause in found.causes:
        own[LETTERS[cause.name]] = Given(here(cause.moment), "N*m", meanings[cause.name])
    return own


def _at(found: Attached, extreme: Extreme, formula: str) -> Place:
    """The torque that is asked at an angle of the shaft, on the side of a jump that has it."""
    said = tr("torque that the cam asks of the shaft")
    sides = [named(_reduced(found, extreme.x, before)) for before in (False, True)]
    right = read(formula).sides[1]
    best = min(sides, key=lambda each: abs(value_of(right, each, "") - extreme.value))
    return Place(
        tr("at φ = {angle}° of the shaft", angle=degrees_of(extreme.x)),
        best | {"M_c": Given(extreme.value, "N*m", said)},
    )


def _works(found: Attached) -> Iterator[Block]:
    """What each cause does while the cam repeats once."""
    yield Paragraph(tr("The works of the causes while the cam repeats once are in table {tab:cam_load}."))
    columns = {"$A$, J": [cause.work for cause in found.causes]}
    labels = [cause_name(cause.name) for cause in found.causes]
    yield tabulated(tr("Works of the cam on the shaft"), columns, labels, head=tr("Cause"), key="cam_load")
