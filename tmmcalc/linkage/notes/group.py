"""A dyad at one position, in time, with the names of its links and points for the formulas of its kind."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Guide, Point
from tmmcalc.linkage import solvers
from tmmcalc.linkage.chain import Chain, Step
from tmmcalc.linkage.dyads.base import Rates
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.telling import vector


class GroupAt(NamedTuple):
    """One position of a dyad; states of its ports, placement and rates are in time [m, s, rad], single numbers."""

    dyad: Any  # its metric
    places: Mapping[str, str]  # what stands for ``<a>``, ``<P>`` ... in formulas
    port1: Any  # Point or Guide
    port2: Any
    placed: Any
    rates: Rates


def group_at(chain: Chain, step: Step, result: Kinematics, row: int) -> GroupAt:
    """The dyad at a position of the result."""
    x = result.x[[row]]
    configuration = chain.evaluate(x)
    number = chain.steps.index(step)
    ports = [_single(_timed(port, result.speed, result.acceleration)) for port in configuration.ports[number]]
    placed = type(configuration.placed[number])(*(one_number(each) for each in configuration.placed[number]))
    dyad: Any = step.dyad
    rates = Rates(*map(one_number, dyad.rates(*ports, placed, solvers.closed)))
    return GroupAt(dyad, names_of(chain, step), ports[0], ports[1], placed, rates)


def _timed(state: Any, speed: float, acceleration: float) -> Any:
    """A state by the input coordinate as one in time."""
    first, second = state.v, state.a
    found = state._replace(v=first * speed, a=second * speed**2 + first * acceleration)
    if isinstance(state, Guide):
        eps = state.eps * speed**2 + state.omega * acceleration
        return found._replace(omega=state.omega * speed, eps=eps)
    return found


def _single(state: Any) -> Any:
    return type(state)(*(np.asarray(one_number(each)) for each in state))


def one_number(value: Any) -> Any:
    """The number of an array of one."""
    return np.ravel(value)[0]


def names_of(chain: Chain, step: Step) -> dict[str, str]:
    """The links of a dyad and of its guides, the points of its joints, the signs of its assembly."""
    mechanism, group = chain.mechanism, step.group
    pins = find_pins(mechanism)
    first, second = (mechanism.joint(name) for name in group.outer)
    inner = mechanism.joint(group.inner[0])
    a, b = group.links
    found = {
        "a": str(a),
        "b": str(b),
        "P": _named(pins, first),
        "Q": _named(pins, second),
        "B": _named(pins, inner),
        "f": str(first.other(a)),
        "g": str(second.other(b)),
    }
    return found | signs_of(step.dyad, found["P"], found["Q"])


def signs_of(dyad: Any, first: str, second: str) -> dict[str, str]:
    """What the assembly of a dyad makes of its formulas, by the points of its outer joints."""
    positive = getattr(dyad, "variant", 1) > 0
    return {
        "sign": "+" if positive else "-",
        "minus": "" if positive else "-",
        "turn": "-" if positive else "+",  # of the line along which a block slides, against that of the pivots
        "start": second if positive else first,
        "end": first if positive else second,
        "left": "+ " if positive else "+ deg(180) - ",
    }


def _named(pins: tuple[Pin, ...], joint: Joint) -> str:
    """The point of a revolute joint; of a prismatic one that of its guide."""
    found = next((plain_name(pin.name) for pin in pins if joint.name in pin.joints), "")
    return found or guide_name(pins, joint)


def guide_name(pins: tuple[Pin, ...], joint: Joint) -> str:
    """The point of the guide of a prismatic joint: the name of the joint, with zeros where a pin has it."""
    name, taken = plain_name(joint.name), {plain_name(pin.name) for pin in pins}
    while name in taken:
        name += "0"
    return name


def plain_name(name: str) -> str:
    """The name of a point as an index: letters and digits."""
    return "".join(letter for letter in name if letter.isalnum())


def length(value: float, meaning: str) -> Given:
    """A length [m]."""
    return Given(float(value), "m", meaning)


def angle(direction: complex, meaning: str) -> Given:
    """The angle of a vector."""
    return Given(math.degrees(cmath.phase(complex(direction))), "deg", meaning)


def along_guide(slider: str, link: str, number: str, s: float, rate: float, rate2: float) -> dict[str, Given]:
    """Coordinate, velocity and acceleration of a slider along its guide on a link."""
    return {
        f"s_{slider}": length(s, tr("coordinate of link {link} along its guide", link=number)),
        f"v_{{{slider}{link}}}": Given(rate, "m/s", tr("velocity of link {link} along its guide", link=number)),
        f"a_{{{slider}{link}}}": Given(rate2, "m/s^2", tr("acceleration of link {link} along its guide", link=number)),
    }


def guide_quantities(
    at: GroupAt, guide: Guide, offset: complex, *, slider: str, origin: str, mark: str
) -> dict[str, Given]:
    """A guide: its direction, and how its place under the slider's pin moves with it; ``offset`` goes to the pin."""
    places = at.places
    offset, omega, eps = complex(offset), float(guide.omega), float(guide.eps)
    velocity = complex(guide.v) + 1j * omega * offset
    acceleration = complex(guide.a) + (1j * eps - omega**2) * offset
    number = places[slider[1:-1]]
    carried = tr("projections of the velocity of the guide of link {link} at {point}", link=number, point=places["B"])
    drawn = tr("projections of the acceleration of the guide of link {link} at {point}", link=number, point=places["B"])
    return {
        f"gamma_{slider}": angle(complex(guide.e), tr("angle of the guide of link {link}", link=number)),
        **vector(f"v_{{<B>%}}^{mark}", velocity, "m/s", carried),
        **vector(f"a_{{<B>%}}^{mark}", acceleration, "m/s^2", drawn),
        **vector(
            f"%_{{{origin}}}",
            complex(guide.r),
            "m",
            tr("coordinates of a point of the guide of link {link}", link=number),
        ),
        **vector(f"v_{{{origin}%}}", complex(guide.v), "m/s", tr("projections of the velocity of this point")),
        **vector(f"a_{{{origin}%}}", complex(guide.a), "m/s^2", tr("projections of the acceleration of this point")),
    }


def pin_quantities(chain: Chain, result: Kinematics, row: int) -> dict[str, Given]:
    """Places, velocities and accelerations of all pins and points of links at a position."""
    motions = chain.evaluate(result.x[[row]]).motions
    found: dict[str, Given] = {}
    for pin in find_pins(chain.mechanism):
        link, place = next(iter(pin.at.items()))
        state = _single(_timed(motions[link].point(place), result.speed, result.acceleration))
        name = plain_name(pin.name)
        found |= point_quantities(name, name, state)
    return found


def point_quantities(key: str, name: str, state: Point) -> dict[str, Given]:
    """A point: coordinates and the projections of its velocity and acceleration."""
    return {
        **vector(f"%_{{{key}}}", complex(state.r), "m", tr("coordinates of point {point}", point=name)),
        **vector(f"v_{{{key}%}}", complex(state.v), "m/s", tr("projections of the velocity of {point}", point=name)),
        **vector(
            f"a_{{{key}%}}", complex(state.a), "m/s^2", tr("projections of the acceleration of {point}", point=name)
        ),
    }
