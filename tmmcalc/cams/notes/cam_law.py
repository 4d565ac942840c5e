"""The chapter on cams, its first part: what is given, the law of motion by phases, constants, table, diagrams."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import degrees

import numpy as np

from tmmcalc.cams.lawresult import LawResult, PhaseMotion, Shock
from tmmcalc.cams.laws.constants import LawConstants
from tmmcalc.cams.laws.details import phase_laws
from tmmcalc.cams.laws.graphical import constructed
from tmmcalc.cams.laws.law import ORDERS, Law
from tmmcalc.cams.notes import laws
from tmmcalc.cams.notes.lexicon import Told, of_motion, of_task, shown_unit, table_rows, told_of
from tmmcalc.cams.pictures.cam_law import draw_portrait
from tmmcalc.cams.pictures.integration import INTERVALS, draw_integration, integration_heading
from tmmcalc.cams.pictures.lawdiagrams import draw_laws, shown_scale, symbol, unit_of
from tmmcalc.cams.pictures.wording import sense_of
from tmmcalc.cams.program import PhaseKind
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.manuscript import Block, Display, Figure, Heading, Lexicon, Paragraph, Place, Table
from tmmcalc.report.telling import WIDE, filled, lines, named, tabulated, titled

PART = {"rise": ("k = phi/phi_y",), "return": ("phi_e = phi_y + phi_d + phi_c", "k = (phi_e - phi)/phi_c")}
MOTION = {
    "rise": ("<dy> = <h>*s", "<y>' = <h>*s'/phi_y", "<y>'' = <h>*s''/phi_y**2"),
    "return": ("<dy> = <h>*s", "<y>' = -<h>*s'/phi_c", "<y>'' = <h>*s''/phi_c**2"),
}
RATES = {  # by whether the follower turns
    False: ("<v> = <y>'*<wn>*10**(-3)", "<a> = <y>''*<wn>**2*10**(-3)"),
    True: ("<v> = <y>'*<wn>", "<a> = <y>''*<wn>**2"),
}
PEAKS = {
    "rise": ("<y>'_{max} = C_v*<h>/phi_y", "<y>''_{max} = C_a*<h>/phi_y**2", "<y>''_{min} = -<C>*<h>/phi_y**2"),
    "return": ("<y>'_{min} = -C_v*<h>/phi_c", "<y>''_{max} = C_a*<h>/phi_c**2", "<y>''_{min} = -<C>*<h>/phi_c**2"),
}
NAMES = (4.0, 4.0, 2.0, 2.0)  # room that names of axes take around the phase portrait [mm]
ROWS = 40  # pieces of a law that are listed
LIKE = 1e-9  # of the largest: a law that brakes as hard as it speeds up
DIAGRAMS, CONSTRUCTION = (WIDE, 138.0), (WIDE, 160.0)  # sizes of the pictures [mm]
PORTRAIT = {True: (WIDE, 66.0), False: (80.0, 72.0)}  # by whether the follower turns; a stem has one scale


def blocks(order: Order) -> Iterator[Block]:
    """What is given, the law by its phases, the table, the diagrams."""
    told = told_of(order)
    yield Heading(tr("Given data of the cam mechanism"))
    yield from _given(told)
    yield Heading(tr("Law of motion of the follower"))
    yield from _phases(told)
    yield from _course(told)


def _given(told: Told) -> Iterator[Block]:
    """The kind of the mechanism in a sentence, its motion as a table."""
    said = "; ".join(f"{what} – {text}" for what, text in described(told))
    yield Paragraph(tr("The cam mechanism: {said}.", said=said))
    rows: list[tuple[str, ...]] = []
    given = told.named(of_task(told))
    for name, each in given.items():
        assert isinstance(each.value, float)
        if each.unit == "rad":
            value = f"{_short(degrees(each.value))} ({_short(each.value)})"
            rows.append((each.meaning, f"${name}$", "° (rad)".replace("rad", shown_unit("rad")), value))
        else:
            rows.append((each.meaning, f"${name}$", shown_unit(each.unit), _short(each.value)))
    yield Paragraph(tr("Its motion is given in table {tab:cam_given}."))
    head = tr("Quantity"), tr("Designation"), tr("Unit"), tr("Value")
    yield Table(tr("Given data of the motion"), head, tuple(rows), key="cam_given")


def described(told: Told) -> Iterator[tuple[str, str]]:
    """The kind of the mechanism: follower, senses, closure, each with what it is."""
    follower = told.follower
    kinds = {
        "translating": tr("translating, with a roller"),
        "oscillating": tr("oscillating, with a roller"),
        "flat": tr("translating, with a flat face"),
    }
    yield tr("follower"), kinds[follower.kind]
    yield tr("sense in which the cam turns"), sense_of(follower)
    if told.turns:
        turn = tr("with the cam") if follower.assembly > 0 else tr("against the cam")
        yield tr("sense of the rocker on its rise"), turn
    closures = {"force": tr("by force"), "groove": tr("by a groove")}
    yield tr("closure of the higher pair"), closures[told.task.asked.closure]


def laws_described(told: Told) -> Iterator[tuple[str, str]]:
    """The laws of rise and return, once where they are one."""
    rise, back = (laws.title(_law(told, phase.kind)) for phase in _moving(told))
    if rise == back:
        yield tr("law of motion of rise and return"), rise
    else:
        yield tr("law of motion of the rise"), rise
        yield tr("law of motion of the return"), back


def _short(value: float) -> str:
    """A number of a table."""
    return spelt(significant(value, 7))


def _moving(told: Told) -> list[PhaseMotion]:
    return [phase for phase in told.law.phases if phase.constants is not None]


def _law(told: Told, kind: PhaseKind) -> Law:
    found = next(phase.law for phase in told.task.program.phases if phase.kind == kind)
    assert found is not None
    return found


def _phases(told: Told) -> Iterator[Block]:
    """The law of the rise and of the return: its formulas and constants once, then what they give in its phase."""
    yield Paragraph(
        tr(
            "The law of motion is given by dimensionless functions of the part $k$ of the phase: the displacement $s$ "
            "in parts of the stroke, its derivatives $s'$ and $s''$ by $k$. On the rise $k$ runs from 0 to 1, on the "
            "return from 1 to 0."
        )
    )
    said: list[Law] = []
    for phase in _moving(told):
        law = _law(told, phase.kind)
        yield Heading(tr("Rise") if phase.kind == "rise" else tr("Return"), 3)
        alike = any(law is each for each in said)
        yield from _formulas(law, phase.kind, alike)
        yield from _worked(told, phase, law)
        yield from _constants(told, phase, law, alike)
        said.append(law)


def _formulas(law: Law, kind: PhaseKind, alike: bool) -> Iterator[Block]:
    """Its pieces, each with its formulas in letters where there are several or they have coefficients."""
    if alike:
        yield Paragraph(tr("The law is that of the rise."))
        return
    yield Paragraph(tr("Law of motion: {law}.", law=laws.title(law)))
    if laws.written_out(law):
        yield from _coefficients(law, f"cam_pieces_{kind}")
        return
    found = laws.pieces_of(law)
    for piece in found if len(found) > 1 else ():
        ends = {"begin": significant(piece.begin, 5), "end": significant(piece.end, 5)}
        yield Paragraph(tr("For ${begin} <= k <= {end}$:", **ends))
        for name, text in zip(laws.ORDERS, piece.formulas, strict=True):
            yield Display(read(f"{name} = {text}"))


def _coefficients(law: Law, key: str) -> Iterator[Block]:
    """The table of the pieces of a law of one's own."""
    powers = laws.used(law)
    if law.count == 1:
        return
    if law.count > ROWS:
        yield Paragraph(tr("The law consists of {count} pieces with coefficients of their own.", count=law.count))
        return
    yield Paragraph(
        tr(
            "The law consists of pieces between points $k_j$; their coefficients are in table {tab}.",
            tab=f"{{tab:{key}}}",
        )
    )
    columns = {"$k_j$": law.breaks[:-1]} | {f"$c_{power}$": law.coefficients[:, power] for power in powers}
    labels = [str(number) for number in range(1, law.count + 1)]
    yield tabulated(tr("Pieces of the law of motion"), columns, labels, head=tr("Piece"), key=key)


def _at(told: Told, row: int) -> Lexicon:
    """The law in a row, angles in rad."""
    law, own = told.law, of_motion(told, row)
    phase = law.phases[law.phase[row]]
    motion = _law(told, phase.kind)
    number = _piece(told, row)
    k = float(law.part[row])
    s, first, second, _ = motion.at(np.array([k]), np.array([number]))[:, 0].tolist()
    found = {
        "phi": Given(float(law.positions.phi[row]), "rad", own["phi"].meaning),
        "phi_e": Given(law.phases[law.phase[row]].end, "rad", tr("angle of the cam at the end of the return")),
        "phi_d": Given(0.0, "rad"),
        **_of_part(k, s, first, second),
        **laws.coefficients(motion, number),
    }
    if told.turns:
        for name in ("<dy>", "<y>"):
            value = own[name].value
            assert isinstance(value, float)
            own[name] = own[name]._replace(value=float(np.radians(value)), unit="rad")
    return own | found


def _of_part(k: float, s: float, first: float, second: float) -> Lexicon:
    return {
        "k": Given(k, "", tr("part of the phase")),
        "s": Given(s, "", tr("displacement in parts of the stroke")),
        "s'": Given(first, "", tr("first derivative of this displacement by $k$")),
        "s''": Given(second, "", tr("second derivative of this displacement by $k$")),
    }


def _piece(told: Told, row: int) -> int:
    """The number of the piece of its law that a row is on."""
    return int(told.task.program.places[1][told.law.positions.piece[row]])


def _worked(told: Told, phase: PhaseMotion, law: Law) -> Iterator[Block]:
    """The shown positions of a phase."""
    rows = [row for row in told.rows if told.law.phases[told.law.phase[row]] is phase]
    if not rows:
        return
    common, found = of_task(told), laws.pieces_of(law)
    at = {row: Place(told.labelled(row), told.named(_at(told, row) | common)) for row in rows}
    places, words = [at[row] for row in rows], told.words
    yield from lines(PART[phase.kind], places, words)
    for number in dict.fromkeys(map(partial(_piece, told), rows)):
        own = [at[row] for row in rows if _piece(told, row) == number]
        texts = [f"{name} = {text}" for name, text in zip(laws.ORDERS, found[number].formulas, strict=True)]
        yield from lines(texts, own, words)
    yield from lines(MOTION[phase.kind], places, words)
    if told.task.loads is not None:
        yield from lines(RATES[told.turns], places, words)


def _constants(told: Told, phase: PhaseMotion, law: Law, alike: bool) -> Iterator[Block]:
    """The constants of the law, and with them the extremes of the derivatives in its phase."""
    found = phase.constants
    assert found is not None
    own, peaks = phase_laws(told.task.program, told.turns, None)[phase.kind]
    even = abs(own.rising + found.braking) <= LIKE * found.acceleration
    constants = _of_constants(found, own.rising, even)
    if not alike:
        yield Paragraph(tr("The constants of the law are the largest values of its derivatives:"))
        pieces = laws.pieces_of(law)
        sides = [("C_v", 1, found.velocity_at, ""), ("C_a", 2, own.rising_at, "")]
        sides += [] if even else [("C_b", 2, found.braking_at, "-")]
        for name, order, k, sign in sides:
            number = _piece_of(law, order, k, constants[name].value, sign)
            lexicon = named(constants | _of_part(k, 0.0, 0.0, 0.0) | laws.coefficients(law, number))
            text = pieces[number].formulas[order]
            yield from lines((f"{name} = {sign}({text})" if sign else f"{name} = {text}",), [_at_part(k, lexicon)])
    unit = "" if told.turns else "mm"
    factor = 1.0 if told.turns else 1e3
    word = "max" if phase.kind == "rise" else "min"
    values = {
        f"<y>'_{{{word}}}": Given(factor * peaks.slope, unit, _extreme_word(word, 1)),
        "<y>''_{max}": Given(factor * peaks.most, unit, _extreme_word("max", 2)),
        "<y>''_{min}": Given(factor * peaks.least, unit, _extreme_word("min", 2)),
    }
    lexicon = told.named(of_task(told) | constants | values)
    yield from lines(PEAKS[phase.kind], [Place("", lexicon)], {**told.words, "C": "C_a" if even else "C_b"})


def _of_constants(found: LawConstants, rising: float, even: bool) -> Lexicon:
    constants = {
        "C_v": Given(found.velocity, "", tr("largest first derivative of the law")),
        "C_a": Given(rising, "", tr("largest second derivative of the law")),
    }
    if not even:
        constants["C_b"] = Given(-found.braking, "", tr("least second derivative of the law, with the other sign"))
    return constants


def _at_part(k: float, lexicon: Lexicon) -> Place:
    return Place(tr("at k = {value}", value=tr_number(significant(k, 5))), lexicon)


def _piece_of(law: Law, order: int, k: float, value: object, sign: str) -> int:
    """The piece whose derivative has its extreme at k."""
    assert isinstance(value, float)
    wanted = -value if sign else value
    near = np.flatnonzero((law.breaks[:-1] <= k + LIKE) & (k - LIKE <= law.breaks[1:]))
    at = law.at(np.full(near.size, k), near)[order]
    return int(near[np.argmin(np.abs(at - wanted))])


def _extreme_word(word: str, order: int) -> str:
    words = {
        ("max", 1): tr("largest analogue of velocity in the phase"),
        ("min", 1): tr("least analogue of velocity in the phase"),
        ("max", 2): tr("largest analogue of acceleration in the phase"),
        ("min", 2): tr("least analogue of acceleration in the phase"),
    }
    return words[word, order]


def _course(told: Told) -> Iterator[Block]:
    """The table over the turn, the diagrams, their graphical integration."""
    law, task = told.law, told.task
    rows = table_rows(told, dwells=False)
    columns = {"$phi$, deg": np.degrees(law.positions.phi), "$k$": law.part}
    for k in range(3):
        unit = ("deg", "", "")[k] if told.turns else "mm"
        name = filled("<dy>" if k == 0 else "<y>" + "'" * k, told.words)
        columns[f"${name}$, {unit}".removesuffix(", ")] = shown_scale(law, k) * law.motion[k]
    if law.in_time is not None:
        for name, unit, values in zip(("<v>", "<a>"), ("/s", "/s^2"), law.in_time, strict=False):
            columns[f"${filled(name, told.words)}$, {'rad' if told.turns else 'm'}{unit}"] = values
    yield Heading(tr("Motion over the turn"), 3)
    yield Paragraph(
        tr(
            "Positions over the turn of the cam are in table {tab:cam_motion}, diagrams of the displacement and of its "
            "three derivatives in figure {fig:cam_law}."
        )
    )
    if any(not law.labels[row].isdecimal() for row in rows):
        yield Paragraph(tr("A position with a minus sign after its number is the state just before the jump there."))
    shown = {head: values[rows] for head, values in columns.items()}
    labels = [law.labels[row] for row in rows]
    yield tabulated(tr("Motion of the follower"), shown, labels, head=tr("Position"), key="cam_motion")
    yield from _shocks(told)
    signs = {"ordinate": symbol(law, 1), "abscissa": symbol(law, 0)}
    yield Paragraph(
        tr(
            "The phase portrait in figure {fig:cam_portrait} is the analogue of velocity over the displacement: the "
            "rise runs above the axis, the return below it."
        )
    )
    yield Figure(
        titled(tr("Diagrams of {names}", names=", ".join(f"${symbol(law, order)}$" for order in range(ORDERS)))),
        partial(draw_laws, program=task.program, result=law, orders=range(ORDERS)),
        DIAGRAMS,
        "cam_law",
    )
    portrait = partial(_draw_portrait, task=task, result=law)
    title = tr("Phase portrait ${ordinate}$(${abscissa}$)", **signs)
    yield Figure(titled(title), portrait, PORTRAIT[told.turns], "cam_portrait")
    yield Paragraph(tr("The graphical integration of the law is shown in figure {fig:cam_integration}."))
    made = constructed(task.program, INTERVALS)
    draw = partial(draw_integration, program=task.program, result=law, made=made)
    yield Figure(titled(integration_heading(law)), draw, CONSTRUCTION, "cam_integration")


def _draw_portrait(drawing: Drawing, box: Box, task: CamTask, result: LawResult) -> None:
    """The phase portrait with room for the names of its axes."""
    draw_portrait(drawing, box.inset(*NAMES), task, result)


def _shocks(told: Told) -> Iterator[Block]:
    """Where velocity and acceleration jump."""
    for order, said in (
        (1, tr("The velocity jumps, which is a rigid shock: {places}.")),
        (2, tr("The acceleration jumps, which is a soft shock: {places}.")),
    ):
        found = [shock for shock in told.law.shocks if shock.order == order]
        if found:
            yield Paragraph(said.replace("{places}", "; ".join(_jump(told, shock) for shock in found)))
    if not any(shock.order < 3 for shock in told.law.shocks):
        yield Paragraph(tr("Neither the velocity nor the acceleration jumps: the motion has no shocks."))


def _jump(told: Told, shock: Shock) -> str:
    """By how much, and at which angle."""
    value = shown_scale(told.law, shock.order) * shock.jump
    unit = unit_of(told.law, shock.order)
    name = f"${filled('<y>', told.words)}{chr(39) * shock.order}$"
    size = spelt(f"{value:+.5g}") + (f" {unit}" if unit and not told.turns else "")
    return tr("{name} by {size} at $phi$ = {angle}°", name=name, size=size, angle=spelt(f"{degrees(shock.phi):.6g}"))
