"""The sizes of six-bars with a dwell as they are listed: all link lengths, angles of the dwell, parameters."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.dwell.linkages import Linkages
from tmmcalc.linkage.synthesis.dwell.task import DwellTask


class Sizes(NamedTuple):
    """One size of m linkages."""

    symbol: str
    values: Real  # (m,)
    unit: str
    meaning: str


def sizes_of(asked: DwellTask, linkages: Linkages, values: Mapping[str, Real], scale: Real) -> Iterator[Sizes]:
    """The sizes of linkages (m,) with l_OB = ``scale`` (m,) [m], of which ``values`` (m,) are the parameters."""
    yield from _lengths(linkages, scale)
    yield from _angles(asked, linkages, values)


def scale_of(asked: DwellTask, stroke: Real) -> Real:
    """l_OB (m,) [m] of linkages by their strokes (m,), parts of l_OB, or as it is given."""
    if asked.stroke is not None:
        return asked.stroke / stroke
    return np.full_like(stroke, 1.0 if asked.frame is None else asked.frame)


def _lengths(linkages: Linkages, scale: Real) -> Iterator[Sizes]:
    d, e, coupler = linkages.d, linkages.e, linkages.coupler
    listed = [
        ("OB", np.ones_like(coupler), "pivot O to B at dwell"),
        ("OA", linkages.crank, "crank"),
        ("AC", coupler, "coupler"),
        ("CD", np.abs(d - coupler), "coupler"),
        ("AD", np.abs(d), "coupler"),
        ("CB", linkages.bar, "bar 3"),
        ("DE", linkages.rod, "bar 4"),
        ("BE", np.abs(e - 1), "output link"),
    ]
    if linkages.rocks:
        f = linkages.output
        listed += [("OF", np.abs(f), "frame"), ("BF", np.abs(1 - f), "rocker"), ("EF", np.abs(e - f), "rocker")]
        listed += [("x_F", f.real, "pivot F from O, B at dwell on +x"), ("y_F", f.imag, "the same")]
    listed += [("x_E", e.real, "E at dwell"), ("y_E", e.imag, "the same")]
    listed += [("x_D2", d.real, "D in the axes of the coupler, from A along AC"), ("y_D2", d.imag, "the same")]
    for name, part, meaning in listed:
        yield Sizes(name if "_" in name else f"l_{name}", scale * part, "m", meaning)


def _angles(asked: DwellTask, linkages: Linkages, values: Mapping[str, Real]) -> Iterator[Sizes]:
    turns = linkages.turns
    alpha = np.angle(linkages.coupler - linkages.d) % (2 * math.pi)
    yield Sizes("alpha", alpha, "rad", "from C -> A to C -> D")
    yield Sizes("phi_0", linkages.phi0, "rad", "crank in position 1")
    yield Sizes("phi_12", turns[1], "rad", "crank from position 1 to 2")
    yield Sizes("phi_B", turns[2], "rad", "dwell: crank from position 1 to 3")
    if asked.lengths is None:
        yield Sizes("psi_0", values["psi0"], "rad", "B -> C in position 1")
        yield Sizes("psi_12", values["psi12_part"] * values["psi13"], "rad", "bar BC from position 1 to 2")
        yield Sizes("psi_13", values["psi13"], "rad", "bar BC from position 1 to 3")
    if not linkages.rocks:
        yield Sizes("q", np.angle(linkages.output), "rad", "guide, the sense in which S grows")
    if asked.pivot is None:
        yield Sizes("n", values["n"], "-", "part of the dwell after which the output moves along the crank")
