"""The documents of the power stage: work over a cycle, efficiency and power, the motor against its duty.

Work, moments and power are those of the input shaft at its mean speed; what drives is positive.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.quantity import keyed, quantities, table
from tmmcalc.linkage.facts.places import Shaft, extreme_values, place
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.facts.drive import rounds_fact, turn_notes
from tmmcalc.machine.judged import Judged
from tmmcalc.machine.motors.plausibility import Curve
from tmmcalc.machine.power import MotorDuty, Power, WorkPart
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number

MACHINES = {
    "working": "working machine: its loads resist",
    "engine": "engine: its loads drive it",
    "idle": "idle: no load does work over a cycle",
}
UNNAMED = "motor"  # name of a motor that the spec gives by its data alone
STORED = 1e-9  # of what the loads could do: less is no work that weights and springs keep

MORE = "--format csv prints all columns, with what speaks against each motor"
JUDGED = ("name", "power", "rated_rpm", "ratio", "load", "heating", "largest", "peak", "starts", "reason")
PEAK, REASONS = quantities(Power)["peak_moment"], quantities(MotorDuty)["reasons"]


class Datum(NamedTuple):
    """A datum of the name plate."""

    name: str  # of a `Motor`
    text: str  # for people


PLATE = (  # a line each
    (
        Datum("power", "{} W"),
        Datum("rated_rpm", "{} rpm"),
        Datum("synchronous_rpm", "no load {} rpm"),
        Datum("nominal_moment", "M_N = {} N*m"),
    ),
    (Datum("overload", "largest moment {} M_N"), Datum("start", "starting moment {} M_N")),
    (Datum("inertia", "rotor J_R = {} kg*m^2"), Datum("time_constant", "time constant {} s")),
    (
        Datum("voltage", "{} V"),
        Datum("resistance", "armature {} ohm"),
        Datum("constant", "constant {} V*s/rad"),
        Datum("saturation", "saturation {}"),
        Datum("efficiency", "efficiency {}"),
    ),
)


def summary(result: Power, title: str) -> Document:
    """Facts and notes; the work of every cause is left to the summary of the reduction."""
    facts = [*_work_facts(result), *_power_facts(result), *_motor_facts(result)]
    if result.line.parts:
        facts.append(_line_fact(result))
    facts.append(
        Fact("error of work (est.)", f"{result.error.work:.0e} (relative)", {"error": {"work": result.error.work}})
    )
    notes = tuple(_notes(result.duty)) if result.duty is not None else ()
    return Document(title, tuple(facts), notes)


def document(result: Power, title: str) -> Document:
    """The summary with the work of every cause."""
    told = summary(result, title)
    machine, *rest = told.facts
    facts = (machine, *(_part_fact(result, part) for part in result.parts), *rest)
    return replace(told, facts=facts, table=_trial_table(result.duty), wide=True, more=MORE)


def _trial_table(duty: MotorDuty | None) -> View | None:
    """The motors that were tried, and those of the next smaller power; None where none was chosen."""
    if duty is None or not duty.judged:
        return None
    weaker = max((each.power for each in duty.judged if each.load > 1), default=0.0)
    shown = [each for each in duty.judged if each.power >= weaker]
    columns = table(shown, Judged, *JUDGED)
    words: dict[Any, Any] = {None: "", True: "yes", False: "no"}
    told = [
        [words.get(value, value) if not isinstance(value, float) else value for value in c] for c in columns.values()
    ]
    return View(list(columns), told)


def _scale(result: Power) -> float:
    """What the loads could do if they kept their peak [J]: what is noise against it is no work."""
    return max(map(abs, result.peak_power)) * result.cycle_time


def _part_fact(result: Power, part: WorkPart) -> Fact:
    """Work of one cause, under the names that it has in the reduction."""
    twice = sum(other.name == part.name for other in result.parts) > 1
    key = f"{part.name}_{part.kind}" if twice else part.name.replace(" ", "_")
    called = Phrase("{name} (damping)", name=part.name) if part.kind == "damper" else part.name
    scale = _scale(result)
    power = number(part.work / result.cycle_time, peak=scale / result.cycle_time)
    text = f"{number(part.work, peak=scale)} J a cycle, {power} W"
    return Fact(Phrase("work of {cause}", cause=called), text, keyed(part, "work", cause=key))


def _work_facts(result: Power) -> list[Fact]:
    """Kind of the machine, work told apart by its sign, efficiency."""
    scale = _scale(result)
    parts = (
        ("driving work A_d", "driving", "of loads that drive", "no load drives"),
        ("resisting work A_c", "resisting", "of loads that resist", "no load resists"),
        ("lost work A_F", "losses", "of friction and dampers", "no friction, no dampers"),
    )
    facts = [Fact("machine", MACHINES[result.machine], keyed(result, "machine"))]
    for label, name, whose, none in parts:
        work = getattr(result, name)
        text = f"{number(work, peak=scale)} J a cycle, {whose}" if work else f"0 J, {none}"
        facts.append(Fact(label, text, keyed(result, name)))
    if abs(result.stored) > STORED * scale:
        text = f"{number(result.stored)} J a cycle, of weights and springs"
        facts.append(Fact("stored work", text, keyed(result, "stored")))
    if result.efficiency is not None:
        text = f"{number(result.efficiency)} = {_formula(result)}"
        facts.append(Fact("efficiency", text, keyed(result, "efficiency")))
    return facts


def _formula(result: Power) -> str:
    """How the efficiency comes from the work, textbook (3.36) where work is lacking, (3.37) where some is left."""
    return "(A_d + A_F)/A_d" if result.mean_moment < 0 else "A_c/(A_c + A_F)"


def _power_facts(result: Power) -> list[Fact]:
    """Time of a cycle, mean and peak power and moment of the input shaft, and what they ask of a motor."""
    (least, largest), mean = result.peak_power, result.mean_moment
    peak = max(abs(least), abs(largest))
    whose = _whose(result)
    shaft = Shaft(np.array([0.0, result.sense]))
    where = f", resisting at {place(shaft, result.peak_at)}" if result.peak_moment else ": nothing ever resists"
    facts = [
        Fact("cycle at mean speed", f"{number(result.cycle_time)} s", keyed(result, "cycle_time")),
        Fact("mean power", f"{number(result.mean_power, peak=peak)} W {whose}", keyed(result, "mean_power")),
        Fact("mean moment", f"{number(abs(mean))} N*m", keyed(result, "mean_moment")),
        Fact(
            "peak resisting moment",
            f"{number(result.peak_moment)} N*m{where}",
            extreme_values(shaft, PEAK.name, PEAK.unit, Extreme(result.peak_moment, result.peak_at)),
        ),
        Fact(
            "instant power",
            f"from {number(least, peak=peak)} W to {number(largest, peak=peak)} W, of all loads together",
            keyed(result, "least_power", "largest_power"),
        ),
    ]
    if result.balancing:
        facts.append(_balancing_fact(result))
    if result.motor_power is not None:
        gears = result.transmission
        over = f", through gears of the efficiency {number(gears)}" if gears != 1 else ""
        of, pair = result.line.efficiency_of, result.line.open
        over += _of_gears(of, pair)
        told = [name for name, there in (("efficiency_of", of), ("open", pair)) if there]
        values = keyed(result, "motor_power") | keyed(result.line, "efficiency", *told)
        facts.append(Fact("required motor power", f"{number(result.motor_power)} W{over}", values))
    return facts


def _of_gears(train: str, pair: str) -> str:
    """Whose a value of the drive line is: of the train that was chosen, of the open pair."""
    of = " and ".join(filter(None, (train and f"gear train {train}", pair and f"the {pair}")))
    return f", of {of}" if train else f", with {of}" if of else ""


def _line_fact(result: Power) -> Fact:
    """Reducer and open pair with ratio, efficiency and inertia, each with where it comes from; and both together."""
    line = result.line
    ratio = result.duty.ratio if result.duty is not None else line.ratio
    parts = line.parts if ratio is None else line.with_ratio(ratio)
    lines = [
        f"{part.name}: "
        + (f"u = {number(part.ratio)}, {part.ratio_of}; " if part.ratio is not None else "")
        + f"efficiency {number(part.efficiency)}, {part.efficiency_of}; "
        + f"inertia at the crank {number(part.inertia)} kg*m^2, {part.inertia_of}"
        for part in parts
    ]
    whole = [f"u = {number(ratio)}"] if ratio is not None else []
    whole += [f"efficiency {number(line.efficiency)}", f"inertia at the crank {number(line.inertia)} kg*m^2"]
    told = [{key: value for key, value in keyed(part).items() if value is not None} for part in parts]
    return Fact("drive line", "\n".join([*lines, f"together: {', '.join(whole)}"]), {"drive_line": told})


def _whose(result: Power) -> str:
    """Whose the mean power is."""
    if result.mean_moment < 0:
        return "left for the machine that it drives"
    return "lacking: the loads resist more than they drive" if result.machine == "engine" else "of the drive"


def _balancing_fact(result: Power) -> Fact:
    """The moment of a balanced diagram that stands for what is driven, or for the drive."""
    moment = result.balancing
    part = "the load of the engine" if moment < 0 else "the drive"
    text = f"{number(moment)} N*m, {number(result.balancing_power)} W: {part}, which makes the work of a cycle zero"
    return Fact("balancing moment", text, keyed(result, "balancing", "balancing_power"))


def _motor_facts(result: Power) -> list[Fact]:
    """The motor, why it was chosen, and what is asked of it."""
    duty = result.duty
    if duty is None:
        return []
    facts = [_plate_fact(duty)]
    if duty.curve is not None:
        facts.append(_curve_fact(duty.curve))
    if duty.reasons:
        facts.append(Fact("chosen because", "\n".join(duty.reasons), {REASONS.key: list(duty.reasons)}))
    if duty.taken:
        facts += [_rules_fact(duty), _refused_fact(duty)]
    if duty.rounds:
        facts.append(rounds_fact(duty.rounds, duty.in_turn))
    text = f"mean {number(duty.mean_load, 4)}, peak {number(duty.peak_load, 4)} of the rated moment"
    facts += [
        _ratio_fact(duty, result.line.open),
        Fact("rated at the input", f"{number(result.rated_moment or 0.0)} N*m", keyed(result, "rated_moment")),
        Fact("load of the motor", text, keyed(duty, "mean_load", "peak_load")),
    ]
    if duty.motor.inertia is not None:
        text = f"{number(duty.rotor)} kg*m^2 = J_R u^2"
        facts.append(Fact("rotor at the input", text, keyed(duty, "rotor")))
    return facts


def _rules_fact(duty: MotorDuty) -> Fact:
    """What each rule of choice would take."""
    lines = [f"{each.rule}: {each.motor}, {number(each.power / 1000)} kW" for each in duty.taken]
    return Fact("by each rule alone", "\n".join(lines), {"rules": [keyed(each) for each in duty.taken]})


def _refused_fact(duty: MotorDuty) -> Fact:
    """The smaller motors with what speaks against them; those that are too weak by their power together."""
    weak = [each for each in duty.judged if each.load > 1]
    tried = [each for each in duty.judged if each.load <= 1 and each.motor.power < duty.motor.power]
    lines = [f"{len(weak)} motors up to {number(max(each.power for each in weak) / 1000)} kW: too weak"] if weak else []
    lines += [f"{each.name}, {number(each.power / 1000)} kW: {each.reason}" for each in tried]
    values = {"judged": [keyed(each, *JUDGED) for each in duty.judged]}
    return Fact("smaller ones", "\n".join(lines) or "there are none", values)


def _ratio_fact(duty: MotorDuty, pair: str) -> Fact:
    """The ratio of the gears, and whose it is."""
    whose = _of_gears(duty.ratio_of, pair)
    values = keyed(duty, "ratio", *(("ratio_of",) if duty.ratio_of else ()))
    return Fact("gear ratio u", f"{number(duty.ratio)}, motor over input shaft{whose}", values)


def _plate_fact(duty: MotorDuty) -> Fact:
    """The data of the motor that are known, and where they come from."""
    motor = duty.motor
    lines: list[str] = [motor.name if motor.name != UNNAMED else "given by its data"]
    values = {**keyed(motor, "name", "kind"), **keyed(duty, "chosen")}
    for line in PLATE:
        known = [datum for datum in line if getattr(motor, datum.name)]
        values |= keyed(motor, *(datum.name for datum in known)) if known else {}
        lines.append(", ".join(datum.text.format(number(getattr(motor, datum.name))) for datum in known))
    if motor.source:
        lines.append(f"data: {motor.source}")
        values |= keyed(motor, "source")
    return Fact("motor", "\n".join(line for line in lines if line), values)


def _curve_fact(curve: Curve) -> Fact:
    """Where the curve of a direct-current motor meets both axes, on its own shaft."""
    values = keyed(curve, "stall")
    if curve.no_load_rpm is None:
        idle = "runs away without load"
    else:
        idle = f"no load at {number(curve.no_load_rpm)} rpm"
        values |= keyed(curve, "no_load_rpm")
    return Fact("its characteristic", f"{idle}, {number(curve.stall)} N*m at standstill", values)


def _notes(duty: MotorDuty) -> Iterator[str]:
    """What the numbers of the motor mean for the machine."""
    motor = duty.motor
    yield from turn_notes(duty.in_turn)
    if duty.rounds and duty.judged and duty.judged[-1].reason:
        yield Phrase(
            "warning: with the ratio {ratio} of the train itself it fails: {reason}",
            ratio=number(duty.ratio),
            reason=duty.judged[-1].reason,
        )
    if duty.off_speed is not None:
        yield duty.off_speed
    yield from duty.contradictions
    if duty.mean_load > 1:
        text = Phrase(
            "the mean load is {mean_load} of the rated moment: the motor is too weak, no flywheel helps",
            mean_load=number(duty.mean_load, 4),
        )
        yield Note("warning", text, value=duty.mean_load, limit=1.0, name="mean_load")
    if motor.inertia is None:
        yield (
            "warning: the inertia of the motor's rotor is not known and counts as 0: the speed comes out too "
            "uneven, the flywheel too heavy; give inertia in [motor]"
        )
    if motor.overload is not None and duty.peak_load > motor.overload:
        text = Phrase(
            "the peak load, {peak_load} of the rated moment, exceeds the largest moment of the motor, {overload}: "
            "kinetic energy has to carry the machine over it",
            peak_load=number(duty.peak_load, 4),
            overload=number(motor.overload, 4),
        )
        yield Note("note", text, value=duty.peak_load, limit=motor.overload, name="peak_load")
