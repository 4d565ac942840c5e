"""The command line, run in this process, in an empty folder."""

from __future__ import annotations

from pathlib import Path

import pytest
from cli.conftest import cli

__all__ = ["cli"]


@pytest.fixture
def empty(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path
