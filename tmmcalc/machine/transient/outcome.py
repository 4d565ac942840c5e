"""From the rows of a run to curves: every mass and shaft on its own shaft, and the energies."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.machine.transient.equations import System
from tmmcalc.machine.transient.model import Drive, ratios, shaft_ratios
from tmmcalc.machine.transient.pointwise import tabulated
from tmmcalc.machine.transient.profile import Profiles
from tmmcalc.machine.transient.run import Row


class Curves(NamedTuple):
    """Everything over the S rows, in the order of the record of a transient motion."""

    t: Values
    theta: Values  # (N, S) on own shafts
    omega: Values
    alpha: Values
    shaft_moment: Values  # (N - 1, S) on own shafts
    motor_moment: Values
    load_moment: Values
    load_factor: Values
    kinetic: Values
    elastic: Values
    works: Values  # (4, S) of motor, load and brake, and what the shafts lose
    step_error: Values | None

    def rows(self) -> dict[str, Any]:
        """All of them by their names in that record."""
        works = zip(("motor_work", "load_work", "brake_work", "shaft_loss"), self.works, strict=True)
        return {name: value for name, value in self._asdict().items() if name != "works"} | dict(works)


class _Moments(NamedTuple):
    """Moments on the groups, on the crank's shaft."""

    motor: Values  # (S,)
    load: Values  # (S,)
    brake: Values  # (S,) against the motion
    elastic: Values  # (n - 1, S) of the elastic shafts
    inertia: Values  # (n, S)
    alpha: Values  # (n, S)


def curves(drive: Drive, system: System, ways: Profiles, rows: list[Row], brake_mass: int) -> Curves:
    """All curves of a run whose brake, if any, is on the mass ``brake_mass``."""
    layout, chain = system.layout, system.chain
    n, group = layout.groups, list(chain.group)
    y = np.array([row.y for row in rows]).T
    twist, w, at_crank = y[1:n], y[n : 2 * n], np.zeros((1, len(rows)))
    moments = _moments(drive, system, ways, rows, y)
    speed = np.array(chain.ratio)[:, None]
    angle = y[0] + np.concatenate((np.cumsum(twist[::-1], axis=0)[::-1], at_crank))
    return Curves(
        t=np.array([row.t for row in rows]),
        theta=speed * angle[group],
        omega=speed * w[group],
        alpha=speed * moments.alpha[group],
        shaft_moment=_shafts(drive, chain.group, moments, brake_mass),
        motor_moment=moments.motor / chain.motor_ratio,
        load_moment=moments.load,
        load_factor=np.array([row.regime.factor for row in rows]),
        kinetic=(moments.inertia * w**2).sum(axis=0) / 2,
        elastic=(np.array(chain.stiffness)[:, None] * twist**2).sum(axis=0) / 2,
        works=y[layout.works :],
        step_error=_errors(rows, layout.works),
    )


def _moments(drive: Drive, system: System, ways: Profiles, rows: list[Row], y: Values) -> _Moments:
    chain, n = system.chain, system.layout.groups
    regimes = [row.regime for row in rows]
    table = np.array([(r.motor, r.braked, r.slip, r.factor, r.stretch, r.base) for r in regimes], dtype=float).T
    on, braked, slip, factor, index, base = table
    w = y[n : 2 * n]
    inertia, slope, load = np.zeros((3, len(rows)))
    way = np.array([r.way for r in regimes])
    for side in set(way.tolist()):
        at = way == side
        found = tabulated(ways.of(side), y[0, at], w[-1, at], factor[at], index[at].astype(np.intp), base[at])
        inertia[at], slope[at], load[at] = found
    motor = _motor(drive, system, on, y)
    damping, stiffness = np.array(chain.damping)[:, None], np.array(chain.stiffness)[:, None]
    elastic = stiffness * y[1:n] - damping * np.diff(w, axis=0)
    brake = braked * (slip * system.grip + system.drag * w[system.brake])
    net = np.concatenate((motor[None], elastic)) - np.concatenate((elastic, np.zeros((1, len(rows)))))
    net[-1] += load - slope * w[-1] ** 2 / 2
    held = [(i, regime) for i, regime in enumerate(regimes) if regime.held]
    for i, regime in held:
        if system.brake in regime.held and abs(net[system.brake, i]) <= regime.braked * system.grip:
            brake[i] = net[system.brake, i]
    net[system.brake] -= brake
    total = np.repeat(np.array(chain.inertia)[:, None], len(rows), axis=1)
    total[-1] += inertia
    alpha = net / total
    for i, regime in held:
        alpha[list(regime.held), i] = 0.0
    return _Moments(motor, load, brake, elastic, total, alpha)


def _motor(drive: Drive, system: System, on: Values, y: Values) -> Values:
    """Moment of the motor on the crank's shaft (S,)."""
    if drive.characteristic is None:
        return np.zeros(y.shape[1])
    if system.layout.lag:
        return y[system.layout.works - 1]
    u = system.chain.motor_ratio
    return on * u * np.asarray(drive.characteristic.moment(u * y[system.layout.speed]))


def _shafts(drive: Drive, group: tuple[int, ...], moments: _Moments, brake_mass: int) -> Values:
    """Moments of all shafts, each on its own (N - 1, S): a rigid one carries on what does not accelerate or brake."""
    speed, own = ratios(drive), shaft_ratios(drive)
    carried, found = moments.motor, []
    for i, u in enumerate(own):
        if group[i + 1] > group[i]:
            carried = moments.elastic[group[i]]
        else:
            carried = carried - drive.masses[i].inertia * speed[i] ** 2 * moments.alpha[group[i]]
            carried = carried - moments.brake if i == brake_mass else carried
        found.append(carried / u)
    return np.array(found).reshape(len(own), len(moments.motor))


def _errors(rows: list[Row], unknowns: int) -> Values | None:
    """Largest estimated error of angle, twists, speeds and motor moment in the step to every row (S,)."""
    if all(row.error is None for row in rows):
        return None
    return np.array([max(map(abs, row.error[:unknowns])) if row.error else 0.0 for row in rows])
