"""A dyad on its own: ports in, motions of both links out.

For single groups, textbook exercises, and mechanisms whose source chain is solved elsewhere. Each link has its
origin in its outer joint (a slider: in the inner pin) and its x axis along its vector: from the outer to the
inner joint, or along the guide.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.core.errors import AccuracyError, AssemblyError, SingularityError
from tmmcalc.core.plane import Guide, LinkMotion, Point, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.dyads.base import Dyad, Motions, Sites, Slide
from tmmcalc.linkage.quality import SINGULAR
from tmmcalc.linkage.solvers import closed

A, B, SOURCE_1, SOURCE_2 = 1, 2, 3, 4


@record
class DyadMotion:
    """Motion of the links a and b, coordinates of the prismatic joints in the order of the kind's letters.

    ``a.point(p)`` and ``b.point(p)`` give any point p [m] of a link; ``inner`` is the inner joint of RRR, RRP, PRP.
    """

    a: LinkMotion
    b: LinkMotion
    slides: tuple[Slide, ...]
    inner: Point | None


def solve_dyad(dyad: Dyad, port1: Point | Guide, port2: Point | Guide) -> DyadMotion:
    """Positions, velocities and accelerations of one dyad from the states of its outer joints.

    ``port1`` belongs to link a, ``port2`` to link b: a `Point` where the kind has an outer revolute joint, a `Guide`
    where it has a prismatic one; arrays of shape (n,) or scalars. Derivatives are with respect to the variable of
    the ports. Raises `AssemblyError` where the links do not reach, `SingularityError` at a dead point, `AccuracyError`
    for sizes that no number can compare.

    >>> from tmmcalc.linkage.dyads import RRR
    >>> p1 = Point(0.1 + 0.2j, 0.3 - 0.4j, 0.5 + 0.1j)
    >>> p2 = Point(0.9 + 0.4j, -0.2 + 0.1j, 0.3j)
    >>> round(float(solve_dyad(RRR(0.7, 0.5, -1), p1, p2).a.omega), 8)
    0.45695885
    """
    name = type(dyad).__name__
    port1, port2 = _arrays(port1), _arrays(port2)
    _check_assembly(dyad, port1, port2, f"dyad {name}")
    with np.errstate(divide="ignore", invalid="ignore"):
        placed = dyad.place(port1, port2)
        regularity = np.nan_to_num(dyad.regularity(placed), nan=0.0)  # the pin on the pivot: no direction
    _check_regular(dyad, regularity, f"dyad {name}")
    motions: Motions = {k: _carrier(port) for k, port in ((SOURCE_1, port1), (SOURCE_2, port2))}
    slides: dict[str, Slide] = {}
    sites = Sites((A, B), (SOURCE_1, SOURCE_2), port1, port2)
    mount, pin = dyad.alone()
    mount.move(sites, motions, slides, placed, dyad.rates(port1, port2, placed, closed))
    inner = None if pin is None else motions[A].point(pin)
    return DyadMotion(motions[A], motions[B], tuple(slides[key] for key in sorted(slides)), inner)


def _arrays(port: Any) -> Any:
    """The port, a `Point` or a `Guide`, with arrays in place of scalars."""
    return type(port)(*map(np.asarray, port))


def _check_assembly(dyad: Dyad, port1: Any, port2: Any, where: str) -> None:
    """Raise `AssemblyError` where the links miss each other, with the worst of the positions."""
    margin = np.atleast_1d(dyad.margin(port1, port2))
    if not np.all(np.isfinite(margin)):
        raise AccuracyError(
            f"sizes too different to be compared{_position(margin, int(np.argmin(np.isfinite(margin))))}",
            where=where,
            remedy="write lengths and places of ordinary size",
        )
    k, least = int(np.argmin(margin)), float(np.min(margin))
    if least < 0:
        gap = dyad.gap("a", "b", _at(port1, margin, k), _at(port2, margin, k))
        raise AssemblyError(
            f"does not assemble{_position(margin, k)}: {gap} (margin {least:.4g})",
            where=where,
            value=least,
            limit=0.0,
            remedy="change the lengths or the places of the outer joints",
        )


def _check_regular(dyad: Dyad, regularity: Real, where: str) -> None:
    least = float(np.min(regularity))
    if not least >= SINGULAR:
        at = _position(np.atleast_1d(regularity), int(np.argmin(regularity)))
        raise SingularityError(
            f"dead point{at}: {dyad.dead_point()}; regularity {least:.3g} is below {SINGULAR:g}, velocities are not "
            "defined",
            where=where,
            value=least,
            limit=SINGULAR,
            remedy="change the lengths, the directions or the places of the outer joints",
        )


def _position(rows: Real, k: int) -> str:
    """Of several positions the number of one."""
    return f" at position {k}" if len(rows) > 1 else ""


def _at(port: Any, rows: Real, k: int) -> Any:
    """The port at one of the positions."""
    return type(port)(*(np.broadcast_to(part, rows.shape)[k] for part in port))


def _carrier(port: Point | Guide) -> LinkMotion:
    """The motion of a source link with its origin in the port and its x axis along the guide."""
    if isinstance(port, Point):
        zero, still = np.zeros((), np.complex128), np.zeros(())
        return LinkMotion(0j, *port, np.ones((), np.complex128), zero, zero, still, still)
    turning = 1j * port.omega
    return LinkMotion(
        0j,
        port.r,
        port.v,
        port.a,
        port.e,
        turning * port.e,
        (1j * port.eps - port.omega**2) * port.e,
        port.omega,
        port.eps,
    )
