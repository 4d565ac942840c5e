"""Columns by choice of a reduction: parts that make the whole, each by another route; Simpson's rule worked out."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from linkage.forces.worked import CASES, press, press_loading
from scipy.integrate import simpson

import tmmcalc
from machine.reduction.drawn import drawn
from tmmcalc import TmmError, UsageError, solve_kinematics
from tmmcalc.core.columns import Column
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.differentiation import differentiate
from tmmcalc.linkage.forces.further import further_columns as further_of_forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.machine.reduction.further import Linkage, further_columns
from tmmcalc.machine.reduction.jumps import nodal_jumps
from tmmcalc.machine.reduction.ordinates import ordinates
from tmmcalc.machine.reduction.solve import solve_reduction
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[3] / "configs"
KINEMATICS = json.loads((Path(__file__).parents[2] / "cases" / "kinematics.json").read_text(encoding="utf-8"))
SHAPER = next(case for case in KINEMATICS if case["id"] == "KIN-S01")


def made(columns: list[Column]) -> dict[str, np.ndarray]:
    assert len({column.name for column in columns}) == len(columns)
    return {column.name: column.make() for column in columns}


def by_choice(scene: RunResult, stage: str = "reduction") -> dict[str, np.ndarray]:
    return made(list(scene.outcomes[stage].stage.part("further")(scene.spec, scene.results)))


@pytest.fixture(scope="module")
def shaper() -> RunResult:
    return run(tmmcalc.load_spec(CONFIGS / "shaper.toml"), target=("reduction", "forces"))


def test_inertia_by_link_is_that_of_the_table_of_the_textbook(shaper: RunResult) -> None:
    """KIN-S01: omega_3 and v_D of table D.2.1 give J of the slotted link and of the ram; dJ by differences."""
    found, expected = by_choice(shaper), SHAPER["expected"]["columns"]
    turning, sliding = (np.array(expected[name]) for name in ("om3", "vD"))
    np.testing.assert_allclose(found["J_red_3"], (4.5 + 55 * 0.5**2) * turning**2, atol=2e-4)
    np.testing.assert_allclose(found["J_red_3_turning"], 4.5 * turning**2, atol=5e-5)
    np.testing.assert_allclose(found["J_red_5"], 190 * (0.2 * sliding) ** 2, atol=1e-3)
    np.testing.assert_allclose(found["dS_of_Q5"], 0.2 * sliding, atol=2e-6)


def test_the_rod_by_differences_of_positions(shaper: RunResult) -> None:
    kinematics, mechanism = shaper.results["kinematics"], to_linkage(shaper.spec.linkage)
    trace, found = differentiate(chain_of(mechanism, kinematics), kinematics.x, 1e-4), by_choice(shaper)
    turning = trace.dangle[trace.link_ids.index(4)]
    centre = trace.dr[trace.point_names.index("S4")]
    np.testing.assert_allclose(found["J_red_4_turning"], 0.1 * turning**2, atol=1e-8)
    np.testing.assert_allclose(found["J_red_4_mass"], 12 * np.abs(centre) ** 2, atol=1e-6)
    np.testing.assert_allclose(found["M_red_weight_4"], -12 * 9.81 * centre.imag, atol=1e-5)


@pytest.mark.parametrize("seed", range(24))
def test_parts_make_the_whole(seed: int) -> None:
    mechanism, loading = drawn(seed)
    try:
        kinematics = solve_kinematics(mechanism)
        result = solve_reduction(mechanism, loading, kinematics, rods="lumped" if seed % 2 else "exact")
    except TmmError:
        pytest.skip("nothing to reduce")
    found = made(further_columns(result, Linkage(mechanism, loading, kinematics)))
    letter = "J" if result.turns else "m"
    force = "M" if result.turns else "F"

    def whole(names: list[str], wanted: np.ndarray, noise: float) -> None:
        parts = sum((found[name] for name in names), np.zeros(len(result.phi)))
        np.testing.assert_allclose(parts, wanted, rtol=1e-9, atol=noise)

    links = sorted({body.link for body in loading.heavy})
    whole([f"{letter}_red_{k}" for k in links], result.inertia, 1e-12 * np.max(result.inertia))
    slopes = [f"d{letter}_red_{k}" for k in links]
    whole(slopes, result.slope, 1e-11 * max((np.max(np.abs(found[name])) for name in slopes), default=0.0))
    for k in links:
        both = found[f"{letter}_red_{k}_mass"] + found[f"{letter}_red_{k}_turning"]
        np.testing.assert_allclose(both, found[f"{letter}_red_{k}"], rtol=1e-13)
    causes = {each.name: row for each, row in zip(result.contributions, result.moment, strict=True)}
    size = max(np.max(np.abs(row)) for row in result.moment)
    if "weight" in causes:
        whole([n for n in found if n.startswith(f"{force}_red_weight_")], causes["weight"], 1e-11 * size)
    if "friction" in causes:
        whole([n for n in found if n.startswith(f"{force}_red_fr_")], causes["friction"], 1e-9 * size)
    for load in loading.loads:
        if load.factor:
            product = found[f"load_{load.name}"] * found[f"dS_of_{load.name}"]
            np.testing.assert_allclose(product, causes[load.name], rtol=1e-9, atol=1e-11 * size)


def test_friction_apart_is_that_of_the_force_analysis() -> None:
    """Of every pair -|F v| or -|M w| over the speed, with friction and speeds out of two other tables; its work too."""
    mechanism, kinematics = press()
    loading = press_loading()
    result = solve_reduction(mechanism, loading, kinematics)
    found = made(further_columns(result, Linkage(mechanism, loading, kinematics)))
    forces = solve_forces(mechanism, loading, kinematics)
    works = made(further_of_forces(mechanism, loading, kinematics, forces))
    pairs = sorted(name.removeprefix("M_red_fr_") for name in found if name.startswith("M_red_fr_"))
    assert pairs == ["A", "B", "B0"]
    rows = [forces.labels.index(label) for label in result.labels]
    for pair in pairs:
        np.testing.assert_allclose(found[f"M_red_fr_{pair}"], works[f"M_red_fr_{pair}"][rows], rtol=1e-10, atol=1e-14)
        assert np.all(found[f"M_red_fr_{pair}"] <= 1e-15)
    friction = next(each for each in result.contributions if each.kind == "friction")
    assert sum(works[f"A_fr_{pair}"][-1] for pair in pairs) == pytest.approx(friction.work, rel=1e-9)


def test_friction_of_the_ram_is_force_times_speed(shaper: RunResult) -> None:
    found, forces, kinematics = by_choice(shaper), shaper.results["forces"], shaper.results["kinematics"]
    table = shaper.table("forces")
    assert table is not None
    rubbing = np.asarray(table.columns[table.header.index("F_fr_D0[N]")], float)
    rows = [forces.labels.index(label) for label in kinematics.labels]
    speed = 0.2 * np.array(SHAPER["expected"]["columns"]["vD"])  # per unit of the crank's
    np.testing.assert_allclose(found["M_red_fr_D0"], -np.abs(rubbing[rows] * speed), rtol=1e-4, atol=1e-3)


def test_the_cam_on_the_crank_has_its_share() -> None:
    scene = run(tmmcalc.load_spec(CONFIGS / "course-project.toml"), target="reduction")
    found, result = by_choice(scene), scene.results["reduction"]
    shares = [found[f"J_red_{name}"] for name in ("1", "2", "3", "4", "5", "cam")]
    np.testing.assert_allclose(np.sum(shares, axis=0), result.inertia, rtol=1e-11)
    slopes = [found[f"dJ_red_{name}"] for name in ("1", "2", "3", "4", "5", "cam")]
    np.testing.assert_allclose(np.sum(slopes, axis=0), result.slope, atol=1e-11 * np.max(np.abs(result.slope)))


class TestSimpson:
    """Against scipy, and the work of the cutting force of the textbook's shaper over its stroke."""

    def test_all_causes(self, shaper: RunResult) -> None:
        result, found = shaper.results["reduction"], by_choice(shaper)
        sums = ordinates(result)
        assert [*sums] == ["weight", "Q5", "friction", "everything"]
        step = np.radians(15)
        for cause, each in sums.items():
            ordinary = result.total if cause == "everything" else result.moment[[*sums].index(cause)]
            assert each.work == pytest.approx(simpson(ordinary, dx=step), rel=1e-13, abs=1e-12)
            assert each.weighted == pytest.approx(each.ends + 4 * each.odd + 2 * each.even, rel=1e-13, abs=1e-12)
            assert each.work == pytest.approx(each.step / 3 * each.weighted, rel=1e-13, abs=1e-12)
            assert each.work == pytest.approx(step / 3 * found[f"sum_ordinates_{cause}"][-1], rel=1e-12, abs=1e-12)
            np.testing.assert_allclose(found[f"ordinate_{cause}"], found["Simpson"] * ordinary, rtol=1e-15)
        assert sums["everything"].exact == pytest.approx(sum(c.work for c in result.contributions), rel=1e-13)

    def test_a_stroke_of_the_textbook(self, shaper: RunResult) -> None:
        """dyn-shaper-reduced: the cutting force over positions 2 to 12, where the book integrates it."""
        expected = CASES["dyn-shaper-reduced"]["expected"]
        found = ordinates(shaper.results["reduction"], range(2, 13))["Q5"]
        assert found.work == pytest.approx(expected["A_Q_simpson_2_12_J"], rel=1e-5)
        assert found.exact == pytest.approx(expected["A_Q_exact_J"], rel=1e-5)

    def test_every_second_position(self, shaper: RunResult) -> None:
        result = shaper.results["reduction"]
        rows = range(0, 25, 2)
        assert ordinates(result, rows)["friction"].work == pytest.approx(
            simpson(result.moment[2][::2], dx=np.radians(30)), rel=1e-13
        )

    @pytest.mark.parametrize("rows", [(), (3,), (0, 1), range(4), (0, 1, 3), (2, 1, 0), (0, 0, 0)])
    def test_positions_without_the_rule(self, shaper: RunResult, rows: Any) -> None:
        with pytest.raises(UsageError, match="Simpson's rule takes"):
            ordinates(shaper.results["reduction"], rows)


def test_nothing_is_solved_before_a_column_is_made(shaper: RunResult, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tmmcalc.machine.reduction.further.compile_scene", None)
    assert len(shaper.outcomes["reduction"].stage.part("further")(shaper.spec, shaper.results)) > 20


def test_what_is_left_of_moments_that_cancel_does_not_jump(shaper: RunResult) -> None:
    """The load of the shaper jumps; what rounding leaves of moments as large that cancel is no jump."""
    found = shaper.results["reduction"]
    assert nodal_jumps(found, 0.0)
    left = 1e-15 * np.max(np.abs(found.parts)) * np.random.default_rng(1).standard_normal(found.cycle.moment.shape)
    still = np.zeros_like(found.cycle.moment)
    cycle = replace(found.cycle, moment=left, viscous=still, quadratic=still)
    assert nodal_jumps(replace(found, cycle=cycle, total=np.zeros_like(found.total)), 0.0) == []
