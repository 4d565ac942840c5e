"""The conditions of a pair or of a wheel alone: each with both of its sides in numbers, and whether it holds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import degrees, isclose
from typing import NamedTuple

from tmmcalc.gears.involute.quality.verdicts import Check
from tmmcalc.gears.notes.pairs.lexicon import of_index
from tmmcalc.gears.pictures.pairtable import check_called
from tmmcalc.report.formula.digits import significant, value_of
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Call, Number, names
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph, Table
from tmmcalc.report.telling import filled, number_of

FIGURES = 4  # digits of a side
NOTHING = 1e-9  # that rounding leaves of a side


class Sides(NamedTuple):
    """A condition in letters; ``<i>`` is the number of the wheel, ``<limit>`` the limit as it is given."""

    left: str
    limit: str = "<limit>"
    unit: str = ""


SIDES = {
    "pressure angle": Sides("alpha_tw", unit="deg"),
    "contact ratio": Sides("eps_alpha"),
    "shortened contact ratio": Sides("eps'_alpha"),
    "undercut": Sides("x<_i>", "<xmin>"),
    "interference": Sides("rho_p<i>", "<end>", "mm"),
    "tip thickness": Sides("<sna>", "<limit>*m", "mm"),
    "tip circle": Sides("r_a<i>", "r_b<i>", "mm"),
    "clearance": Sides("c<_i>", "<limit>*m", "mm"),
    "sliding": Sides("abs(theta<_i>)"),
    "pressure": Sides("<lambda>"),
    "involute interference": Sides("rho_p1", unit="mm"),
    "fillet 1 interference": Sides("rho_p1", "<end1>", "mm"),
    "fillet 2 interference": Sides("rho_p2", "rho_F2", "mm"),
    "trochoid interference": Sides("Gamma", unit="mm"),
}
MARGIN = Sides("<value>", "<least>", "mm")  # of what has no letters
RACK = Sides("rho_a1", "rho_R", "mm")  # interference with the fillet of a rack
AT_MOST = ("fillet 2 interference",)  # whose check knows no more than the margin


def judged(
    found: Sequence[Check], lexicon: Lexicon, words: Mapping[str, str], wheels: Sequence[str], key: str, of: str = ""
) -> Iterator[Block]:
    """The table of the conditions with what follows from it.

    ``wheels`` are their names, ``of`` the teeth where there are several pairs.
    """
    verdicts = {"ok": tr("kept"), "warn": tr("not recommended"), "fail": tr("not kept")}
    shown = [check for check in found if check.limit is not None]
    rows = []
    for check in shown:
        whose = wheels[check.wheel - 1] if check.wheel else ""
        rows.append((check_called(check), whose, _relation(check, lexicon, words), verdicts[check.verdict]))
    head = tr("Figure of quality"), tr("Wheel"), tr("Condition"), tr("Verdict")
    yield Paragraph(tr("The figures of quality and their limits are in table {table}.", table=f"{{tab:{key}}}"))
    caption = f"{tr('Figures of quality of the pair')} {of}" if of else tr("Figures of quality")
    yield Table(caption, head, tuple(rows), key=key)
    yield Paragraph(_concluded(shown, wheels))


def _concluded(shown: Sequence[Check], wheels: Sequence[str]) -> str:
    """Whether all conditions hold, or which do not."""

    def told(verdict: str) -> str:
        found = [check for check in shown if check.verdict == verdict]
        return ", ".join(check_called(check) + (f" ({whose(check)})" if check.wheel else "") for check in found)

    def whose(check: Check) -> str:
        name = wheels[check.wheel - 1]
        return name if name == tr("rack") else tr("wheel {wheel}", wheel=name)

    failed, beyond = told("fail"), told("warn")
    sentences = [tr("All conditions hold.")] if not failed else [tr("Conditions that fail: {names}.", names=failed)]
    if beyond:
        sentences.append(tr("Recommended limits that are not kept: {names}.", names=beyond))
    return " ".join(sentences)


def _relation(check: Check, lexicon: Lexicon, words: Mapping[str, str]) -> str:
    """Both sides of a condition with their numbers; of what has no letters the numbers alone."""
    sides = SIDES.get(check.name, MARGIN)
    if check.name == "interference" and check.wheel == 2 and "rho_R" in lexicon:
        sides = RACK
    index = str(check.wheel) if check.wheel and "i" not in words else ""
    limit = check.limit or 0.0
    shown = _number(degrees(limit) if sides.unit == "deg" else limit, sides.unit)
    m = number_of(lexicon, "m")
    own = {
        "value": _number(m * check.value, "mm"),
        "least": _number(m * limit, "mm"),
        "limit": shown,
        "end": words.get(f"end{index}", ""),
    }
    own |= {**words, **of_index(index, words)}
    least = check.name not in AT_MOST and isclose(check.margin, check.value - limit, abs_tol=1e-12)
    kept, broken = (">=", "<") if least else ("<=", ">")
    sign = kept if check.verdict == "ok" else broken
    left, right = (_side(filled(text, own), lexicon, sides.unit) for text in (sides.left, sides.limit))
    unit = f" {tr_unit(sides.unit)}" if sides.unit == "mm" else ""
    return f"${left} {sign} {right}${unit}"


def _side(text: str, lexicon: Lexicon, unit: str) -> str:
    """A side in letters and its value; of a number alone the number."""
    (side,) = read(text).sides
    if isinstance(side, Number | Call) and not names(side):
        return text
    return f"{text} = {_number(value_of(side, lexicon, unit), unit)}"


def _number(value: float, unit: str) -> str:
    """A number as formulas have it; nothing of one that rounding leaves."""
    text = significant(value, FIGURES) if abs(value) > NOTHING else "0"
    return f"deg({text})" if unit == "deg" else text
