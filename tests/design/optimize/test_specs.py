"""Specs of which nothing can be sought: each with one message, exit 2, and nothing written."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tmmcalc.cli import main

CONFIGS = Path(__file__).parents[3] / "configs"
KEY = "mechanism.links[id=1].points.A[0]"
SOUGHT = 'least = "kinematics.size(omega_3)"'
VARIABLE = f'of = "{KEY}"\nat_least = "40 mm"\nat_most = "120 mm"'


def of(variable: str = VARIABLE, sought: str = SOUGHT, more: str = "") -> str:
    return f"[optimize]\n{sought}\n[[optimize.variables]]\n{variable}\n{more}"


def other(old: str, new: str) -> str:
    """A spec with a part of its variable written otherwise."""
    assert old in VARIABLE
    return of(VARIABLE.replace(old, new))


FAULTS = {
    "an unknown key": (of(sought=f"{SOUGHT}\nsedd = 3"), "unknown key 'sedd'", 'did you mean "seed"?'),
    "an unknown key of a variable": (of(f"{VARIABLE}\nsteps = 3"), "unknown key 'steps'", 'did you mean "step"?'),
    "a wrong unit": (other("120 mm", "120 kg"), "'120 kg' is no number in mm", "write it in mm"),
    "values of what is no number": (
        of('of = "mechanism.input.joint"\namong = ["extreme", "30 deg"]'),
        "'O' is no number",
        "name a key that holds one",
    ),
    "a wrong unit of steps": (of(f'{VARIABLE}\nstep = "5 s"'), "'5 s' is no number in mm", "write it in mm"),
    "limits the wrong way round": (
        other("40 mm", "140 mm"),
        "at_most '120 mm' is not above at_least '140 mm'",
        "widen the limits",
    ),
    "limits that are one": (
        other("120 mm", "40 mm"),
        "at_most '40 mm' is not above at_least '40 mm'",
        "widen the limits",
    ),
    "one limit": (of(f'of = "{KEY}"\nat_least = "40 mm"'), "missing key: at_most", "add at_least"),
    "a step of nothing": (of(f"{VARIABLE}\nstep = 0"), "a step of 0 goes nowhere", "write one above 0"),
    "too large a step": (of(f'{VARIABLE}\nstep = "90 mm"'), "leaves the least value alone", "write a smaller one"),
    "too many steps": (of(f'{VARIABLE}\nstep = "1e-6 mm"'), "values are more than 10000", "write a larger step"),
    "one value": (of(f'of = "{KEY}"\namong = ["40 mm"]'), "one value leaves nothing to choose", "write two or more"),
    "a value twice": (of(f'of = "{KEY}"\namong = ["40 mm", "4 cm"]'), "a value stands twice", "write each once"),
    "a value of another kind": (
        of(f'of = "{KEY}"\namong = ["40 mm", "3 kg"]'),
        "'3 kg' is no number in mm",
        "write it in mm",
    ),
    "a value that is none": (other("120 mm", "far"), "'far' is no quantity", "write it in mm"),
    "a limit that is no number": (other('"120 mm"', "nan"), "nan is not a finite number", "write a number"),
    "an unknown result": (
        of(sought='least = "kinematics.size(omega_4)"'),
        "optimize.least: no quantity is called",
        "kinematics.size(omega_3)",
    ),
    "no one result": (of(sought='least = "size(omega_*)"'), "may name several results", "without * and ?"),
    "a result twice": (
        of(sought='least = ["kinematics.size(omega_3)", "kinematics.size(omega_3)"]'),
        "is named twice",
        "remove one of them",
    ),
    "a result by two names": (
        of(sought='least = ["kinematics.size(omega_3)", "size(omega_3)"]'),
        "are the same result",
        "remove one of them",
    ),
    "a result both ways": (
        of(sought=f'{SOUGHT}\ngreatest = "kinematics.size(omega_3)"'),
        "is to be least and greatest",
        "remove it from one",
    ),
    "no result": (of(sought="seed = 2"), "missing key: least or greatest", "add least"),
    "a key twice": (of(more=f"[[optimize.variables]]\n{VARIABLE}"), "is varied twice", "remove it from one"),
    "a key in two ways": (
        of(more="[[optimize.variables]]\n" + VARIABLE.replace("[id=1]", "[0]")),
        f"mechanism.links[0].points.A[0] is varied twice, as {KEY} too",
        "remove it from one",
    ),
    "no one key": (other("A[0]", "A*"), "may name several keys", "write each"),
    "keys of two kinds": (
        of(VARIABLE.replace(f'"{KEY}"', f'["{KEY}", "mechanism.input.speed"]')),
        "mechanism.input.speed is in rad/s",
        "two variables",
    ),
    "a key of text": (other("points.A[0]", "name"), "'crank' is no number", "name a key that holds one"),
    "a key of a link that is not there": (
        other("id=1", "id=9"),
        "mechanism.links has no element with id = 9",
        "there are: 1, 2, 3",
    ),
    "no variables": (f"[optimize]\n{SOUGHT}\n", "missing key: something has to be changed", "[[optimize.variables]]"),
    "text for a number": (
        of(sought=f'{SOUGHT}\nevaluations = "many"'),
        "'many' is not a number of evaluations",
        "whole number",
    ),
    "too few designs": (of(sought=f"{SOUGHT}\nevaluations = 3"), "3 is out of range", "between 100 and"),
    "a constraint on a stage that does not run": (
        of(more='[[constraints]]\nname = "strong"\nvalue = "forces.max(R_A)"\nat_most = "3 N"\n'),
        "constraints, strong: forces does not run: no loads, masses or springs",
        "",
    ),
    "a constraint in another unit": (
        of(more='[[constraints]]\nname = "swings"\nvalue = "kinematics.size(omega_3)"\nat_most = "3 N"\n'),
        "constraints, swings: '3 N' cannot be compared",
        "write a number in rad/s",
    ),
}


def told(
    file: Path, text: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> tuple[int, str, str]:
    """Exit code, standard output and error of a search by a spec."""
    file.write_text(text)
    monkeypatch.setattr(sys, "argv", ["tmmcalc", "optimize", str(file), "--spec", str(file.with_name("best.toml"))])
    monkeypatch.setattr("tmmcalc.cli.patience.FIRST", 1e6)
    with pytest.raises(SystemExit) as ended:
        main()
    return int(ended.value.code or 0), *capsys.readouterr()


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_told_once_and_nothing_is_written(
    fault: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked, message, remedy = FAULTS[fault]
    text = (CONFIGS / "four-bar.toml").read_text() + asked
    code, out, err = told(tmp_path / "four.toml", text, monkeypatch, capsys)
    assert (code, out) == (2, "")
    assert message in err
    assert remedy in err
    assert err.startswith("error: ")
    assert err.count("->") == (1 if remedy else 0)
    assert [each.name for each in tmp_path.iterdir()] == ["four.toml"]


def test_what_is_no_table_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = 'optimize = "x"\n' + (CONFIGS / "four-bar.toml").read_text()
    code, _, err = told(tmp_path / "four.toml", text, monkeypatch, capsys)
    assert code == 2
    assert "1 fault\n" in err
    assert "'x' is not a table" in err
