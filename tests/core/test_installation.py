"""The command that adds a missing package fits how the program was installed."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path
from typing import Any

import pytest

from tmmcalc.core.installation import command_of, install

GIT = {"url": "https://a.b/c.git", "vcs_info": {"vcs": "git", "commit_id": "1f2e"}}
WHEEL = {"url": "file:///home/a/tmmcalc-0.1.0-py3-none-any.whl", "archive_info": {}}


@pytest.mark.parametrize(
    ("file", "installer", "url", "checkout", "expected"),
    [
        ("", "pip", {}, None, 'pip install "tmmcalc[plot]"'),
        ("", "uv", {}, None, 'uv pip install "tmmcalc[plot]"'),
        ("", "pip", {"url": "file:///src"}, Path("/src"), 'pip install --editable "/src[plot]"'),
        ("", "pip", GIT, None, 'pip install "tmmcalc[plot] @ git+https://a.b/c.git@1f2e"'),
        ("", "pip", WHEEL, None, f'pip install "tmmcalc[plot] @ {WHEEL["url"]}"'),
        ("pipx_metadata.json", "pip", {}, None, 'pipx install --force "tmmcalc[plot]"'),
        ("pipx_metadata.json", "uv", {}, Path("/s d"), 'pipx install --force --editable "/s d[plot]"'),
        ("uv-receipt.toml", "uv", {}, None, 'uv tool install --force "tmmcalc[plot]"'),
        ("uv-receipt.toml", "uv", WHEEL, None, f'uv tool install --force "tmmcalc[plot] @ {WHEEL["url"]}"'),
    ],
)
def test_command(
    tmp_path: Path, file: str, installer: str, url: dict[str, Any], checkout: Path | None, expected: str
) -> None:
    if file:
        (tmp_path / file).touch()
    command = command_of("plot", tmp_path, checkout, installer, url)
    assert command == expected
    assert shlex.split(command)[-1].startswith(str(checkout or "tmmcalc"))


def test_an_environment_that_is_not_active_has_its_own_pip(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "pyvenv.cfg").touch()
    monkeypatch.delenv("VIRTUAL_ENV", raising=False)
    assert command_of("cad", tmp_path, None, "pip", {}) == f'"{sys.executable}" -m pip install "tmmcalc[cad]"'
    monkeypatch.setenv("VIRTUAL_ENV", str(tmp_path))
    assert command_of("cad", tmp_path, None, "pip", {}) == 'pip install "tmmcalc[cad]"'


def test_the_tests_run_from_a_checkout() -> None:
    assert install("plot").endswith(f'install --editable "{Path(__file__).parents[2]}[plot]"')
