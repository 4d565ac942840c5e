"""What is given of what acts on a linkage: masses, gravity, loads by their laws, springs, friction, the drive."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from tmmcalc.linkage.loading import Body, GearDrive, Load, Loading, Pair, Spring
from tmmcalc.linkage.loadlaws.law import Called, Coordinate
from tmmcalc.linkage.model import FRAME
from tmmcalc.linkage.notes.given.bases import Seen
from tmmcalc.linkage.notes.given.metric import coordinate_said, coordinates, degrees, place
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.statics.loaded import force_key, name_index, names_of, own_index
from tmmcalc.linkage.structure import Structure
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Datum

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables
    from tmmcalc.linkage.tables.loads import LoadTable

NEAR = 1e-9  # of the components of gravity [m/s^2]


def given_loads(spec: LinkageTables, seen: Seen, structure: Structure, *, metric: bool) -> Iterator[Datum]:
    """All of it; places that are told by the metric of the linkage only where that is given."""
    loading = to_loading(spec)
    for body in loading.bodies:
        yield from _body(seen, body, metric=metric)
    heavy, links = {body.link for body in loading.heavy}, [link.id for link in seen.mechanism.links if link.id != FRAME]
    if light := [str(link) for link in links if link not in heavy]:
        yield Datum(tr("links whose mass is neglected"), text=", ".join(light))
    yield from _gravity(loading.gravity)
    names = names_of(seen.mechanism, structure, loading)
    for table, load in zip(spec.loads, loading.loads, strict=True):
        yield from _load(seen, table, load, names[load.link, load.name, "load"], metric=metric)
    for spring in loading.springs:
        yield from _spring(seen, spring, metric=metric)
    yield from _pairs(seen, loading)
    if isinstance(loading.drive, GearDrive):
        yield from _drive(loading.drive)


def _body(seen: Seen, body: Body, *, metric: bool) -> Iterator[Datum]:
    """Mass, centre and moment of inertia of a link."""
    if body.mass:
        yield Datum(tr("mass of link {link}", link=body.link), (f"m_{body.link}",), (body.mass,), "kg")
        pin = seen.point_at(body.link, body.center)
        if pin is not None and not pin.centre:
            said = tr("centre of mass of link {link}", link=body.link)
            yield Datum(said, (f"S_{body.link}",), text=tr("in point {point}", point=plain_name(pin.name)))
        elif metric:
            yield from place(seen, body.link, f"S{body.link}", body.center)
    if body.inertia:
        said = tr("moment of inertia of link {link} about its centre of mass", link=body.link)
        yield Datum(said, (f"J_{body.link}",), (body.inertia,), "kg*m^2")


def _gravity(gravity: complex) -> Iterator[Datum]:
    """Gravity [m/s^2] and where it points."""
    if not gravity:
        return
    down = abs(gravity.real) < NEAR and gravity.imag < 0
    said = tr("acceleration of gravity, directed against axis $y$") if down else tr("acceleration of gravity")
    yield Datum(said, ("g",), (abs(gravity),), "m/s^2")
    if not down:
        yield Datum(tr("direction of gravity, from axis $x$"), (), (degrees(gravity),), "deg")


def _load(seen: Seen, table: LoadTable, load: Load, name: str, *, metric: bool) -> Iterator[Datum]:
    """The law of a load with its name in formulas, its factor, where along the motion and on what it acts."""
    called = tr("“{name}”", name=load.name)
    key, index = force_key(name), own_index(name)
    mechanism = seen.mechanism
    turns = mechanism.joint(mechanism.input.joint).kind == "revolute"
    outputs: dict[str | None, Coordinate] = {
        each: Coordinate(coordinate_said(mechanism, output), output.link is not None)
        for output in reversed(mechanism.outputs)
        for each in (None, output.name)
    }
    windowed = load.window is not None
    yield from load.law.given(table, Called(called, key, index, load.kind, turns, outputs, windowed, load.against))
    if "factor" in table.model_fields_set:
        yield Datum(tr("factor by which load {name} is multiplied", name=called), (f"k_{{{index}}}",), (load.factor,))
    yield from _window(table, load, called, outputs, turns=turns)
    yield from _applied(seen, load, called, metric=metric)
    role = {"drive": tr("drives the mechanism"), "neutral": tr("neither drives nor resists")}.get(load.role)
    if role is not None:
        yield Datum(tr("what load {name} does", name=called), text=role)


def _window(
    table: LoadTable, load: Load, called: str, outputs: Mapping[str | None, Coordinate], *, turns: bool
) -> Iterator[Datum]:
    """Where along the motion a load acts."""
    window = load.window
    if window is not None and window.angles is not None and turns:
        said = tr("where load {name} begins and ends, by the angle of the crank from the first position", name=called)
        yield Datum(said, ("phi",), tuple(map(math.degrees, window.angles)), "deg")
    elif window is not None and window.angles is not None:
        said = tr("where load {name} begins and ends, by the travel of the drive from the first position", name=called)
        yield Datum(said, ("Deltas",), window.angles, "m")
    elif window is not None and window.positions is not None:
        first, last = window.positions
        text = tr("from position {first} to position {last}", first=first, last=last)
        yield Datum(tr("where load {name} acts", name=called), text=text)
    elif window is not None:
        text = tr("on the working stroke") if window.stroke == "working" else tr("on the idle stroke")
        whose = outputs.get(window.output) if len(outputs) > 2 else None
        yield Datum(tr("where load {name} acts", name=called), text=f"{text}: {whose.said}" if whose else text)
    if table.period is not None:
        said = tr("angle of the crank after which load {name} comes back", name=called)
        yield Datum(said, (), (math.degrees(table.period),), "deg")


def _applied(seen: Seen, load: Load, called: str, *, metric: bool) -> Iterator[Datum]:
    """The link and the point on which a load acts, and along what it is positive."""
    link = tr("link {link}", link=load.link)
    where = tr("where load {name} is applied", name=called)
    if load.kind == "moment":
        yield Datum(where, text=link)
        yield Datum(tr("positive sense of load {name}", name=called), text=tr("counter-clockwise"))
    else:
        known = seen.point_at(load.link, load.point)
        name = name_index(load.name) if known is None else plain_name(known.name)
        yield Datum(where, text=tr("{link}, point {point}", link=link, point=name))
        if metric and known is None:
            yield from place(seen, load.link, name, load.point)
        yield _direction(seen, load, called, metric=metric)
    if load.against != FRAME:
        said = tr("link that takes the opposite of load {name}", name=called)
        yield Datum(said, text=tr("link {link}", link=load.against))


def _direction(seen: Seen, load: Load, called: str, *, metric: bool) -> Datum:
    """Along what a force is positive: from axis x, or from the line of the link with which it turns."""
    if load.follows == FRAME:
        said = tr("positive direction of load {name}, from axis $x$", name=called)
        return Datum(said, (), (degrees(load.direction),), "deg")
    base = seen.bases[load.follows]
    origin, turn = base.origin, base.angle(load.direction)
    if not metric:
        origin, turn = tr("from axis $x$ of link {link}", link=load.follows), degrees(load.direction)
    said = tr("positive direction of load {name}, {origin}, with which it turns", name=called, origin=origin)
    return Datum(said, (), (turn,), "deg")


def _spring(seen: Seen, spring: Spring, *, metric: bool) -> Iterator[Datum]:
    """A spring with its damper: what it joins, its stiffness, free length or angle, damping."""
    called, name = tr("“{name}”", name=spring.name), name_index(spring.name)
    index = f"s,{name}"  # of its letters, as no load has it
    linear = spring.kind == "linear"
    ends = ["", ""]
    for k, (link, at) in enumerate(zip(spring.links, spring.points, strict=True)):
        known = seen.point_at(link, at)
        ends[k] = f"{name}{k + 1}" if known is None else plain_name(known.name)
        if linear and known is None and link == FRAME:
            yield coordinates(tr("coordinates of point {point}", point=ends[k]), ends[k], at)
        elif linear and known is None and metric:
            yield from place(seen, link, ends[k], at)
    words = {"first": str(spring.links[0]), "second": str(spring.links[1])}
    if linear:
        text = tr("link {first}, point {start}; link {second}, point {end}", start=ends[0], end=ends[1], **words)
        yield Datum(tr("ends of spring {name}", name=called), text=text)
        units, said = ("N/m", "N*s/m"), tr("length of spring {name} without load", name=called)
        free = Datum(said, (f"l_{{{index}}}",), (spring.free,), "m")
    else:
        text = tr("link {first}; link {second}", **words)
        yield Datum(tr("links that spring {name} turns against each other", name=called), text=text)
        said = tr("angle of link {second} less that of link {first}, at which spring {name} has no load",
                  name=called, **words)  # fmt: skip
        units, free = ("N*m/rad", "N*m*s/rad"), Datum(said, (f"phi_{{{index}}}",), (math.degrees(spring.free),), "deg")
    if spring.stiffness:
        said = tr("stiffness of spring {name}", name=called)
        yield Datum(said, (f"k_{{{index}}}",), (spring.stiffness,), units[0])
        yield free
    if spring.damping:
        said = tr("damping coefficient of spring {name}", name=called)
        yield Datum(said, (f"c_{{{index}}}",), (spring.damping,), units[1])


def _pairs(seen: Seen, loading: Loading) -> Iterator[Datum]:
    """Friction, radii of pins, lengths of sliders."""
    rubbing = [pair for pair in loading.pairs if pair.friction]
    yield from _alike(rubbing, "f", [pair.friction for pair in rubbing], "")
    round_ = [pair for pair in rubbing if pair.radius]
    yield from _alike(round_, "r", [pair.radius for pair in round_], "m")
    for pair in loading.pairs:
        if pair.length:
            joint = seen.mechanism.joint(pair.joint)
            said = tr("length of the slider of link {link}", link=joint.links[0])
            yield Datum(said, (f"L_{{{''.join(map(str, joint.links))}}}",), (pair.length,), "m")


def _alike(pairs: Sequence[Pair], letter: str, values: Sequence[float], unit: str) -> Iterator[Datum]:
    """A quantity of several pairs, those with one value together."""
    for value in dict.fromkeys(values):
        own = [pair.joint for pair, its in zip(pairs, values, strict=True) if its == value]
        names = ", ".join(own)
        said = {
            "f": tr("coefficient of friction: {pairs}", pairs=names),
            "r": tr("radius of the pins: {pairs}", pairs=names),
        }[letter]
        alone = len(dict.fromkeys(values)) == 1
        keys = (letter,) if alone else tuple(f"{letter}_{{{plain_name(name)}}}" for name in own)
        yield Datum(said, keys, (value,), unit)


def _drive(gear: GearDrive) -> Iterator[Datum]:
    """The mesh through which the crank is driven; radius and angle of an open pair are told with it."""
    if gear.open:
        yield Datum(tr("mesh that drives the crank"), text=tr("that of the open pair {pair}", pair=gear.teeth))
    else:
        said = tr("operating pitch radius of the wheel on the crank")
        yield Datum(said, ("r_w",), (gear.radius,), "m")
        yield Datum(tr("operating pressure angle"), ("alpha_w",), (math.degrees(gear.mesh_angle),), "deg")
    said = tr("direction from the pivot of the crank to the centre of the pinion, from axis $x$")
    yield Datum(said, ("beta",), (math.degrees(gear.pinion),), "deg")
    if gear.internal:
        yield Datum(tr("teeth of the wheel on the crank"), text=tr("internal"))
