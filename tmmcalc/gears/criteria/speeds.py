"""Speeds of all shafts of many trains, exactly.

With the carrier held, every mesh hands the speed on in the inverse ratio of teeth, reversed by an external mesh. The
fixed central wheel then gives the speed of the carrier (Willis): w_H = -w_fixed relative to it. All ratios are
fractions of 64-bit integers in lowest terms; signs count, positive means turning like the shaft referred to.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.model import Integers, ToothSets, Values
from tmmcalc.gears.scheme import CARRIER

DOUBLE = np.dtype(float)


@record
class Ratios:
    """Ratios of n trains as fractions in lowest terms, the denominators positive."""

    numerators: Integers  # (n, ...)
    denominators: Integers  # (n, ...)

    @property
    def values(self) -> Values:
        """The ratios as floats (n, ...)."""
        return self.of_kind(DOUBLE)

    def of_kind(self, kind: np.dtype[Any]) -> Values:
        """The ratios (n, ...) as numbers of a kind, doubles or longdoubles, rounded once."""
        quotients: Values = self.numerators.astype(kind) / self.denominators.astype(kind)
        return quotients


@record
class Speeds:
    """Speeds over that of one shaft."""

    shafts: tuple[str, ...]  # the wheels, then the carrier H
    over: str
    ratios: Ratios  # (n, shafts)

    def of(self, shaft: str, kind: np.dtype[Any] = DOUBLE) -> Values:
        """Speed (n,) of a shaft in numbers of a kind."""
        return self.exact(shaft).of_kind(kind)

    def exact(self, shaft: str) -> Ratios:
        """Speed (n,) of a shaft as fractions."""
        column = self.shafts.index(shaft)
        return Ratios(self.ratios.numerators[:, column], self.ratios.denominators[:, column])


def speeds(sets: ToothSets, over: str | None = None) -> Speeds:
    """Speeds of all shafts over that of a shaft, by default the output: i_1H, i_2H (textbook 4.19, 4.46, 4.47).

    Raises `NoSolutionError` if that shaft stands still in some train, `UsageError` if it is unknown.

    >>> train = ToothSets("AI", np.array([[22, 118, 17, 97]]), np.array([[4, 7]]), np.full((1, 2), 0.349))
    >>> speeds(train).of("1").round(6).tolist(), speeds(train).of("2").round(6).tolist()
    ([31.604278], [-4.705882])
    """
    shafts = (*sets.scheme.wheels, CARRIER)
    over = sets.scheme.output if over is None else over
    if over not in shafts:
        raise UsageError(f"no shaft {over!r}", where=f"train {sets.layout}", remedy=f"shafts: {', '.join(shafts)}")
    numerators, denominators = _absolute(sets)
    column = shafts.index(over)
    own, under = numerators[:, column, None], denominators[:, column, None]
    _refuse_standing(sets, over, own[:, 0])
    # crosswise reduction first, so that no product leaves 64 bits
    own_shared, under_shared = np.gcd(numerators, own), np.gcd(denominators, under)
    top = numerators // own_shared * (under // under_shared)
    return Speeds(shafts, over, _reduced(top, denominators // under_shared * (own // own_shared)))


def relative(sets: ToothSets) -> Ratios:
    """Speeds (n, wheels) of the wheels over that of wheel 1 with the carrier held."""
    one = np.ones(len(sets), np.int64)
    known = {"1": (one, one)}
    for mesh in sets.scheme.meshes:
        top, bottom = known[_shaft(mesh.first)]
        sign = 1 if mesh.internal else -1
        made = _reduced(sign * top * sets.of(mesh.first), bottom * sets.of(mesh.second))
        known[_shaft(mesh.second)] = made.numerators, made.denominators
    wheels = [known[_shaft(wheel)] for wheel in sets.scheme.wheels]
    return Ratios(np.stack([top for top, _ in wheels], axis=1), np.stack([bottom for _, bottom in wheels], axis=1))


def _shaft(wheel: str) -> str:
    """Wheels of the same number turn together."""
    return wheel.rstrip("'")


def _absolute(sets: ToothSets) -> tuple[Integers, Integers]:
    """Speeds (n, shafts) over the carrier's, of fixed axes over that of wheel 1: numerators and denominators."""
    held = relative(sets)
    n = len(sets)
    carrier = np.zeros((n, 1), np.int64), np.ones((n, 1), np.int64)
    if not sets.scheme.fixed:
        return np.hstack((held.numerators, carrier[0])), np.hstack((held.denominators, carrier[1]))
    fixed = sets.scheme.index(sets.scheme.fixed)
    top, bottom = held.numerators[:, fixed, None], held.denominators[:, fixed, None]
    # w = w_H (1 - r/r_fixed), r relative to the held carrier
    under = held.denominators * top
    made = _reduced(under - held.numerators * bottom, under)
    return np.hstack((made.numerators, carrier[1])), np.hstack((made.denominators, carrier[1]))


def _reduced(numerators: Integers, denominators: Integers) -> Ratios:
    shared = np.gcd(numerators, denominators) * np.where(denominators < 0, -1, 1)
    return Ratios(numerators // shared, denominators // shared)


def _refuse_standing(sets: ToothSets, over: str, speed: Integers) -> None:
    standing = np.flatnonzero(speed == 0)
    if standing.size:
        teeth = ", ".join(map(str, sets.teeth[standing[0]]))
        raise NoSolutionError(
            f"shaft {over} stands still in {standing.size} of {len(sets)} trains, first Z = {teeth}",
            where=f"train {sets.layout}",
            value=0.0,
            remedy="refer to another shaft, or leave these tooth numbers out",
        )
