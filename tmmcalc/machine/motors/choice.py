"""Choice of a motor from a catalogue: the smallest power that suffices, and why every other one was refused.

A motor suffices if its power covers the required one with the reserve that is asked for, its break-down moment the peak
of the load and its starting moment the load at standstill, both reduced to its shaft, and if it stands the trial in the
machine, where there is one. The ratio of the gearing is given, or follows from the speed of the input shaft:
u = omega_N/omega_1.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record
from tmmcalc.machine.motors.model import Motor

USUAL = 50 * math.pi  # synchronous speed that is preferred among equals: 1500 rpm [rad/s]
SPEED_MARGIN = 0.05  # of the input speed that a given ratio may miss [-]

WHERE = "choice of the motor"

Trial = Callable[[Motor, float | None], str]  # (motor, gear ratio) -> what speaks against it; empty: nothing


@record
class Demand:
    """What the machine asks of its motor; moments and speed of the input shaft, None: nothing asked."""

    power: float  # [W]
    synchronous: float | None  # of the motor [rad/s]
    speed: float | None  # [rad/s]
    ratio: float | None  # u [-]
    peak: float | None  # largest resisting moment [N*m]
    start: float | None  # resisting moment at standstill [N*m]
    reserve: float = 0.0  # part of the required power that is asked for beyond it

    @property
    def whole(self) -> float:
        """Required power with its reserve [W]."""
        return self.power * (1 + self.reserve)


@record
class Refusal:
    """A motor that was considered and not chosen."""

    motor: Motor
    reason: str


@record
class Choice:
    """The chosen motor, the reasons for it, and every other motor of the catalogue with the reason against it."""

    motor: Motor
    ratio: float | None  # gear ratio u [-]; None: neither a ratio nor an input speed was given
    reasons: tuple[str, ...]
    refused: tuple[Refusal, ...]
    fit: tuple[Motor, ...] = ()  # against which nothing speaks but a trial, in the order in which they are tried


def choose(
    required_power: float,
    catalogue: Sequence[Motor],
    *,
    synchronous: float | None = None,
    input_speed: float | None = None,
    ratio: float | None = None,
    peak_moment: float | None = None,
    start_moment: float | None = None,
    reserve: float = 0.0,
    trial: Trial | None = None,
) -> Choice:
    """Choose the motor of smallest power that suffices.

    ``required_power`` [W]; ``synchronous`` speed of the motor [rad/s]; ``input_speed`` [rad/s], ``peak_moment`` and
    ``start_moment`` [N*m] of the input shaft, resistance positive; ``reserve`` part of the power beyond the required
    one. The ``trial`` is made of those that nothing else speaks against, one after the other up to the first that
    stands it. Of equal powers that motor is taken whose rotor
    inertia is known, then the synchronous speed nearest to 1500 rpm, then the earlier one. Raises `NoSolutionError` if
    none suffices, `UsageError` for demands that are not positive or moments without a ratio or an input speed.

    >>> from tmmcalc.machine.motors.catalogue import load_catalogue
    >>> motors = [motor for motor in load_catalogue() if motor.name.startswith("4A")]
    >>> choose(6200.0, motors, synchronous=157.08).motor.name
    '4A132S4'
    """
    demand = Demand(required_power, synchronous, input_speed, ratio, peak_moment, start_moment, reserve)
    _check(demand)
    verdicts = [(motor, next(_objections(demand, motor), None)) for motor in catalogue]
    fit = sorted((motor for motor, objection in verdicts if objection is None), key=_preference)
    failed = {}
    for chosen in fit:
        against = trial(chosen, _ratio(demand, chosen)) if trial is not None else ""
        if not against:
            break
        failed[chosen] = against
    verdicts = [(motor, failed.get(motor, objection)) for motor, objection in verdicts]
    if len(failed) == len(fit):
        raise _none(demand, verdicts)
    refused = tuple(
        Refusal(motor, objection or _second(chosen, motor)) for motor, objection in verdicts if motor is not chosen
    )
    return Choice(chosen, _ratio(demand, chosen), _reasons(demand, chosen, verdicts, failed), refused, tuple(fit))


def _preference(motor: Motor) -> tuple[float, bool, float]:
    unusual = math.inf if motor.synchronous is None else abs(math.log(motor.synchronous / USUAL))
    return motor.power, motor.inertia is None, round(unusual, 6)


def _ratio(demand: Demand, motor: Motor) -> float | None:
    if demand.ratio is not None:
        return demand.ratio
    return motor.speed / demand.speed if demand.speed is not None else None


def _objections(demand: Demand, motor: Motor) -> Iterator[str]:
    """What speaks against a motor, the plainest first."""
    wanted, has = demand.synchronous, motor.synchronous
    if wanted is not None and not _runs_at(motor, wanted):
        text = "its synchronous speed is {has}, not {wanted}"
        yield Phrase(text, has=_rpm(has), wanted=_rpm(wanted)) if has else "it has no synchronous speed"
    if motor.power < demand.whole:
        text = "its {power} are less than the required {required}"
        if demand.reserve:
            text = "its {power} are less than the required {required} with {reserve:.3g}% in reserve"
        yield Phrase(text, power=_kw(motor.power), required=_kw(demand.power), reserve=100 * demand.reserve)
    ratio = _ratio(demand, motor)
    if ratio is None:
        return
    if demand.speed is not None and not _in_reach(demand.speed, motor, ratio):
        turns = _rpm(motor.speed / ratio)
        yield Phrase(
            "through the ratio {ratio:.4g} it turns the input shaft at {turns}, not {wanted}",
            ratio=ratio,
            turns=turns,
            wanted=_rpm(demand.speed),
        )
    moments = (
        (demand.peak, motor.overload, "overload ratio", "peak of the load", "break-down moment"),
        (demand.start, motor.start, "starting moment", "load at standstill", "starting moment"),
    )
    for load, times, unknown, what, against in moments:
        if load is None:
            continue
        if times is None:
            yield Phrase("its {unknown} is not known", unknown=unknown)
        elif load / ratio > times * motor.nominal_moment:
            yield (
                Phrase(
                    "the {what}, {load:.4g} N*m at its shaft, exceeds its {against} of {times:.4g} N*m",
                    what=what,
                    load=load / ratio,
                    against=against,
                    times=times * motor.nominal_moment,
                )
            )


def _in_reach(speed: float, motor: Motor, ratio: float) -> bool:
    """Whether the input speed lies between the rated and the no-load speed, with a margin."""
    fastest = motor.synchronous or motor.speed
    return motor.speed / ratio * (1 - SPEED_MARGIN) <= speed <= fastest / ratio * (1 + SPEED_MARGIN)


def _second(chosen: Motor, motor: Motor) -> str:
    if motor.power > chosen.power:
        return Phrase("{power} where {least} suffice", power=_kw(motor.power), least=_kw(chosen.power))
    if motor.inertia is None and chosen.inertia is not None:
        return Phrase("it suffices too, but unlike that of {name} its rotor inertia is not known", name=chosen.name)
    return Phrase("it suffices too; {name} of the same power comes first", name=chosen.name)


def _reasons(
    demand: Demand, motor: Motor, verdicts: Sequence[tuple[Motor, str | None]], failed: Collection[Motor]
) -> tuple[str, ...]:
    """Why the motor was chosen; of smaller ones those that ``failed`` a trial tell most."""
    reserve = motor.power / demand.power - 1
    reasons = [f"{_kw(motor.power)} cover the required {_kw(demand.power)} with {reserve:.0%} in reserve"]
    smaller = [
        (other.power, other in failed, objection)
        for other, objection in verdicts
        if demand.whole <= other.power < motor.power
        and (demand.synchronous is None or _runs_at(other, demand.synchronous))
    ]
    if smaller:
        power, _, objection = max(smaller, key=lambda each: each[:2])
        reasons.append(f"the next smaller of enough power, {_kw(power)}, is refused: {objection}")
    ratio = _ratio(demand, motor)
    if ratio is None:
        return tuple(reasons)
    if demand.speed is not None and demand.ratio is None:
        reasons.append(f"the gear ratio {ratio:.4g} takes its {_rpm(motor.speed)} to {_rpm(demand.speed)}")
    if demand.peak is not None and motor.overload is not None:
        most = motor.overload * motor.nominal_moment
        reasons.append(
            f"the peak of the load, {demand.peak / ratio:.4g} N*m at its shaft, stays below its break-down moment of "
            f"{most:.4g} N*m (K = {motor.overload:g})"
        )
    if demand.start is not None and motor.start is not None:
        most = motor.start * motor.nominal_moment
        reasons.append(
            f"its starting moment of {most:.4g} N*m overcomes the load at standstill, {demand.start / ratio:.4g} N*m"
        )
    return tuple(reasons)


def _none(demand: Demand, verdicts: Sequence[tuple[Motor, str | None]]) -> NoSolutionError:
    """The error that names the largest motor of the wanted speed and what speaks against it."""
    wanted = demand.synchronous
    turning = [(motor, why) for motor, why in verdicts if wanted is None or _runs_at(motor, wanted)]
    if not verdicts:
        return NoSolutionError("the catalogue has no motors", where=WHERE)
    if not turning:
        speeds = sorted({motor.synchronous for motor, _ in verdicts if motor.synchronous is not None})
        return NoSolutionError(
            f"none of the {len(verdicts)} motors has the synchronous speed {_rpm(wanted or 0.0)}",
            where=WHERE,
            value=wanted,
            remedy=f"synchronous speeds in the catalogue: {', '.join(map(_rpm, speeds)) or 'none'}",
        )
    largest, why = max(turning, key=lambda pair: pair[0].power)
    if largest.power < demand.whole:
        remedy = "give a catalogue with larger motors"
    else:
        relief = ", or a flywheel that takes the peak off the motor" if demand.peak is not None else ""
        remedy = f"give a catalogue with stronger motors, another gear ratio{relief}"
    return NoSolutionError(
        f"none of the {len(turning)} motors suffices; the largest is {largest.name}, and {why}",
        where=WHERE,
        value=demand.power,
        limit=largest.power,
        remedy=remedy,
    )


def _runs_at(motor: Motor, synchronous: float) -> bool:
    return motor.synchronous is not None and abs(motor.synchronous - synchronous) <= 0.01 * synchronous


def _check(demand: Demand) -> None:
    parts = {
        "required power": demand.power,
        "synchronous speed": demand.synchronous,
        "input speed": demand.speed,
        "gear ratio": demand.ratio,
        "peak moment": demand.peak,
        "starting moment": demand.start,
    }
    for what, value in parts.items():
        if value is not None and not 0 < value < math.inf:
            raise UsageError(f"the {what} is {value:g}; it is positive", where=WHERE, value=value, limit=0.0)
    if demand.speed is None and demand.ratio is None and (demand.peak is not None or demand.start is not None):
        raise UsageError(
            "moments of the input shaft are given, but nothing that leads to the motor shaft",
            where=WHERE,
            remedy="give the speed of the input shaft or the gear ratio",
        )


def _rpm(omega: float) -> str:
    return f"{omega * 30 / math.pi:.5g} rpm"


def _kw(power: float) -> str:
    return f"{power / 1000:.4g} kW"
