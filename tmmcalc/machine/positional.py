"""Steady motion under forces of position alone, kept at a mean speed by the driving moment.

The kinetic energy is T = T0 + A(theta), where A is the work of all moments with the driving one; a constant driving
moment closes the work of the cycle (textbook 3.45), and T0 sets the mean speed. The speed is omega = sqrt(2 T / J)
(3.48).
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.numerics.collocation import TOLERANCE
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import NARROWEST, PASSES, Panels, Values
from tmmcalc.machine.cycle import Cycle, place
from tmmcalc.machine.onemass import check_inertia, onto
from tmmcalc.machine.regime import Regime, regime_of
from tmmcalc.machine.regimeerrors import ROUNDED

WHERE = "steady motion"
BALANCED = 1e-6  # work that a given driving moment may leave over, against the work of all moments
CLOSED = 1e-14  # the same, as mere rounding of a diagram that closes by itself
LEVEL = 1e-15  # relative change of the energy at which its level is found
LEVELS = 60
ROUNDINGS = 4.0  # that an interpolated inertia or a sum of works adds up: finer panels would follow them


def positional(
    cycle: Cycle,
    constant_inertia: float,
    speed: float | None = None,
    given_moment: float | Values | None = None,
    *,
    sense: float = 1.0,
) -> Regime:
    """The regime whose mean speed (omega_max + omega_min)/2 is ``speed`` [rad/s], by default that of the cycle.

    The driving moment is constant and closes the work of a cycle, or it is the ``given_moment`` [N*m], a number or a
    function (K, N) on the panels of the cycle. ``constant_inertia`` [kg*m^2] may be zero. With resistances that depend
    on speed the constant driving moment is found together with the motion. ``sense`` is -1 where the input turns
    clockwise: messages tell places by its coordinate. Raises `NoSolutionError` where the energy
    does not last for the cycle (with the angle and the inertia that would do), or where a given moment leaves work
    over; `UsageError` for impossible arguments.
    """
    mean = cycle.speed if speed is None else speed
    if not (0 < mean < np.inf and 0 <= constant_inertia < np.inf):
        raise UsageError(
            f"a mean speed of {mean:g} rad/s with a constant inertia of {constant_inertia:g} kg*m^2",
            where=WHERE,
            remedy="the speed is positive, the inertia not negative, both finite",
        )
    check_inertia(cycle, constant_inertia, sense)
    if not np.any(cycle.viscous) and not np.any(cycle.quadratic):
        return free(cycle, constant_inertia, mean, _driving(cycle, given_moment), sense)
    if given_moment is not None:
        raise UsageError(
            "with a resistance that depends on speed a given driving moment sets the speed itself",
            where=WHERE,
            remedy="leave the moment out, or give it as a motor's constant characteristic",
        )
    from tmmcalc.machine.resisted import resisted

    return resisted(cycle, constant_inertia, mean, sense)


def _driving(cycle: Cycle, given: float | Values | None) -> Values:
    """The driving moment (K, N): the constant one that closes the work of the cycle, or the given one if it does."""
    load = float(cycle.panels.total(cycle.moment))
    if given is None:
        closed = abs(load) <= CLOSED * float(cycle.panels.total(np.abs(cycle.moment)))
        return np.full(cycle.moment.shape, 0.0 if closed else -load / cycle.period)
    driving = np.broadcast_to(np.asarray(given, float), cycle.moment.shape)
    surplus = float(cycle.panels.total(driving)) + load
    turnover = float(cycle.panels.total(np.abs(driving) + np.abs(cycle.moment)))
    if abs(surplus) <= BALANCED * turnover:
        return driving - surplus / cycle.period
    raise NoSolutionError(
        f"the given driving moment leaves {surplus:.6g} J over in every cycle, so the speed {_drifts(surplus)}",
        where=WHERE,
        value=surplus,
        limit=BALANCED * turnover,
        remedy=f"a moment with the mean {-load / cycle.period:.6g} N*m, or none: then a constant one is found",
    )


def _drifts(surplus: float) -> str:
    return "grows without end" if surplus > 0 else "falls to a stand"


def free(cycle: Cycle, constant: float, mean: float, driving: Values, sense: float) -> Regime:
    """The regime under the ``driving`` moment (K, N), which closes the work, where nothing depends on the speed."""
    on, moment = cycle, driving
    for meshes in range(1, PASSES + 1):
        inertia = on.inertia + constant
        work = on.panels.primitive(on.moment + moment)[0]
        if meshes == 1:
            _check_energy(on, work, constant, mean, sense)
        energy = _level(on.panels, work, inertia, mean) + work
        omega = np.sqrt(2 * energy / inertia)
        tail = on.panels.tail(omega) / np.max(omega)
        noise = _rounding(cycle, on.panels) * np.max(omega / inertia, axis=1) / (2 * np.max(omega))
        rough = (tail > np.maximum(TOLERANCE, noise)) & (on.panels.width > NARROWEST * cycle.period)
        if not rough.any():
            break
        on = onto(cycle, on.panels.split(rough))
        moment = cycle.panels.at(driving, on.panels.x.ravel()).reshape(on.moment.shape)
    rounding = ROUNDINGS * EPS * float(np.ptp(work) / np.min(energy)) / 2
    drive, turned = float(np.max(np.abs(moment))), float(on.panels.total(np.abs(on.moment))) / on.period
    return regime_of(
        on,
        constant,
        omega,
        moment,
        (1 + 0j,),
        np.maximum(tail - ROUNDED, 0.0) + rounding,
        {"newton": 0, "meshes": meshes},
        own=(ROUNDINGS * EPS + cycle.error) * turned / drive if drive else 0.0,
    )


def _rounding(cycle: Cycle, panels: Panels) -> Values:
    """Rounding (K,) [kg*m^2] of the inertia on finer panels: that of the largest one from which it is interpolated."""
    whole = np.searchsorted(cycle.panels.edges, (panels.edges[:-1] + panels.edges[1:]) / 2) - 1
    return ROUNDINGS * EPS * np.max(cycle.inertia, axis=1)[whole]


def _check_energy(cycle: Cycle, work: Values, constant: float, mean: float, sense: float) -> None:
    """Raise `NoSolutionError` if the energy at the mean speed does not last for the cycle.

    With the least inertia that does, the speed falls to zero once a cycle and rises to twice the mean.
    """
    (least, at), _ = cycle.panels.extremes(work)
    need = cycle.panels.extremes((work - least) / (2 * mean * mean) - cycle.inertia)[1][0]
    if constant > need:
        return
    raise NoSolutionError(
        f"the machine would stop at {place(at, sense)} of the cycle: at a mean speed of {mean:.6g} rad/s "
        f"the kinetic energy of {constant:.6g} kg*m^2 does not last",
        where=WHERE,
        value=constant,
        limit=need,
        remedy=f"a constant inertia of more than {need:.4g} kg*m^2 (a flywheel), or a higher speed",
    )


def _level(panels: Panels, work: Values, inertia: Values, mean: float) -> float:
    """T0, the kinetic energy at theta = 0, for which the extremes of the speed have the mean asked for.

    At an extreme the speed is stationary, so renewing the places and the speeds there in turn doubles the digits.
    """
    lowest = panels.extremes(work)[0][0]
    level = max(mean * mean * float(np.mean(inertia)) / 2, 0.1 * float(np.ptp(work))) - lowest
    for _ in range(LEVELS):
        omega = np.sqrt(2 * (level + work) / inertia)
        (slow, a), (fast, b) = panels.extremes(omega)
        work_a, work_b = panels.at(work, np.array([a, b]))
        inertia_a, inertia_b = 2 * (level + work_a) / slow**2, 2 * (level + work_b) / fast**2
        fast = _faster(inertia_a, inertia_b, float(work_b - work_a), mean)
        before = level
        level = max(inertia_b * fast**2 / 2 - float(work_b), (before + lowest) / 4 - lowest)
        if abs(level - before) <= LEVEL * (level + np.ptp(work)):
            break
    return level


def _faster(inertia_a: float, inertia_b: float, gain: float, mean: float) -> float:
    """The speed at b where J_b w_b^2 - J_a w_a^2 = 2 ``gain`` and w_a + w_b = 2 ``mean``."""
    linear = 4 * mean * inertia_a
    constant = 4 * mean * mean * inertia_a + 2 * gain
    root = linear * linear + 4 * (inertia_b - inertia_a) * constant
    return 2 * constant / (linear + float(np.sqrt(max(root, 0.0))))
