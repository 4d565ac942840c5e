"""Every extreme scene on the command line: exit code, one named error without a traceback, finite numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from cli.conftest import Cli
from sparing import sparing

from tmmcalc.project import templates
from tmmcalc.stress.expected import expected

from .scenes import FOLDER, LONG, MARKED, NAMES, files_not_finite, solved


@sparing("name", NAMES, every=4)
def test_scenes_are_ready_specs_that_tell_what_is_extreme(name: str) -> None:
    assert f"extreme/{name}" in templates.names()
    assert templates.description(f"extreme/{name}").startswith("Extreme: ")
    assert "# Expected: " in templates.text(f"extreme/{name}")


@sparing("name", MARKED, every=6)
def test_scene_on_the_command_line(cli: Cli, empty: Path, name: str) -> None:
    wanted = expected((FOLDER / f"{name}.toml").read_text(encoding="utf-8"))
    target = ("--to", wanted.target) if wanted.target else ()
    tables = ("--no-csv",) if name in LONG else ("--csv",)
    answer = cli("run", str(FOLDER / f"{name}.toml"), "-o", "out", *tables, *target)
    code = wanted.code
    assert answer.code == code, answer.err
    assert wanted.words in " ".join(answer.err.split())
    assert "Traceback" not in answer.out + answer.err
    words = set((answer.out + answer.err).lower().replace("=", " ").split())
    assert not words & {"nan", "inf", "-inf", "+inf"}
    written = sorted(file.suffix for file in (empty / "out").iterdir()) if (empty / "out").exists() else []
    assert code or {".toml", ".npz"} & set(written)
    assert not written or not files_not_finite(empty / "out")


BEYOND = [  # scene, overrides, exit code, words of the error
    ("self-locking", ["mechanism.joints[name=B0].friction=0.7501"], 3, "self-locking at position 6"),
    ("slip", ["motor.speed='1500 rpm'"], 2, "motor.speed"),
    ("slip", ["motor.speed='1500.01 rpm'"], 2, "motor.speed"),
    ("delta-tiny", ["flywheel.delta=0"], 2, "flywheel.delta"),
    ("delta-half", ["flywheel.delta=1"], 2, "flywheel.delta"),
    ("delta-half", ["flywheel.delta=nan"], 2, "flywheel.delta"),
    ("massless", ["mechanism.links[id=3].mass=-1e-300"], 2, "mechanism.links[2].mass"),
    ("massless", ["loads[name=Q].force=inf"], 2, "loads[0].force"),
    ("shaft-stiffness", ["shafts[name=shaft].stiffness=-1"], 2, "shafts[0].stiffness"),
    ("dead-point", ["mechanism.links[id=1].points.A=[0.2000001, 0]"], 3, "cannot make a full turn"),
    ("dead-point", ["mechanism.links[id=1].points.A=[0, 0]"], 2, "the link has no length"),
    ("inertia-ratio", ["mechanism.input.speed=0"], 2, "mechanism.input.speed"),
    ("rotor-ratio", ["rotor.planes=[0.5, 0.5]"], 2, "rotor.planes"),
]


@pytest.mark.parametrize(("name", "overrides", "code", "said"), BEYOND)
def test_beyond_the_edge(cli: Cli, empty: Path, name: str, overrides: list[str], code: int, said: str) -> None:
    flags = [part for override in overrides for part in ("--set", override)]
    answer = cli("run", str(FOLDER / f"{name}.toml"), "-o", "out", "-q", *flags)
    assert answer.code == code, answer
    assert said in answer.err
    assert "Traceback" not in answer.err
    if code == 2:
        assert answer.out == ""
        assert not (empty / "out").exists()


SWEEP = [float(value) for value in np.geomspace(1e-9, 1e9, 7)]
PARAMETERS = [
    ("delta-half", "loads[name=Q].force={}"),
    ("delta-half", "mechanism.links[id=2].mass={}"),
    ("delta-half", "mechanism.links[id=2].inertia={}"),
    ("delta-half", "mechanism.input.speed={}"),
    ("delta-half", "mechanism.gravity={}"),
    ("mass-ratio", "mechanism.links[id=3].mass={}"),
]


@sparing(("name", "override"), PARAMETERS, every=3)
def test_sweep_leaves_numbers_only(name: str, override: str) -> None:
    """Eighteen orders of one quantity through all stages up to the flywheel: `solved` looks at every table."""
    for value in SWEEP:
        solved(name, override.format(repr(value)), target="balance")
        if "flywheel" in (FOLDER / f"{name}.toml").read_text(encoding="utf-8"):
            solved(name, override.format(repr(value)), target="flywheel")
