"""A prismatic pair outside a dyad: its line, its normal reaction and the moment of it about the slider's point."""

from __future__ import annotations

import cmath
import math

import numpy as np

from tmmcalc.linkage.forces.wrench import Slideway
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.statics.loaded import Loaded
from tmmcalc.linkage.notes.statics.pairs import ToldPair
from tmmcalc.linkage.pins import find_pins
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.telling import named, vector


def put_slide(loaded: Loaded, pair: ToldPair, turned: float = 1.0) -> str:
    """Enter the quantities of a prismatic pair, its line ``turned`` (-1) against the program's; the slider's point.

    The line has the name ``gamma_`` with the index of the reaction.
    """
    joint, ij, j = pair.joint, pair.ij, loaded.row_of(pair.joint.name)
    name = _point(loaded, pair)
    seat = loaded.every.state.reactions[joint.name].seat
    assert isinstance(seat, Slideway)
    n = loaded.result.theta.shape
    places, lines = np.broadcast_to(seat.r, n), turned * np.broadcast_to(seat.e, n)
    sign = 1.0 if pair.link > pair.other else -1.0
    for lexicon, row in zip(loaded.told.lexicons, loaded.rows, strict=True):
        e = complex(lines[row])
        normal = sign * (np.conj(1j * e) * loaded.result.reaction[j, row]).real
        reaction = tr("normal reaction of link {other} on link {link}", other=pair.other, link=pair.link)
        about = tr("moment of the normal reaction about {point}", point=name)
        place = tr("coordinates of point {point}", point=name)
        for key, given in vector(f"%_{{{name}}}", complex(places[row]), "m", place).items():
            lexicon |= {k: g for k, g in named({key: given}).items() if k not in lexicon}
        lexicon |= named(
            {
                f"gamma_{{{ij}}}": Given(
                    math.degrees(cmath.phase(e)), "deg", tr("angle of the guide of link {link}", link=pair.link)
                ),
                f"N_{{{ij}}}": Given(float(normal), "N", reaction),
                f"M_{{{ij}}}^{{{name}}}": Given(sign * float(loaded.result.couple[j, row]), "N*m", about),
            }
        )
    return name


def _point(loaded: Loaded, pair: ToldPair) -> str:
    """The name of the slider's point: that of the pin there, or of the joint."""
    joint, pins = pair.joint, find_pins(loaded.told.chain.mechanism)
    own = next((pin for pin in pins if pin.at.get(joint.links[0]) == joint.points[0]), None)
    if own is not None:
        return plain_name(own.name)
    name = plain_name(joint.name)
    return f"s{name}" if name in {plain_name(pin.name) for pin in pins} else name
