from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tmmcalc.errors import Fault, SpecError
from tmmcalc.spec import parse_spec

SHAPER = Path(__file__).parents[1] / "shaper.toml"


@pytest.fixture
def shaper() -> str:
    return SHAPER.read_text(encoding="utf-8")


@pytest.fixture
def faults_of() -> Callable[[str], list[Fault]]:
    def faults(text: str) -> list[Fault]:
        with pytest.raises(SpecError) as caught:
            parse_spec(text, "shaper.toml")
        assert caught.value.exit_code == 2
        return caught.value.faults

    return faults
