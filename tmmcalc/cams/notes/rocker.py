"""The least size of a cam under a rocker: the textbook's rule, the place of the axis where two limits are reached.

With alpha = dpsi - theta_P or dpsi + theta_P a limit is reached where (l_0/l_2) cos(psi_0 + alpha) = p, p = (1 - delta
psi') cos(theta_P): in X = (l_0/l_2) cos(psi_0) and Y = (l_0/l_2) sin(psi_0) a straight line for each angle of the cam.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.notes.lexicon import Told, angle, degrees_of, mm
from tmmcalc.cams.pivot import highest
from tmmcalc.cams.synthesis import oscillatingsizes
from tmmcalc.cams.synthesis.bestplace import Best, best
from tmmcalc.cams.synthesis.completion import ANGLE, GIVEN
from tmmcalc.cams.synthesis.halfplanes import families
from tmmcalc.cams.synthesis.objectives import Distance, Ratio
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Display, Heading, Lexicon, Paragraph, Place
from tmmcalc.report.telling import lines, named

BASE = "R_0 = sqrt(l_0**2 + l_2**2 - 2*l_0*l_2*cos(psi_0))"
START = "psi_0 = acos((l_0**2 + l_2**2 - R_0**2)/(2*l_0*l_2))"
SIDE = "<side> = <other>*cos(psi_0) + sqrt(R_0**2 - <other>**2*sin(psi_0)**2)"
CROSSING = (
    "X = (p_1*sin(alpha_2) - p_2*sin(alpha_1))/sin(alpha_2 - alpha_1)",
    "Y = (p_1*cos(alpha_2) - p_2*cos(alpha_1))/sin(alpha_2 - alpha_1)",
)
FOOT = "X = 1 - (cos(alpha_1) - p_1)*cos(alpha_1)", "Y = (cos(alpha_1) - p_1)*sin(alpha_1)"
TEXTBOOK = "psi_0^{*} = atan(psi'_m/tan(<limit>)) - psi_m/2", "l_0^{*} = l_2/cos(psi_0^{*} + psi_m/2)"
LIMITS = {"rise": "theta_P", "return": "theta_{Pc}"}
NEAR = 1e-9  # of the phase: an angle at the edge of a piece


def told_rocker(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """The condition, the textbook's sizes, the place of the axis, the sizes."""
    asked, minus = told.task.asked, told.words["d-"]
    yield Paragraph(tr("The pressure angle follows from the position and the analogue of velocity:"))
    yield Display(read(f"tan(theta) = (l_2*(1 {minus} psi') - l_0*cos(psi))/(l_0*sin(psi))"))
    lexicon["psi_m"] = angle(told.law.stroke, tr("swing angle of the rocker"))
    yield from _textbook(told, lexicon)
    known = [name for name in ("rocker", "centres", "base", "start") if getattr(asked, name) is not None]
    if len(known) == 1 and asked.start is None:
        yield from _best(told, result, lexicon)
    elif result.governs != GIVEN:
        yield Paragraph(_on_curve(known))


def rocker_base(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """What is left of the triangle of l_0, l_2, R_0 and psi_0."""
    asked = told.task.asked
    place = [Place("", lexicon)]
    if result.governs == GIVEN and asked.start is None:
        yield from lines((START,), place)
    elif result.governs == GIVEN and asked.base is not None:
        if asked.centres is None:
            yield from lines((SIDE,), place, {"side": "l_0", "other": "l_2"})
        elif asked.rocker is None:
            yield from lines((SIDE,), place, {"side": "l_2", "other": "l_0"})
    if asked.base is None:
        yield from lines((BASE,), place)


def _on_curve(known: list[str]) -> str:
    """What is looked for where two sizes are given."""
    if "start" in known:
        return tr("With the given angle $psi_0$ the axis of the cam lies on a ray; the base circle is made the least.")
    if "base" not in known:
        return tr("With the given lengths the angle $psi_0$ is free; the base circle is made the least.")
    if "rocker" in known:
        return tr("With the given lengths the distance $l_0$ is made the least that keeps the limits.")
    return tr("With the given lengths the rocker is made the shortest that keeps the limits.")


def _textbook(told: Told, lexicon: Lexicon) -> Iterator[Block]:
    """The textbook's sizes, the axis of the cam square to the rocker's middle position."""
    found = oscillatingsizes.textbook(told.task, told.follower.rocker)
    if found is None:
        return
    limits = told.task.limits
    least = "theta_{Pc}" if limits.back is not None and limits.back < limits.rise else "theta_P"
    yield Paragraph(
        tr(
            "With the axis of the cam on the perpendicular to the rocker’s middle position the textbook’s approximate "
            "sizes are (5.50, 5.51):"
        )
    )
    lexicon |= named(
        {
            "psi'_m": Given(oscillatingsizes.fastest(told.task), "", tr("largest size of the analogue of velocity")),
            "psi_0^{*}": angle(found.start, tr("approximate angle of the rocker in its lowest position")),
            "l_0^{*}": mm(found.centres, tr("approximate distance of the axes")),
        }
    )
    yield from lines(TEXTBOOK, [Place("", lexicon)], {"limit": least})


def _best(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """The best place by the pressure angle: where the limit is reached at two angles of the cam, or nearest to one."""
    asked = told.task.asked
    aim = Ratio() if asked.centres is not None else Distance(1.0)
    try:
        found = best(families(told.task), aim)
    except NoSolutionError:
        return
    count = len(found.lines.phi)
    if count > 2 or (count == 1 and asked.centres is not None) or not count:
        yield Paragraph(
            tr("The place of the axis with the least base circle is found within the region of the limits.")
        )
        return
    yield Paragraph(
        tr("The limit $theta_P$ is reached where the place $X$, $Y$ of the axis in parts of $l_2$ lies on this line:")
    )
    yield Display(read("X*cos(alpha) - Y*sin(alpha) = p"))
    yield Paragraph(
        tr("The base circle is least where it is reached at two angles of the cam:")
        if count == 2
        else tr("The base circle is least at the foot of the perpendicular to the line of this angle of the cam:")
    )
    minus = told.words["d-"]
    for k in range(count):
        limit, sign, own = _reached(told, found, k)
        lexicon |= named(own)
        place = Place(tr("at φ = {angle}°", angle=degrees_of(float(found.lines.phi[k]))), lexicon)
        texts = f"alpha_{k + 1} = Deltapsi_{k + 1} {sign} {limit}", f"p_{k + 1} = (1 {minus} psi'_{k + 1})*cos({limit})"
        yield from lines(texts, [place])
    lexicon["X"] = Given(found.point.real, "", tr("place of the axis along the lowest rocker in parts of its length"))
    lexicon["Y"] = Given(-found.point.imag, "", tr("place of the axis across the lowest rocker in parts of its length"))
    yield from lines(CROSSING if count == 2 else FOOT, [Place("", lexicon)])
    yield from _lengths(told, result, found, lexicon)


def _reached(told: Told, found: Best, k: int) -> tuple[str, str, Lexicon]:
    """The limit that is reached with line k, its sign in alpha, and the quantities of the rocker there."""
    program, limits = told.task.program, told.task.limits
    phi, side = float(found.lines.phi[k]), int(found.lines.side[k])
    near = np.flatnonzero((program.edges[:-1] <= phi + NEAR) & (phi - NEAR <= program.edges[1:]))
    y, first = program.at(np.full(near.size, phi), near)[:2]
    kinds = [program.phases[number].kind for number in program.places[0][near]]
    best_fit, chosen = np.inf, ("", 0.0, 0.0, 0.0)
    for kind, at, slope in zip(kinds, y.tolist(), first.tolist(), strict=True):
        limit = limits.rise if kind == "rise" else limits.back if kind == "return" else None
        if limit is None:
            continue
        off = abs(-side * (1 - told.follower.assembly * slope) * np.cos(limit) - found.lines.bound[k])
        if off < best_fit:
            best_fit, chosen = off, (kind, limit, at, slope)
    kind, limit, at, slope = chosen
    lean, far = at - side * limit, (1 - told.follower.assembly * slope) * np.cos(limit)
    where = tr("at angle {number}", number=k + 1)
    own = {
        f"Deltapsi_{k + 1}": angle(
            at, tr("angle of the rocker from its lowest position at angle {number}", number=k + 1)
        ),
        f"psi'_{k + 1}": Given(slope, "", f"{tr('analogue of velocity')} {where}"),
        f"alpha_{k + 1}": angle(lean, tr("angle of the line {number}", number=k + 1)),
        f"p_{k + 1}": Given(float(far), "", tr("distance of the line {number}", number=k + 1)),
    }
    return LIMITS[kind], "-" if side > 0 else "+", own


def _lengths(told: Told, result: Synthesis, found: Best, lexicon: Lexicon) -> Iterator[Block]:
    """The sizes of the best place by the length that is given; where something else decides the size they have P."""
    asked = told.task.asked
    taken = result.governs == ANGLE
    triangle = oscillatingsizes.scaled(asked, found.point, "")
    names = {"start": "psi_0", "centres": "l_0", "rocker": "l_2"}
    if not taken:
        names = {"start": "psi_{0P}", "centres": "l_{0P}", "rocker": "l_{2P}"}
        lexicon |= named(
            {
                "psi_{0P}": angle(triangle.start, tr("angle of the lowest rocker by the pressure angle")),
                "l_{0P}": mm(triangle.centres, tr("distance of the axes by the pressure angle")),
                "l_{2P}": mm(triangle.rocker, tr("length of the rocker by the pressure angle")),
            }
        )
    texts = [f"{names['start']} = atan2(Y, X)"]
    if asked.rocker is not None:
        texts.append(f"{names['centres']} = l_2*sqrt(X**2 + Y**2)")
    elif asked.centres is not None:
        texts.append(f"{names['rocker']} = l_0/sqrt(X**2 + Y**2)")
    else:
        texts.append(f"{names['rocker']} = R_0/sqrt((X - 1)**2 + Y**2)")
        texts.append(f"{names['centres']} = {names['rocker']}*sqrt(X**2 + Y**2)")
    yield from lines(texts, [Place("", lexicon)])


def told_pivot(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """Whether the turning cam passes the pivot of the rocker."""
    room = result.pivot
    if room is None:
        return
    yield Heading(tr("Room at the pivot"), 3)
    top = told.follower.start + highest(told.task.program)[0]
    lexicon |= named(
        {
            "psi_{max}": angle(top, tr("largest angle of the rocker from the line of centres")),
            "r_A": mm(room.pivot, tr("radius of the pivot of the rocker")),
            "r_{max}": mm(room.radius, tr("largest radius of the cam")),
            "Delta_A": mm(room.clearance, tr("clearance of cam and pivot")),
        }
    )
    sign = "+" if room.beside else "-"
    texts = (
        f"r_{{max}} = sqrt(l_0**2 + l_2**2 - 2*l_0*l_2*cos(psi_{{max}})) {sign} r_2",
        "Delta_A = l_0 - r_A - r_{max}",
    )
    yield from lines(texts, [Place("", lexicon)])
    if room.swept:
        yield Paragraph(tr("The clearance is negative: the turning cam sweeps over the pivot of the rocker."))
    elif room.passed:
        yield Paragraph(tr("The disc reaches beyond the pivot, which has to stand beside it."))
    else:
        yield Paragraph(tr("The turning cam clears the pivot of the rocker."))
