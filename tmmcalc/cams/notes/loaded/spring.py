"""The return spring: preload and stiffness by the way they are found, the safety that they reach, wire and coils.

Indices: M the largest lifting force, G the phase that asks for a stiffer spring, E the angle that asks for an exact
stiffness, t the touching tangent, r the least safety.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isclose

import numpy as np

from tmmcalc.cams.forces.coils import CLEARANCE, wahl
from tmmcalc.cams.forces.results import SpringFound, Wire
from tmmcalc.cams.forces.spring import DEFLECTION, lifting_force
from tmmcalc.cams.forces.turn import at_rows
from tmmcalc.cams.notes.lexicon import dwell_of, mm, where
from tmmcalc.cams.notes.loaded.quantities import Loaded, of_rate, of_scene, shown_angle
from tmmcalc.cams.pictures.wording import phase_name
from tmmcalc.cams.rounding import sides
from tmmcalc.cams.task import CamTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import tabulated

LIFTING = "<P>_<i> = G - <m>*(<y>''_<i>*omega**2 + <y>'_<i>*eps)<k>"
MEGA = 1e-6
SAME = 1e-9  # [rad] angles that are one
USUAL = 8  # D/d of the row of the table that is worked out


def spring_blocks(of: Loaded) -> Iterator[Block]:
    """How the spring is found, and what it reaches."""
    spring = of.result.spring
    if spring.method == "none" or not (spring.stiffness or spring.preload):
        yield from _none(of, spring)
        return
    yield Heading(tr("Return spring"), 3)
    if spring.method == "given":
        yield Paragraph(tr("Stiffness and preload of the spring are given."))
    elif spring.method == "preload":
        yield from _by_tangent(of, spring)
    else:
        yield from _by_safety(of, spring)
    yield from of.lines(["<Q>_max = <Q>_0 + c*<dy>_max"], [Place("", of.named(of_scene(of)))])
    yield from _reached(of, spring)
    for name in ("c", "<Q>_0"):
        yield Result(name.replace("<Q>", of.words["Q"]), of_scene(of)[name])
    yield from _wire(of, spring)
    yield from _sizes(of, spring)


def _none(of: Loaded, spring: SpringFound) -> Iterator[Block]:
    if of.task.asked.closure == "groove":
        yield Paragraph(tr("Both walls of the groove hold the roller; there is no spring."))
    elif spring.method == "safety":
        yield Paragraph(tr("Nothing lifts the follower off the cam, so no spring is needed."))
    else:
        yield Paragraph(tr("The follower has no spring."))


def _lifted(of: Loaded, task: CamTask, phi: float, force: float, index: str) -> Lexicon:
    """The lifting force, the displacement and what they follow from, at an angle with this index.

    Of both sides of a jump that is meant where the force is nearer.
    """
    points = at_rows(task, of.loads, sides(task.program, np.array([phi])))
    values = lifting_force(task, of.loads, points.acceleration)
    k = int(np.argmin(np.abs(values - force)))
    y, y1, y2 = points.motion[:3, k].tolist()
    speed, eps = of.loads.speed, 0.0
    if task.turning is not None:
        speed, eps = (float(each[0]) for each in task.turning.at(points.phi[k : k + 1]))
    unit, factor, own = ("", 1.0, "N*m") if of.turns else ("mm", 1e3, "N")
    shift = tr("displacement at this angle")
    found = of_scene(of) | {
        "omega": Given(speed, "rad/s", tr("angular velocity of the cam")),
        "eps": Given(eps, "rad/s^2", tr("angular acceleration of the cam")),
        f"<dy>_{index}": Given(y, "rad", shift) if of.turns else mm(y, shift),
        f"<y>'_{index}": Given(factor * y1, unit, tr("first derivative of the displacement at this angle")),
        f"<y>''_{index}": Given(factor * y2, unit, tr("second derivative of the displacement at this angle")),
        f"<P>_{index}": Given(force, own, tr("force that lifts the follower off, by inertia and weight")),
    }
    if of.turns:
        found[f"<P>_{index}"] = Given(force, own, tr("moment that lifts the rocker off, by inertia"))
    return of.named(found)


def _by_safety(of: Loaded, spring: SpringFound) -> Iterator[Block]:
    """Q0 and c at the largest lifting force (5.55 to 5.57), or the least c that keeps K1 all over the turn."""
    assert spring.lifting is not None
    assert spring.phi is not None
    task = of.task.sprung
    place = Place("", _lifted(of, task, spring.phi, spring.lifting, "M"))
    yield Paragraph(
        tr(
            "The spring has to keep the follower on the cam with the safety $K_1$ where inertia lifts it off most, "
            "without technological forces. That is on the {phase} at $phi$ = {angle}:",
            phase=phase_name(spring.phase),
            angle=shown_angle(spring.phi),
        )
    )
    yield from of.lines([LIFTING.replace("<i>", "M")], [place])
    lexicon, asked = dict(place.lexicon), spring.asked or 1.0
    if isclose(spring.preload, (asked - 1) * spring.lifting, rel_tol=1e-9):
        yield from of.lines(["<Q>_0 = (K_1 - 1)*<P>_M"], [place])
    else:
        largest = of.named({"<P>_0": Given(spring.preload / asked, "N*m" if of.turns else "N", "")})
        said = tr("largest lifting force in the lowest position")
        lexicon |= {name: given._replace(meaning=said) for name, given in largest.items()}
        yield Paragraph(tr("In the lowest position the preload alone has to hold the follower:"))
        yield from of.lines(["<Q>_0 = K_1*<P>_0"], [Place("", lexicon)])
    if of.loads.spring.exact:
        yield from _exact(of, spring, "c")
        return
    if spring.governing is None:
        yield from of.lines(["c = <P>_M/<dy>_M"], [place])
    else:
        yield from _governed(of, spring, place)
    if spring.exact is not None and not isclose(spring.exact, spring.stiffness, rel_tol=1e-9):
        yield Paragraph(tr("For comparison, the least stiffness that keeps $K_1$ at every angle with this preload:"))
        yield from _exact(of, spring, "c_e")


def _governed(of: Loaded, spring: SpringFound, place: Place) -> Iterator[Block]:
    """A smaller force of the other phase, which stands lower down, asks for a stiffer spring."""
    other = spring.governing
    assert other is not None
    said = tr("stiffness by the largest lifting force alone")
    lexicon = place.lexicon | of.named({"c_r": Given(of_rate(of, other.rule), _rate(of), said)})
    yield from of.lines(["c_r = <P>_M/<dy>_M"], [Place("", lexicon)])
    yield Paragraph(
        tr(
            "The {phase} lifts the follower off lower down, at $phi$ = {angle}, and asks for a stiffer spring:",
            phase=phase_name(other.phase),
            angle=shown_angle(other.phi),
        )
    )
    there = Place("", _lifted(of, of.task.sprung, other.phi, other.force, "G"))
    yield from of.lines([LIFTING.replace("<i>", "G"), "c = (K_1*<P>_G - <Q>_0)/<dy>_G"], [there])


def _exact(of: Loaded, spring: SpringFound, name: str) -> Iterator[Block]:
    """The least stiffness that keeps the safety at every angle, by the angle that asks for it."""
    if spring.exact is None or spring.exact_phi is None or not spring.exact:
        return
    task, phi = of.task.sprung, spring.exact_phi
    points = at_rows(task, of.loads, sides(task.program, np.array([phi])))
    force = float(np.max(lifting_force(task, of.loads, points.acceleration)))
    lexicon = _lifted(of, task, phi, force, "E")
    said = tr("least stiffness that keeps the safety at every angle")
    lexicon |= {name: Given(of_rate(of, spring.exact), _rate(of), said)}
    yield Paragraph(tr("The angle $phi$ = {angle} asks for the stiffness:", angle=shown_angle(phi)))
    yield from of.lines([LIFTING.replace("<i>", "E"), f"{name} = (K_1*<P>_E - <Q>_0)/<dy>_E"], [Place("", lexicon)])


def _by_tangent(of: Loaded, spring: SpringFound) -> Iterator[Block]:
    """The tangent from the point of the preload's deflection to the curve of P + F_min."""
    asked = of.loads.spring
    if spring.lifting is None or spring.phi is None:
        yield Paragraph(tr("Nothing lifts the follower off the cam, so no spring is needed."))
        return
    lexicon = _lifted(of, of.task.sprung, spring.phi, spring.lifting, "t")
    deflection = DEFLECTION * of.task.program.stroke if asked.deflection is None else asked.deflection
    said = tr("deflection of the spring in the lowest position")
    lexicon |= of.named(
        {
            "f_1": Given(deflection, "rad", said) if of.turns else mm(deflection, said),
            "F_min": Given(asked.least, "N*m" if of.turns else "N", tr("least load of the contact")),
        }
    )
    place = [Place("", lexicon)]
    yield Paragraph(
        tr(
            "The line of the spring over the displacement starts at $-f_1$ and touches the curve of the lifting force "
            "raised by the least load of the contact; it does so {where}:",
            where=_where(of, spring.phi),
        )
    )
    if asked.deflection is None:
        yield from of.lines([f"f_1 = {DEFLECTION:g}*<h>"], place)
    texts = (LIFTING.replace("<i>", "t"), "c = (<P>_t + F_min)/(f_1 + <dy>_t)", "<Q>_0 = c*f_1")
    yield from of.lines(texts, place)


def _reached(of: Loaded, spring: SpringFound) -> Iterator[Block]:
    """The least ratio of spring and lifting force over the turn."""
    if spring.reached is None or spring.reached_phi is None:
        return
    task, phi = of.task, spring.reached_phi
    points = at_rows(task, of.loads, sides(task.program, np.array([phi])))
    force = float(np.max(lifting_force(task, of.loads, points.acceleration)))
    known = spring.method == "safety" and task.turning is None and abs(phi - (spring.phi or 0.0)) < SAME
    index = "M" if known else "r"
    lexicon = _lifted(of, task, phi, force, index)
    lexicon["K_min"] = Given(spring.reached, "", tr("least safety of the closure over the turn"))
    yield Paragraph(tr("The safety is least {where}:", where=_where(of, phi)))
    texts = ("K_min = (<Q>_0 + c*<dy>_<i>)/<P>_<i>",) if known else (LIFTING, "K_min = (<Q>_0 + c*<dy>_<i>)/<P>_<i>")
    yield from of.lines([text.replace("<i>", index) for text in texts], [Place("", lexicon)])
    yield Result("K_min", lexicon["K_min"], spring.asked or 1.0, ">=")


def _where(of: Loaded, phi: float) -> str:
    """An angle of the lifting force, which a dwell keeps."""
    return where(phi, dwell_of(of.task.program, phi))


def _rate(of: Loaded) -> str:
    return "N*m/rad" if of.turns else "N/mm"


def _wire(of: Loaded, spring: SpringFound) -> Iterator[Block]:
    """Coils and stresses of a spring whose wire is given."""
    wire, asked = spring.wire, of.loads.spring
    if wire is None or asked.wire is None or asked.coil is None:
        return
    lexicon = of.named(of_scene(of) | _of_wire(wire))
    lexicon |= {"d": mm(asked.wire, tr("diameter of the wire")), "D": mm(asked.coil, tr("mean diameter of the coils"))}
    lexicon["E_G"] = Given(MEGA * asked.shear, "MPa", tr("shear modulus of the wire"))
    yield Paragraph(tr("The spring is wound of a wire that is given; its coils and shear stresses:"))
    texts = (
        "i_D = D/d",
        "k_w = (4*i_D - 1)/(4*i_D - 4) + 0.615/i_D",
        "n_c = E_G*d**4/(8*D**3*c)",
        "tau_max = 8*Q_max*D*k_w/(pi*d**3)",
        "tau_min = 8*Q_0*D*k_w/(pi*d**3)",
    )
    yield from of.lines(texts, [Place("", lexicon)])
    limit = None if asked.allowed is None else MEGA * asked.allowed
    yield Result("tau_max", lexicon["tau_max"], limit, "<=" if limit is not None else "")


def _of_wire(wire: Wire) -> Lexicon:
    return {
        "i_D": Given(wire.index, "", tr("ratio of the diameters of coils and wire")),
        "k_w": Given(wire.factor, "", tr("factor of the stress at the inside of the coils")),
        "n_c": Given(wire.coils, "", tr("number of working coils")),
        "tau_max": Given(MEGA * wire.stress, "MPa", tr("shear stress of the wire in the highest position")),
        "tau_min": Given(MEGA * wire.stress_low, "MPa", tr("shear stress of the wire in the lowest position")),
    }


def _sizes(of: Loaded, spring: SpringFound) -> Iterator[Block]:
    """The springs that have the allowed stress, one of them worked out."""
    asked = of.loads.spring
    if not spring.sizes or asked.allowed is None:
        return
    one = min(spring.sizes, key=lambda each: abs(each.index - USUAL))
    lexicon = of.named(of_scene(of)) | {
        "i_D": Given(one.index, "", tr("ratio of the diameters of coils and wire")),
        "tau_a": Given(MEGA * asked.allowed, "MPa", tr("permissible shear stress of the wire")),
        "E_G": Given(MEGA * asked.shear, "MPa", tr("shear modulus of the wire")),
        "n_d": Given(asked.dead, "", tr("number of coils at the ends that do not work")),
        "d": mm(one.wire, tr("diameter of the wire")),
        "D": mm(one.coil, tr("mean diameter of the coils")),
        "n_c": Given(one.coils, "", tr("number of working coils")),
        "L_0": mm(one.solid, tr("height of the spring with all coils in touch")),
        "L": mm(one.free, tr("height of the free spring")),
        "k_w": Given(wahl(one.index), "", tr("factor of the stress at the inside of the coils")),
    }
    yield Paragraph(
        tr(
            "The permissible shear stress leaves the springs of table {tab:cam_springs}, one for each ratio of coil "
            "and wire; for $i_D = {index}$:",
            index=f"{one.index:g}",
        )
    )
    texts = (
        "k_w = (4*i_D - 1)/(4*i_D - 4) + 0.615/i_D",
        "d = sqrt(8*Q_max*i_D*k_w/(pi*tau_a))",
        "D = i_D*d",
        "n_c = E_G*d/(8*i_D**3*c)",
        "L_0 = (n_c + n_d)*d",
        f"L = L_0 + {CLEARANCE:g}*d*n_c + Q_max/c",
    )
    yield from of.lines(texts, [Place("", lexicon)])
    columns = {
        "$d$, mm": [1e3 * each.wire for each in spring.sizes],
        "$D$, mm": [1e3 * each.coil for each in spring.sizes],
        "$n_c$": [each.coils for each in spring.sizes],
        "$L_0$, mm": [1e3 * each.solid for each in spring.sizes],
        "$L$, mm": [1e3 * each.free for each in spring.sizes],
    }
    labels = [f"{each.index:g}" for each in spring.sizes]
    yield tabulated(tr("Springs of the permissible stress"), columns, labels, head="$i_D$", key="cam_springs")
