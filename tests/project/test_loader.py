from __future__ import annotations

import math
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from pydantic_core import PydanticUndefined

import tmmcalc
from project.scenes import ENGINE, MACHINE, ROTOR, TORQUE, TRAIN
from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.machine.tables.flywheel import FlywheelTable
from tmmcalc.machine.tables.motion import MotionTable
from tmmcalc.machine.tables.motor import MotorTable
from tmmcalc.machine.tables.reduction import ReductionTable
from tmmcalc.machine.tables.transmission import TransmissionTable
from tmmcalc.project import Spec, load_spec, parse_spec, templates
from tmmcalc.project.tables import tables_at, tables_in
from tmmcalc.project.words import words_of
from tmmcalc.rooms import TABLES
from tmmcalc.spec.limits import MOST_BYTES


@pytest.mark.slow
def test_every_ready_spec_loads() -> None:
    for name in templates.names():
        spec = load_spec(templates.path(name))
        assert isinstance(spec, Spec)
        assert templates.description(name), name


def test_shaper_values(shaper: str) -> None:
    mechanism = parse_spec(shaper).mechanism
    assert mechanism.links[3].points == {"C": [0.0, 0.0], "D": [0.29, 0.0]}
    assert mechanism.links[2].mass == 55.0
    assert mechanism.links[0].mass is None
    assert mechanism.input.start == "extreme"
    assert mechanism.gravity == 9.81


def test_byte_order_mark_and_crlf(tmp_path: Path, shaper: str) -> None:
    file = tmp_path / "spec.toml"
    file.write_bytes(b"\xef\xbb\xbf" + shaper.replace("\n", "\r\n").encode())
    assert load_spec(str(file)) == parse_spec(shaper)


@pytest.mark.parametrize(
    ("content", "fragment"),
    [
        (None, "there is no file"),
        ("directory", "is a directory"),
        (b"title = '\xff'", ".toml:1:10 is not UTF-8 text"),
        ("text".encode("utf-16"), "is not UTF-8"),
        (b"#" * (MOST_BYTES + 1), "larger than 1 MB"),
    ],
)
def test_unreadable_file_is_a_usage_error(tmp_path: Path, content: bytes | str | None, fragment: str) -> None:
    file = tmp_path / "spec.toml"
    if content == "directory":
        file.mkdir()
    elif isinstance(content, bytes):
        file.write_bytes(content)
    with pytest.raises(UsageError) as caught:
        load_spec(file)
    assert fragment in str(caught.value)
    assert str(file) in str(caught.value)


def test_odd_file_names_are_usage_errors() -> None:
    for name in ("a\0b", "x" * 5000, "/dev/zero", "no/such/folder/spec.toml"):
        with pytest.raises(UsageError):
            load_spec(name)


@pytest.mark.parametrize(
    "text",
    [
        "a = " + "[" * 20000,
        "a = " + "[" * 200 + "]" * 200,
        "a = " + "{ b = " * 150 + "1" + " }" * 150,
        "[" + ".".join(["a"] * 5000) + "]",
        "a = " + "9" * 5000,
        "a = 2001-02-30",
    ],
)
def test_hostile_text_is_a_spec_error(text: str) -> None:
    with pytest.raises(SpecError):
        parse_spec(text)


def test_message_names_the_file_and_counts_the_faults(shaper: str) -> None:
    with pytest.raises(SpecError, match=r"ram\.toml: 2 faults\n  ram\.toml:51:1: mechanism\.links\[2\]\.mass: -3 is"):
        parse_spec(shaper.replace("mass = 55", "mass = -3").replace("mass = 12", "mass = -1"), "ram.toml")


def test_every_required_key_has_its_words() -> None:
    tables = [("", Spec), *_tables()]
    required = {
        f"{name}.{field.alias or key}".lstrip(".")
        for name, table in tables
        for key, field in table.model_fields.items()
        if field.default is PydanticUndefined and field.default_factory is None
    }
    said = {f"{key}.{name}" for key in TABLES for name in words_of(key).missing}
    assert required == said


def test_words_are_of_keys_that_there_are() -> None:
    for root in TABLES:
        words = words_of(root)
        for name in (*words.lists, *words.inline, *words.places, *words.elements, *words.lengths, *words.zeros):
            *steps, key = [root, *filter(None, name.removesuffix("[]").split("."))]
            fields = [field.alias or each for table in tables_at(steps) for each, field in table.model_fields.items()]
            assert key in fields, f"{root}.{name}"


def test_every_key_is_described() -> None:
    for _, table in [("", Spec), *_tables()]:
        assert all(field.description for field in table.model_fields.values()), table
        assert table.__doc__


def _tables() -> list[tuple[str, type[Spec]]]:
    found, todo = [], [("", Spec)]
    while todo:
        name, table = todo.pop()
        for key, field in table.model_fields.items():
            for sub in tables_in(field.annotation):
                found.append((f"{name}.{key}".lstrip("."), sub))
                todo.append(found[-1])
    return found


LISTS = ("loads", "springs", "shafts", "transients")
SINGLE = (
    "torque",
    "drive",
    "motor",
    "transmission",
    "reduction",
    "motion",
    "flywheel",
    "balance",
    "engine",
    "rotor",
    "train",
)
LATE = (*LISTS, *SINGLE)
LATER = (
    "gearing",
    "pair",
    "cam",
    "indexing",
    "vibrator",
    "pendulum",
    "unsteady",
    "paths",
    "manipulator",
    "linksynthesis",
)


@cache
def loaded_by(spec: str) -> set[str]:
    """Modules in memory after this spec was read by a process of its own."""
    code = (
        "import sys, tmmcalc.project; late = set(sys.modules)\n"
        "assert 'pydantic' not in late\n"
        "from tmmcalc.project import parse_spec\n"
        f"parse_spec({spec!r})\n"
        "print(*sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=Path.cwd())
    return set(done.stdout.split())


@pytest.mark.slow
def test_a_good_spec_loads_nothing_that_only_faults_need(shaper: str) -> None:
    unneeded = {
        "difflib",
        "numpy",
        "scipy",
        "tmmcalc.project.wording",
        "tmmcalc.project.words",
        "tmmcalc.spec.source",
    }
    assert not unneeded & loaded_by(shaper)
    assert not unneeded & loaded_by(shaper + MACHINE + ENGINE + ROTOR + TRAIN)
    assert not unneeded & loaded_by(templates.path("gears-single-planets").read_text(encoding="utf-8"))
    assert not unneeded & loaded_by("[pair]\nteeth = [14, 27]\nmodule = 0.005\n")


@pytest.mark.slow
def test_tables_are_built_only_when_a_spec_has_them(shaper: str) -> None:
    late = [entry for name, entry in TABLES.items() if name in (*LATE, *LATER, "constraints", "feasibility", "sheets")]
    names = {f"{entry.home}.tables.{entry.name}" for entry in late}
    names |= {f"{entry.home}.tables.checks.{check}" for entry in late for check in entry.checks}
    names |= {f"tmmcalc.linkage.tables.tasks.{task}" for task in ("mechanism", "loading")}
    names |= {f"tmmcalc.machine.tables.tasks.{task}" for task in ("machine", "balance")}
    assert len(names) > len(late) + 20
    assert not names & loaded_by(shaper)
    assert names & loaded_by(f"{shaper}\n[reduction]\n") == {"tmmcalc.machine.tables.reduction"}
    of_a_machine = {f"{TABLES[name].home}.tables.{name}" for name in LATE if name != "torque"}
    assert of_a_machine <= loaded_by(shaper + MACHINE + ENGINE + ROTOR + TRAIN)
    alone = {f"tmmcalc.machine.tables.{part}torque" for part in ("", "checks.")}
    assert names & loaded_by(TORQUE) >= alone


@pytest.mark.slow
def test_files_are_read_only_when_a_spec_names_one(shaper: str) -> None:
    reader = "tmmcalc.project.files"
    load = "\n[[loads]]\nlink = 5\npoint = [0, 0]\n"
    assert reader not in loaded_by(f"{shaper}{load}force = 100\n{MACHINE}")
    assert reader not in loaded_by(TORQUE)
    catalogue = Path(tmmcalc.__file__).parent / "machine" / "motors" / "catalogue.csv"
    assert reader in loaded_by(f"{shaper}\n[motor]\nname = 'choose'\ncatalogue = '{catalogue}'\n")


def test_late_tables_are_those_of_the_root() -> None:
    root = {"project", "mechanism"}
    further = {
        "strength",
        "criteria",
        "gearing",
        "open_pair",
        "pair",
        "wheel",
        "cam",
        "indexing",
        "vibrator",
        "pendulum",
        "unsteady",
        "paths",
        "dyad",
        "manipulator",
        "contact",
        "reliability",
        "tie_down",
        "falling_ball",
        "bearing",
        "liner",
        "transloader",
        "synthesis",
        "constraints",
        "feasibility",
        "sheets",
        "note",
        "tolerances",
        "optimize",
        "class",
    }
    assert {*Spec.model_fields} - root == {*LATE} | further
    assert root < {*Spec.model_fields}


def test_values_of_the_machine(shaper: str) -> None:
    spec = parse_spec(shaper + MACHINE)
    assert (spec.motor, spec.transmission, spec.reduction, spec.motion, spec.flywheel) == (
        MotorTable(
            power=7500.0,
            speed=1455 * math.pi / 30,
            synchronous_speed=50 * math.pi,
            overload=2.2,
            flywheel_moment=0.11,
            characteristic="kloss",
        ),
        TransmissionTable(efficiency=0.95),
        ReductionTable(rods="lumped"),
        MotionTable(inertia=12.0),
        FlywheelTable(delta=0.04, shaft="motor"),
    )


def test_tables_that_a_spec_has_not(shaper: str) -> None:
    spec = parse_spec(shaper)
    assert [getattr(spec, name) for name in LISTS] == [[]] * len(LISTS)
    assert [getattr(spec, name) for name in SINGLE] == [None] * len(SINGLE)
    assert parse_spec(TORQUE).mechanism is None
