"""How many examples a property under hypothesis takes: all in a run of the long tests, a part in a quick one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

WHOLE = 100  # examples of the profile "deep", hypothesis' own default
LEAST = 4  # examples that also a quick run takes

BUSY = [HealthCheck.too_slow]  # a machine that does something else is no fault of a test

settings.register_profile("deep", max_examples=WHOLE, suppress_health_check=BUSY)
settings.register_profile("quick", max_examples=WHOLE // 4, suppress_health_check=BUSY)


def choose(*, quick: bool) -> None:
    """Load the profile; before the modules of the tests are imported, as their decorators read it."""
    settings.load_profile("quick" if quick else "deep")


def examples(number: int, **more: Any) -> Callable[[Any], Any]:
    """Settings of an expensive property: ``number`` examples in a run of the long tests, a part in a quick one."""
    part = -(-number * settings.default.max_examples // WHOLE)
    chosen = settings(max_examples=max(part, min(number, LEAST)), deadline=None, **more)
    return lambda test: pytest.mark.deep(chosen(test))
