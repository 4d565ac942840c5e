"""The estimates of a stage in its document: its errors, and what the last digit of its data does."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.stored import estimates, last_digits
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.errors import with_errors

ERROR: dict[str, Any] = {"position": 9e-16, "reference": "by hand", "last_digit": {"position": 2e-12}}


def test_the_last_digit_is_no_error() -> None:
    """So that a tolerance, which is asked of the computation, does not compare with it."""
    assert dict(estimates(ERROR)) == {"position": 9e-16}
    assert dict(last_digits(ERROR)) == {"position": 2e-12}
    assert dict(last_digits({"position": 9e-16})) == {}


def test_it_stands_below_the_errors_once() -> None:
    own = (Fact("error", "", {"error": {"position": 1.0}}), Fact("digit", "", {"last_digit": {}}), Fact("rows", "3"))
    for facts in (own, own[2:]):
        told = with_errors(Document("a scene", facts), ERROR).facts
        assert {fact.label: fact.text for fact in told} == {
            "rows": "3",
            "error estimate": "position 9e-16",
            "last digit of the data": "position 2e-12",
        }
        assert len(told) == 3


def test_without_it_nothing_is_said() -> None:
    told = with_errors(Document("a scene", ()), {"position": 9e-16}).facts
    assert [fact.label for fact in told] == ["error estimate"]
