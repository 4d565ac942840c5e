"""A formula as it is typeset: in letters, or with what is printed for each name in place of it."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from tmmcalc.report.formula.layout import (
    Arrowed,
    Big,
    Box,
    Digits,
    Fenced,
    Fraction,
    Gap,
    Letter,
    Marked,
    Root,
    Row,
    Script,
    Sign,
    Word,
)
from tmmcalc.report.formula.symbols import GREEK, Symbol, symbol_of
from tmmcalc.report.formula.tree import (
    CONSTANTS,
    Call,
    Name,
    Node,
    Number,
    Over,
    Power,
    Product,
    Quotient,
    Statement,
    Sum,
)
from tmmcalc.report.language import spoken, tr_number

RADIANS = 7  # digits at least of an angle in rad: a round one in degrees has few
RELATIONS = {"=": "=", "<": "<", "<=": "≤", ">": ">", ">=": "≥", "~": "≈"}
ROUNDED = {"floor": "⌊⌋", "ceil": "⌈⌉"}
POWERED = ("sin", "cos", "tan")  # functions whose power stands before the argument
PRINTED = {
    "en": {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2", "ln": "ln", "lg": "lg"},
    "uk": {
        "gcd": "НСД",
        "tan": "tg",
        "asin": "arcsin",
        "acos": "arccos",
        "atan": "arctg",
        "atan2": "arctg2",
        "ln": "ln",
        "lg": "lg",
    },
}


NEGATIVE = re.compile(r"(?<![^,])-(?=\d)")  # the sign of a number among the parts of an index
PARTS = re.compile(r"(?<![A-Za-z])I{1,3}(?=[xy]?$)|[a-zа-яіїєґ]{2,}|[A-Za-zα-ωΑ-Ω]|[^A-Za-zα-ωΑ-Ω]+")  # of an index
ROMAN = re.compile(r"I|[IVX]{2,}|[IVX]+,[IVX]+")
BELOW, ABOVE = "xyzijkn", "ijk"  # single letters of an index that are axes or counters


class Shown(NamedTuple):
    """What is printed for a name: the digits of its value; a degree sign after an angle in deg."""

    digits: str
    degrees: bool = False


Values = Mapping[str, Shown] | None  # None: letters


def statement(found: Statement, values: Values = None) -> Row:
    """The sides with their relations."""
    boxes: list[Box] = []
    for k, side in enumerate(found.sides):
        if k:
            boxes.append(Sign(RELATIONS[found.relations[k - 1]], main=True))
        boxes += _terms(side, values, main=True)
    return Row(tuple(boxes))


def side(node: Node, values: Values = None) -> Row:
    """One side of a line, whose main signs are those of its terms."""
    return Row(tuple(_terms(node, values, main=True)))


def letters(symbol: Symbol) -> Box:
    """A quantity as it is written."""
    base = _letter(symbol.base)
    index = None if not symbol.lower else _index(symbol.lower, BELOW)
    upper = None if not symbol.upper else _index(symbol.upper, ABOVE)
    return base if index is upper is None and not symbol.primes else Script(base, index, upper, symbol.primes)


def _letter(base: str) -> Box:
    if len(base) == 1:
        return Letter(base)
    if base.startswith("Δ") and len(base) == 2:
        return Row((Letter("Δ"), Letter(base[1])))
    return Word(base)


def _index(text: str, slanted: str) -> Box:
    """An index: points and Greek letters, axes and counters are quantities; words, numbers and Roman ones are not."""
    if ROMAN.fullmatch(text):
        return Word(text)
    text = NEGATIVE.sub("−", text)
    boxes: list[Box] = []
    for found in PARTS.finditer(text):
        part, counted = found[0], ROMAN.fullmatch(found[0]) and (not found.start() or text[found.start() - 1] == ",")
        if not counted and len(part) == 1 and (part.isupper() or part in slanted or part in GREEK.values()):
            boxes.append(Letter(part))
        elif boxes and isinstance(boxes[-1], Word):  # words beside each other are one, with no gap between them
            boxes[-1] = Word(boxes[-1].text + part)
        else:
            boxes.append(Word(part))
    return boxes[0] if len(boxes) == 1 else Row(tuple(boxes))


def quantity(key: str) -> Box:
    """A quantity by its name."""
    return Letter(GREEK[key]) if key in CONSTANTS and key in GREEK else letters(symbol_of(key))


def _terms(node: Node, values: Values, *, main: bool = False) -> list[Box]:
    """A side as boxes in a row, signs between its terms."""
    if not isinstance(node, Sum):
        return [_box(node, values)]
    boxes: list[Box] = []
    for k, (sign, term) in enumerate(node.terms):
        box = _term(term, values, leads=not k and sign > 0)
        if k or (sign < 0 and not _starts_with_zero(box)):  # no -0 before the first term
            boxes.append(Sign("+" if sign > 0 else "−", main=main and k > 0, leads=not k))
        boxes.append(box)
    return boxes


def _term(node: Node, values: Values, *, leads: bool) -> Box:
    """A term of a sum, in brackets where it is one itself, or begins with a minus after a sign."""
    box = _box(node, values)
    return Fenced(box) if isinstance(node, Sum | Over) or (not leads and _signed(box)) else box


def _box(node: Node, values: Values) -> Box:
    match node:
        case Number(text):
            return printed(Shown(text))
        case Name(key):
            return quantity(key) if values is None or key in CONSTANTS else printed(values[key])
        case Sum():
            return Row(tuple(_terms(node, values)))
        case Product(factors):
            return _product(factors, values)
        case Quotient(over, under):
            return Fraction(_bare(over, values), _bare(under, values))
        case Power(base, exponent):
            return _power(base, exponent, values)
        case Over(body, counter):
            assert values is None, "a sum is written out before its numbers are set"
            inner = _box(body, values)
            return Big("∑", Letter(counter), Fenced(inner) if isinstance(body, Sum) else inner)
        case Call(function, arguments):
            return _call(function, arguments, values)


def printed(value: Shown) -> Box:
    """A printed number; one with a power of ten has it beside."""
    mantissa, _, exponent = value.digits.partition("e")
    found: Box = Digits(mantissa)
    if exponent:
        ten = Script(Digits("10"), upper=Digits(str(int(exponent))))
        found = Row((found, Sign("·"), ten))
    return Marked(found, "°") if value.degrees else found


def _bare(node: Node, values: Values) -> Box:
    return Row(tuple(_terms(node, values)))


def _product(factors: Sequence[Node], values: Values) -> Box:
    boxes: list[Box] = []
    before: Box | None = None
    for k, factor in enumerate(factors):
        box = _box(factor, values)
        if isinstance(factor, Sum | Over) or (k and _signed(box)):
            box = Fenced(box)
        if before is not None:
            boxes.append(Sign("·") if values is not None or _dotted(before, box) else Gap())
        boxes.append(box)
        before = box
    return Row(tuple(boxes))


def _dotted(before: Box, box: Box) -> bool:
    """Whether a point stands between two factors: before a number, and after the bare argument of a function."""
    return _starts_with_digits(box) or _open_function(before)


def _starts_with_digits(box: Box) -> bool:
    match box:
        case Digits():
            return True
        case Row(boxes):
            return bool(boxes) and _starts_with_digits(boxes[0])
        case Script(base):
            return _starts_with_digits(base)
        case Marked(inner):
            return _starts_with_digits(inner)
        case Fraction(over, under):
            return _starts_with_digits(over) and _starts_with_digits(under)
        case Fenced(inner):
            return _starts_with_digits(inner) or _signed(inner)
        case _:
            return False


def _starts_with_zero(box: Box) -> bool:
    match box:
        case Digits(text):
            return not text.strip("0.")
        case Row(boxes):
            return bool(boxes) and _starts_with_zero(boxes[0])
        case Script(inner) | Marked(inner):
            return _starts_with_zero(inner)
        case _:
            return False


def _open_function(box: Box) -> bool:
    """Whether it ends with the argument of a function that has no brackets."""
    if not isinstance(box, Row) or not box.boxes:
        return False
    first = box.boxes[0]
    named = isinstance(first, Word) or (isinstance(first, Script) and isinstance(first.base, Word))
    return named and len(box.boxes) > 1 and not isinstance(box.boxes[-1], Fenced)


def _power(base: Node, exponent: Node, values: Values) -> Box:
    if isinstance(exponent, Quotient) and exponent.over == Number("1"):
        degree = None if exponent.under == Number("2") else _box(exponent.under, values)
        return Root(_bare(base, values), degree)
    raised = _bare(exponent, values)
    if isinstance(base, Call) and base.function in POWERED and isinstance(exponent, Number):
        return _call(base.function, base.arguments, values, raised)
    box = _box(base, values)
    plain = not _signed(box) and not isinstance(box, Row | Marked)
    simple = isinstance(base, Number) or (isinstance(base, Name) and plain)
    if not simple and not (isinstance(base, Call) and base.function == "abs"):
        box = Fenced(box)
    if isinstance(box, Script) and box.upper is None and not box.primes:
        return Script(box.base, box.lower, raised)
    return Script(Fenced(box) if isinstance(box, Script) else box, upper=raised)


def _call(function: str, arguments: Sequence[Node], values: Values, power: Box | None = None) -> Box:
    first = arguments[0]
    if function == "sqrt":
        return Root(_bare(first, values))
    if function in ROUNDED:
        return Fenced(_bare(first, values), *ROUNDED[function])
    if function == "abs":
        return Fenced(_bare(first, values), "|", "|")
    if function == "rad":
        return _box(first, values and {key: _in_rad(shown) for key, shown in values.items()})
    if function == "deg":
        return Marked(_box(first, values), "°")
    if function == "vec":
        return Arrowed(_box(first, values))
    if function == "exp":
        return Script(Word("e"), upper=_bare(first, values))
    name: Box = Word(PRINTED.get(spoken(), PRINTED["en"]).get(function, function))
    named = name if power is None else Script(name, upper=power)
    if len(arguments) > 1:
        boxes: list[Box] = []
        for k, argument in enumerate(arguments):
            boxes += [Sign(";"), *_terms(argument, values)] if k else _terms(argument, values)
        return Row((named, Fenced(Row(tuple(boxes)))))
    inner = _box(first, values)
    bare = (isinstance(first, Name | Number) and not _signed(inner)) or (
        isinstance(first, Call) and first.function == "deg"
    )
    return Row((named, Gap(), inner)) if bare else Row((named, Fenced(inner)))


def _in_rad(shown: Shown) -> Shown:
    """An angle in rad, with one digit more than in degrees, and no fewer than its line needs."""
    if not shown.degrees:
        return shown
    figures = sum(map(str.isdigit, shown.digits))
    return Shown(f"{math.radians(float(shown.digits)):.{max(figures + 1, RADIANS)}g}")


def _signed(box: Box) -> bool:
    """Whether it begins with a minus."""
    match box:
        case Digits(text):
            return text.startswith(("-", "−"))
        case Sign(text):
            return text == "−"
        case Marked(inner) | Fraction(inner):
            return _signed(inner)
        case Row(boxes):
            return bool(boxes) and _signed(boxes[0])
        case _:
            return False


def spelt(digits: str) -> str:
    """A number as it is printed in the language in force, with a true minus sign."""
    return tr_number(digits).replace("-", "−")
