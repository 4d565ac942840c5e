"""Every error that a stage tells is documented, and some test holds it against the truth over random scenes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tmmcalc import load_spec
from tmmcalc.core.errors import TmmError
from tmmcalc.pipeline.runner import run
from tmmcalc.rooms import STAGES

TESTS = Path(__file__).parents[1]
ROOT = TESTS.parent
HELD = {
    "synthesis": "linkage/synthesis/test_errors.py",
    "dyad": "linkage/test_dyad.py",
    "kinematics": "linkage/test_errors.py linkage/loops/test_estimate.py",
    "paths": "linkage/test_paths.py",
    "forces": "linkage/forces/test_estimate.py",
    "reduction": "machine/reduction/test_estimate.py",
    "train": "gears/test_rounding.py",
    "gearing": "gears/network/test_rounding.py",
    "strength": "gears/test_rounding.py",
    "criteria": "gears/test_rounding.py",
    "pair": "gears/meshing/test_rounding.py",
    "open_pair": "gears/test_open_pair_estimate.py",
    "wheel": "gears/single/test_wheel.py",
    "blocking": "gears/involute/contour/test_rounding.py",
    "profile": "gears/meshing/test_outline_error.py",
    "power": "machine/test_power_estimate.py",
    "flywheel": "machine/flywheel/test_estimates.py",
    "motion": "machine/test_estimates.py",
    "transient": "machine/transient/test_estimates.py",
    "unsteady": "linkage/unsteady/test_estimate.py",
    "manipulator": "manipulators/test_rounding.py",
    "balance": "machine/balance/test_linkage_estimate.py machine/balance/test_estimates.py",
    "cam_law": "cams/test_rounding_law.py",
    "cam_synthesis": "cams/test_rounding_sizes.py",
    "cam_load": "cams/test_rounding_shaft.py",
    "cam_profile": "cams/test_rounding_profile.py",
    "cam_pressure": "cams/test_rounding_pressure.py",
    "cam_forces": "cams/test_rounding_forces.py",
    "cam_strength": "cams/test_rounding_strength.py",
    "cam_optimum": "cams/test_rounding_optimum.py",
    "cam_elastic": "cams/test_rounding_elastic.py",
    "indexing": "cams/test_rounding_indexing.py",
    "vibrator": "vibration/test_device_errors.py vibration/test_frequency_errors.py",
    "pendulum": "vibration/test_pendulum_errors.py",
    "contact": "extras/test_rounding.py",
    "reliability": "extras/test_rounding.py",
    "tie_down": "extras/test_rounding.py",
    "falling_ball": "extras/test_ball_errors.py",
    "bearing": "extras/test_rounding.py",
    "liner": "extras/test_liner.py",
    "transloader": "extras/test_transloader.py",
    "feasibility": "feasibility/test_rows.py",
}
EXACT = {"drive", "structure"}  # whole numbers and names, a ratio of given speeds


def documented() -> dict[str, set[str]]:
    """Words in backticks of docs/files.md by stage: of the rows of its tables, and of sentences that name it."""
    found: dict[str, set[str]] = {name: set() for name in STAGES}
    text = (ROOT / "docs" / "files.md").read_text()
    stage = ""
    for line in text.splitlines():
        row = re.match(r"\| (?:`(\w+)`)? ?\|", line)
        if row is not None:
            stage = row[1] or stage
            found.setdefault(stage, set()).update(re.findall(r"`(\w+)`", line))
    for part in re.split(r"[;.]\s", re.sub(r"\n(?!\n)", " ", text)):
        words = set(re.findall(r"`(\w+)`", part))
        for name in words & set(STAGES):
            found[name] |= words
    return found


def test_every_stage_has_a_test_of_its_estimates() -> None:
    assert set(HELD) | EXACT == set(STAGES)
    missing = [file for files in HELD.values() for file in files.split() if not (TESTS / file).is_file()]
    assert not missing


@pytest.mark.slow
def test_every_estimate_of_the_ready_specs_is_told_and_documented() -> None:
    words = documented()
    silent, unknown = set(), set()
    for file in sorted((ROOT / "configs").glob("*.toml")):
        try:
            results = run(load_spec(file), keep_going=True).results
        except TmmError:
            continue  # a spec whose answer is an error
        for name, result in results.items():
            told = STAGES[name].dump(result).error
            if not told and name not in EXACT:
                silent.add((file.stem, name))
            unknown |= {(name, key) for key in told if key not in words.get(name, set())}
    assert not silent
    assert not unknown
