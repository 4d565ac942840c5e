"""The chapter on a dyad by itself: the states of its outer joints, then its links by the formulas of its kind."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Point
from tmmcalc.linkage.dyad import DyadMotion
from tmmcalc.linkage.dyads.base import Rates
from tmmcalc.linkage.dyadstate import DyadState, DyadTask, dyad_of, motion_of, ports_of
from tmmcalc.linkage.notes import points
from tmmcalc.linkage.notes.group import GroupAt, length, one_number, point_quantities, signs_of
from tmmcalc.linkage.notes.told import DYADS
from tmmcalc.linkage.pictures.dyad import draw_dyad
from tmmcalc.linkage.quality import MODEST
from tmmcalc.linkage.solvers import closed
from tmmcalc.linkage.tables.dyad import METRIC
from tmmcalc.linkage.tables.tasks.dyad import to_dyad
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Display, Figure, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import WIDE, cell, column_of, data_of, data_table, filled, lines, named, quantities

LINKS = {"a": "a", "b": "b", "f": "1", "g": "2"}
LETTERS = "ADBCEGHJKLMN"  # of which the joints have the first ones that no point has
HIGH = 105.0  # of a picture [mm]
EQUATIONS = {  # the velocities as vectors; the accelerations have normal, tangential and Coriolis parts
    "RRR": (
        "vec(v_<B>) = vec(v_<P>) + vec(v_{<B><P>}) = vec(v_<Q>) + vec(v_{<B><Q>})",
        "vec(a_<B>) = vec(a_<P>) + vec(a_{<B><P>}^n) + vec(a_{<B><P>}^t)"
        " = vec(a_<Q>) + vec(a_{<B><Q>}^n) + vec(a_{<B><Q>}^t)",
    ),
    "RRP": (
        "vec(v_<B>) = vec(v_<P>) + vec(v_{<B><P>}) = vec(v_<B>^e) + vec(v_{<b><g>})",
        "vec(a_<B>) = vec(a_<P>) + vec(a_{<B><P>}^n) + vec(a_{<B><P>}^t)"
        " = vec(a_<B>^e) + vec(a_{<b><g>}) + vec(a_{<b><g>}^K)",
    ),
    "RPR": (
        "vec(v_<P>) = vec(v_<Q>) + vec(v_{<P><Q>}) + vec(v_{<a><b>})",
        "vec(a_<P>) = vec(a_<Q>) + vec(a_{<P><Q>}^n) + vec(a_{<P><Q>}^t) + vec(a_{<a><b>}) + vec(a_{<a><b>}^K)",
    ),
    "PRP": (
        "vec(v_<B>) = vec(v_<B>^{e<a>}) + vec(v_{<a><f>}) = vec(v_<B>^{e<b>}) + vec(v_{<b><g>})",
        "vec(a_<B>) = vec(a_<B>^{e<a>}) + vec(a_{<a><f>}) + vec(a_{<a><f>}^K)"
        " = vec(a_<B>^{e<b>}) + vec(a_{<b><g>}) + vec(a_{<b><g>}^K)",
    ),
    "RPP": (
        "vec(v_<P>) = vec(v_<P>^e) + vec(v_{<b><g>}) + vec(v_{<a><b>})",
        "vec(a_<P>) = vec(a_<P>^e) + vec(a_<P>^K) + vec(a_{<b><g>}) + vec(a_{<a><b>})",
    ),
}
FOOT = (  # the point of the guide from which those of the slider of an RPP are counted
    (
        "x_{<O>} = x_{<Q>} + s_<b>*cos(gamma_<b>)",
        "y_{<O>} = y_{<Q>} + s_<b>*sin(gamma_<b>)",
    ),
    (
        "v_{<O>x} = v_{<Q>x} - omega_<g>*(y_{<O>} - y_{<Q>}) + v_{<b><g>}*cos(gamma_<b>)",
        "v_{<O>y} = v_{<Q>y} + omega_<g>*(x_{<O>} - x_{<Q>}) + v_{<b><g>}*sin(gamma_<b>)",
    ),
    (
        "a_{<O>x} = a_{<Q>x} - eps_<g>*(y_{<O>} - y_{<Q>}) - omega_<g>**2*(x_{<O>} - x_{<Q>})"
        " - 2*omega_<g>*v_{<b><g>}*sin(gamma_<b>) + a_{<b><g>}*cos(gamma_<b>)",
        "a_{<O>y} = a_{<Q>y} + eps_<g>*(x_{<O>} - x_{<Q>}) - omega_<g>**2*(y_{<O>} - y_{<Q>})"
        " + 2*omega_<g>*v_{<b><g>}*cos(gamma_<b>) + a_{<b><g>}*sin(gamma_<b>)",
    ),
)


class Alone(NamedTuple):
    """A dyad with its metric and the states of its joints, and what stands in its formulas."""

    task: DyadTask
    result: DyadState
    motion: DyadMotion
    kind: Any  # module of `tmmcalc.linkage.notes.dyads`
    at: GroupAt
    lexicon: Lexicon

    def lines(self, texts: Sequence[str], words: dict[str, str] | None = None) -> Iterator[Block]:
        """The formulas worked out."""
        yield from lines(texts, [Place("", self.lexicon)], {**self.at.places, **(words or {})})


class Axes(NamedTuple):
    """The axes in which points of a link are given: their origin, the angle of x, what they turn with."""

    origin: str
    angle: str
    turning: str


def blocks(order: Order) -> Iterator[Block]:
    """The metric and the outer joints, positions, velocities, accelerations, points, what the links do."""
    alone = alone_of(to_dyad(order.spec), order.results["dyad"])
    places = alone.at.places
    yield Heading(tr("Given data of the dyad"))
    yield from _given(alone)
    for heading, texts, order_ in (
        (tr("Positions"), alone.kind.POSITION, None),
        (tr("Velocities"), alone.kind.VELOCITY, 0),
        (tr("Accelerations"), alone.kind.ACCELERATION, 1),
    ):
        yield Heading(heading)
        if order_ is not None:
            yield Display(read(filled(EQUATIONS[alone.task.kind][order_], places)))
        yield from alone.lines(texts)
    yield from _points(alone)
    yield Heading(tr("Motion of the links"))
    yield from _results(alone)
    captions = tr("Dyad and velocities"), tr("Dyad and accelerations")
    yield Paragraph(tr("Figures {fig:dyad_v} and {fig:dyad_a} show the dyad to scale."))
    joints = {"first": places["P"], "second": places["Q"], "inner": places["B"]}
    for k, caption in enumerate(captions):
        draw = partial(draw_dyad, task=alone.task, result=alone.result, order=k, names=joints)
        yield Figure(caption, draw, (WIDE, HIGH), f"dyad_{'va'[k]}")


def alone_of(task: DyadTask, result: DyadState) -> Alone:
    """All quantities of a dyad by their names."""
    kind, dyad, motion = import_module(f"{DYADS}.{task.kind.lower()}"), dyad_of(task), motion_of(task)
    one, two = (_whole(port) for port in ports_of(task))
    placed: Any = dyad.place(one, two)
    placed = type(placed)(*map(one_number, placed))
    rates = Rates(*map(one_number, dyad.rates(one, two, placed, closed)))
    taken = {point.name for point in task.points}
    letters = [letter for letter in LETTERS if letter not in taken]
    places = {**LINKS, "P": letters[0], "Q": letters[1], "B": letters[2], "O": letters[3]}
    at = GroupAt(dyad, places | signs_of(dyad, letters[0], letters[1]), one, two, placed, rates)
    lexicon: Lexicon = {}
    for port, state, letter, link in zip((task.first, task.second), (one, two), letters, "12", strict=False):
        if isinstance(state, Point):
            lexicon |= named(point_quantities(letter, letter, state))
        lexicon |= named(_turning(link, port.omega, port.eps))
    for each in result.links:
        lexicon |= named(_turning(each.link, each.omega, each.eps))
    if motion.inner is not None:
        lexicon |= named(point_quantities(places["B"], places["B"], motion.inner))
    for key, given in named({filled(k, at.places): each for k, each in kind.quantities(at).items()}).items():
        lexicon.setdefault(key, given)
    return Alone(task, result, motion, kind, at, lexicon)


def _whole(port: Any) -> Any:
    """The state of a joint, its numbers as arrays of none."""
    return type(port)(*(np.asarray(part) for part in port))


def _turning(link: str, omega: float, eps: float) -> dict[str, Given]:
    return {
        f"omega_{link}": Given(omega, "rad/s", tr("angular velocity of link {link}", link=link)),
        f"eps_{link}": Given(eps, "rad/s^2", tr("angular acceleration of link {link}", link=link)),
    }


def data(order: Order) -> Iterator[Block]:
    """Which dyad it is, its metric, the states of its outer joints, the points of its links."""
    alone = alone_of(to_dyad(order.spec), order.results["dyad"])
    task, places = alone.task, alone.at.places
    yield _scene(alone)
    if "P" in task.kind:
        yield Paragraph(
            tr(
                "Offsets are positive to the left of the line from which they are; a slider is counted from the given "
                "point of its guide, along the angle $gamma$ of the guide with axis $x$."
            )
        )
    yield from data_of(_metric(alone))
    if alone.result.variant is not None:
        yield Datum(tr("assembly of the links"), text=_assembled(alone))
    yield from _ports(task, places["P"], places["Q"])
    for mark in task.points:
        axes = _axes(task.kind, mark.link, places)
        name = "".join(letter for letter in mark.name if letter.isalnum())
        words = {"point": name, "link": mark.link, "origin": axes.origin, "angle": axes.angle}
        said = tr("point {point} of link {link} from {origin}, along and across the direction ${angle}$", **words)
        yield Datum(said, (f"xi_{{{name}}}", f"eta_{{{name}}}"), (mark.x, mark.y), "m")


def _scene(alone: Alone) -> Paragraph:
    """The links and the joints."""
    task, places = alone.task, alone.at.places
    meet = tr("The links meet in the pin {pin}.", pin=places["B"]) if alone.motion.inner is not None else ""
    said = tr(
        "The dyad {kind} has the links a and b. The outer joint of a is {first}, that of b {second}; both move as "
        "given.",
        kind=task.kind,
        first=_joint(task.kind[0], places["P"], "1"),
        second=_joint(task.kind[2], places["Q"], "2"),
    )
    return Paragraph(f"{said} {meet}".strip())


def _metric(alone: Alone) -> Lexicon:
    letters = {"length_a": "l_a", "length_b": "l_b", "offset_a": "h_a", "offset_b": "h_b", "turn": "delta_b"}
    swapped = {"offset_a": "h_b"} if alone.task.kind == "RPR" else {}
    keys = [(letters | swapped).get(name, "") for name in METRIC[alone.task.kind]]
    return {key: alone.lexicon[key] for key in keys if key in alone.lexicon}


def _assembled(alone: Alone) -> str:
    """Which of the two assemblies it is."""
    words = {"first": alone.at.places["P"], "second": alone.at.places["Q"], "inner": alone.at.places["B"]}
    one, other = {
        "RRR": (
            tr("{inner} to the left of the line from {first} to {second}", **words),
            tr("{inner} to the right of the line from {first} to {second}", **words),
        ),
        "RRP": (
            tr("{inner} ahead of {first} along the guide", **words),
            tr("{inner} behind {first} along the guide", **words),
        ),
        "RPR": (
            tr("{first} ahead of {second} along the line of link b", **words),
            tr("{first} behind {second} along the line of link b", **words),
        ),
    }[alone.task.kind]
    return one if alone.task.variant > 0 else other


def _given(alone: Alone) -> Iterator[Block]:
    """What dyad it is, its metric, the states of the outer joints."""
    task, places = alone.task, alone.at.places
    yield _scene(alone)
    yield Paragraph(
        tr("Its dimensions are in table {tab:dyad_metric}, the states of its outer joints in table {tab:dyad_ports}.")
    )
    yield quantities(tr("Dimensions of the dyad"), _metric(alone), "dyad_metric", 7)
    yield data_table(tr("States of the outer joints"), _ports(task, places["P"], places["Q"]), "dyad_ports")
    if alone.result.variant is not None:
        yield Paragraph(
            tr(
                "Of the two assemblies variant {variant} is taken.",
                variant=f"{alone.result.variant:+d}".replace("-", "−"),
            )
        )


def _joint(letter: str, point: str, guide: str) -> str:
    if letter == "R":
        return tr("the pin {point}", point=point)
    return tr("a slider on the guide of link {link} through {point}", point=point, link=guide)


def _ports(task: DyadTask, first: str, second: str) -> Iterator[Datum]:
    """Place, velocity and acceleration of the outer joints, of guides their turning."""
    ports = (first, "1", task.first, task.kind[0]), (second, "2", task.second, task.kind[2])
    for point, guide, port, kind in ports:
        yield Datum(tr("place of joint {point}", point=point), (f"x_{point}", f"y_{point}"), port.point, "m")
        for letter, said, values, unit in (
            ("v", tr("velocity of joint {point}", point=point), port.velocity, "m/s"),
            ("a", tr("acceleration of joint {point}", point=point), port.acceleration, "m/s^2"),
        ):
            yield Datum(said, (f"{letter}_{{{point}x}}", f"{letter}_{{{point}y}}"), values, unit)
        if kind == "P":
            link = "ab"[guide == "2"]
            said = tr("angle of the guide of link {link}", link=link)
            yield Datum(said, (f"gamma_{link}",), (math.degrees(port.angle),), "deg")
            yield from data_of(_turning(guide, port.omega, port.eps))


def _points(alone: Alone) -> Iterator[Block]:
    """The points of the links that are asked for."""
    task, places = alone.task, alone.at.places
    if not task.points:
        return
    yield Heading(tr("Points of the links"))
    if task.kind == "RPP" and any(point.link == "b" for point in task.points):
        foot = alone.motion.b.point(0j)
        alone.lexicon.update(named(point_quantities(places["O"], places["O"], foot)))
        yield Paragraph(tr("Points of link b are given from the point {point} of its guide:", point=places["O"]))
        for texts in FOOT:
            yield from alone.lines(texts)
    for mark in task.points:
        axes = _axes(task.kind, mark.link, places)
        place = complex(mark.x, mark.y)
        state = (alone.motion.a if mark.link == "a" else alone.motion.b).point(place)
        name = "".join(letter for letter in mark.name if letter.isalnum())
        alone.lexicon.update(named(point_quantities(name, name, state)))
        own = {
            f"l_{{{axes.origin}{name}}}": length(
                abs(place), tr("distance between points {first} and {second}", first=axes.origin, second=name)
            ),
            f"alpha_{{{name}}}": Given(
                math.degrees(math.atan2(mark.y, mark.x)),
                "deg",
                tr("angle of {point} on link {link}", point=name, link=mark.link),
            ),
        }
        alone.lexicon.update(named(own))
        words = {"D": name, "O": axes.origin, "angle": axes.angle, "k": axes.turning}
        for texts in (points.POSITION, points.VELOCITY, points.ACCELERATION):
            yield from alone.lines(texts, words)


def _axes(kind: str, link: str, places: Any) -> Axes:
    """The axes of a link: with its own angle, that of its guide, or that of the link on which it slides."""
    outer = places["P"] if link == "a" else places["Q"]
    match kind, link:
        case "RRR", _:
            return Axes(outer, f"phi_{link}", link)
        case "RRP", "a":
            return Axes(outer, "phi_a", "a")
        case "RPR", _:
            return Axes(outer, "phi_b", "b")
        case "PRP", "a":
            return Axes(places["B"], "gamma_a", "1")
        case "RPP", "a":
            return Axes(outer, "gamma_b + delta_b", "2")
        case "RPP", _:
            return Axes(places["O"], "gamma_b", "2")
    return Axes(places["B"], "gamma_b", "2")


def _results(alone: Alone) -> Iterator[Block]:
    """Links and points in tables, the transmission angle, both assemblies."""
    result, places = alone.result, alone.at.places
    rows = [
        (
            each.link,
            *(cell(value) for value in (math.degrees(each.angle), each.omega, each.eps)),
        )
        for each in result.links
    ]
    head = tr("Link"), f"$phi$, {tr_unit('deg')}", f"$omega$, {tr_unit('rad/s')}", f"$eps$, {tr_unit('rad/s^2')}"
    yield Paragraph(tr("Table {tab:dyad_links} has the motion of the links."))
    yield Table(tr("Motion of the links"), head, tuple(rows), "dyad_links")
    for each in result.links:
        yield Result(f"omega_{each.link}", alone.lexicon[f"omega_{each.link}"])
        yield Result(f"eps_{each.link}", alone.lexicon[f"eps_{each.link}"])
    found = Given(math.degrees(result.transmission), "deg", tr("transmission angle of the dyad"))
    value = f"{cell(math.degrees(result.transmission))}°"
    yield Paragraph(tr("The transmission angle of the dyad is $mu$ = {value}.", value=value))
    yield Result("mu", found, math.degrees(MODEST), ">=")
    if result.assemblies:
        angles = [math.degrees(angle) for each in result.assemblies for angle in (each.angle_a, each.angle_b)]
        pinned = result.assemblies[0].x is not None
        cells = [
            (
                f"{each.variant:+d}".replace("-", "−") + (" *" if each.taken else ""),
                *column_of(angles[2 * k : 2 * k + 2]),
                *(column_of([each.x or 0.0, each.y or 0.0]) if pinned else ()),
            )
            for k, each in enumerate(result.assemblies)
        ]
        inner = (f"$x_{places['B']}$, {tr_unit('m')}", f"$y_{places['B']}$, {tr_unit('m')}") if pinned else ()
        heads = tr("Variant"), f"$phi_a$, {tr_unit('deg')}", f"$phi_b$, {tr_unit('deg')}", *inner
        yield Paragraph(tr("Table {tab:dyad_assemblies} has both assemblies; that which is taken has a star."))
        yield Table(tr("Assemblies of the dyad"), heads, tuple(cells), "dyad_assemblies")
