from __future__ import annotations

import json
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

import pytest
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.project import templates


def test_shaper_is_there() -> None:
    assert "shaper" in templates.names()
    assert templates.text("shaper").startswith("#:schema")
    assert templates.description("shaper").startswith("Shaper: a crank and slotted link")


@sparing("name", templates.names(), every=6)
def test_the_schema_is_that_of_the_program_wherever_the_spec_stands(name: str) -> None:
    """A URL of a file, with spaces and letters beyond ASCII escaped: editors take it as it is, without a network."""
    directive, url = templates.text(name).splitlines()[0].split(" ")
    assert directive == "#:schema"
    assert url.startswith("file:///")
    assert json.loads(Path(url2pathname(urlsplit(url).path)).read_text())["title"] == "tmmcalc project spec"
    assert templates.text(name).splitlines()[1:] == templates.path(name).read_text(encoding="utf-8").splitlines()[1:]


@pytest.mark.parametrize("name", templates.names())
def test_a_description_is_a_sentence(name: str) -> None:
    assert templates.description(name).endswith((".", "?"))


@pytest.mark.parametrize("name", ["shapr", "../pyproject", "/etc/passwd", "shaper.toml", ""])
def test_unknown_name(name: str) -> None:
    with pytest.raises(UsageError, match="there is no ready spec") as caught:
        templates.text(name)
    assert "shaper" in caught.value.remedy


def test_package_folder_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "tmmcalc"
    monkeypatch.setattr(templates, "_PACKAGE", package)
    with pytest.raises(UsageError, match="no ready specs"):
        templates.names()
    (tmp_path / "configs").mkdir()
    (tmp_path / "configs" / "outside.toml").write_text("x = 1\n# late\n")
    assert templates.names() == ["outside"]
    assert templates.description("outside") == ""
    (package / "configs" / "extreme").mkdir(parents=True)
    (package / "configs" / "extreme" / "hard.toml").write_text("#:schema x\n# Hard one.\n")
    assert templates.names() == ["extreme/hard"]
    assert templates.description("extreme/hard") == "Hard one."
