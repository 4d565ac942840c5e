"""Commands that begin a project: init, check, schema, plan; help, version and completion."""

from __future__ import annotations

import json
import re
import sys
import tomllib
from pathlib import Path

import pytest
from sparing import sparing

from tmmcalc.cli.check import HELD
from tmmcalc.cli.commands import COMMANDS, SECTIONS, grouped
from tmmcalc.project import templates
from tmmcalc.project.checks import SUBJECTS
from tmmcalc.rooms import STAGES

from .conftest import CONFIGS, Cli
from .scenes import ENGINE, ROTOR, TORQUE

READY = templates.names()


def test_help_lists_every_command_in_the_order_of_work(cli: Cli) -> None:
    code, out, err = cli("--help")
    assert (code, err) == (0, "")
    places = [out.index(f"\n  {name} ") for name in COMMANDS]
    assert places == sorted(places)
    assert "Exit codes" in out


GROUPS = {"gears": grouped("gears"), "cam": grouped("cam"), "extra": grouped("extra")}
EVERY = [(name,) for name in COMMANDS] + [(group, name) for group, table in GROUPS.items() for name in table]


def test_help_of_a_group_lists_its_commands(cli: Cli) -> None:
    for group, table in GROUPS.items():
        code, out, _ = cli(group, "--help")
        assert code == 0
        assert [line.split()[0] for line in out.partition("Commands:\n")[2].partition("\n\n")[0].splitlines()] == [
            *table
        ]


@sparing("name", EVERY, ids=" ".join, every=3)
def test_help_has_an_example_and_stays_in_80_columns(
    cli: Cli, name: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    code, out, err = cli(*name, "--help")
    assert (code, err) == (0, "")
    assert out.startswith(f"Usage: tmmcalc {' '.join(name)} ")
    assert f"Example: tmmcalc {' '.join(name)}" in out
    assert max(map(len, out.splitlines())) <= 80


SOLVING = [(name,) for name in (*SECTIONS["Linkages"], *SECTIONS["Machines"], "feasibility", "plot")]
SOLVING += [name for name in EVERY if len(name) == 2]


@sparing("name", [("check",), ("plan",), ("run",), *SOLVING], ids=" ".join, every=4)
def test_a_file_that_is_no_spec_is_one_clear_fault(cli: Cli, name: tuple[str, ...]) -> None:
    Path("folder.toml").mkdir()
    Path("binary.toml").write_bytes(bytes(range(256)))
    Path("empty.toml").touch()
    for file, said in {
        "none.toml": "there is no file none.toml",
        "folder.toml": "folder.toml is a directory",
        "binary.toml": "binary.toml:2:118 is not UTF-8 text",
        "empty.toml": "missing key: a spec describes a mechanism",
    }.items():
        code, out, err = cli(*name, file)
        assert (code, out) == (2, "")
        assert err.startswith("error: ")
        assert said in err
        assert err.count("\n  -> ") + err.count("\n    -> ") == 1


@sparing("name", [name for name in SOLVING if name != ("balance",)], ids=" ".join, every=4)
def test_a_spec_without_the_table_is_one_clear_fault(cli: Cli, name: tuple[str, ...]) -> None:
    Path("rotor.toml").write_text(ROTOR)
    code, out, err = cli(*name, "rotor.toml", "-q")
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert err.count("\n  -> ") == 1
    assert not Path("rotor.out").exists()


def test_a_flag_of_a_command_stands_in_place_of_the_shared_one(cli: Cli) -> None:
    own, shared = cli("cam", "profile", "--help").out, cli("kinematics", "--help").out
    assert own.count("--tolerance ") == shared.count("--tolerance ") == 1
    assert "--tolerance LENGTH" in own
    assert "--tolerance ERROR" in shared


def test_without_a_command_ten_lines_tell_how_to_begin(cli: Cli) -> None:
    code, out, err = cli()
    assert (code, out) == (2, "")
    lines = err.splitlines()
    assert len(lines) == 9
    assert max(map(len, lines)) <= 80
    named = re.findall(r"tmmcalc (\S+) (\S*)", err.replace(".", " "))
    assert {name for name, _ in named} - {"-h"} <= {*COMMANDS}
    assert all(cli(name, "-h").code == 0 for name in ("init", "run", "plan"))
    assert cli("gears").err.startswith("Usage: tmmcalc gears ")


WITHOUT_SPEC = [("flywheel",), ("check",), ("plot", "-q"), ("cam", "synth"), ("sweep", "--set", "a=1")]


@pytest.mark.parametrize("name", WITHOUT_SPEC)
def test_without_a_spec_those_of_the_folder_are_named(cli: Cli, name: tuple[str, ...]) -> None:
    Path("broken.toml").write_text("title = [\n[[ loads ]]\n")
    Path("other.toml").write_text("[tool.ruff]\nline-length = 120\n")
    Path("notes.txt").write_text("[project]\n")
    code, out, err = cli(*name)
    command = " ".join(("tmmcalc", *(word for word in name if word in {*COMMANDS, "synth"})))
    assert (code, out) == (2, "")
    assert err == (
        f"error: {command}: no spec is named\n"
        f"  -> this folder has broken.toml, my.toml; write e.g. {command} broken.toml\n"
    )
    Path("broken.toml").unlink()
    Path("my.toml").unlink()
    assert "this folder has none: tmmcalc init shaper -o my.toml writes one" in cli(*name).err


def test_version(cli: Cli) -> None:
    code, out, _ = cli("--version")
    assert code == 0
    assert out.split()[0] == "tmmcalc"


@pytest.mark.parametrize(
    ("given", "remedy"),
    [("kinematcs", "did you mean kinematics?"), ("my.toml", "tmmcalc run my.toml"), ("zzz", "commands: init")],
)
def test_unknown_command(cli: Cli, given: str, remedy: str) -> None:
    code, out, err = cli(given)
    assert (code, out) == (2, "")
    assert remedy in err


@pytest.mark.parametrize("args", [("forces", "my.toml", "again"), ("check", "my.toml", "--colour")])
def test_wrong_usage(cli: Cli, args: tuple[str, ...]) -> None:
    code, out, err = cli(*args)
    assert (code, out) == (2, "")
    assert "Usage: tmmcalc" in err


@pytest.mark.parametrize(
    ("typed", "at", "offered"),
    [
        ("tmmcalc ", 1, list(COMMANDS)),
        ("tmmcalc kin", 1, ["kinematics"]),
        ("tmmcalc kinematics --me", 2, ["--method"]),
        ("tmmcalc kinematics my.toml --method ", 4, ["closed", "projection", "differences", "splitting"]),
        ("tmmcalc run my.toml --to ", 4, list(STAGES)),
        ("tmmcalc sweep my.toml --to kin", 4, ["kinematics"]),
        ("tmmcalc init slot", 2, ["slotted-link", "slotter"]),
        ("tmmcalc bogus ", 2, list(COMMANDS)),
    ],
)
def test_completion(cli: Cli, monkeypatch: pytest.MonkeyPatch, typed: str, at: int, offered: list[str]) -> None:
    monkeypatch.setenv("COMP_WORDS", typed)
    monkeypatch.setenv("COMP_CWORD", str(at))
    monkeypatch.setenv("_TMMCALC_COMPLETE", "complete_bash")
    code, out, err = cli()
    assert (code, err) == (0, "")
    assert out.split() == offered


def test_show_completion_names_the_program(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    # The shell is looked for among the parents of the process, where a test run need not have one.
    monkeypatch.setattr("shellingham.detect_shell", lambda: ("bash", "/bin/bash"))
    code, out, _ = cli("--show-completion")
    assert code == 0
    assert "_TMMCALC_COMPLETE" in out


def test_init_lists_the_ready_specs(cli: Cli) -> None:
    code, out, err = cli("init", "--list")
    assert (code, err) == (0, "")
    plain = [name for name in READY if "/" not in name]
    assert named_in(out) == [*plain, "extreme/..."]
    assert f"{len(READY) - len(plain)} hard scenes" in out
    assert max(map(len, out.splitlines())) <= 80
    assert named_in(cli("init", "extreme", "--list").out) == [name for name in READY if name.startswith("extreme/")]
    assert named_in(cli("init", "-l", "gears-c").out) == ["gears-circulating", "gears-coaxial"]
    code, out, err = cli("init", "--list", "zebra")
    assert (code, out) == (2, "")
    assert "no ready spec begins with 'zebra'" in err


def named_in(listing: str) -> list[str]:
    return [line.split()[0] for line in listing.splitlines() if not line.startswith(" ")]


@sparing("name", READY, every=6)
def test_init_writes_a_spec_that_checks(cli: Cli, name: str) -> None:
    code, out, err = cli("init", name, "-o", "new.toml")
    assert (code, out) == (0, "")
    assert err.startswith("wrote new.toml")
    assert Path("new.toml").read_text(encoding="utf-8").startswith("#:schema file:///")
    assert not [*Path().glob("*.json")]
    assert cli("check", "new.toml").code == 0


def test_init_writes_the_tables_of_a_spec(cli: Cli) -> None:
    code, out, err = cli("init", "cam-own-law", "-o", "own.toml")
    assert (code, out) == (0, "")
    assert "wrote own.toml, with cam-law.csv" in err
    assert Path("cam-law.csv").read_bytes() == (CONFIGS / "cam-law.csv").read_bytes()
    assert cli("init", "cam-own-law", "-o", "other.toml", "-q") == (0, "", "")  # the same table again
    Path("cam-law.csv").write_text("k,s\n0,0\n1,1\n")
    code, out, err = cli("init", "cam-own-law", "-o", "third.toml")
    assert (code, out) == (2, "")
    assert "cam-law.csv exists" in err
    assert not Path("third.toml").exists()
    assert cli("init", "cam-own-law", "-o", "third.toml", "--force").code == 0
    assert Path("cam-law.csv").read_bytes() == (CONFIGS / "cam-law.csv").read_bytes()


def below(spec: str) -> str:
    """A spec without its first line, which tells editors where this installation has its schema."""
    return spec.partition("\n")[2]


def test_init_prints_the_spec(cli: Cli) -> None:
    code, out, err = cli("init")
    assert (code, err) == (0, "")
    assert below(out) == below((CONFIGS / "crank-slider.toml").read_text(encoding="utf-8"))


def test_init_keeps_a_file_that_exists(cli: Cli) -> None:
    before = Path("my.toml").read_bytes()
    code, out, err = cli("init", "press", "-o", "my.toml")
    assert (code, out) == (2, "")
    assert "--force" in err
    assert Path("my.toml").read_bytes() == before
    assert cli("init", "press", "-o", "my.toml", "--force", "-q") == (0, "", "")
    assert below(Path("my.toml").read_text()) == below((CONFIGS / "press.toml").read_text())


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("shper",), 'did you mean "shaper"?'),
        (("new.toml",), "tmmcalc init crank-slider -o new.toml"),
        (("shaper", "-o", "no/new.toml"), "there is no folder no"),
        (("shaper", "-o", "."), ". is a folder"),
    ],
)
def test_init_refuses(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli("init", *args)
    assert (code, out) == (2, "")
    assert said in err


def test_check_reports_every_file(cli: Cli) -> None:
    bad = (
        Path("my.toml").read_text().replace('"200 mm"', '"200 kg"').replace('kind = "prismatic"', 'kind = "slider"', 1)
    )
    Path("bad.toml").write_text(bad)
    code, out, err = cli("check", "my.toml", "bad.toml", "none.toml", ".")
    assert code == 2
    assert out == "my.toml: ok (5 moving links, 7 joints)\n"
    assert "bad.toml: 2 faults" in err
    line = 1 + bad[: bad.index('"200 kg"')].count("\n")
    assert f"bad.toml:{line}:29: mechanism.links[0].points.A" in err
    assert "none.toml" in err
    assert ". is a directory" in err


@pytest.mark.parametrize(
    ("text", "held"),
    [
        (TORQUE, "a torque diagram"),
        (ROTOR, "a rotor with 1 unbalance"),
        (ENGINE + ROTOR, "an engine of 4 cylinders; a rotor with 1 unbalance"),
        (ENGINE.replace("4", "1"), "an engine of 1 cylinder"),
        ((CONFIGS / "pair-rack.toml").read_text(), "1 pair of gears"),
        ((CONFIGS / "wheel.toml").read_text(), "a wheel of 27 teeth"),
        ((CONFIGS / "pair-blocking.toml").read_text(), "2 pairs of gears"),
        ((CONFIGS / "gears-pairs.toml").read_text(), "a gear train, AIbar; pairs of the train"),
        (
            (CONFIGS / "geared-press.toml").read_text(),
            "3 moving links, 4 joints; a gear train, AIbar; an open pair 18/60; pairs of the train",
        ),
        ((CONFIGS / "cam-flat.toml").read_text(), "a cam with a flat-faced follower"),
        (
            (CONFIGS / "cam-oscillating.toml").read_text() + ROTOR,
            "a rotor with 1 unbalance; a cam with an oscillating follower",
        ),
        ((CONFIGS / "four-bar.toml").read_text() + ROTOR, "3 moving links, 4 joints; a rotor with 1 unbalance"),
        ((CONFIGS / "manipulator-angular.toml").read_text(), "a manipulator with an angular arm"),
        ((CONFIGS / "feasibility.toml").read_text(), "a synthesis, crank rocker; 3 constraints"),
    ],
)
def test_check_says_what_a_spec_holds(cli: Cli, text: str, held: str) -> None:
    Path("held.toml").write_text(text)
    assert cli("check", "held.toml") == (0, f"held.toml: ok ({held})\n", "")


def test_check_says_something_of_every_spec() -> None:
    assert {*HELD} - {"open_pair"} == {*SUBJECTS}


def test_check_quiet_is_silent_where_all_is_well(cli: Cli) -> None:
    assert cli("check", "my.toml", "-q") == (0, "", "")


def test_schema(cli: Cli) -> None:
    code, out, err = cli("schema")
    assert (code, err) == (0, "")
    assert json.loads(out)["$schema"].startswith("https://json-schema.org/")
    assert cli("schema", "-o", "s.json", "-q") == (0, "", "")
    assert Path("s.json").read_text(encoding="utf-8") == out
    assert cli("schema", "-o", "no/s.json").code == 2


def test_plan_says_what_runs_and_why(cli: Cli) -> None:
    code, out, err = cli("plan", "my.toml", "structure", "--format", "json")
    assert (code, err) == (0, "")
    columns = json.loads(out)["columns"]
    assert columns["stage"] == list(STAGES)
    assert columns["runs"] == ["yes" if name == "structure" else "no" for name in STAGES]
    assert columns["why"] == ["asked for" if name == "structure" else "not needed by structure" for name in STAGES]
    whole = tomllib.loads(cli("plan", "my.toml", "-f", "toml").out)["columns"]
    runs, why = (dict(zip(whole["stage"], whole[column], strict=True)) for column in ("runs", "why"))
    assert {runs[stage] for stage in ("structure", "kinematics", "forces", "reduction", "power")} == {"yes"}
    assert {runs[stage] for stage in ("flywheel", "motion")} == {"no"}
    assert why["flywheel"] == "no [flywheel]: no unevenness to keep"
    assert why["motion"] == "no [motor]: the speed is constant"
    table = cli("plan", "my.toml").out
    assert max(map(len, table.splitlines())) <= 80
    assert list(Path().iterdir()) == [Path("my.toml")]


def test_plan_of_a_spec_without_mechanism(cli: Cli) -> None:
    Path("rotor.toml").write_text(ROTOR)
    columns = json.loads(cli("plan", "rotor.toml", "-f", "json").out)["columns"]
    why = dict(zip(columns["stage"], columns["why"], strict=True))
    of_a_linkage = ("structure", "kinematics", "forces", "reduction", "power")
    assert {why[stage] for stage in of_a_linkage} == {"no [mechanism]"}
    assert why["flywheel"] == "no [flywheel]: no unevenness to keep"


@pytest.mark.parametrize(
    "command",
    [("structure",), ("kinematics",), ("kinematics", "--study"), ("forces",), ("plot",), ("run", "--to", "forces")],
)
def test_stages_of_a_linkage_refuse_a_spec_without_mechanism(cli: Cli, command: tuple[str, ...]) -> None:
    Path("rotor.toml").write_text(ROTOR)
    code, out, err = cli(command[0], "rotor.toml", *command[1:])
    assert (code, out) == (2, "")
    assert "no [mechanism]" in err


def test_plan_refuses_an_unknown_stage(cli: Cli) -> None:
    code, out, err = cli("plan", "my.toml", "kinematic")
    assert (code, out) == (2, "")
    assert "did you mean kinematics?" in err


def test_commands_are_not_in_the_way_of_each_other(cli: Cli) -> None:
    """One process may run several commands; none leaves a trace that changes the next."""
    first = cli("structure", "my.toml", "--no-store", "-q")
    assert cli("kinematics", "my.toml", "--no-store", "-q").code == 0
    assert cli("structure", "my.toml", "--no-store", "-q") == first
    assert "tmmcalc" in sys.modules
