"""The three positions of a six-bar at dwell: places of its pins, the centres of both circles, the lengths."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.notes.syntheses.told import Told, angle, length
from tmmcalc.linkage.synthesis.dwell.linkages import Drawn, Parameters, from_lengths, from_positions
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph, Place
from tmmcalc.report.telling import lines, named, number_of, numeral, vector

BAR = ("x_Ci = l_OB + l_CB*cos(psi_0 + psi_{1,i})", "y_Ci = l_CB*sin(psi_0 + psi_{1,i})")
TURNED = (
    "x'_Ci = x_Ci*cos(phi_{1,i}) + y_Ci*sin(phi_{1,i})",
    "y'_Ci = y_Ci*cos(phi_{1,i}) - x_Ci*sin(phi_{1,i})",
)
CENTRE_A = "(x'_Ci - x'_C1)*x_A1 + (y'_Ci - y'_C1)*y_A1 = (x'_Ci**2 + y'_Ci**2 - x'_C1**2 - y'_C1**2)/2"
CRANK = ("l_OA = sqrt(x_A1**2 + y_A1**2)", "phi_0 = atan2(y_A1, x_A1)")
COUPLER = "l_AC = sqrt((x_C1 - x_A1)**2 + (y_C1 - y_A1)**2)"
PIN = ("x_Ai = l_OA*cos(phi_0 + phi_{1,i})", "y_Ai = l_OA*sin(phi_0 + phi_{1,i})")
TRIANGLE = (
    "f_i = sqrt((l_OB - x_Ai)**2 + y_Ai**2)",
    "delta_i = atan2(-y_Ai, l_OB - x_Ai)",
    "gamma_i = acos((l_AC**2 + f_i**2 - l_CB**2)/(2*l_AC*f_i))",
    "x_Ci = x_Ai + l_AC*cos(delta_i <side> gamma_i)",
    "y_Ci = y_Ai + l_AC*sin(delta_i <side> gamma_i)",
)
POINT = (
    "x_Di = x_Ci + l_CD*((x_Ai - x_Ci)*cos(alpha) - (y_Ai - y_Ci)*sin(alpha))/l_AC",
    "y_Di = y_Ci + l_CD*((x_Ai - x_Ci)*sin(alpha) + (y_Ai - y_Ci)*cos(alpha))/l_AC",
)
CENTRE_E = "(x_Di - x_D1)*x_E + (y_Di - y_D1)*y_E = (x_Di**2 + y_Di**2 - x_D1**2 - y_D1**2)/2"
ENDS = ("l_DE = sqrt((x_D1 - x_E)**2 + (y_D1 - y_E)**2)", "l_BE = sqrt((x_E - l_OB)**2 + y_E**2)")


def by_positions(told: Told, asked: DwellTask) -> Iterator[Block]:
    """From three positions of the bar BC to the pivot of the crank, then to E."""
    scale = told.design.size("l_OB")
    lengths = {name: told.design.size(name) / scale for name in ("l_CB", "l_CD")}

    def one(name: str) -> Real:
        return np.array([lengths.get(name) or told.design.size(name)])

    drawn = from_positions(
        Parameters(
            phi12=one("phi_12"),
            phi13=one("phi_B"),
            psi0=one("psi_0"),
            psi12=one("psi_12"),
            psi13=one("psi_13"),
            bar=one("l_CB"),
            side=one("l_CD"),
            alpha=one("alpha"),
        )
    )
    places = _places(told, drawn, scale)
    given_ = {"CB": asked.positions.bar, "CD": asked.positions.side}
    yield from _scaled(told, [name for name, value in given_.items() if value is not None])
    yield Paragraph(
        tr(
            "The origin is $O$, the $x$ axis points to $B$ at dwell. The bar $BC$ stands in positions 1, 2 and 3 at "
            "the angles $psi_0$, $psi_0 + psi_12$, $psi_0 + psi_13$:"
        )
    )
    yield from lines(BAR, places)
    yield Paragraph(
        tr(
            "Seen from the crank, that is turned back with it by $phi_12$ and $phi_B$, the places of $C$ lie on a "
            "circle about its pin $A$ in position 1:"
        )
    )
    yield from lines(TURNED, places)
    yield Paragraph(tr("The centre follows from two linear equations, which hold for what was found:"))
    yield from lines([CENTRE_A], places[1:])
    yield Paragraph(tr("Its place in position 1: $x_A1 = {x}$ m, $y_A1 = {y}$ m.", **_shown(told, "A1")))
    yield from told.lines(*CRANK, COUPLER)
    yield from _rest(told, places)


def by_lengths(told: Told, asked: DwellTask) -> Iterator[Block]:
    """From the lengths of the four-bar OACB to three places of C, then to E."""
    assert asked.lengths is not None
    scale = told.design.size("l_OB")
    drawn = from_lengths(asked.lengths, asked.dwell)
    places = _places(told, drawn, scale)
    yield from _scaled(told, ["OA", "AC", "CB", "CD"])
    yield Paragraph(
        tr(
            "The origin is $O$, the $x$ axis points to $B$ at dwell. In positions 1, 2 and 3 the crank pin stands, "
            "and the triangle $ABC$ gives $C$:"
        )
    )
    yield from lines((*PIN, *TRIANGLE), places, {"side": "+" if asked.lengths.left else "-"})
    yield from _rest(told, places, pins=False)


def _scaled(told: Told, names: Sequence[str]) -> Iterator[Block]:
    """Lengths that are given as parts of l_OB; of one metre they are themselves."""
    if told.design.size("l_OB") != 1.0:
        yield from told.lines(*(f"l_{name} = lambda_{name}*l_OB" for name in names))


def _shown(told: Told, point: str) -> dict[str, str]:
    return {axis: numeral(number_of(told.lexicon, f"{axis}_{point}"), 7) for axis in "xy"}


def _places(told: Told, drawn: Drawn, scale: float) -> list[Place]:
    """The three positions with the places of all pins [m]."""
    turns = drawn.linkages.turns[:, 0]
    told.give(_point("A1", complex(scale * drawn.a[0, 0]), "A"))
    told.give(_point("C1", complex(scale * drawn.c[0, 0]), "C"))
    told.give(_point("D1", complex(scale * drawn.dd[0, 0]), "D"))
    back = np.exp(-1j * turns) * drawn.c[:, 0] * scale
    seen = tr("coordinates of point {point}, turned back with the crank", point="C")
    first = vector("%'_C1", complex(back[0]), "m", seen)
    bars = [0.0, *(told.design.size(name) for name in ("psi_12", "psi_13"))] if "psi_0" in told.lexicon else [0.0] * 3
    found = []
    for k, turn in enumerate(turns.tolist()):
        a, c, d = (complex(scale * part[k, 0]) for part in (drawn.a, drawn.c, drawn.dd))
        gap = complex(scale) - a
        reach = (c - a) / gap
        own = {
            "phi_{1,i}": angle(turn, tr("turn of the crank from position 1")),
            "psi_{1,i}": angle(bars[k], tr("turn of bar BC from position 1")),
            **_point("Ai", a, "A"),
            **_point("Ci", c, "C"),
            **_point("Di", d, "D"),
            **first,
            **vector("%'_Ci", complex(back[k]), "m", seen),
            "f_i": length(abs(gap), tr("distance between points {first} and {second}", first="A", second="B")),
            "delta_i": angle(float(np.angle(gap)), tr("angle of the line {first}{second}", first="A", second="B")),
            "gamma_i": angle(abs(float(np.angle(reach))), tr("angle of the triangle at A")),
        }
        name = tr("pos. {label}", label=k + 1)
        found.append(Place(name, told.lexicon | named(own), str(k + 1)))
    return found


def _point(key: str, at: complex, name: str) -> dict[str, Given]:
    return named(vector(f"%_{key}", at, "m", tr("coordinates of point {point}", point=name)))


def _rest(told: Told, places: Sequence[Place], *, pins: bool = True) -> Iterator[Block]:
    """The places of D, the centre E of their circle, the bars."""
    for place in places:
        place.lexicon.update({key: each for key, each in told.lexicon.items() if key not in place.lexicon})
    yield Paragraph(tr("The pin $D$ of the coupler is at the angle $alpha$ from $CA$:"))
    if pins:
        yield from lines(PIN, places)
    yield from lines(POINT, places)
    yield Paragraph(tr("So that link 5 stands in all three positions, $E$ is the centre of the circle through them:"))
    yield from lines([CENTRE_E], places[1:])
    yield Paragraph(tr("Its place: $x_E = {x}$ m, $y_E = {y}$ m.", **_shown(told, "E")))
    yield from told.lines(*ENDS)
