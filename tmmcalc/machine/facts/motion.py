"""The documents of the motion stage: unevenness, extreme speeds, the drive, stability, the recurrence, the table.

Speeds, moments and inertias are those of the input shaft, counted along its motion: speeds are positive, and so are
moments that drive.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from tmmcalc.core.columns import Column
from tmmcalc.core.quantity import Quantity, keyed, quantities, table
from tmmcalc.linkage.facts.places import Shaft, span_fact
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.columns import motion_columns
from tmmcalc.machine.driver import ConstantInertia
from tmmcalc.machine.facts.timescales import scales_fact
from tmmcalc.machine.motion import Motion
from tmmcalc.machine.motorside import MotorSide
from tmmcalc.machine.recurrence import BOOK
from tmmcalc.machine.regime import LOST, Regime
from tmmcalc.machine.textbook import Textbook, Turn
from tmmcalc.machine.verdicts import SLACK
from tmmcalc.report.document import Document, Fact, untold
from tmmcalc.report.numbers import NOISE, number
from tmmcalc.report.positions import with_positions

NAMES = {"kloss": "Kloss", "table": "tabulated"}
SHOWN = 6  # speeds of the iteration that are named
STEADY = 1e-9  # of a moment: it changes by less and is constant

SPEED, IDLE_SPEED, DRIVING = (quantities(Motion)[name] for name in ("omega", "omega_idle", "driving"))
MULTIPLIERS = quantities(Regime)["multipliers"]
METHOD = Quantity("method", "method that found the regime")
WHY = Quantity("method_reason", "why by that method")
IDLE_DELTA = Quantity("delta_idle", "coefficient of speed fluctuation without technological loads")
IDLE_POWER = Quantity("P_idle_mean[W]", "mean driving power without technological loads")
OF_DRIVE = ("mean_moment", "rms_moment", "mean_power")  # of a regime: told where something drives


def summary(result: Motion, title: str) -> Document:
    """Facts and notes, without the table of positions."""
    regime, shaft = result.regime, Shaft(result.phi)
    facts = (
        _driver_fact(result),
        inertia_fact("constant inertia", keyed(result.inertia, "total"), result.inertia),
        _delta_fact(result),
        _speed_fact(shaft, "speed", SPEED, regime),
        *_mean_facts(regime),
        *(_driving_facts(shaft, regime) if result.kind != "none" else ()),
        *_motor_facts(result.motor),
        _stability_fact(regime),
        *_idle_facts(shaft, result.idle),
        *_textbook_facts(result),
        *_energy_facts(result),
        *_method_facts(result),
        *_check_facts(regime),
    )
    facts += (
        *untold(facts, regime, but=OF_DRIVE if result.kind == "none" else ()),
        *untold(facts, result, but=("balancing",)),
    )
    return Document(title, facts, tuple(str(verdict) for verdict in result.verdicts))


def document(
    result: Motion,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """Summary and table of positions.

    ``patterns`` choose columns by name, header or wildcard, ``rows`` positions by index; all columns are shown
    as far as they fit, so ``everything`` changes nothing here. ``where`` is the file that has them all. ``further``
    columns are there if ``patterns`` name them.
    """
    return with_positions(
        summary(result, title),
        result.labels,
        motion_columns(result),
        patterns,
        rows,
        example="phi,omega*",
        everything=everything,
        where=where,
        further=further,
    )


def unevenness(delta: float, digits: int = 7) -> str:
    """The coefficient, and as courses write it: ``0.05 = 1/20``."""
    return f"{number(delta, digits)} = 1/{number(1 / delta, 4)}" if delta > NOISE else "0"


def inertia_fact(label: str, total: Mapping[str, Any], inertia: ConstantInertia) -> Fact:
    """A constant inertia, its ``total`` under its key, and its parts."""
    parts = {name: getattr(inertia, name) for name in ("rotor", "gears", "further", "flywheel")}
    trains = " and ".join(filter(None, (inertia.train and f"gear train {inertia.train}", inertia.open)))
    whence = {"gears": f" ({trains})" if trains else ""}
    text = " + ".join(f"{name} {number(value)}{whence.get(name, '')}" for name, value in parts.items() if value)
    values = {**total, **{key: value for key, value in keyed(inertia, *parts, "train", "open").items() if value}}
    return Fact(label, f"{number(inertia.total)} kg*m^2{f' = {text}' if text else ''}", values)


def _driver_fact(result: Motion) -> Fact:
    values = keyed(result, "kind", "characteristic")
    if result.kind == "motor":
        name = NAMES.get(result.characteristic, result.characteristic)
        return Fact("driven by", f"a motor with the {name} characteristic", values)
    if result.kind == "none":
        return Fact("driven by", "nothing but its loads, which set the speed", values)
    moment, balancing = result.regime.mean_moment, result.balancing
    if balancing:
        text = f"the diagram with its balancing moment of {number(balancing)} N*m"
        return Fact("driven by", f"{text}: nothing is left to drive", values | keyed(result, "balancing"))
    what = "a constant moment" if moment >= 0 else "its loads, against a constant moment"
    return Fact("driven by", f"{what} that makes the work of a cycle zero", values)


def _delta_fact(result: Motion) -> Fact:
    """The unevenness, and that of the idle run beside it."""
    delta, idle = result.regime.delta, result.idle
    values = keyed(result.regime, "delta")
    text = f"{unevenness(delta)}, coefficient of speed fluctuation"
    if idle is not None:
        text += f"\n{unevenness(idle.delta)} without technological loads"
        values |= IDLE_DELTA.value(idle.delta)
    return Fact("delta", text, values)


def _speed_fact(shaft: Shaft, label: str, told: Quantity, regime: Regime) -> Fact:
    extremes = Extreme(regime.omega_min, regime.theta_min), Extreme(regime.omega_max, regime.theta_max)
    return span_fact(shaft, label, told.name, told.unit, extremes)


def _mean_facts(regime: Regime) -> list[Fact]:
    mean, over_time, time = regime.mean, regime.time_mean, regime.cycle_time
    text = f"{number(mean)} rad/s ({number(mean * 30 / math.pi)} rpm), between the extremes\n"
    text += f"{number(over_time)} rad/s ({number(over_time * 30 / math.pi)} rpm), over the time"
    return [
        Fact("mean speed", text, keyed(regime, "mean", "time_mean")),
        Fact("cycle time", f"{number(time)} s", keyed(regime, "cycle_time")),
    ]


def _driving_facts(shaft: Shaft, regime: Regime) -> list[Fact]:
    """Moment and power of the drive."""
    (least, least_at), (largest, largest_at) = regime.driving_extremes
    mean, rms = regime.mean_moment, regime.rms_moment
    extremes = Extreme(least, least_at), Extreme(largest, largest_at)
    fact = span_fact(shaft, "driving moment", DRIVING.name, DRIVING.unit, extremes)
    text = fact.text
    if largest - least > STEADY * max(abs(least), abs(largest)):
        text += f"\nmean {number(mean)} N*m, rms over the time {number(rms)} N*m"
    values = {**fact.values, **keyed(regime, "mean_moment", "rms_moment")}
    return [
        replace(fact, text=text, values=values),
        Fact("mean driving power", f"{number(regime.mean_power)} W", keyed(regime, "mean_power")),
    ]


def _motor_facts(motor: MotorSide | None) -> list[Fact]:
    """Power and moment at the shaft of the motor, and how they warm it."""
    if motor is None:
        return []
    gears = f", through gears of the efficiency {number(motor.efficiency)}" if motor.efficiency != 1 else ""
    text = f"mean {number(motor.mean_power)} W{gears}\nlargest moment {number(motor.largest)} N*m"
    facts = [Fact("at the motor's shaft", text, keyed(motor, "mean_power", "largest"))]
    rms, heating = f"rms moment {number(motor.rms_moment)} N*m", motor.heating
    values = keyed(motor, "rms_moment")
    if heating is None:
        return [*facts, Fact("heating of the motor", f"{rms}; its rated moment is not known", values)]
    says = "it overheats" if heating > 1 + SLACK else "it bears that"
    text = f"{rms}, {number(heating, 4)} of the rated {number(motor.rated_moment or 0.0)} N*m: {says}"
    return [*facts, Fact("heating of the motor", text, values | keyed(motor, "heating"))]


def _stability_fact(regime: Regime) -> Fact:
    """The multipliers in words."""
    pairs = [[mu.real, mu.imag] for mu in regime.multipliers]
    slowest = regime.multipliers[0]
    size = abs(slowest)
    if regime.stable is None:
        text = "indifferent: nothing depends on the speed, a governor has to hold it"
    elif not regime.stable:
        text = f"unstable: a deviation grows {number(size, 4)} times in a cycle"
    else:
        left = number(100 * size, 3) if size > LOST else "0"
        swings = ", swinging" if slowest.imag else ""
        text = f"stable: {left} % of a deviation is left after a cycle{swings}"
    return Fact("stability", text, {**keyed(regime, "stability"), MULTIPLIERS.key: pairs})


def _idle_facts(shaft: Shaft, idle: Regime | None) -> list[Fact]:
    """The run without technological loads."""
    if idle is None:
        return []
    return [
        _speed_fact(shaft, "speed when idle", IDLE_SPEED, idle),
        Fact("idle driving power", f"{number(idle.mean_power)} W", IDLE_POWER.value(idle.mean_power)),
    ]


def _textbook_facts(result: Motion) -> list[Fact]:
    """The recurrence (3.57) on the positions, and how far it is off."""
    book = result.textbook
    if book is None:
        if result.characteristic != "parabolic":
            return []
        why = "not done: it takes a parabola without gear losses or lag, equal steps, and a speed that settles"
        return [Fact("recurrence (3.57)", why)]
    exact, nodal = result.regime.delta, book.regime.delta
    off = f", {100 * (nodal / exact - 1):+.3g} % against the exact one" if exact > NOISE else ""
    low, high = (result.labels[k] for k in (book.regime.node_min, book.regime.node_max))
    lines = (
        f"A = {number(book.a)} N*m, B = {number(book.b)} N*m*s^2",
        f"delta = {number(nodal, peak=1.0)}{off}",
        f"speed least in position {low}, largest in {high}",
        _off(result),
        f"largest B dphi/J = {number(book.regime.warning, 4)}{_sound(book)}",
        *_turns(book),
    )
    values = {
        **keyed(book, "a", "b"),
        **keyed(book.regime, "delta"),
        **keyed(result, "textbook_error"),
        **table(book.turns, Turn),
        **keyed(book.regime, "warning"),
    }
    return [Fact("recurrence (3.57)", "\n".join(lines), values)]


def _off(result: Motion) -> str:
    """How far the speeds of the textbook are off."""
    return f"speeds up to {number(100 * (result.textbook_error or 0.0), 3, peak=100.0)} % off the exact ones"


def _energy_facts(result: Motion) -> list[Fact]:
    """The motion by the energy at the positions (3.48), and how far it is off."""
    if result.kind != "positional":
        return []
    found, label = result.by_energy, "textbook (3.48)"
    if found is None:
        return [Fact(label, "not done: it takes equal steps, and an energy that lasts for the cycle")]
    exact, mean = result.regime.delta, result.regime.mean
    off = f", {100 * (found.delta / exact - 1):+.3g} % against the exact one" if exact > NOISE else ""
    low, high = (result.labels[k] for k in (found.node_min, found.node_max))
    lines = (
        f"T0 = J(0) omega_m^2/2 = {number(found.energy)} J, a first approximation; M_d = {number(found.drive)} N*m",
        f"delta = {number(found.delta, peak=1.0)}{off}",
        f"speed least in position {low}, largest in {high}",
        f"mean speed {number(found.mean)} rad/s, {100 * (found.mean / mean - 1):+.3g} % off the one asked for",
        _off(result),
    )
    values = {**keyed(found, "energy", "drive", "delta", "mean"), **keyed(result, "textbook_error")}
    return [Fact(label, "\n".join(lines), values)]


def _turns(book: Textbook) -> Iterator[str]:
    """The iteration of the textbook from the rated speed, where it settles."""
    if not book.turns:
        yield "turn by turn from the rated speed it does not settle"
        return
    speeds = [number(speed) for speed in (book.turns[0].first, *(turn.last for turn in book.turns))]
    if len(speeds) > SHOWN:
        speeds = [*speeds[: SHOWN - 1], "...", speeds[-1]]
    yield f"settles within {BOOK:g} rad/s in {len(book.turns)} turns, if begun at the rated speed:"
    yield f"{' -> '.join(speeds)} rad/s"


def _sound(book: Textbook) -> str:
    return "" if book.regime.warning < 1 else ": above 1 it swings from node to node, take more positions"


def _method_facts(result: Motion) -> list[Fact]:
    """How the regime was found, and of a motor's its time scales."""
    counters = result.regime.counters
    if result.kind != "motor":
        return []
    why = "implicit over the whole cycle at once, so that stiffness costs nothing"
    text = f"collocation: {why}\n{result.regime.panels.count} panels, {counters['newton']} Newton steps"
    values = {**METHOD.value("collocation"), **WHY.value(why), **keyed(result.regime, "counters")}
    return [Fact("found by", text, values), scales_fact(result.scales, "stiffness of a cycle")]


def _check_facts(regime: Regime) -> list[Fact]:
    work, error = abs(regime.residual), regime.error
    return [
        Fact("energy balance", f"{work:.0e} of all work is left over a cycle", {"residual": {"work": work}}),
        Fact("error of speed (est.)", f"{error:.0e} (relative)", {"error": {"speed": error}}),
    ]
