"""The stages of vibration through the pipeline: stored and loaded, resonance and critical speed told, no scipy."""

from __future__ import annotations

from pathlib import Path

import pytest
from sparing import sparing
from stages.test_laziness import imported, within
from storing import assert_stored_as_found

import tmmcalc
from tmmcalc import run
from tmmcalc.core.plan import plan
from tmmcalc.project.templates import folder

CONFIGS = Path(folder())
SHORT = ("vibrator.start.duration='0.2 s'", "vibrator.drive.duration='0.05 s'")


def spec(name: str, *overrides: str) -> tmmcalc.Spec:
    return tmmcalc.load_spec(CONFIGS / f"{name}.toml", overrides)


@sparing(
    ("name", "stage", "overrides"),
    [("vibratory-device", "vibrator", SHORT), ("pendulum-rotor", "pendulum", ())],
    every=2,
    first=1,
)
def test_what_is_stored_is_what_was_found(name: str, stage: str, overrides: tuple[str, ...], tmp_path: Path) -> None:
    assert_stored_as_found(spec(name, *overrides), stage, tmp_path)


def test_each_stage_runs_alone() -> None:
    assert list(plan(spec("vibratory-device")).running) == ["vibrator"]
    assert list(plan(spec("pendulum-rotor")).running) == ["pendulum"]


@pytest.mark.slow
def test_at_resonance_and_near_a_critical_speed_it_is_told() -> None:
    found = run(spec("vibratory-device", *SHORT)).results["vibrator"]
    assert any("works at resonance" in note for note in found.notes)
    found = run(spec("pendulum-rotor", "pendulum.spin='2880 rpm'")).results["pendulum"]
    assert any("of the critical speed" in note for note in found.notes)


def test_large_turns_are_told() -> None:
    found = run(spec("pendulum-rotor", "pendulum.swing.tilt='20 deg'")).results["pendulum"]
    assert any("equations of small slopes" in note for note in found.notes)
    heavy = ("vibrator.unbalance.moment='1500 g*mm'", "vibrator.speed='2590 rpm'")
    shaken = run(spec("vibratory-device", *SHORT, *heavy)).results["vibrator"]
    assert any("equations of small turns" in note for note in shaken.notes)


@pytest.mark.slow
def test_frequencies_take_no_scipy() -> None:
    """Only the start by a motor integrates."""
    assert not within(imported("pendulum-rotor.toml"), "scipy", "reportlab", "tmmcalc.linkage.forces", "tmmcalc.gears")
    assert within(imported("vibratory-device.toml", None, SHORT), "scipy.integrate")
