"""Load or compute: what is recomputed after which change, and that nobody can tell the difference."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tmmcalc.core.errors import AssemblyError, UsageError
from tmmcalc.pipeline import content
from tmmcalc.pipeline.outcome import Event, Watch

from . import toy
from .toy import CALLS, Spec, contents, go, shown

SPEC = Spec()
ALL = ["geometry", "path", "energy"]


def kinds(result) -> list[str]:
    return [event.kind for event in result.events]


def mtimes(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.iterdir() if path.name != "run.log"}


def test_first_run_computes_and_second_loads_without_touching(tmp_path: Path):
    first = go(SPEC, tmp_path)
    assert kinds(first) == ["computed"] * 3
    assert [event.message for event in first.events] == ["no stored result"] * 3
    before = mtimes(tmp_path)
    second = go(SPEC, tmp_path)
    assert (kinds(second), CALLS) == (["loaded"] * 3, [])
    assert mtimes(tmp_path) == before
    assert [path.name for path in second.files] == [
        "geometry.toml", "path.toml", "path.npz", "path.csv", "energy.toml", "energy.npz"
    ]  # fmt: skip
    assert second.results["energy"].total == first.results["energy"].total


@pytest.mark.parametrize(
    ("spec", "computed"),
    [
        (replace(SPEC, title="another title"), []),
        (replace(SPEC, radius=0.21), ALL),
        (replace(SPEC, positions=26), ["path", "energy"]),
        (replace(SPEC, speed=5.0), ["energy"]),
        (replace(SPEC, points=dict(reversed(SPEC.points.items()))), ALL),
        (replace(SPEC, points={**SPEC.points, "A": complex(0.1, -0.0)}), ALL),
    ],
)
def test_only_what_depends_on_the_change_is_computed(tmp_path: Path, spec: Spec, computed: list[str]):
    go(SPEC, tmp_path / "a")
    go(spec, tmp_path / "a")
    assert computed == CALLS
    go(spec, tmp_path / "b")
    assert contents(tmp_path / "a") == contents(tmp_path / "b")


def bits(result) -> list[bytes | str]:
    path, energy = result.results["path"], result.results["energy"]
    arrays = [path.phi, path.xy, energy.by_position]
    return [a.tobytes() for a in arrays] + [repr(a.strides) for a in arrays] + [energy.total.hex(), path.method]


def test_resumed_run_is_bit_identical(tmp_path: Path):
    spec = replace(SPEC, positions=997)
    unstored = go(spec)
    whole = go(spec, tmp_path / "whole")
    go(spec, tmp_path / "steps", target="geometry")
    go(spec, tmp_path / "steps", target="path")
    resumed = go(spec, tmp_path / "steps")
    assert CALLS == ["energy"]
    loaded = go(spec, tmp_path / "steps")
    assert bits(unstored) == bits(whole) == bits(resumed) == bits(loaded)
    assert contents(tmp_path / "whole") == contents(tmp_path / "steps")


def test_arrays_are_decoded_only_when_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    go(SPEC, tmp_path)
    decoded: list[int] = []
    original = content.npz_arrays
    monkeypatch.setattr(content, "npz_arrays", lambda data: decoded.append(len(data)) or original(data))
    result = go(SPEC, tmp_path)
    assert decoded == []
    assert result.results["energy"].total > 0
    assert result.results["energy"] is result.results["energy"]
    assert len(decoded) == 1


@pytest.mark.parametrize("out", [True, False])
def test_results_cannot_be_changed_in_place(tmp_path: Path, out: bool):
    for result in (go(SPEC, tmp_path if out else None), go(SPEC, tmp_path if out else None)):
        with pytest.raises(ValueError, match="read-only"):
            result.results["path"].phi[0] = 1.0


def test_fresh_computes_all_and_leaves_equal_files_alone(tmp_path: Path):
    go(SPEC, tmp_path)
    before = mtimes(tmp_path)
    assert kinds(go(SPEC, tmp_path, fresh=True)) == ["computed"] * 3
    assert mtimes(tmp_path) == before


def test_from_stage_forces_it_and_the_rest(tmp_path: Path):
    go(SPEC, tmp_path)
    result = go(SPEC, tmp_path, from_stage="path")
    assert kinds(result) == ["loaded", "computed", "computed"]
    assert result.events[1].message == "forced from path"
    assert CALLS == ["path", "energy"]


def test_damaged_file_is_told_and_computed_again(tmp_path: Path):
    go(SPEC, tmp_path)
    whole = contents(tmp_path)
    with (tmp_path / "path.npz").open("r+b") as file:
        file.truncate(100)
    result = go(SPEC, tmp_path)
    assert shown(result) == [
        ("geometry", "loaded"), ("path", "damaged"), ("path", "computed"), ("energy", "loaded")
    ]  # fmt: skip
    assert f"{tmp_path / 'path.npz'}: has 100 bytes, expected {len(whole['path.npz'])}" in result.events[1].message
    assert contents(tmp_path) == whole


def test_edited_scalar_never_reaches_a_later_stage(tmp_path: Path):
    expected = go(SPEC, tmp_path).results["energy"].total
    path = tmp_path / "geometry.toml"
    path.write_text(path.read_text().replace("radius = 0.2", "radius = 0.3"))
    result = go(SPEC, tmp_path, from_stage="path")
    assert result.results["energy"].total == expected
    assert shown(result)[0] == ("geometry", "damaged")


def test_failing_stage_leaves_earlier_files_valid_and_writes_nothing(tmp_path: Path):
    go(SPEC, tmp_path)
    before = contents(tmp_path)
    events: list[Event] = []
    with pytest.raises(AssemblyError):
        go(replace(SPEC, radius=0.3, broken=True), tmp_path, watch=Watch(event=events.append))
    assert [(event.stage, event.kind) for event in events] == [("geometry", "computed")]
    after = contents(tmp_path)
    assert {name for name in after if after[name] != before.get(name)} == {"geometry.toml"}
    assert shown(go(replace(SPEC, radius=0.3), tmp_path))[0] == ("geometry", "loaded")


def test_a_run_that_keeps_going_leaves_out_what_reads_the_failed_stage(tmp_path: Path):
    go(SPEC, tmp_path)
    result = go(replace(SPEC, broken=True), tmp_path, keep_going=True)
    assert [(event.stage, event.kind) for event in result.events if event.stage != "spare"] == [
        ("geometry", "loaded"),
        ("path", "failed"),
        ("energy", "lost"),
    ]
    assert Event("energy", "lost", "it reads path") in result.events
    assert isinstance(result.failures["path"], AssemblyError)
    assert not {"path", "energy"} & set(result.results)
    assert not [file for file in result.files if file.stem in ("path", "energy")]


def test_left_out_stage_is_told_with_its_reason(tmp_path: Path):
    result = go(replace(SPEC, speed=None), tmp_path)
    assert result.events[-1] == Event("energy", "left out", "no [motor]: speed is constant")
    assert list(result.results) == ["geometry", "path"]
    assert "energy" not in result.results
    assert go(SPEC, target="path").events[-1].stage == "path"


def test_target_that_the_scene_leaves_out_is_refused_before_anything_is_written(tmp_path: Path):
    with pytest.raises(UsageError, match=r"energy: no \[motor\]: speed is constant"):
        go(replace(SPEC, speed=None), tmp_path / "out", target="energy")
    assert not (tmp_path / "out").exists()
    assert CALLS == []


def test_stages_that_do_not_run_are_not_imported():
    result = go(SPEC, target="energy", stages=toy.STAGES)  # `spare` names a module that does not exist
    assert result.plan.running == ("geometry", "path", "energy")


def test_settings_are_options_with_defaults(tmp_path: Path):
    assert go(SPEC, tmp_path).results["path"].method == "closed"
    result = go(SPEC, tmp_path, settings={"path": {"method": "newton"}})
    assert result.results["path"].method == "newton"
    assert shown(result) == [("geometry", "loaded"), ("path", "computed"), ("energy", "computed")]
    assert [event.message for event in result.events[1:]] == ["settings changed", "path changed"]


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"settings": {"path": {"methd": 1}}}, "path: has no option 'methd'\n  -> options: method"),
        ({"settings": {"geometry": {"x": 1}}}, "options: none"),
        ({"settings": {"pth": {}}}, "no stage is called 'pth'"),
        ({"from_stage": "enrgy"}, "did you mean energy"),
        ({"target": "nothing at all"}, "stages: geometry, path, energy"),
    ],
)
def test_wrong_names_are_refused(wrong: dict, message: str):
    with pytest.raises(UsageError, match=re.escape(message)):
        go(SPEC, **wrong)


def test_csv_follows_the_flag_without_computing(tmp_path: Path):
    go(SPEC, tmp_path / "auto")
    go(SPEC, tmp_path / "off", csv=False)
    go(SPEC, tmp_path / "x")
    for csv, like in ((False, "off"), (None, "auto"), (False, "off"), (True, "auto")):
        assert kinds(go(SPEC, tmp_path / "x", csv=csv)) == ["loaded"] * 3
        assert contents(tmp_path / "x") == contents(tmp_path / like)


def test_deleted_csv_comes_back_without_computing(tmp_path: Path):
    go(SPEC, tmp_path)
    whole = contents(tmp_path)
    (tmp_path / "path.csv").unlink()
    assert kinds(go(SPEC, tmp_path)) == ["loaded"] * 3
    assert contents(tmp_path) == whole


def test_foreign_csv_under_the_name_of_a_stage_is_removed(tmp_path: Path):
    go(SPEC, tmp_path, csv=False)
    (tmp_path / "path.csv").write_text("old numbers\n")
    go(SPEC, tmp_path, csv=False)
    assert not (tmp_path / "path.csv").exists()


def test_run_times_go_to_the_log_alone(tmp_path: Path):
    go(SPEC, tmp_path)
    go(SPEC, tmp_path)
    lines = (tmp_path / "run.log").read_text().splitlines()
    stamp = r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d[+-]\d{4}"
    assert [re.sub(f"^{stamp} (.*) [0-9.]+ s: .*$", r"\1", line) for line in lines] == [
        f"{stage} {kind}" for kind in ("computed", "loaded") for stage in ALL
    ]


def test_events_come_as_soon_as_a_stage_is_done():
    seen: list[tuple[str, int]] = []
    result = go(SPEC, watch=Watch(event=lambda event: seen.append((event.stage, len(CALLS)))))
    assert seen == [("geometry", 1), ("path", 2), ("energy", 3)]
    assert all(event.seconds > 0 for event in result.events)


def test_record_and_table_of_a_stage(tmp_path: Path):
    for result in (go(SPEC), go(SPEC, tmp_path), go(SPEC, tmp_path)):
        table = result.table("path")
        assert table is not None
        assert table.header[0] == "phi[deg]"
        assert table.rows == 25
        assert result.record("path").error == {"position": 1e-16}
        assert result.table("energy") is None
        np.testing.assert_array_equal(result.record("path").arrays["phi"], result.results["path"].phi)


def test_out_that_cannot_be_is_refused_before_computing(tmp_path: Path):
    (tmp_path / "file").touch()
    with pytest.raises(UsageError, match="is a file, not a folder"):
        go(SPEC, tmp_path / "file" / "out")
    assert CALLS == []


LIGHT = """
import sys
from tmmcalc.core.stage import Stage
from tmmcalc.core.stored import Record
import tmmcalc.pipeline.runner as runner
def solve(value):
    return value
def dump(result):
    return Record({"x": result})
def load(record):
    return record.scalars["x"]
inputs = solve
stage = Stage("one", "one", "__main__")
assert runner.run(1.5, stages={"one": stage}).results["one"] == 1.5
heavy = "numpy tomllib tomli_w hashlib zipfile difflib pathlib fcntl pydantic typer".split()
print([name for name in heavy if name in sys.modules])
"""


def test_without_files_nothing_heavy_is_imported():
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    assert subprocess.check_output([sys.executable, "-S", "-c", LIGHT], env=env, text=True) == "[]\n"
