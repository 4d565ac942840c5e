"""Checks of ``[[loads]]``: what the law of each load asks of its data."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.loadlaws import laws
from tmmcalc.linkage.tables.checks.loads import loads
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline


def check_data(outline: Outline) -> Iterator[Finding]:
    """What the law of a load asks for, law by law."""
    for key, law in laws().items():
        for path, load in loads(outline):
            if key in load:
                yield from law.check(outline, load, path)


CHECKS = (check_data,)
