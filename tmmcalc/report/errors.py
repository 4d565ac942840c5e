"""What a stage estimates of its errors, in its document."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from tmmcalc.core.stored import LAST_DIGIT, estimates, last_digits
from tmmcalc.report.document import Document, Fact

FEW = 6  # errors that are all told; of more the largest


def with_errors(document: Document, error: Mapping[str, Any]) -> Document:
    """The document with all estimated relative errors of its stage, in the place of those that it tells itself."""
    told = dict(estimates(error))
    if not told:
        return document
    own = [k for k, fact in enumerate(document.facts) if isinstance(fact.values.get("error"), Mapping)]
    at = own[0] if own else len(document.facts)
    rest = [fact for fact in document.facts[at + 1 :] if LAST_DIGIT not in fact.values]
    fact = Fact("error estimate", _text(told), {"error": told})
    return replace(document, facts=(*document.facts[:at], fact, *digit_facts(dict(last_digits(error))), *rest))


def with_counters(document: Document, counters: Mapping[str, Any]) -> Document:
    """The document for programs, with the counters of its stage beside those that it tells itself."""
    told = {key: value for fact in document.facts for key, value in fact.values.items()}
    own = told.get("counters", {})
    if not counters or not isinstance(own, Mapping):  # a quantity of this name stays what it is
        return document
    return replace(document, facts=(*document.facts, Fact("", "", {"counters": {**counters, **own}})))


def digit_facts(told: Mapping[str, float]) -> list[Fact]:
    """What a unit in the last place of the data does to the quantities of a stage, where it is told at all."""
    return [Fact("last digit of the data", _text(told), {LAST_DIGIT: dict(told)})] if told else []


def _text(told: Mapping[str, float]) -> str:
    """Estimates are orders of magnitude: one digit is enough for people.

    >>> _text({"speed": 3.14e-15, "time": 2e-16})
    'speed 3e-15, time 2e-16'
    """
    if len(told) <= FEW:
        return ", ".join(f"{name} {size:.0e}" if size else f"{name} 0" for name, size in told.items())
    name = max(told, key=lambda each: told[each])
    return f"up to {told[name]:.0e}, of {name}"
