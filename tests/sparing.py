"""Parameters of a test of which every run takes some and the run of the long tests the others."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import pytest
from _pytest.mark import ParameterSet


def sparing(
    names: str | Sequence[str], values: Iterable[Any], *, every: int, first: int = 0, **more: Any
) -> pytest.MarkDecorator:
    """Parametrize; all but each ``every``-th of the values, from the ``first`` on, are long."""
    single = isinstance(names, str) and "," not in names
    chosen = []
    for k, value in enumerate(values):
        given = value if isinstance(value, ParameterSet) else pytest.param(*((value,) if single else value))
        slow = [] if k % every == first else [pytest.mark.slow]
        chosen.append(pytest.param(*given.values, marks=[*given.marks, *slow], id=given.id))
    return pytest.mark.parametrize(names, chosen, **more)
