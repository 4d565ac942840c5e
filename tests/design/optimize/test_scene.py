"""`tmmcalc optimize` on specs: the same at any number of jobs, after a kill, and by the ordinary stages."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tmmcalc.batch.sweep import part
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.design.optimize.scene import Optimum, optimize

CONFIGS = Path(__file__).parents[3] / "configs"
CRANK, COUPLER = "mechanism.links[id=1].points.A[0]", "mechanism.links[id=2].points.B[0]"


def spec(folder: Path, asked: str) -> Path:
    """The four-bar linkage, crank 100 mm, coupler 600 mm, with what is asked of it."""
    file = folder / "four.toml"
    file.write_text((CONFIGS / "four-bar.toml").read_text() + asked)
    return file


SWIFTEST = f"""
[optimize]
least = "kinematics.size(omega_3)"
evaluations = 100
variables = [
    {{ of = "{CRANK}", at_least = "50 mm", at_most = "200 mm" }},
    {{ of = "{COUPLER}", at_least = "0.4 m", at_most = "900 mm" }},
]

[[constraints]]
name = "swing"
value = "kinematics.range(angle_3)"
at_least = "42 deg"
"""


def plain(result: Optimum) -> Optimum:
    return replace(result, resumed=0)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Optimum:
    """The swiftest linkage, found in one go by one process."""
    return optimize(spec(tmp_path_factory.mktemp("whole"), SWIFTEST))


def test_a_constraint_binds_and_the_optimum_is_that_of_a_grid(whole: Optimum, tmp_path: Path) -> None:
    from tmmcalc.batch.reading import frame_of
    from tmmcalc.design.model import Model

    file, result = spec(tmp_path, SWIFTEST), whole
    (design,) = result.designs
    assert design.again < 1e-12
    assert [each.name for each in result.binding] == ["swing"]
    model = Model(frame_of(file, (), [CRANK, COUPLER], ["kinematics.size(omega_3)", "kinematics.range(angle_3)"]))
    crank, coupler = np.meshgrid(np.linspace(100, 115, 31), np.linspace(560, 680, 31))
    places = np.column_stack((crank.ravel(), coupler.ravel()))
    found = model.over([0, 1], places.min(axis=0), places.max(axis=0))(places).values
    swing, speed = ([name.split(".")[1][:6] for name in model.names].index(part) for part in ("range(", "size(o"))
    kept = found[found[:, swing] >= 42 - 1e-9, speed]
    assert design.objectives[0] <= kept.min()
    assert design.objectives[0] == pytest.approx(kept.min(), rel=5e-3)
    assert result.second is not None
    assert result.second.best[0] == pytest.approx(design.objectives[0], rel=1e-6)
    assert result.second.hits[0] > result.second.starts / 2  # one that begins far away ends at the longest coupler


@pytest.mark.slow
def test_several_processes_find_the_same_to_the_last_digit(whole: Optimum, tmp_path: Path) -> None:
    assert optimize(spec(tmp_path, SWIFTEST), jobs=2) == whole


@pytest.mark.slow
def test_a_run_that_was_killed_goes_on_and_ends_as_one_that_was_not(whole: Optimum, tmp_path: Path) -> None:
    file, out = spec(tmp_path, SWIFTEST), tmp_path / "best.toml"
    command = [sys.executable, "-m", "tmmcalc", "optimize", str(file), "--spec", str(out), "-q"]
    run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    journal, until = part(out), time.monotonic() + 60
    while (not journal.exists() or journal.stat().st_size < 20_000) and time.monotonic() < until:
        time.sleep(0.02)
    os.kill(run.pid, signal.SIGKILL)
    run.wait()
    assert not out.exists()
    with journal.open("ab") as end:
        end.write(b"deadbeef [1, torn")
    again = optimize(file, out=out)
    assert again.resumed > 50
    assert plain(again) == whole
    assert not journal.exists()


@pytest.mark.slow
def test_what_is_solved_is_kept_until_the_result_was_used(tmp_path: Path) -> None:
    file, out = spec(tmp_path, SWIFTEST), tmp_path / "best.toml"

    def fails(result: Optimum) -> None:
        raise OSError("no room is left")

    with pytest.raises(OSError, match="no room"):
        optimize(file, out=out, use=fails)
    used: list[Optimum] = []
    again = optimize(file, out=out, use=used.append)
    assert again.resumed == again.solved > 50
    assert used == [again]
    assert not part(out).exists()


def test_a_catalogue_and_whole_numbers_are_solved_completely(tmp_path: Path) -> None:
    asked = f"""
[optimize]
least = "kinematics.size(omega_3)"
variables = [
    {{ of = "{CRANK}", among = ["0.12 m", "100 mm", "110 mm"] }},
    {{ of = "{COUPLER}", at_least = "580 mm", at_most = "625 mm", step = "15 mm" }},
    {{ of = "mechanism.grid.positions", at_least = 12, at_most = 13 }},
]
[[constraints]]
name = "swing"
value = "kinematics.range(angle_3)"
at_least = "42 deg"
"""
    result = optimize(spec(tmp_path, asked))
    assert result.complete
    assert result.solved == 3 * 4 * 2
    assert result.variables[0].among == (100.0, 110.0, 120.0)
    assert result.variables[2].among == (12.0, 13.0)
    assert result.designs[0].values[0] == 110.0


def test_limits_within_which_no_linkage_assembles(tmp_path: Path) -> None:
    asked = f"""
[optimize]
least = "kinematics.size(omega_3)"
evaluations = 100
variables = [{{ of = "{CRANK}", at_least = "800 mm", at_most = "900 mm" }}]
"""
    with pytest.raises(NoSolutionError, match=r"none of .* designs has a solution; most often, .* times: kinematics"):
        optimize(spec(tmp_path, asked))


def test_a_result_that_no_variable_changes(tmp_path: Path) -> None:
    asked = f"""
[optimize]
least = "structure.mobility"
evaluations = 100
variables = [{{ of = "{CRANK}", at_least = "90 mm", at_most = "100 mm" }}]
"""
    with pytest.raises(NoSolutionError, match="is the same of all"):
        optimize(spec(tmp_path, asked))


def test_nothing_is_sought(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="nothing is sought"):
        optimize(spec(tmp_path, ""))
