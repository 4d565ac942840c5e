"""``tmmcalc extra`` on the ready specs: documents, formats, stored results, pictures."""

from __future__ import annotations

import json
from pathlib import Path

from sparing import sparing
from storing import assert_stored_as_found
from typer.testing import CliRunner

import tmmcalc
from tmmcalc.cli.app import app
from tmmcalc.project import templates

SPECS = {  # command -> stage, words that people read
    "contact": ("contact", "p_max/p0"),
    "reliability": ("reliability", "r = 2.559414288"),
    "tie-down": ("tie_down", "14287.23"),
    "ball": ("falling_ball", "tau* = 3.739921"),
    "bearing": ("bearing", "BPFO = 4.496355"),
    "liner": ("liner", "Q0 = 45885.16"),
    "transloader": ("transloader", "K_m = K1 + K2 (sum, as printed)"),
}
RUNNER = CliRunner()


def file_of(command: str) -> str:
    return str(templates.path(f"extra-{command}"))


@sparing("command", SPECS, every=3)
def test_documents(command: str) -> None:
    words = SPECS[command][1]
    people = RUNNER.invoke(app, ["extra", command, file_of(command), "--no-store", "-q"])
    assert people.exit_code == 0, people.output
    assert words in people.stdout
    programs = RUNNER.invoke(app, ["extra", command, file_of(command), "--no-store", "-q", "--format", "json"])
    assert json.loads(programs.stdout)


@sparing("command", SPECS, every=3)
def test_what_is_stored_is_what_was_found(command: str, tmp_path: Path) -> None:
    stage = SPECS[command][0]
    scene = tmmcalc.load_spec(file_of(command))
    assert_stored_as_found(scene, stage, tmp_path)
    assert [*tmmcalc.run(scene).outcomes] == [stage]
    assert (tmp_path / f"{stage}.csv").exists() == (command not in ("bearing", "transloader"))


@sparing("command", ["contact", "reliability", "ball", "liner", "tie-down"], every=3)
def test_columns_and_pictures(command: str, tmp_path: Path) -> None:
    done = RUNNER.invoke(
        app,
        [
            "extra",
            command,
            file_of(command),
            "--no-store",
            "-q",
            "--columns",
            {"ball": "S", "tie-down": "k"}.get(command, "x"),
        ],
    )
    assert done.exit_code == 0, done.output
    picture = tmp_path / "a.svg"
    scene = tmp_path / "scene.toml"
    scene.write_text(Path(file_of(command)).read_text())
    done = RUNNER.invoke(app, ["plot", str(scene), SPECS[command][0], "-o", str(picture)])
    assert done.exit_code == 0, done.output
    assert picture.stat().st_size > 8_000
