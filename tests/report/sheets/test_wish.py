"""What ``[sheets]`` asks of the pieces."""

from __future__ import annotations

from typing import Any

import pytest

from tmmcalc.core.errors import UsageError
from tmmcalc.project import parse_spec
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.sheets.wish import diagrams_of, positions_of

LABELS = ("0", "1", "2", "3", "3'", "4")


def order(said: str) -> Order:
    spec = parse_spec(f"[pair]\nteeth = [14, 27]\nmodule = 0.005\n{said}")
    return Order(spec, {}, {}, lambda stage: None, parse_spec)


def test_positions() -> None:
    asked = order('[sheets]\npositions = [3, "3\'", 1]\n')
    assert positions_of(asked, LABELS) == [3, 4, 1]
    assert positions_of(order("[sheets]\npositions = 2\n"), LABELS) == [2]
    assert positions_of(order("[sheets]\n"), LABELS) is None
    assert positions_of(order(""), LABELS) is None
    with pytest.raises(UsageError, match="no position is called '7'"):
        positions_of(order("[sheets]\npositions = [7]\n"), LABELS)


@pytest.mark.parametrize(
    ("said", "found"),
    [('["v_*", "S_D"]', ["v_B", "v_D", "S_D"]), ('["S_D", "S_*"]', ["S_D", "S_B"]), ('["a_*"]', [])],
)
def test_diagrams(said: str, found: list[Any]) -> None:
    assert diagrams_of(order(f"[sheets]\ndiagrams = {said}\n"), ["S_B", "S_D", "v_B", "v_D"]) == found
    assert diagrams_of(order(""), ["S_B"]) is None
