"""Variants solved one by one: the numbers are those of the stages, and what fails says why."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from sparing import sparing

import tmmcalc
from tmmcalc.batch.points import solve_points
from tmmcalc.batch.quantities import told as told_of
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.task import Row
from tmmcalc.naming.choice import chosen_facts
from tmmcalc.naming.scene import Scene
from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import Variants, read_text

ROOT = Path(__file__).parents[2]
SHAPER = ROOT / "configs" / "shaper.toml"
FEW = "mechanism.grid.positions=12"
CRANK = "mechanism.links[id=1].points.A[0]"


def rows(spec: Path, *sets: str, to: tuple[str, ...] = (), columns: tuple[str, ...] = ()) -> list[dict[str, object]]:
    task = task_of(spec, sets, None, to, columns)
    return [told(row) for row in solve_points(task, range(task.count))]


def told(row: Row) -> dict[str, object]:
    return {"status": row.status, "reason": row.reason, **dict(zip(row.names, row.values, strict=True))}


def test_the_stroke_of_the_shaper() -> None:
    """S = 2 l_BC l_OA / l_OB, the horizontal distance of the dead centres of C."""
    found = rows(SHAPER, FEW, f"{CRANK}=0.15:0.25:5", columns=("kinematics.stroke_D",))
    assert [row["kinematics.stroke_D[m]"] for row in found] == pytest.approx(
        [2 * 1.02 * a / 0.62 for a in (0.15, 0.175, 0.2, 0.225, 0.25)], rel=1e-12
    )


def test_quantities_are_those_of_the_stages() -> None:
    found = rows(SHAPER, FEW, "mechanism.links[id=5].mass=150,190", columns=("forces.max(R_A)", "motion.delta"))
    for mass, row in zip((150, 190), found, strict=True):
        spec = tmmcalc.load_spec(SHAPER, [FEW, f"mechanism.links[id=5].mass={mass}"])
        table = tmmcalc.run(spec, target="forces").table("forces")
        column = table.columns[table.header.index("R_A[N]")]
        assert row["status"] == "ok"
        assert row["forces.max(R_A)[N]"] == column.max()
        assert row["motion.delta"] == tmmcalc.solve_motion(spec).regime.delta


@sparing("name", ["shaper", "press", "class-four", "piston-pump", "extreme/delta-tiny", "reduced-machine"], every=3)
def test_what_names_tell_is_told_of_a_run_that_leaves_the_rest_out(name: str) -> None:
    """A sweep leaves out what no name can ask for; all that names tell, by choice too, is that of a whole run."""
    spec = tmmcalc.load_spec(ROOT / "configs" / f"{name}.toml")
    whole, brief = (run(spec, target="flywheel", by_name=by_name) for by_name in (False, True))
    assert whole.results["flywheel"].history or whole.results["flywheel"].required is None
    assert not brief.results["flywheel"].history
    found = [
        [
            [*told_of(each.results, []), *(offer for stage in each.results for offer in chosen_facts(stage, scene))]
            for scene in [Scene(each.spec, each.results)]
        ]
        for each in (whole, brief)
    ]
    assert repr(found[0]) == repr(found[1])


@sparing(
    ("of", "truth"),
    [
        ("max", lambda c: c.max()),
        ("min", lambda c: c.min()),
        ("range", lambda c: c.max() - c.min()),
        ("mean", lambda c: math.fsum(c) / len(c)),
        ("size", lambda c: abs(c).max()),
        ("first", lambda c: c[0]),
        ("last", lambda c: c[-1]),
    ],
    every=3,
)
def test_what_is_asked_of_a_column(of: str, truth) -> None:
    (row, _) = rows(SHAPER, FEW, "motion.inertia=40,50", columns=(f"kinematics.{of}(vS_D)",))
    table = tmmcalc.run(tmmcalc.load_spec(SHAPER, [FEW]), target="kinematics").table("kinematics")
    column = table.columns[table.header.index("vS_D[m/s]")]
    assert row[f"kinematics.{of}(vS_D)[m/s]"] == pytest.approx(float(truth(column)), rel=1e-14)


@pytest.mark.slow
def test_all_facts_of_the_targets_or_of_all_stages() -> None:
    (row, _) = rows(SHAPER, FEW, "motion.inertia=40,50", to=("kinematics", "power"))
    assert {name.partition(".")[0] for name in row} - {"status", "reason"} == {"kinematics", "power"}
    (row, _) = rows(SHAPER, FEW, "motion.inertia=40,50")
    ran = tmmcalc.run(tmmcalc.load_spec(SHAPER, [FEW])).plan.running
    assert {name.partition(".")[0] for name in row} - {"status", "reason"} == set(ran)


def test_points_that_fail_say_why() -> None:
    found = rows(SHAPER, FEW, "mechanism.links[id=4].points.D[0]=-0.29,0,0.029,0.29", to=("kinematics",))
    assert [row["status"] for row in found] == ["ok", "failed 2", "failed 3", "ok"]
    assert "the link has no length" in str(found[1]["reason"])
    assert str(found[2]["reason"]).startswith("kinematics, group RRP(4,5): the crank cannot make a full turn")
    assert "\n" not in str(found[2]["reason"])
    assert set(found[2]) == {"status", "reason"}


def test_what_stages_before_a_failure_tell_is_kept() -> None:
    (weak, strong) = rows(
        SHAPER, FEW, "loads[name=Q5].force=75000000,7500", columns=("kinematics.stroke_D", "motion.delta")
    )
    assert (weak["status"], strong["status"]) == ("failed 3", "ok")
    assert weak["kinematics.stroke_D[m]"] == strong["kinematics.stroke_D[m]"]
    assert "motion.delta" not in weak


def test_a_target_that_a_variant_leaves_out_fails_there(tmp_path: Path) -> None:
    spec = tmp_path / "t.toml"
    spec.write_text('[torque]\nspeed = "20 rad/s"\nformula = "100*sin(theta)"\n[flywheel]\ninertia = 5\n')
    (none, some) = rows(spec, "flywheel.inertia=0,5", to=("motion",))
    assert (none["status"], some["status"]) == ("failed 2", "ok")
    assert none["reason"] == "motion: no masses and no constant inertia: nothing stores kinetic energy"


def test_a_fault_of_the_program_ends_one_point_only(monkeypatch: pytest.MonkeyPatch) -> None:
    import tmmcalc.batch.points as points

    def broken(*given: object, **more: object) -> None:
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(points, "run", broken)
    (row, _) = rows(SHAPER, "motion.inertia=40,50")
    assert (row["status"], row["reason"]) == ("failed 1", "a fault of the program: ZeroDivisionError: by zero")


def test_a_variant_is_the_spec_with_its_overrides() -> None:
    """The text is read once, and no variant leaves a trace in the next."""
    variants = Variants(read_text(SHAPER), str(SHAPER), SHAPER.parent, [FEW])
    for overrides in ([f"{CRANK}=0.15", "motor.start=2"], [], [f'{CRANK}="150 mm"'], ["mechanism.links[id=3].mass=1"]):
        assert variants.spec(overrides) == tmmcalc.load_spec(SHAPER, [FEW, *overrides])


def test_variants_of_a_spec_with_files() -> None:
    config = ROOT / "configs" / "cam-own-law.toml"
    variants = Variants(read_text(config), str(config), config.parent)
    for _ in range(2):
        assert variants.spec(["cam.speed=3"]) == tmmcalc.load_spec(config, ["cam.speed=3"])
