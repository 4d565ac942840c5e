"""The sizes of a six-bar with a dwell as they are listed: all link lengths, angles of the dwell, parameters."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.linkage.synthesis.dwell.linkages import Linkages
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.results import Size


def sizes_of(
    asked: DwellTask, linkages: Linkages, values: dict[str, float], n: float | None, scale: float
) -> tuple[Size, ...]:
    """The sizes of one linkage (1,) built with l_OB = ``scale`` [m]."""
    return (*_lengths(linkages, scale), *_angles(asked, linkages, values, n))


def _lengths(linkages: Linkages, scale: float) -> Iterator[Size]:
    d, e = complex(linkages.d[0]), complex(linkages.e[0])
    coupler = float(linkages.coupler[0])
    listed = [
        ("OB", 1.0, "pivot O to B at dwell"),
        ("OA", float(linkages.crank[0]), "crank"),
        ("AC", coupler, "coupler"),
        ("CD", abs(d - coupler), "coupler"),
        ("AD", abs(d), "coupler"),
        ("CB", float(linkages.bar[0]), "bar 3"),
        ("DE", float(linkages.rod[0]), "bar 4"),
        ("BE", abs(e - 1), "output link"),
    ]
    if linkages.rocks:
        f = complex(linkages.output[0])
        listed += [("OF", abs(f), "frame"), ("BF", abs(1 - f), "rocker"), ("EF", abs(e - f), "rocker")]
        listed += [("x_F", f.real, "pivot F from O, B at dwell on +x"), ("y_F", f.imag, "the same")]
    listed += [("x_E", e.real, "E at dwell"), ("y_E", e.imag, "the same")]
    listed += [("x_D2", d.real, "D in the axes of the coupler, from A along AC"), ("y_D2", d.imag, "the same")]
    for name, part, meaning in listed:
        symbol = name if "_" in name else f"l_{name}"
        yield Size(symbol, scale * part, "m", meaning)


def _angles(asked: DwellTask, linkages: Linkages, values: dict[str, float], n: float | None) -> Iterator[Size]:
    arm = complex(linkages.d[0]) - float(linkages.coupler[0])
    turns = linkages.turns[:, 0]
    yield Size("alpha", float(np.angle(-arm)) % (2 * math.pi), "rad", "from C -> A to C -> D")
    yield Size("phi_0", float(linkages.phi0[0]), "rad", "crank in position 1")
    yield Size("phi_12", float(turns[1]), "rad", "crank from position 1 to 2")
    yield Size("phi_B", float(turns[2]), "rad", "dwell: crank from position 1 to 3")
    if asked.lengths is None:
        yield Size("psi_0", values["psi0"], "rad", "B -> C in position 1")
        yield Size("psi_12", values["psi12_part"] * values["psi13"], "rad", "bar BC from position 1 to 2")
        yield Size("psi_13", values["psi13"], "rad", "bar BC from position 1 to 3")
    if not linkages.rocks:
        yield Size("q", float(np.angle(linkages.output[0])), "rad", "guide, the sense in which S grows")
    if n is not None:
        yield Size("n", n, "-", "part of the dwell after which the output moves along the crank")
