"""Checks of ``[note]``: chapters and units that there are, texts that a page can write, a folder beside the spec."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePath

from tmmcalc.core.errors import UsageError
from tmmcalc.core.stage import STAGES
from tmmcalc.report.drawing.lettering import pieces, plain
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable
from tmmcalc.spec.phrases import did_you_mean, listing, show
from tmmcalc.spec.units import kind_of


def check_chapters(outline: Outline) -> Iterator[Finding]:
    """The chapters that are listed are there, each once."""
    known = list(dict.fromkeys(stage.chapter for stage in STAGES.values() if stage.chapter))
    said = subtable(outline.document, "note").get("chapters")
    named = said if isinstance(said, list) else []
    for k, name in enumerate(named):
        if name not in known:
            guess = did_you_mean(name, known) if isinstance(name, str) else ""
            remedy = f"{guess + ' ' if guess else ''}there are: {listing(known)}"
            yield Finding(("note", "chapters", k), f"{show(name)} is no chapter", remedy)
        elif name in named[:k]:
            yield Finding(("note", "chapters", k), f"{show(name)} is named twice", "remove one of them")
    if said == []:
        yield Finding(("note", "chapters"), "[] is an empty list", "name chapters, or remove it")


def check_units(outline: Outline) -> Iterator[Finding]:
    """The units that are listed are known, one of a dimension."""
    said = subtable(outline.document, "note").get("units")
    kinds: dict[str, object] = {}
    for k, unit in enumerate(said if isinstance(said, list) else []):
        kind = kind_of(unit) if isinstance(unit, str) else None
        if kind is None:
            yield Finding(("note", "units", k), f"{show(unit)} is no unit", 'write one such as "mm" or "MPa"')
        elif kind in kinds:
            message = f"{show(unit)} and {show(kinds[kind])} are both units of {kind}"
            yield Finding(("note", "units", k), message, "remove one of them")
        else:
            kinds[kind] = unit


def check_texts(outline: Outline) -> Iterator[Finding]:
    """What stands on the title page is in letters that the font has."""
    for key, said in subtable(subtable(outline.document, "note"), "who").items():
        for text in said if isinstance(said, list) else [said]:
            try:
                pieces(plain(text) if isinstance(text, str) else "")
            except UsageError as error:
                yield Finding(("note", "who", key), error.message, "write it in Latin, Greek or Cyrillic letters")


def check_folder(outline: Outline) -> Iterator[Finding]:
    """The folder of texts is named from the folder of the spec."""
    folder = subtable(outline.document, "note").get("texts")
    if isinstance(folder, str) and (not folder or PurePath(folder).is_absolute()):
        yield Finding(("note", "texts"), f"{show(folder)} is no folder beside the spec", 'write one such as "note"')


CHECKS = (check_chapters, check_units, check_texts, check_folder)
