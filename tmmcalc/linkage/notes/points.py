"""Points of a link found from one of them: coordinates, velocity, acceleration (textbook (2.22), (2.58), (2.59))."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import FRAME
from tmmcalc.linkage.notes.group import GroupAt, length, plain_name
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.structure import Group
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.telling import named

POSITION = (
    "x_{<D>} = x_{<O>} + l_{<O><D>}*cos(<angle> + alpha_{<D>})",
    "y_{<D>} = y_{<O>} + l_{<O><D>}*sin(<angle> + alpha_{<D>})",
)
VELOCITY = (
    "v_{<D>x} = v_{<O>x} - l_{<O><D>}*omega_<k>*sin(<angle> + alpha_{<D>})",
    "v_{<D>y} = v_{<O>y} + l_{<O><D>}*omega_<k>*cos(<angle> + alpha_{<D>})",
)
ACCELERATION = (
    "a_{<D>x} = a_{<O>x} - l_{<O><D>}*(eps_<k>*sin(<angle> + alpha_{<D>}) + omega_<k>**2*cos(<angle> + alpha_{<D>}))",
    "a_{<D>y} = a_{<O>y} + l_{<O><D>}*(eps_<k>*cos(<angle> + alpha_{<D>}) - omega_<k>**2*sin(<angle> + alpha_{<D>}))",
)


class Carrier(NamedTuple):
    """A link whose motion is known: a point of it with its name, the name of an angle that turns with it."""

    link: int
    origin: str
    place: complex  # of the point in the axes of the link [m]
    angle: str  # ``phi_3``
    direction: complex  # unit vector at this angle, in the axes of the link
    turning: int  # the link that turns as it does


class Carried(NamedTuple):
    """A point of such a link: what stands in the formulas, and the quantities that are new."""

    places: Mapping[str, str]
    quantities: dict[str, Given]


def carried(chain: Chain, carrier: Carrier, known: set[str]) -> Iterator[Carried]:
    """The points of a link that are not ``known``, which takes their names."""
    for pin in find_pins(chain.mechanism):
        name = plain_name(pin.name)
        if carrier.link not in pin.at or name in known:
            continue
        known.add(name)
        way = (pin.at[carrier.link] - carrier.place) / carrier.direction
        places = {"D": name, "O": carrier.origin, "angle": carrier.angle, "k": str(carrier.turning)}
        turn = math.degrees(cmath.phase(way)) if abs(way) else 0.0
        quantities = {
            f"l_{{{carrier.origin}{name}}}": length(
                abs(way), tr("distance between points {first} and {second}", first=carrier.origin, second=name)
            ),
            f"alpha_{{{name}}}": Given(
                turn, "deg", tr("angle of {point} on link {link}", point=name, link=carrier.link)
            ),
        }
        yield Carried(places, quantities)


def gathered(chain: Chain, carrier: Carrier, known: set[str], lexicons: Sequence[dict[str, Given]]) -> list[Carried]:
    """The points of a link that are not known yet, with their quantities in the lexicons."""
    found = [*carried(chain, carrier, known)]
    for lexicon in lexicons:
        for each in found:
            lexicon |= named(each.quantities)
    return found


def input_carrier(chain: Chain) -> Carrier | None:
    """The input crank about its pivot, or a driven slider along its guide; None: the drive is within a group."""
    if chain.structure.driven is not None:
        return None
    link, joint = chain.structure.input_link, chain.input_joint
    pins = find_pins(chain.mechanism)
    if not chain.turns:
        pin = next(pin for pin in pins if link in pin.at)
        line = joint.directions[joint.links.index(link)]
        return Carrier(link, plain_name(pin.name), pin.at[link], f"gamma_{link}", line, FRAME)
    pivot = next(pin for pin in pins if joint.name in pin.joints)
    return Carrier(link, plain_name(pivot.name), pivot.at[link], f"phi_{link}", 1 + 0j, link)


def carriers(chain: Chain, group: Group, at: GroupAt) -> Iterator[Carrier]:
    """The links of a dyad."""
    places = at.places
    a, b = group.links
    pins = {plain_name(pin.name): pin for pin in find_pins(chain.mechanism)}
    match group.kind:
        case "RRR":
            yield _rod(pins, a, places["P"], places["B"], f"phi_{a}")
            yield _rod(pins, b, places["Q"], places["B"], f"phi_{b}")
        case "RRP":
            yield _rod(pins, a, places["P"], places["B"], f"phi_{a}")
            yield _slider(chain, pins[places["B"]], b, group.outer[1], f"gamma_{b}", int(places["g"]))
        case "RPR":
            yield _slider(chain, pins[places["Q"]], b, group.inner[0], f"phi_{b}", b)
            yield _slider(chain, pins[places["P"]], a, group.inner[0], f"phi_{b}", b)
        case "PRP":
            yield _slider(chain, pins[places["B"]], a, group.outer[0], f"gamma_{a}", int(places["f"]))
            yield _slider(chain, pins[places["B"]], b, group.outer[1], f"gamma_{b}", int(places["g"]))


def _rod(pins: Mapping[str, Pin], link: int, outer: str, inner: str, angle: str) -> Carrier:
    start, end = pins[outer].at[link], pins[inner].at[link]
    return Carrier(link, outer, start, angle, (end - start) / abs(end - start), link)


def _slider(chain: Chain, pin: Pin, link: int, joint: str, angle: str, turning: int) -> Carrier:
    """A link by the line of its prismatic joint."""
    found = chain.mechanism.joint(joint)
    return Carrier(link, plain_name(pin.name), pin.at[link], angle, found.directions[found.links.index(link)], turning)
