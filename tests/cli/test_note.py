"""``tmmcalc note`` as its user types it."""

from __future__ import annotations

from pathlib import Path

import pytest

from .conftest import CONFIGS, Cli


def test_a_note_is_printed(cli: Cli) -> None:
    code, out, err = cli("note", str(CONFIGS / "shaper.toml"), "-o", "-", "--no-store", "--only", "structure", "-q")
    assert (code, err) == (0, "")
    assert "= 3·5 − 2·7 = 1" in out


@pytest.mark.parametrize("form", ["pdf", "docx", "html", "typ", "txt"])
def test_a_note_is_written_the_same_every_time(cli: Cli, tmp_path: Path, form: str) -> None:
    file = tmp_path / f"my.{form}"
    args = (
        "note",
        str(CONFIGS / "press.toml"),
        "-o",
        str(file),
        "--no-store",
        "--only",
        "structure",
        "--language",
        "uk",
    )
    assert cli(*args)[0] == 0
    first = file.read_bytes()
    assert cli(*args)[0] == 0
    assert file.read_bytes() == first
    assert b"CreationDate" not in first  # or it were the same only within a second


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("shaper.toml", "-o", "a.doc"), "a note has no form 'doc'"),
        (("shaper.toml", "--only", "gearing"), "there is no chapter 'gearing'"),
        (("shaper.toml", "--language", "de"), "there is no language 'de'"),
        (("shaper.toml", "--positions", "77"), "no position is called '77'"),
        (("pair-spur.toml", "--only", "structure"), "the scene has nothing for these chapters"),
    ],
)
def test_what_cannot_be_is_refused(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli("note", str(CONFIGS / args[0]), *args[1:], "--no-store")
    assert (code, out) == (2, "")
    assert said in err
