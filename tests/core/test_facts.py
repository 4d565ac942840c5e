"""Names of the facts of a summary with several parts."""

from __future__ import annotations

import pytest

from tmmcalc.core.facts import beginnings
from tmmcalc.report.document import Document, Fact


def part(title: str, name: str = "", key: str = "a[m]") -> Document:
    return Document(title, (Fact("a", "1", {key: 1.0}),), name=name)


@pytest.mark.parametrize(
    ("parts", "expected"),
    [
        ([part("start"), part("stop")], ["start.", "stop."]),
        ([part("z = 25/62", "1-2"), part("z = 18/60")], ["1-2.", "z = 18/60."]),
        ([part("engine", key="F[N]"), part("rotor", key="U[kg*m]")], ["", ""]),  # no fact is told twice
        ([part("one"), part("one"), part("two")], ["1.", "2.", "two."]),
        ([part("m(2.0)"), part("max")], ["1.", "max."]),  # dots and brackets would be taken apart
    ],
)
def test_parts_that_tell_the_same_are_named(parts: list[Document], expected: list[str]) -> None:
    assert beginnings(parts) == expected
