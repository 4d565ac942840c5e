"""The table ``[strength]`` on its own: what it takes, one clear fault for each slip, the task that it becomes."""

from __future__ import annotations

import tomllib
from typing import Any, get_args

import pytest
from pydantic import TypeAdapter, ValidationError

from gears.strength.scenes import MM, MPA, sets_of
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.strength import material, task
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.tables import Arrangement, table
from tmmcalc.gears.tables.checks.strength import CHECKS
from tmmcalc.gears.tables.strength import ROWS, MaterialTable, StrengthTable
from tmmcalc.gears.tables.tasks.strength import to_strength
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import show_path

STEEL = 'treatment = "improved"\nsteel = "40Kh"\nhardness = "300 HB"\n'
PLAIN = f'[strength]\ntorque = "75 N*m"\nface_width = 0.6\n[strength.material]\n{STEEL}'
CHECKED = PLAIN.replace("face_width", 'module = ["2 mm", "3.5 mm"]\nface_width')


def read(text: str) -> StrengthTable:
    return StrengthTable.model_validate(tomllib.loads(text)["strength"])


def checks(text: str) -> list[Finding]:
    outline = Outline(tomllib.loads(text), lambda path: None)
    return [finding for rule in CHECKS for finding in rule(outline)]


def faults(text: str) -> list[tuple[str, str, str]]:
    """All faults of a text: those of the types, then those of the checks."""
    found = []
    try:
        read(text)
    except ValidationError as error:
        for item in error.errors():
            fault = item.get("ctx", {}).get("error", item["msg"])
            found.append((show_path(("strength", *item["loc"])), str(fault), getattr(fault, "remedy", "")))
    return found + [(show_path(finding.path), finding.message, finding.remedy) for finding in checks(text)]


def test_a_plain_table() -> None:
    assert faults(PLAIN) == []
    found = to_strength(read(PLAIN))
    (stage,) = found.stages
    assert found.torque == 75.0
    assert (stage.psi_bd, stage.row, stage.wheel) == (0.6, None, None)
    assert stage.pinion is not None
    assert (stage.pinion.steel, stage.pinion.treatment, str(stage.pinion.hardness)) == ("40Kh", "improved", "300 HB")
    assert found == task.StrengthTask(75.0, (stage,))  # the defaults are those of the room
    result = solve_strength(sets_of("AI", planets=3), found)
    assert result.accepted.all()


def test_everything_at_once() -> None:
    text = """
[strength]
moment = "-1980 N*m"
moment_ratio = "30/2"
face_width = [0.7, 0.8]
arrangement = [3, 5]
permissible_contact = ["700 MPa", "650 MPa"]
modules_row = 1
underrun = 0.01
face_width_rule = "book1992"
rounding = "floor1"
on_overload = "reject"
iterate = true
[strength.pinion]
treatment = "nitrided"
steel = "40ХФА"
hardness = { value = 600, scale = "HV" }
core = "HRC 30"
protected = true
failure = "severe"
blank = "casting"
wear = "abrasive"
load = "two-sided"
[strength.wheel]
treatment = "through-hardened"
steel = "40Kh"
hardness = "50 HRC"
contact_limit = "900 MPa"
bending_limit = "500 MPa"
structure = "surface-strengthened"
"""
    assert faults(text) == []
    found = to_strength(read(text))
    assert found.torque == 132.0
    rules = (found.rows, found.underrun, found.width_rule, found.rounding, found.on_overload, found.iterate)
    assert rules == (1, 0.01, "book1992", "floor1", "reject", True)
    first, second = found.stages
    assert (first.psi_bd, first.row, first.permissible_contact) == (0.7, 3, 700 * MPA)
    assert (second.psi_bd, second.row, second.permissible_contact) == (0.8, 5, 650 * MPA)
    pinion, wheel = first.pinion, first.wheel
    assert pinion is not None
    assert wheel is not None
    assert (str(pinion.hardness), str(pinion.core), pinion.load) == ("600 HV", "30 HRC", "two-sided")
    assert (pinion.protected, pinion.failure, pinion.blank, pinion.wear) == (True, "severe", "casting", "abrasive")
    assert (wheel.contact_limit, wheel.bending_limit) == (900 * MPA, 500 * MPA)
    assert wheel.structure == "surface-strengthened"


def test_given_modules() -> None:
    found = to_strength(read(CHECKED.replace("face_width", 'width = "30 mm"\nface_width')))
    assert found.modules == (2 * MM, 3.5 * MM)
    assert found.widths == (30 * MM,)


def test_the_moment_may_come_from_the_reduction() -> None:
    text = PLAIN.replace('torque = "75 N*m"', "moment_ratio = 15")
    assert [fault[1] for fault in faults(text)] == ["missing key: the torque on wheel 1"]
    assert faults(f"{text}[mechanism]\n") == []
    assert faults(text.replace("moment_ratio = 15\n", "") + "[mechanism]\n") == []  # the ratio is that of the train
    assert to_strength(read(text), 1980.0).torque == 132.0
    with pytest.raises(UsageError, match="not known"):
        to_strength(read(text))
    with pytest.raises(UsageError, match="arrangement is given for 2 stages"):
        to_strength(read(PLAIN.replace("0.6", "[0.6, 0.7, 0.8]\narrangement = [1, 1]")))


SLIPS = [
    (
        PLAIN.replace('"75 N*m"', "0"),
        "strength.torque",
        "0 is zero; a moment other than 0 is needed here",
        "write",
    ),
    (PLAIN.replace('"75 N*m"', '"75 N"'), "strength.torque", "'75 N' is a force, a moment is needed", "write"),
    (
        PLAIN.replace("face_width", "moment_ratio = 15\nface_width"),
        "strength.moment_ratio",
        "torque together with moment_ratio: the torque on wheel 1 is the moment over the ratio",
        "remove moment_ratio",
    ),
    (PLAIN.replace('torque = "75 N*m"\n', ""), "strength", "missing key: the torque on wheel 1", "torque = "),
    (
        PLAIN.replace("0.6", "2.6"),
        "strength.face_width",
        "2.6 is out of range; a face-width coefficient psi_bd is above 0 and at most 2",
        "such as 0.9",
    ),
    (
        PLAIN.replace("0.6", "[0.6, 0]"),
        "strength.face_width",
        "0 is out of range; a face-width coefficient psi_bd is above 0 and at most 2",
        "such as 0.9",
    ),
    (
        PLAIN.replace("0.6", "[]"),
        "strength.face_width",
        "[] has 0 values; a train has up to 3 stages",
        "one value for all stages",
    ),
    (
        PLAIN.replace("0.6", "0.6\narrangement = 8"),
        "strength.arrangement",
        "8 is not a row of Table D.4.1",
        "from 1 to 7",
    ),
    (
        PLAIN.replace("0.6", "[0.6, 0.7]\narrangement = [1, 2, 3]"),
        "strength.arrangement",
        "arrangement has 3 values, face_width has 2",
        "one for each",
    ),
    (
        PLAIN.replace("0.6", "0.6\nunderrun = 0.1"),
        "strength.underrun",
        "0.1 is out of range; an underrun is at least 0 and at most 0.05",
        "such as 0.005",
    ),
    (
        PLAIN.replace("0.6", '0.6\nwidth = "30 mm"'),
        "strength.width",
        "width without module: the width follows from the module that strength asks for",
        'module = "2 mm"',
    ),
    (
        CHECKED.replace("0.6", "0.6\nunderrun = 0.01"),
        "strength.underrun",
        "underrun together with module: a given module is checked, nothing is chosen",
        "remove underrun",
    ),
    (
        CHECKED.replace('"3.5 mm"', "3.5"),
        "strength.module",
        "3.5 without a unit is in m",
        'write "3.5 mm" or "3.5 m"',
    ),
    (
        PLAIN.replace("0.6", "0.6\npermissible_contact = 600"),
        "strength.permissible_contact",
        "600 without a unit is in Pa",
        'write "600 MPa" or "600 Pa"',
    ),
    (
        PLAIN.split("[strength.material]")[0],
        "strength",
        "missing key: the material of the wheels, or both permissible stresses",
        "[strength.material]",
    ),
    (
        PLAIN.replace("material", "wheel"),
        "strength.wheel",
        "wheel without pinion",
        "[strength.pinion]",
    ),
    (
        f"{PLAIN}[strength.pinion]\n{STEEL}",
        "strength.material",
        "material together with pinion: material is that of all wheels",
        "remove it",
    ),
    (
        PLAIN.replace("40Kh", "40KhM"),
        "strength.material.steel",
        "Table D.4.3 has no steel '40KhM'",
        "did you mean 40Kh",
    ),
    (
        PLAIN.replace('steel = "40Kh"\n', ""),
        "strength.material",
        "missing key: the bending limit depends on the steel",
        'steel = "40Kh"',
    ),
    (
        PLAIN.replace('hardness = "300 HB"\n', ""),
        "strength.material",
        "missing key: the limits depend on the hardness of the teeth",
        'hardness = "300 HB"',
    ),
    (
        PLAIN.replace('treatment = "improved"\n', ""),
        "strength.material",
        "missing key: the limits depend on the heat treatment",
        'treatment = "improved"',
    ),
    (
        PLAIN.replace("300 HB", "300"),
        "strength.material.hardness",
        "'300' is not a hardness",
        '"300 HB"',
    ),
    (
        PLAIN.replace('"300 HB"', "300"),
        "strength.material.hardness",
        "300 is not a hardness: it has a number and a scale",
        '"300 HB"',
    ),
    (
        PLAIN.replace("300 HB", "3000 HB"),
        "strength.material.hardness",
        "a hardness of 3000 HB cannot be: HB goes from 80 to 650",
        '"300 HB"',
    ),
    (
        PLAIN.replace("300 HB", "400 HB"),
        "strength.material.hardness",
        "a hardness of 400 HB is outside the tables: improved wheels have HB 350 at most or HB 180 to 300",
        "change the hardness",
    ),
    (
        PLAIN.replace("300 HB", "30 HRC"),
        "strength.material.hardness",
        "the hardness of improved wheels is told in HB; 30 HRC is given",
        "give it in HB",
    ),
    (
        PLAIN.replace("improved", "carburised").replace("300 HB", "60 HRC"),
        "strength.material.steel",
        "Table D.4.3 has no bending limit of 40Kh for carburised wheels",
        "40Kh is",
    ),
    (
        PLAIN.replace("improved", "through-hardened").replace("300 HB", "50 HRC"),
        "strength.material",
        "missing key: Table D.4.4 has no contact limit of through-hardened teeth",
        'contact_limit = "900 MPa"',
    ),
    (
        PLAIN.replace("improved", "nitrided").replace("300 HB", "600 HV").replace("40Kh", "40KhFA"),
        "strength.material",
        "missing key: the bending limit of nitrided teeth depends on the hardness of their core",
        'core = "30 HRC"',
    ),
    (
        PLAIN.replace('steel = "40Kh"', 'row = "h7"'),
        "strength.material.row",
        "'h7' is not a row of Table D.4.3 for improved wheels",
        "rows: im",
    ),
    (
        PLAIN.replace('"improved"', '"boiled"'),
        "strength.material.treatment",
        "Input should be 'annealed'",
        "",
    ),
    (PLAIN.replace("face_width", "face_widht"), "strength.face_widht", "Extra inputs are not permitted", ""),
]


@pytest.mark.parametrize(("text", "path", "message", "remedy"), SLIPS)
def test_one_slip_is_one_fault(text: str, path: str, message: str, remedy: str) -> None:
    ((where, said, advice),) = faults(text)
    assert where == path
    assert said.startswith(message)
    assert remedy in advice


@pytest.mark.parametrize(
    "text",
    [
        PLAIN,
        CHECKED,
        PLAIN.replace("0.6", '0.6\npermissible_contact = "600 MPa"\npermissible_bending = ["200 MPa", "220 MPa"]'),
        '[strength]\ntorque = 5\npermissible_contact = "600 MPa"\npermissible_bending = "200 MPa"\n',
        PLAIN.replace("material", "pinion"),
        f"{PLAIN.replace('material', 'pinion')}[strength.wheel]\n{STEEL}",
        PLAIN.replace('steel = "40Kh"', 'row = "im"'),
        PLAIN.replace('steel = "40Kh"', 'bending_limit = "540 MPa"'),
        PLAIN.replace('improved"\nsteel = "40Kh"', 'surface-hardened"').replace("300 HB", "45 HRC"),
        PLAIN.replace("improved", "annealed").replace("300 HB", "180 HB") + 'bending_limit = "300 MPa"\n',
        PLAIN.replace("300 HB", "330 HB"),
    ],
)
def test_what_is_allowed(text: str) -> None:
    assert faults(text) == []
    assert to_strength(read(text)).torque > 0


HOSTILE: list[Any] = [True, -1, 0, 1e400, float("nan"), "", "x", [], [[]], [{}], {}, {"a": 1}, "300 HB", [None]]


@pytest.mark.parametrize("key", [*StrengthTable.model_fields, *(f"material.{k}" for k in MaterialTable.model_fields)])
def test_no_value_breaks_the_checks(key: str) -> None:
    counts = {1}
    for value in HOSTILE:
        document = tomllib.loads(PLAIN)
        *home, last = key.split(".")
        target = document["strength"]
        for step in home:
            target = target[step]
        target[last] = value
        found = [finding for rule in CHECKS for finding in rule(Outline(document, lambda path: None))]
        assert all(finding.message for finding in found)
        try:
            read_table = StrengthTable.model_validate(document["strength"])
        except ValidationError as error:
            counts.add(error.error_count())
            continue
        if not found:
            to_strength(read_table)
    assert counts == {1}
    for value in HOSTILE:
        for rule in CHECKS:
            list(rule(Outline({"strength": value}, lambda path: None)))


def test_words_are_those_of_the_room() -> None:
    def words(of: Any, key: str) -> set[Any]:
        literal = of.model_fields[key].annotation
        options = [get_args(part) or (part,) for part in get_args(literal)] or [get_args(literal)]
        return {word for option in options for word in option} - {type(None)}

    assert words(MaterialTable, "treatment") == {*material.TREATMENTS}
    assert words(MaterialTable, "structure") == {*material.STRUCTURES}
    assert words(MaterialTable, "failure") == {*material.FAILURES}
    assert words(MaterialTable, "blank") == {*material.BLANKS}
    assert words(MaterialTable, "wear") == {*material.WEARS}
    assert words(MaterialTable, "load") == {*material.LOADS}
    assert words(StrengthTable, "face_width_rule") == {*task.WIDTH_RULES}
    assert words(StrengthTable, "rounding") == {*task.ROUNDINGS}
    assert words(StrengthTable, "on_overload") == {*task.ON_OVERLOAD}
    assert {row.row for row in table(Arrangement)} == {*range(1, ROWS + 1)}


def test_schema() -> None:
    schema = TypeAdapter(StrengthTable).json_schema()
    assert {*schema["properties"]} == {*StrengthTable.model_fields}
    assert all(value.get("description") for value in schema["properties"].values())
