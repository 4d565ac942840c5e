"""The drive: the law of a driven slider or length, and a link turned by a driven length, textbook 2.10.2.

The pivots and the pin are a triangle with two constant sides; the third is the driven length (2.72) to (2.85).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from tmmcalc.core.plane import cross
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.model import FRAME
from tmmcalc.linkage.notes.group import angle, guide_name, length, plain_name
from tmmcalc.linkage.notes.ways import NOTHING, Arm, Loop, Slid, Spin
from tmmcalc.linkage.pins import find_pins
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Lexicon
from tmmcalc.report.telling import number_of

LAW = ("s_<s> = s_0 + Deltas",)
POSITION = (
    "l_{<O><A>} = sqrt((x_{<A>} - x_{<O>})**2 + (y_{<A>} - y_{<O>})**2)",
    "phi_{<O><A>} = atan2(y_{<A>} - y_{<O>}, x_{<A>} - x_{<O>})",
    "theta_{<O>} = acos((l_{<O><B>}**2 + l_{<O><A>}**2 - s_<s>**2)/(2*l_{<O><B>}*l_{<O><A>}))",
    "phi_<k> = phi_{<O><A>} <side> theta_{<O>}",
    "x_{<B>} = x_{<O>} + l_{<O><B>}*cos(phi_<k>)",
    "y_{<B>} = y_{<O>} + l_{<O><B>}*sin(phi_<k>)",
    "phi_<c> = atan2(y_{<end>} - y_{<start>}, x_{<end>} - x_{<start>})",
)
VELOCITY = (
    "omega_<k> = (<minus>v_{<pair>} + (v_{<A>x} - v_{<O>x})*cos(phi_<c>) + (v_{<A>y} - v_{<O>y})*sin(phi_<c>))"
    "/(l_{<O><B>}*sin(phi_<c> - phi_<k>))",
    "omega_<c> = <minus>(l_{<O><B>}*omega_<k>*cos(phi_<c> - phi_<k>) + (v_{<A>x} - v_{<O>x})*sin(phi_<c>)"
    " - (v_{<A>y} - v_{<O>y})*cos(phi_<c>))/s_<s>",
    "v_{<B>x} = v_{<O>x} - l_{<O><B>}*omega_<k>*sin(phi_<k>)",
    "v_{<B>y} = v_{<O>y} + l_{<O><B>}*omega_<k>*cos(phi_<k>)",
)
ACCELERATION = (
    "eps_<k> = (<minus>a_{<pair>} <less> s_<s>*omega_<c>**2 + l_{<O><B>}*omega_<k>**2*cos(phi_<c> - phi_<k>)"
    " + (a_{<A>x} - a_{<O>x})*cos(phi_<c>) + (a_{<A>y} - a_{<O>y})*sin(phi_<c>))"
    "/(l_{<O><B>}*sin(phi_<c> - phi_<k>))",
    "eps_<c> = (<minus>(l_{<O><B>}*eps_<k>*cos(phi_<c> - phi_<k>) + l_{<O><B>}*omega_<k>**2*sin(phi_<c> - phi_<k>)"
    " + (a_{<A>x} - a_{<O>x})*sin(phi_<c>) - (a_{<A>y} - a_{<O>y})*cos(phi_<c>)) - 2*omega_<c>*v_{<pair>})/s_<s>",
    "a_{<B>x} = a_{<O>x} - l_{<O><B>}*(eps_<k>*sin(phi_<k>) + omega_<k>**2*cos(phi_<k>))",
    "a_{<B>y} = a_{<O>y} + l_{<O><B>}*(eps_<k>*cos(phi_<k>) - omega_<k>**2*sin(phi_<k>))",
)


class Triangle(NamedTuple):
    """A link about its pivot, and the driven length from the other pivot to its pin."""

    arm: Arm
    driven: Arm


def triangle_of(loops: Sequence[Loop], drive: str) -> Triangle | None:
    """The triangle, where the group is one."""
    if len(loops) != 1 or any(len(way.arms) != 1 for way in (loops[0].first, loops[0].second)):
        return None
    arms = sorted((loops[0].first.arms[0], loops[0].second.arms[0]), key=lambda arm: len(arm.slid))
    arm, driven = arms
    fits = not arm.slid and len(driven.slid) == 1 and abs(driven.fixed) < NOTHING
    fits = fits and driven.slid[0].joint.name == drive and not arm.spin.known and not driven.spin.known
    return Triangle(arm, driven) if fits else None


def words_of(triangle: Triangle, lexicon: Lexicon) -> dict[str, str]:
    """What stands in the formulas."""
    arm, driven = triangle
    (slid,) = driven.slid
    ahead = slid.sign > 0
    pivot, pin, other = (_place(lexicon, name) for name in (arm.start, arm.end, driven.start))
    left = cross(other - pivot, pin - pivot) > 0
    return {
        "O": arm.start,
        "A": driven.start,
        "B": arm.end,
        "k": str(arm.spin.link),
        "c": str(driven.spin.link),
        "s": str(slid.joint.links[0]),
        "pair": slid.pair,
        "side": "+" if left else "-",
        "minus": "" if ahead else "-",
        "less": "-" if ahead else "+",
        "start": driven.start if ahead else arm.end,
        "end": arm.end if ahead else driven.start,
    }


def quantities(triangle: Triangle, lexicon: Lexicon) -> Lexicon:
    """The line of the pivots, and the angle at the pivot."""
    first, second = triangle.arm.start, triangle.driven.start
    pivot, pin, other = (_place(lexicon, name) for name in (first, triangle.arm.end, second))
    said = {"first": first, "second": second}
    turn = angle((pin - pivot) / (other - pivot), tr("angle of the triangle at {point}", point=first))
    assert isinstance(turn.value, float)
    return {
        f"l_{{{first}{second}}}": length(
            abs(other - pivot), tr("distance between points {first} and {second}", **said)
        ),
        f"phi_{{{first}{second}}}": angle(other - pivot, tr("angle of the line {first}{second}", **said)),
        f"theta_{{{first}}}": turn._replace(value=abs(turn.value)),
    }


def _place(lexicon: Lexicon, name: str) -> complex:
    return complex(number_of(lexicon, f"x_{{{name}}}"), number_of(lexicon, f"y_{{{name}}}"))


def law_quantities(first: float, travel: float) -> dict[str, Given]:
    """The coordinate of the drive."""
    return {
        "s_0": length(first, tr("coordinate of the drive in the first position")),
        "Deltas": length(travel, tr("travel of the drive from the first position")),
    }


def driven_slider(chain: Chain) -> Arm | None:
    """The vector from the guide of a driven slider to its pin; None: a crank, or a drive between moving links."""
    if chain.turns or chain.structure.driven is not None:
        return None
    joint, link = chain.input_joint, chain.structure.input_link
    side = joint.links.index(link)
    pins = find_pins(chain.mechanism)
    pin = next(pin for pin in pins if link in pin.at)
    line = joint.directions[side]
    spin = Spin(f"gamma_{link}", FRAME, True, (link, line))
    slid = Slid(joint, 1 if side == 0 else -1, 0.0)
    return Arm(guide_name(pins, joint), plain_name(pin.name), spin, (pin.at[link] - joint.points[side]) / line, (slid,))
