"""The appendix of the note: error estimates, the spec, the version of the program."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from tmmcalc import __version__
from tmmcalc.report.formula.digits import significant
from tmmcalc.report.formula.symbols import GREEK
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Chapter, Heading, Paragraph, Table, Verbatim

DIGITS = 2  # of an estimate
LETTER = "A"  # of its sections and tables
REMARK = re.compile(r"^([^#]*[^#\s])\s{3,}#")


def appendix(errors: Mapping[str, Mapping[str, float]], source: str, own: Sequence[Block]) -> Chapter:
    """What the person wrote; the estimates by title of the stage and quantity; the text of the spec."""
    return Chapter("appendix", tr("Appendix A"), (*own, *_blocks(errors, source)), number=LETTER)


def _blocks(errors: Mapping[str, Mapping[str, float]], source: str) -> Iterator[Block]:
    rows = [
        (tr_name(title), "; ".join(f"{_said(name)} ${significant(value, DIGITS)}$" for name, value in found.items()))
        for title, found in errors.items()
    ]
    if rows:
        yield Heading(tr("Error estimates"))
        yield Paragraph(
            tr("The relative errors of the results, as the program estimates them, are listed in table {tab:errors}.")
        )
        head = (tr("Calculation"), tr("Estimates"))
        yield Table(tr("Estimates of relative errors"), head, tuple(rows), key="errors")
    yield Heading(tr("Input data"))
    yield Paragraph(tr("Calculated by tmmcalc {version} from this file:", version=__version__))
    yield Verbatim("\n".join(map(_narrow, source.splitlines())))


def _narrow(line: str) -> str:
    """A line of the spec with its remark beside it, not in a column of remarks.

    >>> _narrow('mass = 24          # kg'), _narrow("#     C     pivot")
    ('mass = 24  # kg', '#     C     pivot')
    """
    return REMARK.sub(r"\1  #", line)


def _said(name: str) -> str:
    """What an estimate is of: a word, or a quantity by its name in formulas."""
    if len(name) == 1 or name[1] == "_" or name[-1].isdigit() or name in GREEK:
        return f"${name}$"
    return tr_name(name).replace("_", " ")
