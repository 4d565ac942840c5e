"""What goes round with the input shaft beside the linkage: a mechanism of its own that the shaft drives, such as a cam.

The room of that mechanism makes the record; here its inertia and its moments join those of a reduction. Nothing of how
they were found is known here.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.results import Extreme, Grade
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.nodes import NEAR, on_edges
from tmmcalc.machine.reduction.results import Contribution, Reduction, ReductionError

Kind = Literal["load", "weight", "spring", "friction"]


@record
class AttachedCause:
    """One cause of moment of what is attached: along the motion a positive moment drives the shaft [N*m], (K, N).

    With technological loads and without, and the same where the shaft is turned back, which turns friction alone round.
    """

    name: str
    kind: Kind
    moment: Values
    idle: Values
    back: Values
    back_idle: Values
    work: float = quantity("work_{cause}[J]", "work of {cause} on the shaft while it repeats once")


@record
class Attached:
    """What is attached to the input shaft, reduced to it, over the ``turns`` of the shaft after which it repeats."""

    name: str
    turns: int = quantity("turns_{name}", "turns of the input shaft after which the {name} repeats")
    panels: Panels  # of [0, 2 pi turns] of the angle of the input shaft, along its motion
    inertia: Values  # J [kg*m^2], (K, N)
    slope: Values  # dJ/dtheta [kg*m^2/rad], (K, N)
    causes: tuple[AttachedCause, ...]
    speed: float = quantity("speed[rad/s]", "mean speed of the input shaft, at which the friction is taken")
    ratio: float = quantity("u_{name}", "speed of the {name} over that of the input shaft")
    inertia_max: float = quantity("J_{name}_max[kg*m^2]", "largest inertia of the {name} at the input shaft")
    torque: tuple[Extreme, Extreme]  # least and largest moment that it asks of the shaft at the mean speed, inertia too
    jams_back: bool  # turned back it would jam: then the moments back are not known
    notes: tuple[str, ...]
    error: ReductionError

    def moments(self, which: str = "moment") -> Values:
        """Moments (S, K, N) of all causes: ``moment``, ``idle``, ``back`` or ``back_idle``."""
        return np.array([getattr(cause, which) for cause in self.causes]).reshape(-1, *self.inertia.shape)

    @property
    def period(self) -> float:
        """Angle of the input shaft after which it repeats [rad]."""
        return 2 * math.pi * self.turns

    def on(self, panels: Panels, values: Values) -> Values:
        """Functions (..., K, N) on finer panels of whole periods."""
        x = self._once(panels.x.ravel())
        return self.panels.at(values, x).reshape(*values.shape[:-2], *panels.x.shape)

    def along(self, values: Values, theta: Values) -> Values:
        """Functions (..., K, N) at angles theta (n,) of the input, the last from within the cycle."""
        inner = self.panels.at(values, on_edges(self.panels.edges, self._once(theta), NEAR * self.period))
        inner[..., -1] = self.panels.at(values, np.array([self.period]), before=True)[..., 0]
        return inner

    def _once(self, theta: Values) -> Values:
        """Angles (n,) from its last repetition on; rounding does not make its begin an end."""
        near = NEAR * self.period
        return np.maximum(np.mod(theta + near, self.period) - near, 0.0)


def common_turns(attached: Iterable[Attached]) -> int:
    """The turns of the shaft after which all of them repeat."""
    return math.lcm(1, *(each.turns for each in attached))


def with_attached(result: Reduction, attached: Iterable[Attached]) -> Reduction:
    """A reduction, of whole periods of all that is attached, with its causes behind those of the linkage.

    Raises `UsageError` where the input does not turn fully: nothing then repeats with it.
    """
    for each in attached:
        result = _with_one(result, each)
    return result


def _with_one(result: Reduction, attached: Attached) -> Reduction:
    if not result.whole:
        raise UsageError(
            f"the {attached.name} repeats with the turns of the crank, which does not turn fully",
            where=attached.name,
            remedy="leave out what limits its turn, such as span in [mechanism.grid], or remove shaft in "
            f"[{attached.name}]",
        )
    panels = _common(result.cycle.panels, attached)
    theta = np.abs(result.phi - result.phi[0])
    sense = 1.0 if result.speed > 0 else -1.0
    moment = sense * attached.along(attached.moments(), theta)
    inertia = attached.along(attached.inertia, theta)
    parts = attached.on(panels, attached.moments())
    cycle = joined(result.cycle, attached, panels)
    least, largest = panels.extremes(cycle.inertia)
    return replace(
        result,
        contributions=(*result.contributions, *_contributions(attached, panels, parts, sense, theta, moment)),
        moment=np.concatenate((result.moment, moment)),
        total=result.total + moment.sum(axis=0),
        inertia=result.inertia + inertia,
        slope=result.slope + sense * attached.along(attached.slope, theta),
        parts=np.concatenate((_refined(result.cycle.panels, panels, result.parts), parts)),
        cycle=cycle,
        idle=_idle(result, attached, panels),
        inertia_range=(Extreme(*least), Extreme(*largest)),
        other=None if result.other is None else result.other + inertia,
        error=_worse(result.error, attached.error),
        grades=(*result.grades, *(Grade("note", attached.name, note) for note in attached.notes)),
        counters={"panels": panels.count, "points": panels.x.size},
    )


def joined(
    cycle: Cycle, attached: Attached, panels: Panels | None = None, *, idle: bool = False, back: bool = False
) -> Cycle:
    """A cycle with what is attached: ``idle`` without its technological loads, ``back`` with the shaft turned back."""
    on = panels or _common(cycle.panels, attached)
    name = ("back_idle" if idle else "back") if back else ("idle" if idle else "moment")
    moments = attached.on(on, attached.moments(name).sum(axis=0))
    own = _refined(
        cycle.panels, on, np.stack((cycle.inertia, cycle.slope, cycle.moment, cycle.viscous, cycle.quadratic))
    )
    return replace(
        cycle,
        panels=on,
        inertia=own[0] + attached.on(on, attached.inertia),
        slope=own[1] + attached.on(on, attached.slope),
        moment=own[2] + moments,
        viscous=own[3],
        quadratic=own[4],
        error=max(cycle.error, attached.error.functions),
    )


def backwards(
    cycle: Cycle, idle: Cycle | None, attached: Sequence[Attached], *, joined_already: bool = True
) -> tuple[Cycle, Cycle | None]:
    """Cycles with and without technological loads where the shaft is turned back.

    Those that have what is attached, turned forward, in them (``joined_already``) get what its friction changes by.
    Raises `NoSolutionError` for what jams when it is turned back.
    """
    for each in attached:
        if each.jams_back:
            raise NoSolutionError(
                f"turned back, the {each.name} jams its follower",
                where=each.name,
                remedy='less friction, or standstill = "stop"',
            )
        cycle = _back(cycle, each, idle=False, there=joined_already)
        idle = None if idle is None else _back(idle, each, idle=True, there=joined_already)
    return cycle, idle


def _back(cycle: Cycle, attached: Attached, *, idle: bool, there: bool) -> Cycle:
    if not there:
        return joined(cycle, attached, idle=idle, back=True)
    back, forth = ("back_idle", "idle") if idle else ("back", "moment")
    change = (attached.moments(back) - attached.moments(forth)).sum(axis=0)
    return replace(cycle, moment=cycle.moment + attached.on(cycle.panels, change))


def _idle(result: Reduction, attached: Attached, panels: Panels) -> Cycle | None:
    """Without technological loads, where there are any: those of what is attached, or those of the linkage."""
    loaded = any(cause.kind == "load" for cause in attached.causes)
    if result.idle is not None:
        return joined(result.idle, attached, panels, idle=True)
    linked = any(part.kind == "load" for part in result.contributions)
    return joined(result.cycle, attached, panels, idle=True) if loaded and not linked else None


def _common(panels: Panels, attached: Attached) -> Panels:
    """Panels with the edges of both, those of what is attached in each of its periods."""
    period = float(panels.edges[-1])
    times = round(period / attached.period)
    further = np.concatenate([attached.panels.edges[1:] + attached.period * k for k in range(times)])
    place = np.searchsorted(panels.edges, further)
    low, high = panels.edges[np.maximum(place - 1, 0)], panels.edges[np.minimum(place, panels.count)]
    apart = np.minimum(np.abs(further - low), np.abs(further - high)) > NEAR * period
    return Panels(np.sort(np.concatenate((panels.edges, further[apart]))), panels.order)


def _refined(coarse: Panels, fine: Panels, values: Values) -> Values:
    """Functions (..., K, N) on panels that divide those that they are on."""
    return coarse.at(values, fine.x.ravel()).reshape(*values.shape[:-2], *fine.x.shape)


def _contributions(
    attached: Attached, panels: Panels, parts: Values, sense: float, theta: Values, moment: Values
) -> Iterator[Contribution]:
    for cause, part, row in zip(attached.causes, parts, sense * moment, strict=True):
        (low, low_at), (high, high_at) = panels.extremes(sense * part)
        yield Contribution(
            name=cause.name,
            kind=cause.kind,
            role=None,
            order=0,
            work=float(panels.total(part)),
            error=(attached.error.work + EPS) * float(panels.total(np.abs(part))),
            simpson=simpson(theta, row),
            least=Extreme(low, low_at),
            largest=Extreme(high, high_at),
        )


def _worse(own: ReductionError, other: ReductionError) -> ReductionError:
    """The larger of each error."""
    names: Sequence[str] = ("inertia", "slope", "moment", "functions", "between", "work")
    return ReductionError(*(max(getattr(own, name), getattr(other, name)) for name in names))
