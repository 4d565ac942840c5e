"""``[tie_down]``: the preload is given once, a yield stress has its section."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable


def check_tie_down(outline: Outline) -> Iterator[Finding]:
    """The preload is given once, a yield stress has its section."""
    table = subtable(outline.document, "tie_down")
    if "preload" in table and "thread" in table:
        yield Finding(
            ("tie_down", "preload"), "preload together with thread: it gives the preload", "remove one of them"
        )
    if "strength" in table and "section" not in table:
        rule = "missing key: strength without section, over which the force is a stress"
        yield Finding(("tie_down",), rule, 'add section = "1.8 cm^2"')


CHECKS = (check_tie_down,)
