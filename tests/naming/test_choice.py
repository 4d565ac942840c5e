"""What is by choice, by name: columns against what is computed otherwise, details of a stage that has any."""

from __future__ import annotations

import csv
import math
import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.stages import forces as forces_stage
from tmmcalc.linkage.stages import kinematics as kinematics_stage
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import CHOICE, Extent, Told, chosen, listed, offered, one
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

SHAPER = Path(__file__).parents[2] / "configs" / "shaper.toml"
STAGES = ("kinematics", "forces")


@pytest.fixture(scope="module")
def scene() -> RunResult:
    return run(tmmcalc.load_spec(SHAPER), target=STAGES)


def told(scene: RunResult, text: str) -> Told:
    return one(parse(text), scene.results, Scene(scene.spec, scene.results))


def test_reactions_without_friction_are_those_of_the_scene_without_it(scene: RunResult) -> None:
    smooth = run(tmmcalc.parse_spec(re.sub(r"friction = [\d.]+", "friction = 0", SHAPER.read_text())), target=STAGES)
    assert told(scene, "forces.max(R_A)").value > 1.01 * told(smooth, "forces.max(R_A)").value
    for asked in ("max({}_A)", "rms({}_D0_y)", "at_max({}_B)", "min({}_A)@2..12", "{}_C[phi=47 deg]"):
        found = told(scene, f"forces.{asked.format('R0')}")
        assert found.value == pytest.approx(told(smooth, f"forces.{asked.format('R')}").value, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("place", ["@7", "[phi=47 deg]", "[phi=311.5 deg]"])
def test_a_relative_velocity_is_the_difference_of_two_velocities(scene: RunResult, place: str) -> None:
    ends = [complex(*(told(scene, f"kinematics.v{axis}_{point}{place}").value for axis in "xy")) for point in "DC"]
    apart = ends[0] - ends[1]
    assert told(scene, f"kinematics.vrelx_D_C{place}").value == pytest.approx(apart.real, abs=1e-12)
    assert abs(told(scene, f"vrel_D_C{place}").value) == pytest.approx(abs(apart), abs=1e-12)


def test_what_stands_in_a_table_comes_first(scene: RunResult) -> None:
    by_name = tmmcalc.told(scene, "forces.max(R*_A)")
    assert [*by_name] == ["forces.max(R_A)[N]"]
    assert [*tmmcalc.told(scene, "forces.max(R0*_A)")] == ["forces.max(R0_A)[N]"]
    with pytest.raises(UsageError, match="forces tells no 'R0_Z'") as refused:
        told(scene, "forces.max(R0_Z)")
    assert "R0_" in refused.value.remedy


def test_nothing_by_choice_is_asked_for_where_a_name_fits(scene: RunResult, monkeypatch: pytest.MonkeyPatch) -> None:
    def never(spec: Any, results: Mapping[str, Any]) -> Any:
        raise AssertionError

    for stage in (kinematics_stage, forces_stage):
        monkeypatch.setattr(stage, "further", never)
        monkeypatch.setattr(stage, "details", never, raising=False)
    assert len(tmmcalc.told(scene, "forces.max(R_A)", "stroke_D", "kinematics.S_D[phi=47 deg]")) == 3


def test_the_list_computes_nothing(scene: RunResult) -> None:
    listed = {each.quantity: each for each in offered("forces", Scene(scene.spec, scene.results))}
    column = listed["Pi_3"]
    assert isinstance(column, Extent)
    assert (column.unit, column.rows, column.choice) == ("N", 0, True)
    assert math.isnan(column.least)
    assert column.meaning == "magnitude of the inertia force of link 3"


def test_errors_and_counters_are_those_of_the_stage_file(tmp_path: Path) -> None:
    result = tmmcalc.run(tmmcalc.load_spec(SHAPER), out=tmp_path)
    for stage in ("kinematics", "forces", "motion", "balance"):
        stored = tomllib.loads((tmp_path / f"{stage}.toml").read_text())
        wanted = {f"{stage}.error.{name}": size for name, size in stored.get("error", {}).items() if size != str(size)}
        wanted |= {f"{stage}.counters.{name}": size for name, size in stored.get("counters", {}).items()}
        assert wanted
        assert tmmcalc.told(result, *wanted) == wanted


def test_an_error_estimate_means_an_error_estimate() -> None:
    """Of facts as of what is by choice; the last digit's change of the positions is called ``position`` too."""
    result = tmmcalc.run(tmmcalc.load_spec(SHAPER))
    found = {
        f"{stage}.{each.quantity}": each.meaning
        for stage, of_stage in result.results.items()
        for each in listed(stage, of_stage)
        if "error." in each.quantity
    }
    assert found["kinematics.error.position"] == "estimated relative error: position"
    assert found["forces.error.reactions"] == "estimated relative error: reactions"
    assert len(found) > 6
    for name, meaning in found.items():
        assert meaning == f"estimated relative error: {name.partition('.error.')[2]}"


def test_warnings_are_counted_and_hold_their_numbers() -> None:
    result = tmmcalc.run(tmmcalc.load_spec(SHAPER), target="motion")
    regime = result.results["motion"].regime
    found = tmmcalc.told(result, "motion.warnings", "motion.warnings.1.value", "motion.warnings.1.limit")
    assert found["motion.warnings"] == sum(each.severity == "warning" for each in result.results["motion"].verdicts)
    assert found["motion.warnings.1.value[rad/s]"] == regime.omega_min
    assert found["motion.warnings.1.limit[rad/s]"] > regime.omega_min


@record
class Pair:
    joint: str
    lost: float = quantity("P_{joint}[W]", "power lost in {joint}")


@record
class Details:
    mass: float = quantity("m_all[kg]", "mass of all links")
    turn: float = quantity("turn[rad]", "an angle")
    roots: tuple[float, ...] = quantity("root[1/s]", "roots")
    pairs: tuple[Pair, ...] = ()
    first: Pair | None = None

    @derived("twice[kg]", "twice the mass")
    def twice(self) -> float:
        """Twice the mass."""
        return 2 * self.mass


def details(spec: Any, results: Mapping[str, Any]) -> Details:
    pairs = tuple(Pair(each.joint, 2.0 * k) for k, each in enumerate(results["forces"].pairs[:2]))
    return Details(12.5, math.pi, (-1.0, -2.0), pairs, pairs[1])


def test_details_are_facts_by_choice(scene: RunResult, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(forces_stage, "details", details, raising=False)
    found = tmmcalc.told(scene, "forces.m_all", "turn", "root.*", "forces.twice", "pairs.*", "first.*")
    assert found == {
        "forces.m_all[kg]": 12.5,
        "forces.twice[kg]": 25.0,
        "forces.turn[deg]": 180.0,
        "forces.root.0[1/s]": -1.0,
        "forces.root.1[1/s]": -2.0,
        "forces.pairs.0.P_O[W]": 0.0,
        "forces.pairs.1.P_A[W]": 2.0,
        "forces.first.P_A[W]": 2.0,
    }
    assert "forces.m_all[kg]" not in tmmcalc.told(scene)
    beyond = Scene(scene.spec, scene.results)
    assert [each.how for each in chosen("forces", [parse("m_all")], beyond) if isinstance(each, Told)] == [CHOICE]

    def never(spec: Any, results: Mapping[str, Any]) -> Details:
        raise AssertionError

    monkeypatch.setattr(forces_stage, "details", never)
    names = [each.quantity for each in offered("forces", Scene(scene.spec, scene.results))]
    assert {"m_all", "turn", "root", "pairs.{name}.P_{joint}", "first.P_{joint}", "twice"} <= {*names}


def test_records_of_details_by_word(scene: RunResult, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(forces_stage, "details", lambda spec, results: {"start": Pair("A", 3.0)}, raising=False)
    assert tmmcalc.told(scene, "forces.start.P_A") == {"forces.start.P_A[W]": 3.0}


def test_rows_without_a_value_are_left_out(scene: RunResult, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from tmmcalc.core.columns import Column

    values = np.where(np.arange(25) % 5 == 0, np.nan, np.arange(25.0))
    made = [Column("gap", "m", lambda: values, "a column with gaps")]
    monkeypatch.setattr(forces_stage, "further", lambda spec, results: made)
    monkeypatch.setattr(forces_stage, "declares", ("gap",))
    assert told(scene, "forces.max(gap)").value == 24.0
    assert told(scene, "forces.max(gap)").how == "of 20 rows"
    assert told(scene, "at_min(gap)").value == 15.0
    for asked in ("gap@5", "integral(gap)", "max(gap)@5..5"):
        with pytest.raises(UsageError, match="has no value here"):
            told(scene, f"forces.{asked}")
    assert tmmcalc.told(scene, "forces.gap@5", "forces.gap@6") == {"forces.gap@6[m]": 6.0}
    tmmcalc.run(scene.spec, target="forces", out=tmp_path, columns=["gap"])
    rows = [*csv.DictReader((tmp_path / "forces.csv").open())]
    assert [row["gap[m]"] for row in rows[4:7]] == ["4.0", "", "6.0"]


def test_every_fact_by_choice_has_a_name_of_its_own() -> None:
    run = tmmcalc.run(tmmcalc.load_spec("configs/gears-coaxial.toml"))
    scene = Scene(run.spec, run.results)
    for stage in run.results:
        names = [each.quantity for each in offered(stage, scene)]
        assert len(names) == len({*names}), stage
    sides = [run.value(f"train.conditions.conditions.ratio.{k}.right") for k in (0, 1)]
    assert sides == pytest.approx([8.15 - 0.08, 8.15 + 0.08], rel=1e-12)
    told = run.tell("train.conditions.conditions.ratio.1.left")
    assert told.meaning == "left side of Z2*Z3/(Z1*Z2') <= u_max"


def test_members_and_factors_are_named_by_what_they_belong_to() -> None:
    run = tmmcalc.run(tmmcalc.load_spec("configs/gears-coaxial.toml"))
    omega = run.tell("train.plans.lines.1.omega")
    assert omega.meaning.startswith("speed of 1;")
    assert run.value("train.plans.lines.1.n") == pytest.approx(omega.value * 30 / math.pi, rel=1e-12)
    limit, safety, allowed = (
        run.tell(f"strength.factors.wheel 2'.{symbol}.value") for symbol in ("sigma_Hlim", "S_H", "sigma_HP")
    )
    assert (limit.unit, safety.unit) == ("Pa", "")
    assert limit.meaning == "limit of contact endurance, wheel 2'"
    assert allowed.value == pytest.approx(limit.value / safety.value, rel=1e-12)
