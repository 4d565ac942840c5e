"""Quantities of constraints in words: what a column of a stage is, and what of it is asked."""

from __future__ import annotations

from tmmcalc.core.notes import Phrase
from tmmcalc.feasibility.judge import ASKED
from tmmcalc.naming.language import ANY
from tmmcalc.naming.meanings import described
from tmmcalc.report.language import tr, tr_name


def worded(quantity: str) -> str:
    """The quantity of a constraint as a person says it; one without words by its name, as the spec has it."""
    if not isinstance(quantity, Phrase):
        return tr_name(quantity)
    stage, column = str(quantity.values["stage"]), str(quantity.values["column"])
    named = _named(stage, column)
    if not named:
        return _broken(tr_name(quantity))
    of = next((key for key, template in ASKED.items() if template == quantity.template), "")
    asked = {
        "max": tr("the largest value"),
        "min": tr("the least value"),
        "range": tr("the range"),
        "mean": tr("the mean value"),
        "size": tr("the largest magnitude"),
        "first": tr("the first value"),
        "last": tr("the last value"),
        "rms": tr("the root mean square"),
    }.get("" if stage == "synthesis" else of, "")
    return f"{named}: {asked}" if asked else named


def _named(stage: str, column: str) -> str:
    """What a column or a fact is, as its field declares it; of a linkage found a size; empty where nobody says it."""
    meaning = described(stage, column=True)(column, ANY)[0] or described(stage, column=False)(column, ANY)[0]
    if meaning:
        return tr_name(meaning)
    if stage != "synthesis":
        return ""
    if column == "transmission_min":
        return tr_name("least transmission angle")
    return f"{tr('size of the linkage')} ${column}$" if len(column) == 1 else ""


def _broken(name: str) -> str:
    """A name with places where a line of a narrow column may end."""
    return name.replace("_", "_\u200b")
