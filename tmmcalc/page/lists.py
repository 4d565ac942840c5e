"""The tables in the summaries of stages: checks with their limits, methods side by side, pairs, events of a motion."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from tmmcalc.core.facts import named
from tmmcalc.page.packing import Content
from tmmcalc.page.said import Said, name_of, said, unit_of
from tmmcalc.report.document import Document
from tmmcalc.report.formula.symbols import GREEK, with_letters
from tmmcalc.report.language import tr, tr_measured

ENGLISH = re.compile(r"[a-z]{4,}|\b[A-Z]?[a-z]{2,3}\b")  # a word that is no symbol
SIGN = re.compile(rf"(?:[A-Za-z]|{'|'.join(GREEK)})'*(?:_.+)?")  # a letter with its index
MEASURED = re.compile(r"(?:(.+) = )?(-?\d+(?:\.\d*)?(?:e[-+]?\d+)?)(?: ([^\s\d]\S*))?")
KEYS = re.compile("(?<=[a-z]{2})_(?=[a-z]{2})")  # what joins words of a key


def tables(document: Document, given: Container[str] = ()) -> Iterator[Content]:
    """The table of a summary and those of its parts, without columns that would stay English in other languages.

    What the spec names stays as it is: its texts are ``given``.
    """
    for part in (document, *document.parts):
        if part.table is not None:
            columns = [*_columns(part.table.headers, part.table.columns, given)]
            if len(columns) > 1:
                yield {"title": "" if part is document else worded(name_of(part.title)), "columns": columns}


def worded(text: Said) -> Said:
    """A text in which words are parted by blanks, as in no key."""
    return KEYS.sub(" ", text) if isinstance(text, str) else [KEYS.sub(" ", each) for each in text]


def _columns(headers: Sequence[str], columns: Sequence[Sequence[Any]], given: Container[str]) -> Iterator[Content]:
    for header, column in zip(headers, columns, strict=True):
        name, unit = named(header)
        sign, known = SIGN.fullmatch(name) is not None, name in _heads()
        head = name if sign else said(partial(_head, name)) if known else worded(name_of(name))
        cells = [_cell(each) for each in column]
        strange = (cell for cell in cells if _english(cell) and cell not in given)
        if (sign or known or not _english(head)) and not any(strange):
            yield {"name": head, "sign": sign, "unit": unit_of(unit), "cells": cells}


def _english(told: Any) -> bool:
    """Whether a text has words that no other language has."""
    return isinstance(told, str) and ENGLISH.search(told) is not None


def _head(name: str) -> str:
    return _heads()[name]


def _heads() -> dict[str, str]:
    """Heads of columns by the words of summaries."""
    return {
        "requirement": tr("Requirement"),
        "constraint": tr("Requirement"),
        "value": tr("Value"),
        "limit": tr("Limit"),
        "margin": tr("Margin"),
        "margin_least": tr("Least margin"),
        "verdict": tr("Verdict"),
        "group": tr("Group"),
        "class": tr("Class"),
        "order": tr("Order"),
        "inner joints": tr("Inner pairs"),
        "attachment points": tr("Outer pairs"),
        "source chain": tr("Joined to the links"),
        "method": tr("Method"),
        "max_at": tr("Greatest at"),
        "min_at": tr("Least at"),
        "outcome": tr("Outcome"),
        "rank": tr("Rank"),
        "event": tr("Event"),
        "turns": tr("Turns"),
        "member": tr("Member"),
        "count": tr("Count"),
        "carrier": tr("Carrier"),
        "state": tr("State"),
        "variant": tr("Variant"),
        "pair": tr("Pair"),
        "wheel": tr("Wheel"),
        "size": tr("Size"),
        "symbol": tr("Designation"),
        "no.": tr("No."),
    }


def _cell(value: Any) -> Any:
    """A truth value, a number, a measured quantity with its sign, a text."""
    if isinstance(value, bool | np.bool_):
        return bool(value)
    if isinstance(value, int | float | np.number):
        return float(value) if np.isfinite(value) else ""
    measured = MEASURED.fullmatch(str(value))
    if measured is None:
        return name_of(value)
    sign, number, unit = measured.groups(default="")

    def tell() -> str:
        before = f"{with_letters(sign)} = " if sign else ""
        return before + tr_measured(number, unit)

    return said(tell)
