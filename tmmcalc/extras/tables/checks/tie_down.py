"""``[tie_down]``: the preload is given once."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable


def check_tie_down(outline: Outline) -> Iterator[Finding]:
    """The preload is given once."""
    table = subtable(outline.document, "tie_down")
    if "preload" in table and "thread" in table:
        yield Finding(
            ("tie_down", "preload"), "preload together with thread: it gives the preload", "remove one of them"
        )


CHECKS = (check_tie_down,)
