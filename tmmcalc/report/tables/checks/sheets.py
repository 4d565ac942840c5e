"""Checks of ``[sheets]``: texts that a drawing can write, a designation with a place for the number of the sheet."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.report.drawing.lettering import pieces, plain
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable
from tmmcalc.spec.phrases import show

PLACE = re.compile(r"\{[^}]*\}?|\}")
LONGEST = 120  # characters of a text in a title block


def check_texts(outline: Outline) -> Iterator[Finding]:
    """What stands in the title block is in letters that the font has, and not longer than a title block."""
    for key, text in subtable(subtable(outline.document, "sheets"), "who").items():
        if not isinstance(text, str):
            continue
        path = ("sheets", "who", key)
        if len(text) > LONGEST:
            yield Finding(path, f"{show(text)} has {len(text)} characters", f"write at most {LONGEST}")
            continue
        try:
            pieces(plain(text))
        except UsageError as error:
            yield Finding(path, error.message, "write it in Latin, Greek or Cyrillic letters")


def check_designation(outline: Outline) -> Iterator[Finding]:
    """Braces in the designation stand around the word sheet."""
    said = subtable(subtable(outline.document, "sheets"), "who").get("designation")
    strange = [] if not isinstance(said, str) else [each for each in PLACE.findall(said) if each != "{sheet}"]
    if strange:
        yield Finding(
            ("sheets", "who", "designation"),
            f"{strange[0]!r} in {show(said)} is no place; the number of the sheet takes that of {{sheet}}",
            "write {sheet}, or leave the braces out",
        )


def check_lists(outline: Outline) -> Iterator[Finding]:
    """A list of diagrams names some."""
    if subtable(outline.document, "sheets").get("diagrams") == []:
        yield Finding(("sheets", "diagrams"), "[] is an empty list", 'name columns, such as "S_*", or remove it')


CHECKS = (check_texts, check_designation, check_lists)
