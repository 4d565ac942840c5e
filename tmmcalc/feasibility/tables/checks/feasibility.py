"""Checks of ``[feasibility]``: a rule that combines the names of constraints."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.feasibility.rule import check_names
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable, tables


def check_rule(outline: Outline) -> Iterator[Finding]:
    """A rule combines the names of constraints; without constraints there is nothing to combine."""
    feasibility = subtable(outline.document, "feasibility")
    names = [each.get("name") for _, each in tables(outline.document, "constraints")]
    known = [name for name in names if isinstance(name, str)]
    if feasibility and not names:
        yield Finding(("feasibility",), "there are no [[constraints]] to combine", "add [[constraints]], or remove it")
        return
    rule = feasibility.get("rule")
    if isinstance(rule, str) and rule and len(known) == len(names):
        try:
            check_names(rule, known)
        except UsageError as error:
            yield Finding(("feasibility", "rule"), error.message, error.remedy)
    if "smoothness" in feasibility and feasibility.get("form") != "Rm":
        yield Finding(
            ("feasibility", "smoothness"), "smoothness is that of the form Rm", 'write form = "Rm", or remove it'
        )


CHECKS = (check_rule,)
