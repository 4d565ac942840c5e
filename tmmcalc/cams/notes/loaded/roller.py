"""The roller: its pin, whether it rolls without slip, the contact stress."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.cams.notes.lexicon import degrees_of
from tmmcalc.cams.notes.loaded.judged import Judging
from tmmcalc.cams.notes.loaded.quantities import Found, listed
from tmmcalc.cams.strength.case import contact_curvature, roller_acceleration
from tmmcalc.cams.strength.formulas import HERTZ, contact_stress, flat_stress, slip
from tmmcalc.cams.strength.material import contact_endurance
from tmmcalc.cams.tables.cam_parts import CamMaterialTable
from tmmcalc.gears.notes.letters import letter, noted
from tmmcalc.gears.notes.strength import factor_lexicon, source_of
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr, tr_name, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Paragraph, Place, Table
from tmmcalc.report.telling import lines, number_of

PITCH = {
    "translating": ("w = sqrt(S**2 + (S' <+> e)**2)",),
    "oscillating": (
        "u_1 = <t>l_2*(1 <d-> psi')*sin(psi)",
        "h_1 = l_0 - l_2*(1 <d-> psi')*cos(psi)",
        "u_2 = l_2*((1 <d-> psi')**2*cos(psi) + psi''*sin(psi)) - l_0",
        "h_2 = <a>l_2*(psi''*cos(psi) - (1 <d-> psi')**2*sin(psi))",
        "w = sqrt(u_1**2 + h_1**2)",
    ),
}
ROLLING = {
    "translating": "<A> = (S*S' + (S' <+> e)*S'')/w",
    "oscillating": "<A> = (u_1*u_2 + h_1*h_2)/w",
}
TURNING = "A = (omega**2*A_0 + eps*(w <g> r_2))/<wn>**2"
CURVATURE = {
    "translating": ("b_κ = S**2 + (S' <+> e)*(2*S' <+> e) - S*S''", "kappa = b_κ/w**3"),
    "oscillating": ("b_κ = u_1*h_2 - h_1*u_2", "kappa = b_κ/w**3"),
}
SLIP = "D = abs(C_1 + C_2*A/abs(R))"


def pin(of: Judging) -> Iterator[Block]:
    """r0 by the pressure on it, and the least roller (5.82 to 5.84)."""
    unit = of.found.unit
    if unit is None:
        return
    yield Heading(tr("Roller and its pin"), 3)
    if unit.given:
        yield Paragraph(tr("The radius of the pin is given."))
        if (pressed := of.margin("pressure on the pin")) is not None:
            lexicon = {"p_0": Given(1e-6 * (pressed.value or 0.0), "MPa", tr("pressure on the pin"))}
            yield from of.lines(["p_0 = R_max/(4*alpha_2*r_0**2)"], lexicon)
    else:
        yield Paragraph(tr("The pressure of the largest force on the pin gives its radius:"))
        yield from of.lines(["r_0 = sqrt(R_max/(alpha_2*p_0P))/2"], {})
    yield Paragraph(tr("The bearing of the roller asks for the least radius"))
    yield from of.lines(["r_2^{*} = alpha_0*r_0"], {})


def rolling_blocks(of: Judging) -> Iterator[Block]:
    """The slip function at the positions and where it is largest (5.66 to 5.72)."""
    rolls = of.found.rolling
    if rolls is None or of.found.slip is None:
        return
    yield Heading(tr("Rolling without slip"), 3)
    if of.needs.roller_inertia is None:
        yield Paragraph(tr("The roller is a hollow cylinder on its pin:"))
        yield from of.lines(["J_r = pi*b*rho_s*(r_2**4 - r_0**4)/(2*10**15)"], {})
    texts = ("C_1 = (k_r + f_0*r_0)/(f_r*r_2)", "C_2 = 10**3*J_r*<wn>**2/(f_r*r_2**2)")
    yield from of.lines(texts, {})
    said = tr("The roller rolls where the slip function $D$ is at most 1.")
    places, worst = _rows(of), of.margin("no slip")
    if worst is not None and worst.phi is not None and worst.value is not None:
        place = of.of.where(worst.phi, worst.value, lambda found: _slip_at(of, found))
        said += " " + tr("It is largest {where}:", where=place)
        there = of.of.found(worst.phi, worst.value, lambda found: _slip_at(of, found))
        places = [*_asked(of), Place(at_angle(worst.phi), of.at(there, slip=worst.value))]
    yield Paragraph(said)
    yield from _slipped(of, places)
    if rolls.slipping:
        yield Paragraph(tr("The roller slips {where}.", where=listed(rolls.slipping)))
    elif worst is not None:
        yield Paragraph(tr("The roller rolls all over the turn."))


def _slip_at(of: Judging, found: Found) -> np.ndarray:
    """D at points."""
    rolls, loads, follower = of.found.rolling, of.of.loads, of.found.follower
    assert rolls is not None
    run = roller_acceleration(of.of.task, loads, follower, found.points, found.now.contact)
    friction = of.needs.roller_friction or 1.0
    grown, _ = slip(found.now.contact, run, rolls.resisting, rolls.inertia, loads.speed, friction, follower.roller)
    return np.abs(grown)


def _slipped(of: Judging, places: Sequence[Place]) -> Iterator[Block]:
    """v, A and D at places; where the speed varies A follows from that of an even turn."""
    turning = of.of.task.turning is not None
    kind = of.of.kind
    words = _words(of) | {"A": "A_0" if turning else "A"}
    yield from lines([*PITCH[kind], ROLLING[kind]], places, words) if places else ()
    for sign in (1, -1) if turning else ():
        own = [place for place in places if (number_of(place.lexicon, "R") >= 0) == (sign > 0)]
        yield from lines([TURNING], own, words | {"g": "-" if sign > 0 else "+"}) if own else ()
    yield from lines([SLIP], places, words) if places else ()


def _words(of: Judging) -> dict[str, str]:
    """Signs that the sense of the rocker makes."""
    against = of.found.follower.assembly < 0
    return {**of.of.words, "t": "" if against else "-", "a": "-" if against else ""}


def contact(of: Judging, steel: CamMaterialTable | None) -> Iterator[Block]:
    """sigma_H where it is largest (5.86 to 5.90), and where its limit comes from."""
    worst = of.margin("contact stress")
    if worst is None or worst.phi is None or worst.value is None:
        return
    yield Heading(tr("Contact stress"), 3)
    if steel is not None:
        yield from _permissible(steel)
    place = of.of.where(worst.phi, worst.value, lambda found: _stress_at(of, found))
    yield Paragraph(tr("The contact stress is largest {where}:", where=place))
    there = of.of.found(worst.phi, worst.value, lambda found: _stress_at(of, found))
    asked = [] if of.found.stress is None else _asked(of)
    yield from _stressed(of, [*asked, Place(at_angle(worst.phi), of.at(there, stress=worst.value))])


def _rows(of: Judging) -> list[Place]:
    """The positions that are shown, where the roller is on the cam."""
    return [of.row(row) for row in of.of.told.rows if of.found.touching[row]]


def _asked(of: Judging) -> list[Place]:
    """Those that are asked for; else the place where a value is largest is enough."""
    return _rows(of) if of.of.told.asked else []


def at_angle(phi: float) -> str:
    """A place of a line by its angle."""
    return tr("at φ = {angle}°", angle=degrees_of(phi))


def _stress_at(of: Judging, found: Found) -> np.ndarray:
    """sigma_H at points."""
    follower, force = of.found.follower, found.now.contact
    width, modulus = of.needs.width or 1.0, of.needs.modulus
    curvature = contact_curvature(follower, found.points.motion)
    if follower.kind == "flat":
        return np.asarray(flat_stress(force, 1 / curvature, width, modulus)[0])
    return np.asarray(contact_stress(force, curvature, follower.roller, width, modulus)[0])


def _stressed(of: Judging, places: Sequence[Place]) -> Iterator[Block]:
    """The curvature that is pressed, and the stress; on the outer wall of a groove it bulges the other way."""
    if of.of.kind == "flat":
        yield from lines(["rho = S + S''", f"sigma_H = {HERTZ:g}*sqrt(E_n*R/(b*rho))"], places)
        return
    words = _words(of)
    yield from lines(PITCH[of.of.kind], places, words)
    yield from lines(CURVATURE[of.of.kind], places, words)
    for sign in (1, -1):
        own = [place for place in places if (number_of(place.lexicon, "R") >= 0) == (sign > 0)]
        side = "-" if sign > 0 else "+"
        text = f"sigma_H = {HERTZ:g}*sqrt(E_n*abs(R)/(b*r_2*(1 {side} kappa*r_2)))"
        yield from lines([text if sign < 0 else text.replace("abs(R)", "R")], own, words) if own else ()


def _permissible(steel: CamMaterialTable) -> Iterator[Block]:
    """[sigma_H] by the tables of gears: the limit of endurance and the safety of a steel."""
    found = contact_endurance(steel.treatment, steel.hardness, steel.failure)
    own = {each.told.symbol: each for each in found.factors if each.told.symbol in ("sigma_Hlim", "S_H", "sigma_HP")}
    yield Paragraph(
        tr(
            "The permissible contact stress is that of the softer steel, {treatment}, of hardness {hardness}, with "
            "the values of table {tab:cam_steel}:",
            treatment=tr_name(steel.treatment),
            hardness=steel.hardness,
        )
    )
    rows = []
    for symbol, unit, scale in (("sigma_Hlim", "MPa", 1e-6), ("S_H", "", 1.0)):
        factor = own[symbol]
        meaning = factor_lexicon(symbol, factor)[canonical(letter(symbol))].meaning
        value = f"{tr_number(significant(scale * factor.told.value, RESULT))} {tr_unit(unit)}".strip()
        rows.append((meaning, f"${letter(symbol)}$", value, source_of(factor)))
    head = tr("Quantity"), tr("Designation"), tr("Value"), tr("Source")
    yield Table(tr("Values from tables"), head, tuple(rows), "cam_steel")
    for symbol in ("sigma_Hlim", "sigma_HP"):
        factor = own[symbol]
        if factor.formula:
            text = f"{letter(symbol)} = {noted(factor.formula)}"
            yield from lines([text], [Place("", factor_lexicon(symbol, factor))])
