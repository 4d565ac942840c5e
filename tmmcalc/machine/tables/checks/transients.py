"""Checks of ``[[transients]]``: how a motion begins, what is switched and when, and how it is integrated."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks import places
from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, tables, word
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.values import amount, amounts, check_bare_speed, first_disorder

_STEPPING = ("rk4", "merson")
_CIRCUITS = {"shunt": ("voltage", "resistance", "constant"), "series": ("voltage", "resistance")}
_BRAKED = "shunt motor with voltage, resistance and constant, and no series motor with voltage and resistance"
_BRAKING = {"moment": ("moment",), "viscous": ("torsional damping",)}


def check_names(outline: Outline) -> Iterator[Finding]:
    """Every motion has a name of its own; a motion in time is that of a machine with a crank."""
    linkage = written_linkage(outline)
    yield from places.check_names(outline, tables(outline.document, "transients"), "transients", "transient motion")
    if linkage.slides and linkage.input_joint is not None:
        joint = f'the input joint "{linkage.input_joint.name}" is prismatic'
        rule = f"{joint}; motions in time are those of a machine with a crank"
        yield Finding(("transients",), rule, "remove [[transients]]")


def check_begin(outline: Outline) -> Iterator[Finding]:
    """A motion begins with a given speed and angle, or in the steady motion; backwards only where it may pass rest."""
    for path, transient in motions(outline):
        for key in ("start_speed", "start_angle"):
            if "from" in transient and key in transient:
                rule = f'{key} together with from = "steady": the steady motion gives speed and angle'
                yield Finding((*path, key), rule, "remove it, or remove from")
        speed = amount(transient.get("start_speed"), "angular speed")
        if speed is not None and speed < 0 and word(transient, "standstill", "stop") == "stop":
            rule = f'{show(transient["start_speed"])} is backwards, where standstill = "stop" lets no crank turn'
            yield Finding((*path, "start_speed"), rule, 'write it without the minus, or standstill = "pass"')
        for key in ("start_speed", "end_speed"):
            yield from check_bare_speed(transient.get(key), (*path, key))


def check_motor(outline: Outline) -> Iterator[Finding]:
    """A motor that is switched on is there; it is on, off, or on at given times."""
    for path, transient in motions(outline):
        times = transient.get("motor_on")
        if "motor" in transient and "motor_on" in transient:
            rule = "motor together with motor_on: the times tell when it is on"
            yield Finding((*path, "motor"), rule, "remove one of them")
        elif "motor" not in outline.document and word(transient, "motor", "on") == "on":
            key = next((key for key in ("motor", "motor_on") if key in transient), None)
            yield Finding(
                (*path, key) if key else path,
                "missing motor: it is on in this motion, but the spec has no [motor]",
                'add [motor], or motor = "off"',
            )
        for place, pair in enumerate(times if isinstance(times, list) else ()):
            numbers = amounts(pair, "time")
            if numbers is not None and len(numbers) == 2 and not numbers[0] < numbers[1]:
                rule = f"{show(pair)} ends before it begins"
                yield Finding((*path, "motor_on", place), rule, 'write [on, off], such as ["0 s", "2 s"]')


def check_load(outline: Outline) -> Iterator[Finding]:
    """A load step waits for a time, for a speed or for a quiet part of the cycle; times ascend."""
    for path, transient in motions(outline):
        steps = tables(transient, "load_steps")
        for index, step in steps:
            at = (*path, "load_steps", index)
            if "time" in step and "speed" in step:
                rule = "time and speed together: a load step waits for one of them"
                yield Finding((*at, "speed"), rule, "remove one of them, or write two steps")
            if not {"time", "speed", "quiet"} & {*step}:
                rule = "missing key: a load step waits for a time or for a speed of the crank"
                yield Finding(at, rule, 'add time = "3 s" or speed = "950 rpm"; load is the factor at the beginning')
            yield from check_bare_speed(step.get("speed"), (*at, "speed"))
        timed = [(index, step["time"]) for index, step in steps if "time" in step]
        numbers = amounts([time for _, time in timed], "time")
        disorder = first_disorder(numbers) if numbers else None
        if disorder is not None:
            index, time = timed[disorder]
            rule = f"{show(time)} does not come after {show(timed[disorder - 1][1])}; load steps come in order"
            yield Finding((*path, "load_steps", index, "time"), rule, "put the steps in order")


def check_brake(outline: Outline) -> Iterator[Finding]:
    """A brake brakes, for some time, one of the masses of the drive."""
    shafts = outline.document.get("shafts", [])
    last = len(shafts) if isinstance(shafts, list) else 0
    for path, transient in motions(outline):
        brake, at = transient.get("brake"), (*path, "brake")
        if not isinstance(brake, dict):
            continue
        if not {*_BRAKING} & {*brake}:
            yield Finding(at, "missing key: a brake has its moment", 'add moment = "200 N*m", or viscous')
        given = {key: amount(brake[key], *dimensions) for key, dimensions in _BRAKING.items() if key in brake}
        if given and not any(number != 0 for number in given.values()):
            key = next(iter(given))
            yield Finding((*at, key), f"{show(brake[key])}: this brake does not brake", 'write "200 N*m", for example')
        times = amounts([brake.get("from", 0), brake.get("to")], "time")
        if times is not None and not times[0] < times[1]:
            yield Finding(
                (*at, "to"), f"{show(brake['to'])} is not after the time from which it acts", "write a later time"
            )
        mass = brake.get("mass")
        if is_integer(mass) and mass > last:
            known = f"the masses are 0 (the rotor) to {last} (the crank)" if last else "without [[shafts]] it is 0"
            yield Finding((*at, "mass"), f"there is no mass {mass}", known)


def check_within(outline: Outline) -> Iterator[Finding]:
    """What is switched is switched before the end."""
    for path, transient in motions(outline):
        duration = amount(transient.get("duration"), "time")
        for place, time in _times(transient):
            number = amount(time, "time")
            if duration and number is not None and number >= duration:
                rule = f"{show(time)} is not before the end of the motion, {show(transient['duration'])}"
                yield Finding((*path, *place), rule, "write an earlier time, or a longer duration")


def _times(transient: Raw) -> Iterator[tuple[Path, object]]:
    """Yield the times at which something is switched on or changed, each with its place."""
    listed = transient.get("motor_on")
    for index, pair in enumerate(listed if isinstance(listed, list) else ()):
        if isinstance(pair, list) and pair:
            yield ("motor_on", index, 0), pair[0]
    for index, step in tables(transient, "load_steps"):
        yield ("load_steps", index, "time"), step.get("time")
    yield ("brake", "from"), subtable(transient, "brake").get("from")


def check_braking(outline: Outline) -> Iterator[Finding]:
    """Only a direct-current motor whose circuit is known brakes, while it is on, and as its field allows."""
    motor = subtable(outline.document, "motor")
    machine = word(motor, "kind", "induction")
    for path, transient in motions(outline):
        if "braking" not in transient:
            continue
        at, braking = (*path, "braking"), subtable(transient, "braking")
        if machine not in _CIRCUITS or not {*_CIRCUITS[machine]} <= {*motor}:
            said = f"braking of a motor that is no {_BRAKED}"
            remedy = 'write kind = "shunt" or "series" with these in [motor], or a brake = { moment = "200 N*m" }'
            yield Finding(at, said if motor else "braking without [motor]: there is nothing that brakes", remedy)
        if transient.get("motor") == "off":
            yield Finding(at, 'braking together with motor = "off": a motor that is off does not brake', "remove motor")
        kind = word(braking, "kind", "regenerative")
        if "voltage" in braking and kind != "regenerative":
            said = f"voltage with kind = {show(kind)}: only regenerative braking has a source of its own"
            yield Finding((*at, "voltage"), said, "remove it")
        if machine == "series" and "field" not in braking:
            yield from _self_excited(at, word(braking, "kind", ""), motor)
        elif machine == "shunt" and "field" in braking:
            said = "field of a shunt motor: its field has a source of its own already"
            yield Finding((*at, "field"), said, "remove it; constant holds for the field as it is")


def _self_excited(at: Path, kind: str, motor: Raw) -> Iterator[Finding]:
    """What a series motor whose field carries the current of its armature cannot do."""
    if kind == "regenerative":
        said = (
            "a series motor cannot feed a source: its field falls with its own current, which ends before its EMF "
            "comes up to the voltage"
        )
        yield Finding((*at, "kind"), said, 'add field = 1, a source of its own for the field, or write "dynamic"')
    elif kind == "dynamic" and not motor.get("saturation"):
        said = (
            "dynamic braking of a series motor whose flux is in proportion to its current: nothing limits the current "
            "with which it excites itself"
        )
        yield Finding((*at, "kind"), said, "add saturation = 0.3 to [motor], or field = 1, a source for the field")


def check_method(outline: Outline) -> Iterator[Finding]:
    """Fixed steps belong to the methods that take them."""
    for path, transient in motions(outline):
        method = word(transient, "method", "auto")
        if method == "rk4" and "step" not in transient:
            yield Finding((*path, "method"), "rk4 takes fixed steps; there is no step", 'add step = "0.01 s"')
        if "step" in transient and method not in _STEPPING:
            said = f"{method} controls its steps itself" if "method" in transient else "auto controls its steps itself"
            yield Finding(
                (*path, "step"), f"{said}, it takes no step", 'remove it, or write method = "merson" or "rk4"'
            )


def check_targets(outline: Outline) -> Iterator[Finding]:
    """Speeds in rpm say so."""
    for path, transient in motions(outline):
        targets = transient.get("targets")
        for index, target in enumerate(targets if isinstance(targets, list) else ()):
            yield from check_bare_speed(target, (*path, "targets", index))


def motions(outline: Outline) -> list[tuple[Path, Raw]]:
    """Return the motions that are tables, each with its place."""
    return [(("transients", index), transient) for index, transient in tables(outline.document, "transients")]


CHECKS = (
    check_names,
    check_begin,
    check_motor,
    check_load,
    check_brake,
    check_braking,
    check_within,
    check_method,
    check_targets,
)
