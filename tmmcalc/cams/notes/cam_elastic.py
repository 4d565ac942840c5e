"""The follower as one mass on an elastic train: natural frequency, what the law leaves of vibration, contact."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.cams.elastic import ElasticResult
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.turn import at_rows, loads_of, weight
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.notes.laws import named_title
from tmmcalc.cams.notes.lexicon import ANGLES, Told, degrees_of, mean_speed, mm, of_task, quantities_table, told_of
from tmmcalc.cams.notes.loaded.duhamel import integrals
from tmmcalc.cams.notes.loaded.quantities import ROCKER, STEM, listed
from tmmcalc.cams.pictures.cam_elastic import draw_spectra, draw_vibration
from tmmcalc.cams.pictures.wording import phase_name
from tmmcalc.cams.response import rate_of, residual, steady
from tmmcalc.cams.rounding import sides
from tmmcalc.cams.speed import constant_speed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Display, Figure, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import WIDE, column_of, filled, lines, named, plainly, tabulated

PERCENT = 100
TRAIN = ("m_e", "k_e", "zeta")  # what is given of the train
TURN, SPECTRA = (WIDE, 120.0), (WIDE, 85.0)  # sizes of the pictures [mm]
LOAD = "<P>_c = <O> + G - (<Q>_0 + c*<dy>) - m_e*a_x"
RIGID = "<P>_r = <O> + G - (<Q>_0 + c*<dy>) - m_e*a_y"
NAMES = {"rise": "y", "return": "c"}  # indices of the moving phases


def blocks(order: Order) -> Iterator[Block]:
    """The vibration of the follower of the spec."""
    told, result = told_of(order), order.results["cam_elastic"]
    scene = told.named(train_scene(told, result))
    yield Heading(tr("Vibration of the elastic follower"))
    yield Paragraph(
        tr(
            "The follower is one mass on an elastic train; $y$ is the displacement that the cam gives, $x$ that of the "
            "mass, with derivatives by time:"
        )
    )
    yield Display(read("m_e*x'' + 2*zeta*omega_0*m_e*(x' - y') + k_e*(x - y) = 0"))
    yield Paragraph(tr("The given data of the train are in table {tab:cam_train}."))
    yield quantities_table(tr("Given data of the elastic train"), TRAIN, scene, "cam_train")
    yield Paragraph(tr("Natural frequency, without the damping and with it, and its ratio to that of the cam:"))
    frequency = "omega_0 = sqrt(k_e/m_e)" if told.turns else "omega_0 = sqrt(10**3*k_e/m_e)"
    damped = ("omega_d = omega_0*sqrt(1 - zeta**2)",) * bool(result.damping)
    yield from lines([frequency, *damped, "f_e = omega_0/(2*pi)", "nu = omega_0/<wt>"], [Place("", scene)], told.words)
    yield from _phases(told, result, scene)
    yield from _peak(told, result, scene)
    yield from _laws(told, result)
    yield from _contact(told, result)
    yield from _pictures(told, result)


def train_scene(told: Told, result: ElasticResult) -> Lexicon:
    """The train, its frequencies, the speed."""
    rate = rate_of(result.frequency, result.damping)
    mass, stiffness = ("kg*m^2", "N*m/rad") if told.turns else ("kg", "N/mm")
    return (
        of_task(told)
        | mean_speed(told)
        | {
            "m_e": Given(
                result.mass,
                mass,
                tr("moment of inertia of the rocker") if told.turns else tr("mass on the elastic train"),
            ),
            "k_e": Given(
                result.stiffness if told.turns else 1e-3 * result.stiffness,
                stiffness,
                tr("stiffness of the elastic train"),
            ),
            "zeta": Given(result.damping, "", tr("damping as a part of the critical one")),
            "omega_0": Given(result.frequency, "rad/s", tr("natural angular frequency")),
            "omega_d": Given(rate.imag, "rad/s", tr("angular frequency of the damped vibration")),
            "f_e": Given(result.hertz, "Hz", tr("natural frequency of the train")),
            "nu": Given(result.multiple, "", tr("natural frequency over that of the cam")),
        }
    )


def _phases(told: Told, result: ElasticResult, scene: Lexicon) -> Iterator[Block]:
    """Time of each moving phase over the natural period, and the amplitude that it leaves."""
    task = told.task
    speed = constant_speed(loads_of(task).speed) if task.turning is None else task.turning
    course = steady(task.program, speed, result.frequency, result.damping)
    rate, unit, factor = rate_of(result.frequency, result.damping), "rad" if told.turns else "mm", _factor(told)
    moving = [
        (phase, begin, end)
        for phase, begin, end in zip(task.program.phases, task.program.starts, task.program.starts[1:], strict=False)
        if phase.law is not None
    ]
    yield Paragraph(
        tr(
            "From rest a phase leaves a free vibration. Its amplitude follows from the integrals $a_c$, $a_s$ of "
            "$y''*exp(-zeta*omega_0*(t_1 - t))$ times the cosine and the sine of $omega_d*(t_1 - t)$ over the phase, "
            "which ends at $t_1$:"
        )
    )
    for (phase, begin, end), found in zip(moving, result.phases, strict=True):
        first, last = (int(np.argmin(np.abs(course.panels.edges - x))) for x in (begin, end))
        time, i = float(course.time[last] - course.time[first]), NAMES[found.kind]
        alone = -(course.edges[last] - np.exp(rate * time) * course.edges[first])
        integral = tr("integral over the phase")
        values = {
            f"t_{i}": Given(time, "s", tr("time of the phase")),
            f"tau_{i}": Given(found.ratio, "", tr("time of the phase over the natural period")),
            f"a_c{i}": Given(factor * alone.real, f"{unit}/s", integral),
            f"a_s{i}": Given(factor * alone.imag, f"{unit}/s", integral),
            f"A_{i}": Given(factor * found.residual, unit, tr("amplitude after the phase, from rest")),
            "omega_d": scene["omega_d"]._replace(meaning=tr("angular frequency of the damped vibration")),
        }
        timed = (f"t_{i} = {ANGLES[phase.kind]}/<wt>",) if task.turning is None else ()
        name = phase_name(found.kind)
        place = Place(name, scene | named(values))
        yield from lines((*timed, f"tau_{i} = t_{i}*f_e"), [place], told.words)
        if task.turning is None and phase.law is not None:
            letter, back = canonical(told.words["h"]), found.kind == "return"
            first = found is result.phases[0]
            yield from integrals(phase.law, i, result.damping, place.lexicon, letter, back=back, first=first)
        yield from lines((f"A_{i} = sqrt(a_c{i}**2 + a_s{i}**2)/omega_d",), [place])
    yield Paragraph(tr("Table {tab:cam_residual} compares them with what is left in the steady motion, turn by turn."))
    yield _residual_table(told, result)


def _factor(told: Told) -> float:
    return 1.0 if told.turns else 1e3


def _residual_table(told: Told, result: ElasticResult) -> Table:
    unit, factor = ("rad", 1.0) if told.turns else ("mm", 1e3)
    columns = {
        "$tau$": [each.ratio for each in result.phases],
        f"$A$, {unit}": [factor * each.residual for each in result.phases],
        f"{tr('amplitude over the stroke')}, %": [PERCENT * each.relative for each in result.phases],
        f"{tr('amplitude in the steady motion')}, {unit}": [factor * each.steady for each in result.phases],
    }
    labels = [phase_name(each.kind) for each in result.phases]
    return tabulated(tr("Residual vibration"), columns, labels, head=tr("Phase"), key="cam_residual")


def _peak(told: Told, result: ElasticResult, scene: Lexicon) -> Iterator[Block]:
    """The largest acceleration of the mass, the force in the train, the load along the lift there."""
    yield Paragraph(
        tr(
            "In the steady motion the mass accelerates most at $phi$ = {angle}°, {times} times as much as the law asks "
            "anywhere; the force in the train is then",
            angle=degrees_of(result.peak_phi),
            times=plainly(abs(result.peak_response) / result.peak_given),
        )
    )
    rate, force = ("rad/s^2", "N*m") if told.turns else ("m/s^2", "N")
    values = {
        "a_max": Given(result.peak_response, rate, tr("largest acceleration of the mass")),
        "F_max": Given(result.train, force, tr("largest force in the train")),
    }
    yield from lines(["F_max = m_e*a_max"], [Place("", scene | named(values))])
    yield Result("F_{max}", values["F_max"])
    if not result.contact.judged:
        return
    words = {**told.words, **(ROCKER if told.turns else STEM)}
    lexicon = scene | _at_peak(told, result, words)
    yield Paragraph(
        tr(
            "Nearby, at $phi$ = {angle}°, the load along the lift is with the elastic train and with a rigid one",
            angle=degrees_of(_node(result)[1]),
        )
    )
    yield from lines([LOAD, RIGID], [Place("", lexicon)], words)


def _node(result: ElasticResult) -> tuple[int, float]:
    """The point of the curves where the mass accelerates most."""
    k = int(np.argmax(np.abs(result.response)))
    return k, float(result.phi[k])


def _at_peak(told: Told, result: ElasticResult, words: dict[str, str]) -> Lexicon:
    """The loads there; of both sides of a jump of the force that which is in the load."""
    k, phi = _node(result)
    loads = loads_of(told.task)
    spring = solve_spring(told.task, loads)
    still = float(result.load[k] + result.mass * result.response[k])
    points = at_rows(told.task, loads, sides(told.task.program, np.array([phi])))
    elastic = spring.preload + spring.stiffness * points.motion[0]
    side = int(np.argmin(np.abs(points.force - elastic - still)))
    unit, rate, stiffness = ("N*m", "rad/s^2", "N*m/rad") if told.turns else ("N", "m/s^2", "N/mm")
    own = weight(told.task, loads)
    lift = tr("displacement of the follower from its lowest position")
    found = {
        "<P>_c": Given(float(result.load[k]), unit, tr("load along the lift with the elastic train")),
        "<P>_r": Given(float(result.rigid[k]), unit, tr("load along the lift with a rigid train")),
        "<O>": Given(float(points.force[side]) - own, unit, tr("technological load")),
        "G": Given(own, "N", tr("weight of the follower along the lift")),
        "<Q>_0": Given(spring.preload, unit, tr("preload of the spring in the lowest position")),
        "c": Given(spring.stiffness / _factor(told), stiffness, tr("stiffness of the return spring")),
        "<dy>": Given(float(result.lift[k]), "rad", lift) if told.turns else mm(float(result.lift[k]), lift),
        "a_x": Given(float(result.response[k]), rate, tr("acceleration of the mass")),
        "a_y": Given(float(result.given[k]), rate, tr("acceleration that the cam gives")),
    }
    return named({filled(name, words): given for name, given in found.items()})


def _laws(told: Told, result: ElasticResult) -> Iterator[Block]:
    """What the laws leave at the ratio of the rise."""
    ratio = result.phases[0].ratio
    own = {phase.law.name: phase.law for phase in told.task.program.phases if phase.law is not None}
    rows = []
    for each in result.spectra:
        law = own.get(each.law) or LAWS[each.law]
        rows.append((float(residual(law, np.array([ratio]), result.damping)[0]), named_title(each.law)))
    rows.sort()
    yield Paragraph(
        tr(
            "Table {tab:cam_laws} shows what other laws would leave after a rise of the same time, $tau_y$ = {ratio}.",
            ratio=plainly(ratio),
        )
    )
    values = column_of([PERCENT * size for size, _ in rows])
    head = (tr("Law of motion"), f"{tr('amplitude over the stroke')}, %")
    cells = tuple(zip([law for _, law in rows], values, strict=True))
    yield Table(tr("Residual vibration of the laws"), head, cells, "cam_laws")


def _contact(told: Told, result: ElasticResult) -> Iterator[Block]:
    """Whether vibration parts the follower from the cam."""
    contact = result.contact
    if contact.closure == "groove":
        yield Paragraph(
            tr(
                "Both walls hold the roller; with the elastic train it goes to the other wall {count} times a turn.",
                count=len(contact.reversals),
            )
        )
        return
    if not contact.judged:
        return
    if contact.lost:
        yield Paragraph(tr("Vibration parts the follower from the cam {where}.", where=listed(contact.lost)))
        also = tr("A follower on a rigid train leaves it too.") if contact.rigid else tr("On a rigid train it stays.")
        yield Paragraph(also)
    else:
        yield Paragraph(tr("In spite of the vibration the follower stays on the cam all over the turn."))
    unit = "N*m" if told.turns else "N"
    letter = "M_{c,max}" if told.turns else "P_{c,max}"
    largest = Given(contact.largest, unit, tr("largest load along the lift, which has to press on the cam"))
    yield Result(letter, largest, 0.0, "<=")


def _pictures(told: Told, result: ElasticResult) -> Iterator[Block]:
    """Acceleration and load over the turn; what the laws leave by the ratio of the times."""
    yield Paragraph(
        tr(
            "Figure {fig:cam_vibration} shows acceleration and load over the turn, figure {fig:cam_spectra} the "
            "residual vibration of the laws."
        )
    )
    draw = partial(draw_vibration, task=told.task, result=result)
    yield Figure(tr("Vibration of the follower over the turn"), draw, TURN, "cam_vibration")
    spectra = partial(draw_spectra, result=result)
    yield Figure(tr("Residual vibration after a rise from rest"), spectra, SPECTRA, "cam_spectra")
