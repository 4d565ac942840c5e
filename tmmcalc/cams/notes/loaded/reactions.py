"""Forces along the lift, the reactions with friction, torques, jamming, work: at positions, over the turn."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from math import degrees

import numpy as np

from tmmcalc.cams.forces.results import ForceExtreme
from tmmcalc.cams.forces.turn import at_rows
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.notes.lexicon import angle, table_rows
from tmmcalc.cams.notes.loaded.quantities import Found, Loaded, listed, of_scene, shown_angle
from tmmcalc.cams.program import Positions
from tmmcalc.cams.rounding import sides
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, number_of, plainly, tabulated, two_sides

ALONG = (
    "<P>_j = -<m>*(<y>''*omega**2 + <y>'*eps)<k>",
    "<Q>_s = -(<Q>_0 + c*<dy>)",
    "<P>_c = <P>_j + <Q>_s + <O> + G",
)
EVEN = "<P>_j = -<m>*<y>''*<wn>**2<k>", ALONG[-1]  # of a shaft that turns evenly at the given speed
GUIDE = "H_1 = S_0 + <dy>_max + r_2 + Delta_g"
FLAT_GUIDE = "H_1 = S_0 + <dy>_max + Delta_g"
RATIO = {
    "translating": ("q = H_1 - S", "mu = f_T*abs(sin(theta))*(1 + 2*q/l)"),
    "flat": ("mu = 2*f_T*abs(S')/l",),
    "oscillating": ("mu = f_A*r_A/l_2",),
}
CONTACT = {  # <g>: friction opposes the motion
    "translating": "R = -P_c/(cos(theta)<g>)",
    "flat": "R = -P_c/(1<g>)",
    "oscillating": "R = -M_c*10**3/(l_2*(cos(theta)<g>))",
}
SUPPORTS = {
    "translating": ("N_2 = <+>R*sin(theta)*q/l", "N_1 = <->R*sin(theta)*(1 + q/l)"),
    "flat": ("N_1 = <+>R*S'/l", "N_2 = <->R*S'/l"),
    "oscillating": ("R_Ax = -R*sin(psi - theta)", "R_Ay = <s>R*cos(psi - theta)", "R_A = sqrt(R_Ax**2 + R_Ay**2)"),
}
TORQUE = {
    "translating": ("T = P_c*S'/10**3", "M_d = R*cos(theta)*S'/10**3"),
    "flat": ("T = P_c*S'/10**3", "M_d = R*S'/10**3"),
    "oscillating": ("T = M_c*psi'", "M_d = R*l_2*cos(theta)*psi'/10**3"),
}
EFFICIENCY = {1: "eta = 1 - mu/cos(theta)", -1: "eta = 1/(1 + mu/cos(theta))"}  # follower driven, and driving
JUMP = 1e-9  # of the load: a smaller change is none
COLUMNS = 11  # of a table that is no broader than a page


def reactions(of: Loaded) -> Iterator[Block]:
    """The guide, then the positions with their formulas in the order in which one needs the other."""
    result = of.result
    yield Heading(tr("Reactions and torque"), 3)
    yield from _guide(of)
    places = [of.at_row(row) for row in of.told.rows]
    yield Paragraph(
        tr("Inertia, spring and technological moment add up about the pivot:")
        if of.turns
        else tr("Inertia, spring, technological force and weight add up along the lift:")
    )
    yield from of.lines(ALONG, places)
    yield Paragraph(_friction_said(of))
    yield from of.lines(RATIO[of.kind] if of.carried.rubs else (), places)
    yield from pressed(of, places)
    if result.guide is not None or of.turns:
        yield from of.lines(_signed(of, SUPPORTS[of.kind]), places)
    torque, driving = TORQUE[of.kind]
    yield from of.lines((torque, driving if of.carried.rubs else "M_d = -T"), places)
    yield from _efficiency(of, places)
    yield from _jamming(of)


def _lifting(of: Loaded) -> list[int]:
    """1 where friction adds to what the cam has to press with, -1 where it takes of it, 0 without; at the rows."""
    rows = of.told.rows
    sense = [float(of.points(row).sense[0]) for row in rows]
    load = of.result.load
    signs = [-own if load[row] > 0 else own for own, row in zip(sense, rows, strict=True)]
    return [round(sign) if of.carried.rubs else 0 for sign in signs]


def _friction_said(of: Loaded) -> str:
    if not of.carried.rubs:
        return tr("Without friction the force of the cam is")
    if of.turns:
        return tr("Friction in the pivot opposes the motion of the rocker:")
    return tr("Friction at both edges of the guide opposes the motion of the follower:")


def pressed(of: Loaded, places: Sequence[Place]) -> Iterator[Block]:
    """R at the rows where friction is to be overcome, then where it helps, or there is none."""
    for way, word in ((1, " - mu"), (-1, " + mu"), (0, "")):
        own = [place for place, lifting in zip(places, _lifting(of), strict=True) if lifting == way]
        yield from of.lines([CONTACT[of.kind].replace("<g>", word)], own)


def _signed(of: Loaded, texts: Sequence[str]) -> list[str]:
    """Reactions along the user's axes: a cam that turns the other way is the mirror image."""
    plus, minus = ("", "-") if of.result.follower.sense > 0 else ("-", "")
    side = "-" if of.result.follower.sense * of.result.follower.assembly > 0 else ""
    return [text.replace("<+>", plus).replace("<->", minus).replace("<s>", side) for text in texts]


def _guide(of: Loaded) -> Iterator[Block]:
    """H1, H2 and l."""
    guide = of.result.guide
    if guide is None:
        return
    place = [Place("", of.named(of_scene(of)))]
    yield Paragraph(
        tr("The guide begins above the roller in its highest position:")
        if of.kind == "translating"
        else tr("The guide begins above the face in its highest position:")
    )
    yield from of.lines([GUIDE if of.kind == "translating" else FLAT_GUIDE], place)
    yield from of.lines(["H_2 = H_1 + l" if of.task.guide.top is None else "l = H_2 - H_1"], place)


def _efficiency(of: Loaded, places: Sequence[Place]) -> Iterator[Block]:
    """What friction leaves of the torque, where there is some: the follower is driven, or drives the cam back."""
    if not of.carried.rubs:
        return
    driven: list[Place] = []
    driving: list[Place] = []
    for place, way in zip(places, _lifting(of), strict=True):
        torque, moment = number_of(place.lexicon, "T"), number_of(place.lexicon, "M_d")
        if not torque or not moment:
            continue
        parts = (-torque / moment, driven) if way > 0 else (-moment / torque, driving)
        value, into = parts
        said = tr("efficiency of the follower's motion")
        into.append(Place(place.name, place.lexicon | of.named({"eta": Given(value, "", said)})))
    flat = {way: text.replace("mu/cos(theta)", "mu") for way, text in EFFICIENCY.items()}
    texts = flat if of.kind == "flat" else EFFICIENCY
    if driven:
        yield Paragraph(tr("The camshaft moves the follower against the friction with the efficiency"))
        yield from of.lines([texts[1]], driven)
    if driving:
        yield Paragraph(tr("The spring moves the follower, which drives the cam with the efficiency"))
        yield from of.lines([texts[-1]], driving)


def _jamming(of: Loaded) -> Iterator[Block]:
    """The place where friction takes the largest part of the useful component, and the critical angle there."""
    reserve = of.result.reserve
    if not of.carried.rubs or not reserve.eaten:
        return
    said = tr("part of the useful component of $R$ that friction takes")
    lexicon = of.at(of.found(reserve.phi, reserve.useful, lambda found: found.now.cosine - found.now.ratio))
    place_said = of.where(reserve.phi, reserve.useful, lambda found: found.now.cosine - found.now.ratio)
    lexicon |= of.named({"chi": Given(reserve.eaten, "", said)})
    if reserve.critical is not None:
        lexicon["theta_cr"] = angle(reserve.critical, tr("pressure angle at which the follower would jam"))
    place = [Place("", lexicon)]
    yield Paragraph(
        tr(
            "The follower is nearest to jamming {where}; it would jam where friction takes all of the useful "
            "component, $chi = 1$:",
            where=place_said,
        )
    )
    yield from of.lines([*RATIO[of.kind], "chi = mu" if of.kind == "flat" else "chi = mu/cos(theta)"], place)
    if reserve.critical is not None:
        yield from of.lines(["theta_cr = acos(mu)" if of.turns else "theta_cr = atan(1/(f_T*(1 + 2*q/l)))"], place)
    yield Result("chi", lexicon["chi"], 1.0, "<=")


def course(of: Loaded) -> Iterator[Block]:
    """The forces in positions, in one table where it is no broader than a page, and extremes; contact and work."""
    yield Heading(tr("Forces over the turn"), 3)
    rows = table_rows(of.told)
    labels = [of.result.labels[row] for row in rows]
    first, second = _columns(of, rows)
    moved: dict[str, list[Values]] = {}  # by their units
    for name, values in (first | second).items():
        if not name.startswith("$phi"):
            moved.setdefault(name.partition("$, ")[2], []).append(values)
    jumping = [*two_sides(labels, moved.values()), *_jumps(of, rows)]
    if len(first | second) < COLUMNS:
        yield Paragraph(
            tr(
                "The forces in the positions $i$ are in table {tab:cam_loads}, their extremes over the turn in table "
                "{tab:cam_extremes}."
            )
        )
        yield from jumping
        yield tabulated(tr("Forces and torques"), first | second, labels, head="$i$", key="cam_loads")
    else:
        yield Paragraph(
            tr(
                "The forces in the positions $i$ are in tables {tab:cam_loads} and {tab:cam_reactions}, their extremes "
                "over the turn in table {tab:cam_extremes}."
            )
        )
        yield from jumping
        along = tr("Moments about the pivot of the rocker") if of.turns else tr("Forces along the lift")
        yield tabulated(along, first, labels, head="$i$", key="cam_loads")
        yield tabulated(tr("Reactions and torques"), second, labels, head="$i$", key="cam_reactions")
    yield _extremes(of)
    yield from _contact(of)
    yield from _work(of)


def _jumps(of: Loaded, rows: Sequence[int]) -> Iterator[Paragraph]:
    """Which side of a jump of the technological load between the ends of the turn a row has."""
    positions = of.result.positions
    inner = np.asarray(rows[1:-1], int)
    phi = positions.phi[inner]
    told = at_rows(of.task, of.loads, Positions(phi, positions.piece[inner], ())).force
    before, after = at_rows(of.task, of.loads, sides(of.task.program, phi)).force.reshape(2, -1)
    jumping = np.abs(after - before) > JUMP * np.max(np.abs((before, after)), initial=0.0)
    found = [of.result.labels[row] for row in inner[jumping & (told == after)]]
    if found:
        labels = ", ".join(found)
        yield Paragraph(
            tr(
                "Where the technological load jumps in a position (here {labels}), its value there is that after the "
                "jump.",
                labels=labels,
            )
        )


def _columns(of: Loaded, rows: Sequence[int]) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    result, words = of.result, of.words
    load, spring, own = words["P"], words["Q"], words["O"]
    unit = "N·m" if of.turns else "N"
    first = {
        "$phi$, deg": np.degrees(result.positions.phi),
        f"${load}_j$, {unit}": result.inertia,
        f"${spring}_s$, {unit}": result.elastic,
        f"${own}{'' if not of.loads.gravity else ' + G'}$, {unit}": result.force,
        f"${load}_c$, {unit}": result.load,
    }
    second = {"$phi$, deg": np.degrees(result.positions.phi)}
    if of.carried.rubs:
        second["$mu$"] = result.ratio
    if result.protrusion is not None:
        second["$q$, mm"] = 1e3 * result.protrusion
    second["$R$, N"] = result.contact
    if result.lower is not None and result.upper is not None:
        second |= {"$N_1$, N": result.lower, "$N_2$, N": result.upper}
    if result.pivot is not None:
        second |= {"$R_Ax$, N": result.pivot[0], "$R_Ay$, N": result.pivot[1]}
    if of.carried.rubs:  # else it is M_d with the other sign
        second["$T$, N·m"] = result.torque
    second["$M_d$, N·m"] = result.driving
    kept = ({name: np.asarray(values)[rows] for name, values in each.items()} for each in (first, second))
    filled, other = ({name: v for name, v in each.items() if v.any() or name.startswith("$phi")} for each in kept)
    return filled, other


NAMES = {"P_c": "P_c", "M_c": "M_c", "R": "R", "N1": "N_1", "N2": "N_2", "T": "T", "M_drive": "M_d"}
PICKS: Mapping[str, Callable[[Loaded, Found], Values]] = {
    "P_c": lambda of, found: found.now.load,
    "M_c": lambda of, found: found.now.load,
    "R": lambda of, found: found.now.contact,
    "N1": lambda of, found: of.result.follower.sense * found.now.lower,
    "N2": lambda of, found: of.result.follower.sense * found.now.upper,
    "T": lambda of, found: -found.now.torque,
    "M_drive": lambda of, found: found.now.driving,
}


def _extremes(of: Loaded) -> Table:
    """Least and largest values of the turn with their angles; without friction T is the driving torque turned back."""
    rows = [_extreme(of, each) for each in of.result.extremes if of.carried.rubs or each.name != "T"]
    head = (tr("Quantity"), tr("Least"), "$phi$, °", tr("Largest"), "$phi$, °")
    return Table(tr("Extremes over the turn"), head, tuple(rows), "cam_extremes")


def _extreme(of: Loaded, each: ForceExtreme) -> tuple[str, ...]:
    """A row: an extreme that a dwell keeps is at all of its angles."""
    low, high = column_of([each.least, each.largest])
    places = []
    for phi, value in ((each.least_phi, each.least), (each.largest_phi, each.largest)):
        dwell = of.dwell(phi, value, partial(PICKS[each.name], of))
        places.append("–".join(spelt(f"{round(degrees(at), 4) + 0.0:.6g}") for at in dwell or (phi,)))
    return f"${NAMES[each.name]}$, {tr_unit(each.unit)}", low, places[0], high, places[1]


def _contact(of: Loaded) -> Iterator[Block]:
    """Whether the follower stays on the cam, or goes from wall to wall; the largest force of the cam."""
    result = of.result
    if result.closure == "groove":
        if result.reversals:
            where = ", ".join(map(shown_angle, result.reversals))
            yield Paragraph(tr("The roller goes to the other wall of the groove at $phi$ = {where}.", where=where))
        else:
            yield Paragraph(tr("The same wall of the groove presses on the roller all over the turn."))
    elif result.lost:
        where = listed(result.lost)
        yield Paragraph(
            tr("Nothing presses the follower on the cam {where}: the closure of the pair is lost.", where=where)
        )
    else:
        yield Paragraph(tr("The follower stays on the cam all over the turn."))
    largest = result.extreme("R").size
    yield Result("R_{max}", Given(largest, "N", tr("largest force of the cam")))
    driving = result.extreme("M_drive").size
    yield Result("M_{d,max}", Given(driving, "N*m", tr("largest driving torque of the cam")))


def _work(of: Loaded) -> Iterator[Block]:
    """Energies of a turn, mean torque and power."""
    work = of.result.work
    if not work.given and not work.returned:
        return
    found: Lexicon = {
        "W_d": Given(work.driving, "J", tr("work of the camshaft in a turn")),
        "W_Q": Given(work.force, "J", tr("work of the technological force in a turn")),
        "W_g": Given(work.given, "J", tr("work that the camshaft gives to the follower in a turn")),
        "W_b": Given(-work.returned, "J", tr("work that the follower gives back to the camshaft in a turn")),
        "W_f": Given(work.friction, "J", tr("work of friction in a turn")),
        "M_m": Given(work.mean, "N*m", tr("mean driving torque")),
        "N_m": Given(work.power, "W", tr("mean power of the camshaft")),
    }
    if work.efficiency is not None:
        found["eta_m"] = Given(work.efficiency, "", tr("mean efficiency of the cam mechanism in a turn"))
    place = [Place("", of.named(of_scene(of) | found))]
    if not work.driving:
        yield Paragraph(
            tr(
                "In a turn the camshaft gives {given} J to the follower and gets as much back.",
                given=plainly(work.given),
            )
        )
        return
    yield Paragraph(tr("The work of the camshaft in a turn is what it gives to the follower less what it gets back:"))
    yield from of.lines(["W_d = W_g - W_b"], place)
    if work.friction and work.force:
        yield Paragraph(tr("Inertia, spring and weight give no work in a turn, so friction takes what is left:"))
    elif work.friction:
        yield Paragraph(tr("Inertia, spring and weight give no work in a turn, so friction takes all of it:"))
    elif work.force:
        yield Paragraph(tr("Inertia, spring and weight give no work in a turn, so the technological load takes it:"))
    yield from of.lines(["W_f = W_d + W_Q"] if work.friction else ["W_d = -W_Q"], place)
    if work.efficiency is not None:
        yield Paragraph(tr("Useful is the work done against the technological load:"))
        yield from of.lines(["eta_m = -W_Q/W_d"], place)
    yield from of.lines(["M_m = W_d/(2*pi)", "N_m = M_m*<wt>"], place)
