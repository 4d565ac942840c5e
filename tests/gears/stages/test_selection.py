"""Selected columns and stages: only they are written, and only they are held in memory."""

from __future__ import annotations

import subprocess
import sys
import tracemalloc
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.core.plan import plan
from tmmcalc.linkage.stages.kinematics import EXTRA
from tmmcalc.linkage.wanted import NO_CSV
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.pipeline.store import CSV_ROWS
from tmmcalc.pipeline.why import explain
from tmmcalc.project import Spec, load_spec, templates

CONFIGS = templates.folder()
LONG = 6_000


def shaper(positions: int, *more: str) -> Spec:
    return load_spec(CONFIGS / "shaper.toml", (f"mechanism.grid.positions={positions}", *more))


def kinds(result: RunResult) -> set[str]:
    return {event.kind for event in result.events if event.kind != "left out"}


def header(file: Path) -> list[str]:
    return file.read_text(encoding="utf-8").partition("\n")[0].split(",")


def test_csv_files_have_the_columns_asked_for_and_npz_files_all(tmp_path: Path) -> None:
    spec = shaper(24)
    whole = run(spec, out=tmp_path / "whole")
    chosen = run(spec, out=tmp_path / "chosen", columns=["phi", "M_*", "x_C[m]"])
    assert header(tmp_path / "chosen" / "kinematics.csv") == ["i", "phi[deg]", "x_C[m]"]
    assert header(tmp_path / "chosen" / "motion.csv") == ["i", "phi[deg]", "M_d[N*m]", "M_load[N*m]"]
    for stage in whole.outcomes:
        for name, array in whole.record(stage).arrays.items():
            np.testing.assert_array_equal(chosen.record(stage).arrays[name], array)
    full = (tmp_path / "whole" / "motion.csv").read_text().splitlines()
    kept = [
        header(tmp_path / "whole" / "motion.csv").index(name) for name in header(tmp_path / "chosen" / "motion.csv")
    ]
    cut = [",".join(line.split(",")[k] for k in kept) for line in full]
    assert (tmp_path / "chosen" / "motion.csv").read_text().splitlines() == cut


def test_other_columns_are_written_without_computing(tmp_path: Path) -> None:
    spec = shaper(24)
    assert kinds(run(spec, target="forces", out=tmp_path, columns=["R_A"])) == {"computed"}
    assert not (tmp_path / "kinematics.csv").exists()  # it has none of them
    assert header(tmp_path / "forces.csv") == ["i", "R_A[N]"]
    stamps = {path: path.stat().st_mtime_ns for path in tmp_path.glob("*.*s*")}
    assert kinds(run(spec, target="forces", out=tmp_path, columns=["R_A"])) == {"loaded"}
    assert stamps == {path: path.stat().st_mtime_ns for path in tmp_path.glob("*.*s*")}
    assert kinds(run(spec, target="forces", out=tmp_path)) == {"loaded"}
    assert len(header(tmp_path / "forces.csv")) > 20
    assert (tmp_path / "kinematics.csv").exists()
    run(spec, target="forces", out=tmp_path, csv=False, columns=["R_A"])
    assert not list(tmp_path.glob("*.csv"))
    run(spec, target="forces", out=tmp_path, csv=True, columns=["R_A"])
    assert [path.name for path in tmp_path.glob("*.csv")] == ["forces.csv"]


def test_a_column_that_no_stage_has(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no stage has a column called 'M_driv'") as caught:
        run(shaper(24), target="forces", out=tmp_path, columns=["phi", "M_driv"])
    assert "M_drive" in str(caught.value)


@pytest.mark.slow
def test_long_tables_are_not_written_and_the_plan_says_so(tmp_path: Path) -> None:
    for positions, missing in ((CSV_ROWS - 50, False), (CSV_ROWS, True)):
        spec = shaper(positions)
        out = tmp_path / str(positions)
        result = run(spec, out=out)
        for why in explain(spec, plan(spec)):
            table = result.table(why.step.stage) if why.step.runs else None
            if table is not None:
                assert (NO_CSV in why.omits) is missing, why.step.stage
                assert (out / f"{why.step.stage}.csv").exists() is not missing


@pytest.mark.parametrize(
    ("more", "equal"),
    [((), True), (("mechanism.grid.extra=[0.1]",), False), (("mechanism.grid.extremes=true",), False)],
)
def test_equal_steps_alone(more: tuple[str, ...], equal: bool) -> None:
    spec = shaper(24, *more)
    (why,) = (why for why in explain(spec, plan(spec)) if why.step.stage == "kinematics")
    assert (EXTRA in why.omits) is equal
    assert (len(run(spec, target="kinematics").results["kinematics"].labels) == 25) is equal


def peak(spec: Spec, out: Path, columns: Sequence[str] = (), *, csv: bool | None, target: str = "kinematics") -> int:
    """Largest memory that a run allocates [bytes]."""
    run(shaper(24), target=target, out=out)  # the modules
    tracemalloc.start()
    try:
        run(spec, target=target, out=out, columns=columns, csv=csv, fresh=True)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.slow
def test_a_selected_run_takes_less_memory(tmp_path: Path) -> None:
    spec = shaper(LONG)
    arrays = run(spec, target="kinematics").record("kinematics").arrays
    held = sum(array.nbytes for array in arrays.values())
    nothing = peak(spec, tmp_path, csv=None)
    few = peak(spec, tmp_path, ["phi", "x_C"], csv=True)
    whole = peak(spec, tmp_path, csv=True)
    assert nothing < 3.5 * held  # the arrays and their bytes: no column of the table is made
    assert few < 1.3 * nothing
    assert few < whole / 3
    files = {name: (tmp_path / name).stat().st_size for name in ("kinematics.csv", "kinematics.npz")}
    run(spec, target="kinematics", out=tmp_path, columns=["phi", "x_C"], csv=True)
    assert (tmp_path / "kinematics.csv").stat().st_size < files["kinematics.csv"] / 20
    assert (tmp_path / "kinematics.npz").stat().st_size == files["kinematics.npz"]


@pytest.mark.slow
def test_a_run_to_a_stage_takes_less_memory_than_the_whole(tmp_path: Path) -> None:
    spec = shaper(LONG // 4)
    assert peak(spec, tmp_path / "a", csv=False) < 0.7 * peak(spec, tmp_path / "b", csv=False, target="motion")


RSS = """
import tmmcalc
from pathlib import Path
from tmmcalc.pipeline.runner import run
spec = tmmcalc.load_spec({file!r}, ("mechanism.grid.positions=40000",))
run(spec, target="kinematics", out=Path({out!r}), columns={columns!r}, csv=True)
lines = Path("/proc/self/status").read_text().splitlines()
print(next(line.split()[1] for line in lines if line.startswith("VmHWM")))
"""


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="no peak of a process alone is told here")
def test_a_selected_run_takes_less_memory_of_the_machine(tmp_path: Path) -> None:
    """The peak is that of the process itself: what resource tells begins with that of its parent."""

    def resident(*columns: str) -> int:
        code = RSS.format(file=str(CONFIGS / "shaper.toml"), out=str(tmp_path), columns=columns)
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        return int(done.stdout)

    assert resident("phi", "x_C") < 0.6 * resident()


def test_a_skipped_stage_is_left_out_with_all_that_read_it(tmp_path: Path) -> None:
    result = run(shaper(24, "flywheel.inertia=0"), out=tmp_path, skip=["flywheel", "balance"])
    reasons = {step.stage: step.reason for step in result.plan.steps if not step.runs}
    assert reasons["flywheel"] == reasons["balance"] == "left out by --skip"
    assert reasons["motion"] == "reads flywheel, which --skip leaves out"  # without it the motion would be another one
    assert {path.stem for path in tmp_path.glob("*.toml")} == set(result.plan.running)
    assert "motion" not in result.plan.running
    assert "power" in result.plan.running


def test_a_flywheel_that_is_there_need_not_be_sized_for_a_motion() -> None:
    """The motion with the wheel of the spec is the same whether or not another one is looked for."""
    spec = shaper(24)
    assert "flywheel" not in plan(spec, "motion").running
    alone, beside = run(spec, target="motion"), run(spec, skip=["balance"])
    assert "flywheel" in beside.plan.running
    assert alone.results["motion"].inertia.flywheel == 186
    assert np.array_equal(alone.results["motion"].omega, beside.results["motion"].omega)
    assert "flywheel" in plan(shaper(24, "flywheel.inertia=0"), "motion").running
    (why,) = (why for why in explain(spec, plan(spec)) if why.step.stage == "motion")
    assert "the result of flywheel is not read: the spec gives it" in why.omits


def test_a_skipped_stage_is_known() -> None:
    with pytest.raises(UsageError, match="did you mean flywheel"):
        plan(shaper(24), skip=["flywhel"])
    with pytest.raises(UsageError, match="left out by --skip"):
        run(shaper(24), target="forces", skip=["forces"])
    with pytest.raises(UsageError, match="reads kinematics, which --skip leaves out"):
        run(shaper(24), target="forces", skip=["kinematics"])
