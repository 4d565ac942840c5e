"""Stage ``forces``: reactions in all pairs and the drive, with friction where the pairs have it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.quantity import keyed
from tmmcalc.core.stage import said
from tmmcalc.core.stored import LAST_DIGIT
from tmmcalc.linkage.forces.results import Forces, LeverScale
from tmmcalc.linkage.wanted import FRICTION, NO_CSV, SPRINGS, interpolated, is_long

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.room import LinkageTables


INERTIA = "massless links: no loads of inertia"
GEAR = "no gear on the crank: no force of a mesh"

solve = "tmmcalc.linkage.forces.solve:solve_forces"
kind = Forces
columns = "tmmcalc.linkage.forces.columns:columns"
placed = "tmmcalc.linkage.tables.tasks.placed:with_position"
dense = "tmmcalc.linkage.tables.tasks.placed:with_positions"
derivatives = "tmmcalc.linkage.derivatives.told:of_forces"
words = "tmmcalc.linkage.tables.tasks.words:words_of"
declares = ("tmmcalc.linkage.columns:PHI", "tmmcalc.linkage.forces.further", "tmmcalc.linkage.forces.terms")


def inputs(spec: LinkageTables) -> tuple[Mechanism, Loading]:
    """The linkage and what acts on it."""
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    return to_linkage(spec.linkage), to_loading(spec)


def errors(result: Forces) -> dict[str, Any]:
    """Estimates of its errors, and what the last digit of the data does where it is more."""
    if result.last_digit is None:
        return keyed(result, "error")
    return {**keyed(result, "error"), LAST_DIGIT: keyed(result, "last_digit")}


def further(spec: LinkageTables, results: Mapping[str, Any]) -> list[Column]:
    """Loads of inertia, components along links, arms, what is without friction, friction by pair, terms of balances."""
    from tmmcalc.linkage.forces.further import further_columns

    return further_columns(*inputs(spec), results["kinematics"], results["forces"])


def details(spec: LinkageTables, results: Mapping[str, Any]) -> LeverScale:
    """The scale of Zhukovsky's lever in the columns by choice."""
    from tmmcalc.linkage.forces.rows import Rows
    from tmmcalc.linkage.forces.terms import lever_scale

    return lever_scale(Rows(*inputs(spec), results["kinematics"], results["forces"]))


def omits(spec: LinkageTables) -> tuple[str, ...]:
    """What does not act."""
    from tmmcalc.linkage.loading import GearDrive
    from tmmcalc.linkage.tables.tasks.loading import to_loading

    loading = to_loading(spec)
    return said(
        (not loading.rubs, FRICTION),
        (not loading.heavy, INERTIA),
        (not loading.springs, SPRINGS),
        (not isinstance(loading.drive, GearDrive), GEAR),
        (is_long(spec), NO_CSV),
    )


def packages(spec: LinkageTables) -> tuple[str, ...]:
    """Monotone cubics through the points of a load."""
    return ("scipy.interpolate",) if interpolated(spec) else ()
