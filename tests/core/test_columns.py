"""Columns are chosen by name, by header or with wildcards, alike from columns that are made late and from arrays."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest

from tmmcalc.core.columns import Column, picked, select
from tmmcalc.core.errors import UsageError

HEADERS = ["phi[deg]", "x_A[m]", "x_B[m]", "omega_3[rad/s]"]


def selected(patterns: Sequence[str]) -> list[str]:
    """What `select` takes of the columns after that of the labels."""
    parts = [header.rstrip("]").split("[") for header in HEADERS]
    available = [Column(name, unit, lambda: np.zeros(1)) for name, unit in parts]
    return [column.header for column in select(available, patterns)]


def kept(patterns: Sequence[str]) -> list[str]:
    """What `picked` takes; the column of the labels comes first by itself."""
    first, *others = picked(dict.fromkeys(["i", *HEADERS], 0), patterns)
    assert first == "i"
    return others


Chooser = Callable[[Sequence[str]], list[str]]


@pytest.mark.parametrize("choose", [selected, kept])
@pytest.mark.parametrize(
    ("patterns", "found"),
    [
        (["omega_3"], ["omega_3[rad/s]"]),
        (["omega_3[rad/s]", "phi[deg]"], ["omega_3[rad/s]", "phi[deg]"]),
        (["x_*", "x_A", "phi"], ["x_A[m]", "x_B[m]", "phi[deg]"]),
        (["i", "x_B"], ["x_B[m]"]),
        (["*"], HEADERS),
    ],
)
def test_patterns(choose: Chooser, patterns: list[str], found: list[str]) -> None:
    assert choose(patterns) == found


@pytest.mark.parametrize("choose", [selected, kept])
def test_a_pattern_without_a_column(choose: Chooser) -> None:
    with pytest.raises(UsageError, match="no column is called 'omga_3'") as caught:
        choose(["phi", "omga_3"])
    assert caught.value.remedy == "did you mean omega_3?"


@pytest.mark.parametrize("choose", [selected, kept])
def test_a_column_in_another_unit_is_told_with_its_own(choose: Chooser) -> None:
    with pytest.raises(UsageError, match=r"no column is called 'phi\[rad\]'") as caught:
        choose(["phi[rad]"])
    assert caught.value.remedy == "it is phi[deg]"


def test_without_patterns_all_are_kept_in_their_order() -> None:
    assert list(picked(dict.fromkeys(["x[m]", "series"], 0), [], "series")) == ["x[m]", "series"]
    assert list(picked(dict.fromkeys(["x[m]", "series"], 0), ["x"], "series")) == ["series", "x[m]"]
    assert list(picked(dict.fromkeys(["x[m]", "y[m]"], 0), ["y"])) == ["y[m]"]
