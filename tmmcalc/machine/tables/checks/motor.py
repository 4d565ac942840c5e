"""Checks of ``[motor]``: a name of the catalogue or data, and what the characteristic needs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.linkage.tables.checks.curves import Curve
from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, word
from tmmcalc.spec.phrases import either, listing, show
from tmmcalc.spec.values import FASTEST_BARE, amount, amounts, bare_number, check_bare_speed, first_disorder

CHOOSE = "choose"
_RATED = ("power", "speed")
_BESIDE_CHOICE = ("synchronous_speed", "catalogue", "reserve", "characteristic", "time_constant")

# What a characteristic needs beside the rated power and speed: one of these sets of keys.
_NEEDS: dict[str, tuple[tuple[str, ...], ...]] = {
    "parabolic": (("synchronous_speed",),),
    "linear": (("synchronous_speed",),),
    "kloss": (("synchronous_speed", "overload"),),
    "shunt": (("no_load_speed",), ("voltage", "resistance", "constant")),
    "series": (("efficiency",), ("voltage", "resistance")),
    "table": (("table",),),
}
_EXAMPLES = {
    "power": '"7.5 kW"',
    "speed": '"1455 rpm"',
    "synchronous_speed": '"1500 rpm"',
    "no_load_speed": '"1600 rpm"',
    "overload": "2.2",
    "efficiency": "0.88",
    "voltage": '"220 V"',
    "resistance": '"0.5 ohm"',
    "constant": '"1.4 V*s/rad"',
    "table": '{ speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }',
}
_OTHER_IDLE = {"synchronous_speed": "no_load_speed", "no_load_speed": "synchronous_speed"}
_DIRECT_CURRENT = {
    "voltage": ("shunt", "series"),
    "resistance": ("shunt", "series"),
    "constant": ("shunt",),
    "saturation": ("series",),
    "field_resistance": ("series",),
}
_USUAL = {"induction": "parabolic", "shunt": "shunt", "series": "series"}
_OF_KIND = {
    "parabolic": ("induction",),
    "linear": ("induction", "shunt"),
    "kloss": ("induction",),
    "shunt": ("shunt",),
    "series": ("series",),
}
# What is missing for the characteristic as well, which tells it.
_TOLD = tuple((key, form) for form in ("parabolic", "linear", "kloss") for way in _NEEDS[form] for key in way)
_LEAST_BARE = 20.0  # W: a smaller bare power is kW in disguise
_SPEEDS = ("speed", "synchronous_speed", "no_load_speed")


def check_source(outline: Outline) -> Iterator[Finding]:
    """A motor has a name or data; one that is chosen has no data yet."""
    linkage = written_linkage(outline)
    motor = subtable(outline.document, "motor")
    name = motor.get("name")
    if not {"name", *_RATED} & {*motor}:
        yield Finding(
            ("motor",),
            "missing key: a motor has a name in the catalogue, or its data",
            'add name = "4A132S4", or power = "7.5 kW" and speed = "1455 rpm"',
        )
    if "catalogue" in motor and "name" not in motor:
        yield Finding(
            ("motor", "catalogue"),
            "catalogue without name: nothing is read from it",
            f'add name = "{CHOOSE}", or the name of a motor in it',
        )
    if "reserve" in motor and name != CHOOSE:
        yield Finding(
            ("motor", "reserve"),
            "reserve beside a motor that is given: it says how far one that is chosen exceeds what is asked of it",
            f'remove it, or write name = "{CHOOSE}" and none of its data',
        )
    for key in motor if name == CHOOSE else ():
        if key not in (*_BESIDE_CHOICE, "name"):
            yield Finding(
                ("motor", key),
                f'{key} together with name = "{CHOOSE}": the catalogue gives the data of the motor that is chosen',
                f"remove it; beside the choice there may be {listing(_BESIDE_CHOICE)}",
            )
    if "flywheel_moment" in motor and "inertia" in motor:
        yield Finding(
            ("motor", "flywheel_moment"),
            "inertia and flywheel_moment together: the rotor has one",
            "remove one of them",
        )
    if linkage.slides and linkage.input_joint is not None:
        yield Finding(
            ("motor",),
            f'the input joint "{linkage.input_joint.name}" is prismatic; a motor turns a crank',
            "remove [motor]",
        )


def check_catalogue(outline: Outline) -> Iterator[Finding]:
    """A catalogue of one's own can be read, and a motor without data stands in its catalogue."""
    motor = subtable(outline.document, "motor")
    name, file = motor.get("name"), motor.get("catalogue")
    if not isinstance(name, str) or (isinstance(file, str) and not Path(file).is_file()):
        return  # a file that is not there has its fault
    from tmmcalc.machine.motors.catalogue import find, load_catalogue  # late: only named motors need it

    try:
        motors = load_catalogue(file) if isinstance(file, str) else None
    except SpecError as error:
        for fault in error.faults:
            yield Finding(("motor", "catalogue"), f"{file}, {fault}".partition("\n")[0], fault.remedy)
        return
    except UsageError as error:
        yield Finding(("motor", "catalogue"), error.message, error.remedy)
        return
    if name == CHOOSE or "power" in motor:
        return
    try:
        find(name, motors)
    except UsageError as error:
        yield Finding(("motor", "name"), error.message, error.remedy)


def check_characteristic(outline: Outline) -> Iterator[Finding]:
    """The characteristic belongs to the kind of motor and has what it needs."""
    motor = subtable(outline.document, "motor")
    # with a power the name is only a name
    named = "name" in motor and ("power" not in motor or motor["name"] == CHOOSE)
    kind = word(motor, "kind", "" if named else "induction")  # the catalogue knows the kind of a named one
    yield from _check_kind(motor, kind)
    form = word(motor, "characteristic", _USUAL.get(kind, ""))
    kinds = _OF_KIND.get(form, (kind,))
    if kind in _USUAL and kind not in kinds:
        owners = either(_article(owner) for owner in kinds)
        yield Finding(
            ("motor", "characteristic"),
            f"{show(form)} is a characteristic of {owners} motor, not of {_article(kind)} one",
            f'write "{_USUAL[kind]}", or {either(_kind_is(owner) for owner in kinds)}',
        )
        return
    if "table" in motor and form != "table":
        what = f'table without characteristic = "table"; the characteristic is {form or "that of the catalogue"}'
        yield Finding(("motor", "table"), what, 'add characteristic = "table", or remove table')
    elif form == "table" if named else form and {*_RATED} & {*motor}:
        yield from _check_needs(motor, form, kind, named)


def _check_needs(motor: Raw, form: str, kind: str, named: bool) -> Iterator[Finding]:
    ways = _NEEDS.get(form, ((),))
    if form == "linear" and kind == "shunt":
        ways = _NEEDS["shunt"][:1]
    needed = next((way for way in ways if {*way} & {*motor}), ways[0])  # the way that was begun
    for key in (*(() if named else _RATED), *needed):
        if key not in motor and _OTHER_IDLE.get(key) not in motor:  # the other one has its own fault
            yield Finding(
                ("motor", key), f"missing key: a {form} characteristic needs {key}", f"add {key} = {_EXAMPLES[key]}"
            )


def _check_kind(motor: Raw, kind: str) -> Iterator[Finding]:
    """Each kind of motor has its own speed without load; only a direct-current one has a circuit."""
    for key, owner in (("synchronous_speed", "induction"), ("no_load_speed", "shunt")):
        if key in motor and kind in _USUAL and kind != owner:
            other = "no_load_speed" if kind == "shunt" else "synchronous_speed"
            remedy = "remove it, or write" if kind == "series" else f"write {other}, or"
            yield Finding(("motor", key), f"{_article(kind)} motor has no {key}", f"{remedy} {_kind_is(owner)}")
    for key, owners in _DIRECT_CURRENT.items():
        if key in motor and kind in _USUAL and kind not in owners:
            remedy = f"remove it, or write {either(_kind_is(owner) for owner in owners)}"
            yield Finding(("motor", key), f"{_article(kind)} motor has no {key}", remedy)


def _article(kind: str) -> str:
    return f"an {kind}" if kind == "induction" else f"a {kind}"


def _kind_is(kind: str) -> str:
    return f'kind = "{kind}"'


def check_lag(outline: Outline) -> Iterator[Finding]:
    """The time constant by the formula asks for the critical slip of an induction motor."""
    motor = subtable(outline.document, "motor")
    if motor.get("time_constant") != "auto":
        return
    kind = word(motor, "kind", "induction")
    if kind in _USUAL and kind != "induction":
        yield Finding(
            ("motor", "time_constant"),
            f'"auto" is for an induction motor, not for {_article(kind)} one: it follows from the critical slip',
            'write a time, such as "20 ms"',
        )
        return
    for key in ("synchronous_speed", "overload") if "power" in motor else ():
        if key not in motor and (key, word(motor, "characteristic", "parabolic")) not in _TOLD:
            yield Finding(
                ("motor", key),
                f'missing key: time_constant = "auto" follows from the critical slip, which needs {key}',
                f"add {key} = {_EXAMPLES[key]}",
            )


def check_bare_numbers(outline: Outline) -> Iterator[Finding]:
    """Speeds in rpm and a power in kW say so: their bare numbers stand out."""
    motor = subtable(outline.document, "motor")
    for key in _SPEEDS:
        yield from check_bare_speed(motor.get(key), ("motor", key))
    power = bare_number(motor.get("power"))
    if power is not None and 0 < power < _LEAST_BARE:
        yield Finding(
            ("motor", "power"), f"{show(power)} without a unit is in W", f'write "{power:g} kW" or "{power:g} W"'
        )


def check_order(outline: Outline) -> Iterator[Finding]:
    """The rated speed is below the one without load."""
    motor = subtable(outline.document, "motor")
    rated = amount(motor.get("speed"), "angular speed")
    for key in _SPEEDS[1:]:
        idle = amount(motor.get(key), "angular speed")
        disguised = any((bare_number(motor.get(name)) or 0.0) > FASTEST_BARE for name in ("speed", key))
        if rated is not None and idle is not None and rated >= idle > 0 and not disguised:
            yield Finding(
                ("motor", "speed"),
                f"the rated speed {show(motor['speed'])} is not below {key} {show(motor[key])}",
                'a motor slips under load: such as speed = "1455 rpm" below synchronous_speed = "1500 rpm"',
            )


def check_circuit(outline: Outline) -> Iterator[Finding]:
    """A shunt motor runs slower under load than U/k, its speed without; the field's resistance is part of the whole."""
    motor = subtable(outline.document, "motor")
    whole, field = (amount(motor.get(key), "resistance") for key in ("resistance", "field_resistance"))
    if "field_resistance" in motor and "resistance" not in motor:
        said = "field_resistance without resistance, of which it is a part"
        yield Finding(("motor", "field_resistance"), said, 'add resistance = "0.5 ohm", that of armature and field')
    elif whole is not None and field is not None and field >= whole > 0:
        said = f"{show(motor['field_resistance'])} is not below resistance = {show(motor['resistance'])}, its whole"
        yield Finding(("motor", "field_resistance"), said, "resistance is that of armature and field")
    rated = amount(motor.get("speed"), "angular speed")
    voltage, constant = amount(motor.get("voltage"), "voltage"), amount(motor.get("constant"), "motor constant")
    if rated is None or not voltage or not constant or constant < 0 or rated < voltage / constant:
        return
    yield Finding(
        ("motor", "constant"),
        f"no-load speed U/k = {voltage / constant * 30 / math.pi:.6g} rpm is not above the rated speed "
        f"{show(motor['speed'])}",
        "check voltage and constant: a shunt motor of 220 V and 1.4 V*s/rad runs at 1500 rpm without load",
    )


_POINTS = {"speed": '["0 rpm", "1400 rpm", "1500 rpm"]', "moment": '["15 N*m", "7.5 N*m", 0]'}


def check_curve(outline: Outline) -> Iterator[Finding]:
    """A characteristic by points has one moment for each speed, and its speeds ascend."""
    motor = subtable(outline.document, "motor")
    if not isinstance(motor.get("table"), dict):
        return
    table = subtable(motor, "table")
    curve = Curve(outline, table, ("motor", "table"), "speed")
    given = [key for key in ("speed", "moment") if key in table]
    if "file" in table and given and curve.path not in outline.rows:
        said = f"file together with {' and '.join(given)}: the file holds all values"
        yield Finding((*curve.path, "file"), said, f"remove file, or remove {' and '.join(given)}")
    elif "file" not in table:
        for key in ("speed", "moment"):
            if key not in table:
                remedy = f'add {key} = {_POINTS[key]}, or both in a file, file = "m.csv"'
                yield Finding(("motor", "table", key), f"missing key: a characteristic has its {key}s", remedy)
    speed, moment = table.get("speed"), table.get("moment")
    if isinstance(speed, list) and isinstance(moment, list) and len(speed) != len(moment) > 1 < len(speed):
        yield Finding(
            ("motor", "table", "moment"),
            f"{len(moment)} moments for {len(speed)} speeds",
            "write one moment for each speed",
        )
    numbers = amounts(speed, "angular speed")
    disorder = first_disorder(numbers) if numbers else None
    if disorder is not None:
        later, before = show(table["speed"][disorder]), show(table["speed"][disorder - 1])
        rule = f"{curve.at(disorder)}{later} does not come after {before}; speeds ascend"
        yield Finding(curve.place("speed", disorder), rule, "put the points in order")


CHECKS = (
    check_source,
    check_catalogue,
    check_characteristic,
    check_lag,
    check_bare_numbers,
    check_order,
    check_circuit,
    check_curve,
)
