"""What is given of a linkage: its scheme with the letters, its metric, its masses, what acts on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from itertools import combinations

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.loading import Body, Load, Loading, Pair
from tmmcalc.linkage.model import FRAME, Mechanism
from tmmcalc.linkage.notes.group import guide_name, plain_name
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.notes.statics.loaded import force_key
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Figure
from tmmcalc.report.telling import numeral

EXTREME = "extreme"  # a beginning that is found
SIZE = (150.0, 95.0)  # of the scheme [mm]
NEAR = 1e-9  # [m] within which points are one
SIDES = 3  # pins of a link up to which all distances are given


def blocks(order: Order) -> Iterator[Block]:
    """The scheme in a position, then the data."""
    if "kinematics" not in order.results:
        return
    mechanism, result = to_linkage(order.spec.linkage), order.results["kinematics"]
    chain = chain_of(mechanism, result)
    row = rows_shown(order, chain, result)[0]
    draw = partial(draw_scheme, result=result, cycle=whole_cycle(chain, result), positions=[row])
    yield Figure(tr("Scheme of the mechanism"), draw, SIZE, "task_scheme")
    yield from _motion(order, result)
    yield from _metric(mechanism)
    if {"forces", "reduction", "balance"} & set(order.results):
        yield from _loading(order, mechanism, to_loading(order.spec))


def _motion(order: Order, result: Kinematics) -> Iterator[Datum]:
    """The motion of the input, the positions, in which sense outputs are counted."""
    table = order.spec.linkage
    if result.turns:
        name = f"n_{result.structure.input_link}"
        yield Datum(tr("speed of the crank"), (name,), (abs(result.speed) * 30 / math.pi,), "rpm")
        sense = tr("counter-clockwise") if result.speed > 0 else tr("clockwise")
        yield Datum(tr("sense in which the crank turns"), text=sense)
    even = [label for label in result.labels if label.isdigit()]  # without those between, as 7'
    yield Datum(tr("number of equal steps of the cycle"), ("n",), (float(len(even) - 1),))
    if table.input.start == EXTREME:
        yield Datum(tr("beginning of the count, position 0"), text=tr("dead centre before the working stroke"))
    elif result.turns:
        yield Datum(tr("position 0: angle of the crank from axis $x$"), (), (math.degrees(table.input.start),), "deg")
    for output in table.outputs:
        if output.point is not None:
            said = tr("direction of the coordinate of point {point}, from axis $x$", point=output.point)
            yield Datum(said, (), (math.degrees(output.direction),), "deg")


def _metric(mechanism: Mechanism) -> Iterator[Datum]:
    """Points of the frame, guides on it, distances of the pins of every link."""
    pins = [pin for pin in find_pins(mechanism) if pin.joints]
    for pin in pins:
        if pin.fixed:
            name = plain_name(pin.name)
            yield _point(tr("coordinates of point {point}", point=name), name, pin.at[FRAME])
    for joint in mechanism.joints:
        if joint.kind == "prismatic" and FRAME in joint.links:
            side, link = joint.links.index(FRAME), joint.other(FRAME)
            said = tr("coordinates of a point of the guide of link {link}", link=link)
            yield _point(said, guide_name(tuple(pins), joint), joint.points[side])
            angle = _degrees(joint.directions[side])
            yield Datum(tr("angle of the guide of link {link}", link=link), (f"gamma_{link}",), (angle,), "deg")
    for own in mechanism.links:
        for first, second in _distances([pin for pin in pins if own.id in pin.at]):
            yield _distance(plain_name(first.name), plain_name(second.name), second.at[own.id] - first.at[own.id])


def _distances(pins: Sequence[Pin]) -> Iterator[tuple[Pin, Pin]]:
    """The pins between which distances are given: all of a triangle, those to the first two of more."""
    for first, second in combinations(pins, 2):
        if len(pins) <= SIDES or first in pins[:2]:
            yield first, second


def _point(said: str, name: str, at: complex) -> Datum:
    return Datum(said, (f"x_{{{name}}}", f"y_{{{name}}}"), (at.real, at.imag), "m")


def _distance(first: str, second: str, vector: complex) -> Datum:
    said = tr("distance between points {first} and {second}", first=first, second=second)
    return Datum(said, (f"l_{{{first}{second}}}",), (abs(vector),), "m")


def _loading(order: Order, mechanism: Mechanism, loading: Loading) -> Iterator[Datum]:
    """Masses with their centres, gravity, loads, friction with the sizes of the pairs."""
    pins = [pin for pin in find_pins(mechanism) if pin.joints]
    for body in loading.bodies:
        if body.mass:
            yield Datum(tr("mass of link {link}", link=body.link), (f"m_{body.link}",), (body.mass,), "kg")
            yield from _centre(body, pins)
        if body.inertia:
            said = tr("moment of inertia of link {link} about its centre of mass", link=body.link)
            yield Datum(said, (f"J_{body.link}",), (body.inertia,), "kg*m^2")
    yield from _gravity(loading.gravity)
    for table, load in zip(order.spec.loads, loading.loads, strict=True):
        yield from _load(table, load.name)
        yield from _applied(load, find_pins(mechanism))
    rubbing = [pair for pair in loading.pairs if pair.friction]
    yield from _alike(rubbing, "f", [pair.friction for pair in rubbing], "")
    round_ = [pair for pair in rubbing if pair.radius]
    yield from _alike(round_, "r", [pair.radius for pair in round_], "m")
    for pair in loading.pairs:
        if pair.length:
            link = mechanism.joint(pair.joint).links[0]
            yield Datum(tr("length of the slider of link {link}", link=link), (f"l_{link}",), (pair.length,), "m")


def _gravity(gravity: complex) -> Iterator[Datum]:
    """Gravity [m/s^2] and where it points."""
    if not gravity:
        return
    down = abs(gravity.real) < NEAR and gravity.imag < 0
    said = tr("acceleration of gravity, directed against axis $y$") if down else tr("acceleration of gravity")
    yield Datum(said, ("g",), (abs(gravity),), "m/s^2")
    if not down:
        yield Datum(tr("direction of gravity, from axis $x$"), (), (_degrees(gravity),), "deg")


def _degrees(direction: complex) -> float:
    """The angle [deg] of a vector from axis x."""
    return math.degrees(math.atan2(direction.imag, direction.real))


def _centre(body: Body, pins: Sequence[Pin]) -> Iterator[Datum]:
    """Where the centre of mass lies: in a pin, or by its distances from the first pins of the link."""
    pin = _pin_at(body.link, body.center, pins)
    if pin is None:
        yield from _from_pins(body.link, f"S{body.link}", body.center, pins)
    else:
        said = tr("centre of mass of link {link}", link=body.link)
        yield Datum(said, (f"S_{body.link}",), text=tr("in point {point}", point=plain_name(pin.name)))


def _pin_at(link: int, at: complex, pins: Sequence[Pin]) -> Pin | None:
    """The pin that lies at a place of a link, in its axes [m]."""
    return next((pin for pin in pins if link in pin.at and abs(pin.at[link] - at) < NEAR), None)


def _from_pins(link: int, name: str, at: complex, pins: Sequence[Pin]) -> Iterator[Datum]:
    """The distances of a point of a link from its first pins; from one, where the point lies on their line."""
    own = [pin for pin in pins if link in pin.at]
    for pin in own[:2]:
        vector = at - pin.at[link]
        yield _distance(plain_name(pin.name), name, vector)
        if len(own) > 1 and abs((vector / (own[1].at[link] - own[0].at[link])).imag) < NEAR:
            return


def _load(table: object, name: str) -> Iterator[Datum]:
    """A load that is constant or a polynomial of the angle, and where it acts."""
    called = tr("“{name}”", name=name)
    for kind, unit in (("force", "N"), ("moment", "N*m")):
        value = getattr(table, kind, None)
        if isinstance(value, float):
            yield Datum(f"{tr('given load')} {called}", (force_key(name),), (value,), unit)
        coefficients = getattr(getattr(table, "polynomial", None), kind, None)
        if coefficients is not None:
            said = tr("given load {name}; $theta$ – angle of the crank from its beginning, rad", name=called)
            yield Datum(said, (force_key(name),), text=f"${_polynomial(coefficients)}$ {tr_unit(unit)}")
    if "factor" in getattr(table, "model_fields_set", ()):
        yield Datum(tr("factor of load {name}", name=called), ("k",), (getattr(table, "factor", 1.0),))
    between = getattr(table, "between", None)
    if between is not None:
        said = tr("where load {name} begins and ends, by the angle of the crank from the first position", name=called)
        yield Datum(said, ("phi",), tuple(map(math.degrees, between)), "deg")


def _applied(load: Load, points: Sequence[Pin]) -> Iterator[Datum]:
    """The link and the point on which a load acts, and along what it is positive."""
    called, pins = tr("“{name}”", name=load.name), [point for point in points if point.joints]
    link = tr("link {link}", link=load.link)
    where = tr("where load {name} is applied", name=called)
    if load.kind == "moment":
        yield Datum(where, text=link)
        yield Datum(tr("positive sense of load {name}", name=called), text=tr("counter-clockwise"))
    else:
        known = _pin_at(load.link, load.point, points)
        name = plain_name(load.name if known is None else known.name)
        yield Datum(where, text=tr("{link}, point {point}", link=link, point=name))
        if known is None or not known.joints:
            yield from _from_pins(load.link, name, load.point, pins)
        yield _direction(load, called, pins)
    if load.against != FRAME:
        said = tr("link that takes the opposite of load {name}", name=called)
        yield Datum(said, text=tr("link {link}", link=load.against))


def _direction(load: Load, called: str, pins: Sequence[Pin]) -> Datum:
    """Along what a force is positive: from axis x, or from the line of the link with which it turns."""
    own = [pin for pin in pins if load.follows in pin.at]
    if load.follows == FRAME or len(own) < 2:
        said = tr("positive direction of load {name}, from axis $x$", name=called)
        if load.follows != FRAME:
            said = tr("positive direction of load {name}, from axis $x$ of link {link}", name=called, link=load.follows)
        return Datum(said, (), (_degrees(load.direction),), "deg")
    first, second = own[:2]
    line = f"{plain_name(first.name)}{plain_name(second.name)}"
    said = tr("positive direction of load {name}, from line {line} with which it turns", name=called, line=line)
    turned = load.direction / (second.at[load.follows] - first.at[load.follows])
    return Datum(said, (), (_degrees(turned),), "deg")


def _polynomial(coefficients: Sequence[float]) -> str:
    """A polynomial of the angle as a formula.

    >>> _polynomial([0.0, -180.0, 68.75])
    '- 180*theta + 68.75*theta**2'
    """
    terms = []
    for power, value in enumerate(coefficients):
        if value:
            angle = ["", "*theta"][power] if power < 2 else f"*theta**{power}"
            terms.append(f"{'-' if value < 0 else '+'} {numeral(abs(value))}{angle}")
    return " ".join(terms).removeprefix("+ ") or "0"


def _alike(pairs: Sequence[Pair], letter: str, values: Sequence[float], unit: str) -> Iterator[Datum]:
    """A quantity of several pairs, those with one value together."""
    for value in dict.fromkeys(values):
        names = ", ".join(pair.joint for pair, own in zip(pairs, values, strict=True) if own == value)
        said = {
            "f": tr("coefficient of friction: {pairs}", pairs=names),
            "r": tr("radius of the pins: {pairs}", pairs=names),
        }[letter]
        yield Datum(said, (letter,), (value,), unit)
