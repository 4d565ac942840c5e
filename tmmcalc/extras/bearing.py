"""Rolling bearing of a wheel: speeds and the frequencies at which its defects are heard; crest factors of vibration.

The inner ring turns by n with the wheel's shaft, the outer ring stands. Rolling bodies of diameter d are on the mean
diameter Dm at the contact angle phi.
"""

from __future__ import annotations

from math import pi

import numpy as np

from tmmcalc.core.notes import Said, held
from tmmcalc.core.numerics.extended import PI, apart, widened
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

SOUND = 3.0  # crest factor of a sound bearing, about
HIGH = 5.0  # a defect that has begun


@record
class BearingTask:
    """A bearing, its speed, and readings of its vibration."""

    omega: float  # of the shaft [rad/s]
    inner: float  # bore or raceway [m]
    outer: float  # [m]
    roller: float  # d [m]
    count: int  # z
    angle: float = 0.0  # phi [rad]
    peak: tuple[float, ...] = ()  # of the vibration, in any unit
    rms: tuple[float, ...] = ()  # the same unit


@record
class Bearing:
    """Frequencies of defects in 1/s."""

    omega: float = quantity("omega[rad/s]", "angular speed of the inner ring")
    turns: float = quantity("n[1/s]", "rotational frequency of the inner ring")
    width: float = quantity("R_n[m]", "difference of outer and inner radius")
    half: float = quantity("half[m]", "half the difference of outer and inner radius")
    mean_radius: float = quantity("R_mean[m]", "mean radius")
    cage: float = quantity("FTF[Hz]", "frequency of the cage")
    outer_race: float = quantity("BPFO[Hz]", "frequency of a defect of the outer raceway")
    inner_race: float = quantity("BPFI[Hz]", "frequency of a defect of the inner raceway")
    roller: float = quantity("BSF[Hz]", "rotational frequency of a rolling body; a defect on it strikes twice a turn")
    raceway_speed: float = quantity("v_inner[m/s]", "speed of the raceway of the inner ring")
    crest: tuple[float, ...] = quantity("crest", "crest factors: peak over root mean square of readings", default=())
    notes: tuple[Said, ...] = ()
    error: float = 0.0  # of the frequencies, each relative to itself


def solve_bearing(task: BearingTask) -> Bearing:
    """Frequencies of the cage, the raceways and the rolling bodies, crest factors of the readings.

    >>> found = solve_bearing(BearingTask(4.8, 0.15, 0.34, 0.039, 14))
    >>> round(found.outer_race, 6), round(found.inner_race, 6), round(found.roller, 6), round(found.cage, 6)
    (4.496355, 6.198858, 2.338763, 0.321168)
    """
    n, mean = task.omega / (2 * pi), (task.inner + task.outer) / 2
    rates = _rates(task, pi)
    cage, outer, inner, roller = rates.tolist()
    crest = tuple(peak / rms for peak, rms in zip(task.peak, task.rms, strict=True))
    return Bearing(
        omega=task.omega,
        turns=n,
        width=(task.outer - task.inner) / 2,
        half=(task.outer - task.inner) / 4,
        mean_radius=mean / 2,
        cage=cage,
        outer_race=outer,
        inner_race=inner,
        roller=roller,
        raceway_speed=task.omega * task.inner / 2,
        crest=crest,
        notes=tuple(_notes(crest)),
        error=max(apart(one, exact) for one, exact in zip(rates, _rates(widened(task), PI), strict=True)),
    )


def _rates(task: BearingTask, half_turn: float) -> Values:
    """Cage, outer race, inner race, rolling body (4,) [1/s], in the numbers of the task."""
    n, mean = task.omega / (2 * half_turn), (task.inner + task.outer) / 2
    part = task.roller / mean * np.cos(task.angle)
    races = task.count * n / 2 * (1 - part), task.count * n / 2 * (1 + part)
    return np.array([n / 2 * (1 - part), *races, n * mean / (2 * task.roller) * (1 - part) * (1 + part)])


def _notes(crest: tuple[float, ...]) -> list[Said]:
    if not crest:
        return []
    found: list[Said] = ["note: the trend of the crest factor tells, not one value: peaks rise first, the RMS later"]
    top = max(crest)
    if top >= HIGH and crest[-1] < top:
        text = "the crest factor fell from {limit:.4g} to {value:.4g}: wear spreads, the end is near"
        found.append(held("warning", text, crest[-1], top, name="crest"))
    elif top >= HIGH:
        text = "the crest factor of {value:.4g} tells of a defect; of a sound bearing it is about {limit:g}"
        found.append(held("warning", text, top, SOUND, name="crest"))
    return found
