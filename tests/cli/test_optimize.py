"""``tmmcalc optimize`` as its user meets it."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from cli.conftest import Cli

CONFIGS = Path(__file__).parents[2] / "configs"
CRANK = "mechanism.links[id=1].points.A[0]"
ONE = f"""
[optimize]
least = "kinematics.size(omega_3)"
evaluations = 100
variables = [{{ of = "{CRANK}", at_least = "50 mm", at_most = "200 mm" }}]

[[constraints]]
name = "swing"
value = "kinematics.range(angle_3)"
at_least = "42 deg"
"""


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    file = tmp_path / "four.toml"
    file.write_text((CONFIGS / "four-bar.toml").read_text() + ONE)
    return file


@pytest.mark.slow
def test_the_best_design_is_a_ready_spec(cli: Cli, spec: Path) -> None:
    out = spec.with_name("best.toml")
    told = cli("optimize", str(spec), "--spec", str(out), "-f", "json")
    assert told.code == 0
    found = json.loads(told.out)
    (crank,) = found["columns"]["value"]
    assert tomllib.loads(out.read_text())["mechanism"]["links"][0]["points"]["A"][0] == f"{crank!r} mm"
    again = json.loads(cli("kinematics", str(out), "-f", "json", "--no-store").out)
    omega = again["columns"]["omega_3[rad/s]"]
    assert max(map(abs, omega)) == pytest.approx(found["best"], rel=1e-12)
    assert "# the crank along the line of centres OC" in out.read_text()
    table = cli("optimize", str(spec)).out
    assert "least kinematics.size(omega_3)" in table
    assert "second method" in table
    assert "swing" in table
    assert not [*spec.parent.glob("*.part")]


@pytest.mark.slow
def test_a_front_is_as_many_specs_and_a_picture(cli: Cli, spec: Path) -> None:
    other = '{ of = "mechanism.links[id=3].points.B[0]", at_least = "250 mm", at_most = "350 mm" }'
    sought = 'least = ["kinematics.size(omega_3)", "kinematics.size(eps_3)"]\ndesigns = 4'
    spec.write_text(
        spec.read_text()
        .replace('least = "kinematics.size(omega_3)"', sought)
        .replace("variables = [", f"variables = [{other}, ")
    )
    out, picture = spec.with_name("best.toml"), spec.with_name("front.svg")
    drawn = ("--picture", str(picture), "--language", "uk")
    told = cli("optimize", str(spec), "--spec", str(out), "--choose", "2", *drawn, "-f", "json")
    assert told.code == 0
    found = json.loads(told.out)
    count = found["designs"]
    assert count > 1
    wanted = found["columns"]["kinematics.size(omega_3)[rad/s]"][1]
    again = json.loads(cli("kinematics", str(out), "-f", "json", "--no-store").out)
    assert max(map(abs, again["columns"]["omega_3[rad/s]"])) == pytest.approx(wanted, rel=1e-9)
    one, two = (values for key, values in found["columns"].items() if key.startswith("kinematics.size"))
    assert one == sorted(one)
    assert two == sorted(two, reverse=True)
    words = picture.read_text(encoding="utf-8")
    assert "Four-bar linkage: оптимум" in words
    assert "kinematics.size(eps_3), рад/с²" in words


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (('at_least = "50 mm"', 'at_least = "250 mm"'), "at_most '200 mm' is not above at_least '250 mm'"),
        (('at_least = "50 mm"', 'at_least = "50 N"'), "50 N"),
        ((CRANK, "mechanism.links[id=9].points.A[0]"), "id"),
        (('least = "kinematics.size(omega_3)"\n', ""), "least or greatest, the result that is sought"),
        (("size(omega_3)", "size(omega_*)"), "may name several results"),
        (("size(omega_3)", "size(omega_9)"), "optimize.least: no quantity is called 'kinematics.size(omega_9)'"),
        (('value = "kinematics.range', 'value = "kinematics.rank'), "constraints"),
        (('at_most = "200 mm"', 'at_most = "200 mm", step = 0'), "a step of 0 goes nowhere"),
        (('at_least = "50 mm", at_most = "200 mm"', 'among = ["50 mm"]'), "one value leaves nothing to choose"),
        (("evaluations = 100", "evaluations = 3"), "evaluations"),
    ],
)
def test_what_is_wrong_is_one_error_and_nothing_is_written(
    cli: Cli, spec: Path, change: tuple[str, str], message: str
) -> None:
    spec.write_text(spec.read_text().replace(*change))
    before = {*spec.parent.iterdir()}
    told = cli("optimize", str(spec), "--spec", str(spec.with_name("best.toml")))
    assert told.code == 2
    assert message in told.err
    assert {*spec.parent.iterdir()} == before


def test_one_result_has_no_front_to_draw(cli: Cli, spec: Path) -> None:
    told = cli("optimize", str(spec), "--picture", str(spec.with_name("front.svg")))
    assert told.code == 2
    assert "there is no front to draw" in told.err
