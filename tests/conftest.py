from __future__ import annotations

from pathlib import Path

import faults
import pytest
from faults import Faults

SHAPER = Path(__file__).parents[0] / "shaper.toml"


@pytest.fixture
def shaper() -> str:
    return SHAPER.read_text(encoding="utf-8")


@pytest.fixture
def faults_of() -> Faults:
    return faults.faults_of
