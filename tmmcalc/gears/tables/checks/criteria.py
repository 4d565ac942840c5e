"""Checks of ``[criteria]``: weights, trains in series."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable
from tmmcalc.spec.values import amount


def check_weights(outline: Outline) -> Iterator[Finding]:
    """One of the weights counts."""
    criteria = subtable(outline.document, "criteria")
    weights = criteria.get("weights")
    if not isinstance(weights, dict):
        return
    numbers = [amount(weight) for weight in weights.values()]
    if not any(number is None or number for number in numbers):
        rule = "all weights are 0: no criterion counts" if weights else "weights without a criterion"
        yield Finding(("criteria", "weights"), rule, "write weights = { mass = 1, inertia = 2 }, or remove it")


def check_sizes(outline: Outline) -> Iterator[Finding]:
    """Trains are compared by the sizes that strength gives."""
    document = outline.document
    if "train" in document and "strength" not in document:
        rule = "[criteria] without [strength]: trains are compared by their sizes"
        yield Finding(("criteria",), rule, "add [strength] with torque and material, or remove it")


def check_series(outline: Outline) -> Iterator[Finding]:
    """Trains in series replace a planetary one of a ratio i_1H, and choose their modules."""
    document = outline.document
    if subtable(document, "criteria").get("series") is not True:
        return
    if "module" in subtable(document, "strength"):
        rule = "series together with [strength] module: the trains in series choose their own modules"
        yield Finding(("criteria", "series"), rule, "remove module from [strength], or series")


CHECKS = (check_sizes, check_weights, check_series)
