"""What a steady regime means for the motor: overload, pull-out, heating, stability, and the range of the formula."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal

from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic
    from tmmcalc.machine.regime import Regime

SLACK = 1e-9  # relative: a limit that is met exactly counts as kept
SLOW = 0.5  # multiplier above which settling takes several cycles and is worth a note


@record
class Verdict:
    """Something worth knowing about the regime: ``note`` or ``warning``, and the numbers."""

    severity: Literal["note", "warning"]
    message: str
    value: float | None = None  # that it is about, and the limit that it is held against
    limit: float | None = None
    unit: str | None = None  # of both
    name: str = ""  # of the quantity

    def __str__(self) -> str:
        return Note(self.severity, self.message, value=self.value, limit=self.limit, unit=self.unit, name=self.name)


def verdicts(regime: Regime, characteristic: Characteristic | None, sense: float = 1.0) -> tuple[Verdict, ...]:
    """Verdicts on a regime with the ``characteristic`` reduced to the input shaft, None without motor; warnings first.

    Where the input turns clockwise ``sense`` is -1: places are told by its coordinate from position 0.
    """
    found = list(_stability(regime))
    if characteristic is not None:
        found += _speeds(regime, characteristic, sense)
        found += _moments(regime, characteristic)
        found += _validity(regime, characteristic)
    return tuple(sorted(found, key=lambda verdict: verdict.severity == "note"))


def _stability(regime: Regime) -> Iterator[Verdict]:
    slowest = abs(regime.multipliers[0])
    if regime.stable is None:
        yield Verdict("note", "nothing depends on the speed: a governor has to keep the regime")
    elif not regime.stable:
        text = Phrase("the regime is unstable: a deviation grows {slowest:.4g} times in every cycle", slowest=slowest)
        yield Verdict("warning", text, slowest, 1.0, name="multiplier")
    elif slowest > SLOW:
        cycles = math.log(10) / -math.log(slowest)
        text = Phrase(
            "the regime settles slowly: a deviation needs {cycles:.3g} cycles to fall to a tenth", cycles=cycles
        )
        yield Verdict("note", text, slowest, SLOW, name="multiplier")


def _speeds(regime: Regime, motor: Characteristic, sense: float) -> Iterator[Verdict]:
    low = Phrase(
        "the least speed {omega_min:.6g} rad/s at {place}",
        omega_min=regime.omega_min,
        place=_place(regime.theta_min, sense),
    )
    if motor.critical is not None and _less(regime.omega_min, motor.critical):
        yield Verdict(
            "warning",
            Phrase(
                "pull-out: {low} is below the break-down speed {critical:.6g} rad/s; only the kinetic energy "
                "carries the machine on: more inertia or a stronger motor",
                low=low,
                critical=motor.critical,
            ),
            *(regime.omega_min, motor.critical, "rad/s", "omega_min"),
        )
    elif motor.nominal is not None and _less(regime.omega_min, motor.nominal):
        yield Verdict(
            "warning",
            Phrase(
                "overload: {low} is below the rated speed {nominal:.6g} rad/s: more inertia or a stronger motor",
                low=low,
                nominal=motor.nominal,
            ),
            *(regime.omega_min, motor.nominal, "rad/s", "omega_min"),
        )
    if motor.synchronous is not None and _less(motor.synchronous, regime.omega_max):
        yield Verdict(
            "note",
            Phrase(
                "the motor brakes as a generator: the largest speed {omega_max:.6g} rad/s at {place} is above its "
                "no-load speed {synchronous:.6g} rad/s",
                omega_max=regime.omega_max,
                place=_place(regime.theta_max, sense),
                synchronous=motor.synchronous,
            ),
            *(regime.omega_max, motor.synchronous, "rad/s", "omega_max"),
        )


def _moments(regime: Regime, motor: Characteristic) -> Iterator[Verdict]:
    if motor.nominal is None:
        return
    rated = float(motor.moment(motor.nominal))
    peak = regime.driving_extremes[1][0]
    if _less(rated, regime.mean_moment):
        yield Verdict(
            "warning",
            Phrase(
                "the mean driving moment {mean_moment:.6g} N*m exceeds the rated {rated:.6g} N*m: the motor is "
                "too weak, no flywheel helps",
                mean_moment=regime.mean_moment,
                rated=rated,
            ),
            *(regime.mean_moment, rated, "N*m", "mean_moment"),
        )
    elif _less(rated, regime.rms_moment):
        yield Verdict(
            "warning",
            Phrase(
                "heating: the root mean square of the driving moment {rms_moment:.6g} N*m exceeds the rated "
                "{rated:.6g} N*m: a stronger motor, or more inertia",
                rms_moment=regime.rms_moment,
                rated=rated,
            ),
            *(regime.rms_moment, rated, "N*m", "rms_moment"),
        )
    elif _less(rated, peak):
        yield Verdict(
            "note",
            Phrase(
                "the largest driving moment {peak:.6g} N*m exceeds the rated {rated:.6g} N*m for a while; its "
                "root mean square {rms_moment:.6g} N*m does not",
                peak=peak,
                rated=rated,
                rms_moment=regime.rms_moment,
            ),
            *(peak, rated, "N*m", "largest_moment"),
        )


def _validity(regime: Regime, motor: Characteristic) -> Iterator[Verdict]:
    if motor.least is not None and _less(regime.omega_min, motor.least):
        yield Verdict(
            "warning",
            Phrase(
                "the {characteristic} holds from {least:.6g} rad/s up, the speed falls to {omega_min:.6g} "
                "rad/s: the whole curve of the motor (Kloss) tells more",
                characteristic=f"{motor.name} characteristic",
                least=motor.least,
                omega_min=regime.omega_min,
            ),
            *(regime.omega_min, motor.least, "rad/s", "omega_min"),
        )
    if motor.most is not None and _less(motor.most, regime.omega_max):
        yield Verdict(
            "note",
            Phrase(
                "the {characteristic} holds up to {most:.6g} rad/s, the speed rises to {omega_max:.6g} rad/s",
                characteristic=f"{motor.name} characteristic",
                most=motor.most,
                omega_max=regime.omega_max,
            ),
            *(regime.omega_max, motor.most, "rad/s", "omega_max"),
        )


def _place(theta: float, sense: float) -> str:
    return Phrase("phi = {theta:.4g} deg", theta=math.degrees(sense * theta if theta else 0.0))


def _less(a: float, b: float) -> bool:
    return a < b - SLACK * abs(b)
