"""Columns by choice of the forces table: the terms of Zhukovsky's lever, and of the equations of every link.

A term has the name of what acts, as `linkage.acting` gives it; a couple on the lever those of its two forces, with the
point of each: ``lever_M_M4_C``. The lever of all rows is to one scale, that of the fact ``lever_mu_v``; moments on a
link are about the point that `linkage.moments` takes. What is nothing in a row has no arm there.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.acting import Acts, acting_on, told_apart
from tmmcalc.linkage.forces.columns import drive_of
from tmmcalc.linkage.forces.results import LeverScale
from tmmcalc.linkage.forces.rows import Rows
from tmmcalc.linkage.lever import UNGIVEN, Lever, LeverForce, levers, replaced_at, velocity_scale
from tmmcalc.linkage.moments import LinkEquilibrium, equilibria, moments_about

BY_LEVER = Quantity("{name}_lever[{unit}]", "{name} by Zhukovsky's lever", source="3.2.8")
OFF_LEVER = Quantity("{name}_difference[{unit}]", "{name} by the lever, less that of the force analysis")
ON_LEVER = {
    "force": Quantity("lever_F_{force}[N]", "size of {what} on Zhukovsky's lever", source="3.2.8"),
    "arm": Quantity(
        "lever_h_{force}[mm]",
        "arm of {what} about the pole of Zhukovsky's lever, positive if it turns counter-clockwise",
        source="3.2.8",
    ),
    "moment": Quantity("lever_M_{force}[N*mm]", "moment of {what} about the pole of Zhukovsky's lever", source="3.2.8"),
}
LEVER_SUM = Quantity("lever_M[N*mm]", "sum of the moments about the pole of Zhukovsky's lever", source="3.2.8")
ON_LINK = {
    "force": Quantity("eq_{link}_F_{force}[N]", "size of {what} on link {link}", source="3.2.3"),
    "force_x": Quantity("eq_{link}_Fx_{force}[N]", "{what} on link {link}, along x", source="3.2.3"),
    "force_y": Quantity("eq_{link}_Fy_{force}[N]", "{what} on link {link}, along y", source="3.2.3"),
    "arm": Quantity(
        "eq_{link}_h_{force}[m]",
        "arm of {what} on link {link} about {joint}, positive if it turns counter-clockwise",
        source="3.2.3",
    ),
    "moment": Quantity(
        "eq_{link}_M_{force}[N*m]",
        "moment of {what} about {joint}, a term of the equation of link {link}",
        source="3.2.3",
    ),
}
LEFT = {
    "force_left": Quantity("eq_{link}_F[N]", "size of the sum of the forces on link {link}", source="3.2.3"),
    "moment_left": Quantity("eq_{link}_M[N*m]", "sum of the moments on link {link} about {joint}", source="3.2.3"),
}


class Term(NamedTuple):
    """What acts, by its name in results, and what tells it from others in a row."""

    name: str
    said: str
    couple: bool
    key: Hashable


def lever_scale(rows: Rows) -> LeverScale:
    """The scale of the lever in the columns."""
    return LeverScale(velocity_scale(rows.statics, rows.kinematics, rows.result.theta))


def lever_columns(rows: Rows) -> Iterator[Column]:
    """The drive by Zhukovsky's lever, the sum of its moments, and of each force its size, arm and moment."""
    balance, drive = _Levers(rows), drive_of(rows.result.turns)
    places = {"name": drive.name, "unit": drive.unit}
    yield column(BY_LEVER.of(**places), partial(balance.over, "drive"))
    yield column(OFF_LEVER.of(**places), lambda: balance.over("drive") - rows.result.drive)
    yield column(LEVER_SUM, partial(balance.over, "moment"))
    for term in _on_lever(rows):
        yield from _columns(ON_LEVER, term, lambda: balance.terms, {})


def equation_columns(rows: Rows) -> Iterator[Column]:
    """What is left of the equations of every link, and of each term its force, arm and moment."""
    balance = _Equations(rows)
    acting = acting_on(rows.mechanism, rows.kinematics.structure, rows.loading)
    for k, link in enumerate(rows.mechanism.links):
        about = moments_about(rows.mechanism, rows.kinematics.structure, link.id).name
        places = {"link": link.id, "joint": about}
        for part, told in LEFT.items():
            yield column(told.of(**places), partial(balance.left, k, part))
        own = [each for each in acting if each.link == link.id]
        for each, name in zip(own, told_apart(own), strict=True):
            term = Term(name, each.said, each.couple, (link.id, each.name, each.kind))
            yield from _columns(ON_LINK, term, lambda: balance.terms, places)


def _on_lever(rows: Rows) -> Iterator[Term]:
    """The forces on the lever: those given, and two for each couple."""
    structure = rows.kinematics.structure
    acting = [each for each in acting_on(rows.mechanism, structure, rows.loading) if each.kind not in UNGIVEN]
    for each, name in zip(acting, told_apart(acting), strict=True):
        if not each.couple:
            yield Term(name, each.said, False, _key(each, ""))
            continue
        tail, head = replaced_at(rows.mechanism, each.link)
        for point, _ in (head, tail):
            said = Phrase("the force in {point} in place of {what}", point=point, what=each.said)
            yield Term(f"{name}_{point}", said, False, _key(each, point))


def _key(each: Acts | LeverForce, point: str) -> Hashable:
    return each.link, each.name, each.kind, point


def _columns(
    told: Mapping[str, Quantity], term: Term, rows: Callable[[], Sequence[Mapping[Any, Any]]], places: dict[str, Any]
) -> Iterator[Column]:
    """The columns of a term; a couple has a moment alone."""

    def made(part: str) -> Real:
        nothing = np.nan if part == "arm" else 0.0
        return np.array([getattr(row[term.key], part) if term.key in row else nothing for row in rows()])

    for part, each in told.items():
        if part == "moment" or not term.couple:
            yield column(each.of(force=term.name, what=term.said, **places), partial(made, part))


class _Levers:
    """The levers of all rows, made when they are first asked for."""

    def __init__(self, rows: Rows) -> None:
        self.rows = rows

    @cached_property
    def found(self) -> tuple[Lever, ...]:
        rows = self.rows
        return levers(rows.statics, rows.kinematics, rows.result.theta, rows.side, lever_scale(rows).mu)

    @cached_property
    def terms(self) -> list[dict[Hashable, Any]]:
        """Of each row the forces by their keys."""
        return [{_key(force, force.point): force for force in each.forces} for each in self.found]

    def over(self, part: str) -> Real:
        """A number of the lever (n,)."""
        return np.array([getattr(each, part) for each in self.found])


class _Equations:
    """The equations of all links in all rows, made when they are first asked for."""

    def __init__(self, rows: Rows) -> None:
        self.rows = rows

    @cached_property
    def found(self) -> list[tuple[LinkEquilibrium, ...]]:
        return equilibria(self.rows.statics, self.rows.result.theta, self.rows.side)

    @cached_property
    def terms(self) -> list[dict[Hashable, Any]]:
        """Of each row the terms by their keys."""
        return [{(t.link, t.name, t.kind): t for each in row for t in each.terms} for row in self.found]

    def left(self, link: int, part: str) -> Real:
        """What is left (n,) of a sum on a link, by its number among the links."""
        return np.array([getattr(row[link], part) for row in self.found])
