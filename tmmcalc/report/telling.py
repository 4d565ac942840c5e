"""What chapters of a note are told with: formulas of several links or points from one text, worked out at places.

A chapter gathers its quantities by their names in formulas in a lexicon for each place, ``{"omega_1": Given(5.76,
"rad/s", tr("angular velocity of the crank"))}``, and gives the texts of its formulas in their order to `lines`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike

from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import message
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import PLAIN, Given, digits_given, result_of, rounded, significant, value_of
from tmmcalc.report.formula.setting import spelt
from tmmcalc.report.formula.simplify import ZERO, simplified
from tmmcalc.report.formula.symbols import GREEK, NAME, canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Datum, Figure, Lexicon, Line, Listing, Paragraph, Place, Table
from tmmcalc.report.printing import printed_as
from tmmcalc.report.sheets.piece import Piece

Step = TypeVar("Step")
Of = Callable[[str], str]  # words what a quantity is, with what it is of where several have it
STILL = 1e-12  # a value this small in every shown place is nothing
CELL = 12  # values of a list that stand in one cell
DIGITS = 5  # of the largest number of a column, of a number within a sentence
WIDE, HIGH = 160.0, 130.0  # that a picture may be [mm]
LATIN = {greek: name for name, greek in GREEK.items()}  # names of Greek letters
SIGNS = ("<=", ">=", "<", ">")
SAME = 1e-9  # of the largest value of its unit: values that differ less are equal
ANGLE = 6  # decimals of an angle that are no rounding [deg]
STEPS = (1, 2, 5, 10, 20, 50, 100, 200, 500)  # of a long course that are shown
LETTERED = 1.15  # words of a picture against those of a drawing on screen


def named(quantities: Lexicon) -> dict[str, Given]:
    """Quantities by the names that formulas have when they are read."""
    return {canonical(key): given for key, given in quantities.items()}


def filled(text: str, words: Mapping[str, str]) -> str:
    """A formula or a name with words for its places in angle brackets.

    >>> filled("omega_<k> = v_<P>/l_<k>", {"k": "3", "P": "B"})
    'omega_3 = v_B/l_3'
    """
    for key, word in words.items():
        text = text.replace(f"<{key}>", word)
    return text


def vector(name: str, value: complex, unit: str, meaning: str) -> dict[str, Given]:
    """The projections of a vector; ``%`` in the name is the axis."""
    return {
        name.replace("%", "x"): Given(value.real, unit, meaning),
        name.replace("%", "y"): Given(value.imag, unit, meaning),
    }


def number_of(lexicon: Lexicon, key: str) -> float:
    """The value of a quantity."""
    found = lexicon[canonical(key)].value
    assert isinstance(found, float)
    return found


def lines(texts: Sequence[str], places: Sequence[Place], words: Mapping[str, str] | None = None) -> Iterator[Line]:
    """The formulas worked out at these places, without terms and factors that are nothing in all of them.

    The left side of each is a quantity of the lexicons, or a number that is a function of some, as ``inv(alpha)``. The
    line gives its value by the program; one that is nothing is left out.
    An angle has from then on as many whole turns as its formula gives.
    """
    for text in texts:
        formula = simplified(read(filled(text, words or {})), _zeros(places))
        left, right = formula.sides
        if right in (ZERO, left):
            continue
        for place in places:
            given = result_of(left, place.lexicon)
            if given.unit == "deg" and isinstance(left, Name):
                place.lexicon[left.key] = _turned(given, value_of(right, place.lexicon, "deg"))
        yield Line(formula, tuple(places))


def _zeros(places: Sequence[Place]) -> set[str]:
    """Names that are nothing at every place."""
    found = set(places[0].lexicon)
    for place in places:
        found = {key for key in found if key in place.lexicon and _size(place.lexicon[key]) <= STILL}
    return found


def _size(given: Given) -> float:
    return abs(given.value) if isinstance(given.value, float) else math.inf


def _turned(given: Given, near: float) -> Given:
    """An angle [deg] with as many whole turns as bring it to ``near``."""
    assert isinstance(given.value, float)
    return given._replace(value=given.value + 360.0 * round((near - given.value) / 360.0))


def tabulated(
    caption: str,
    columns: Mapping[str, ArrayLike],
    labels: Sequence[str],
    *,
    head: str,
    key: str = "",
    digits: int = DIGITS,
) -> Table:
    """A table of columns over labelled rows; the numbers of a column have one last digit, the largest ``digits``.

    ``columns`` are headed by what they are, ``"$phi_3$, deg"`` with the unit of the values after the comma.
    """
    found = {head: list(labels), **dict(column(name, values, digits) for name, values in columns.items())}
    return Table(caption, tuple(found), tuple(zip(*found.values(), strict=True)), key)


def folded(table: Table, parts: int) -> Table:
    """A table of many rows with parts of it side by side, each under the head; the last may be shorter.

    >>> folded(Table("t", ("i", "x"), tuple((str(k), "") for k in range(14))), 3).rows[4]
    ('4', '', '9', '', '', '')
    """
    columns, count = len(table.head), len(table.rows)
    high = math.ceil(count / parts)
    padded = (*table.rows, *((("",) * columns,) * (parts * high - count)))
    rows = (sum((padded[k + part * high] for part in range(parts)), ()) for k in range(high))
    return table._replace(head=table.head * parts, rows=tuple(rows))


def column(name: str, values: ArrayLike, digits: int = DIGITS) -> tuple[str, list[str]]:
    """The head and the cells of a column ``"$phi_3$, deg"`` in the unit in which it is printed."""
    what, comma, own = name.partition(", ")
    unit, factor = printed_as(own)
    return headed(f"{what}{comma}{unit}"), column_of(np.asarray(values, dtype=float) * factor, digits)


def headed(head: str) -> str:
    """The head of a column with its unit, after a comma, in the language in force."""
    name, comma, unit = head.partition(", ")
    return name + (comma and f", {tr_unit(unit)}")


def spaced(steps: Sequence[Step]) -> list[Step]:
    """Of the steps of a course the first, the last, and between them some at growing distances.

    >>> spaced(range(30))
    [0, 1, 2, 5, 10, 20, 29]
    """
    last = len(steps) - 1
    return [steps[row] for row in sorted({0, last, *(row for row in STEPS if row < last)})]


def numeral(value: float, digits: int = DIGITS) -> str:
    """A number within a formula of a sentence.

    >>> numeral(0.0125), numeral(1 / 3), numeral(2.5e-7)
    ('0.0125', '0.33333', '2.5*10**(-7)')
    """
    mantissa, _, exponent = significant(value, digits).partition("e")
    return f"{mantissa}*10**({exponent})" if exponent else mantissa


def degrees(angle: float) -> str:
    """An angle [rad] within a formula of a sentence, in degrees.

    >>> degrees(math.pi / 8), degrees(-math.pi / 2)
    ('deg(22.5)', '-deg(90)')
    """
    value = round(math.degrees(angle), ANGLE) + 0.0
    return f"{'-' if value < 0 else ''}deg({numeral(abs(value))})"


def plainly(value: float, digits: int = DIGITS) -> str:
    """A number of a sentence.

    >>> plainly(-12.5)
    '−12.5'
    """
    return spelt(f"{value:.{digits}g}")


def as_given(value: float) -> str:
    """A number of a sentence that is given: as it was written, if ten digits tell it.

    >>> as_given(123.4567), as_given(-2 / 3)
    ('123.4567', '−0.66667')
    """
    return plainly(value, digits_given(value))


def cell(value: float, digits: int = DIGITS) -> str:
    """A number by itself in a cell or a sentence, with a power of ten as a formula.

    >>> cell(-0.25), cell(2.5e-7)
    ('−0.25', '$2.5*10**(-7)$')
    """
    text = numeral(value, digits)
    return f"${text}$" if "*" in text else spelt(text)


def held(condition: str, sides: tuple[float, float], unit: str, *, holds: bool) -> Paragraph:
    """A condition ``a <= b`` with the numbers of both sides, and whether it holds."""
    sign = next(each for each in SIGNS if each in condition)
    unit, factor = printed_as(unit)
    first, second = (numeral(factor * side) for side in sides)
    if unit == "deg":
        first, second, unit = f"deg({first})", f"deg({second})", ""
    told = f"${condition}$: ${first} {sign} {second}$" + (f" {tr_unit(unit)}" if unit else "")
    said = tr("The condition holds.") if holds else tr("The condition fails.")
    return Paragraph(f"{told}. {said}")


def quantities(caption: str, known: Mapping[str, Given], key: str = "", digits: int = DIGITS) -> Table:
    """A table of quantities: what each is, its symbol, unit and value."""
    return data_table(caption, data_of(known), key, digits)


def owned(name: str) -> Of:
    """Quantities of one among several: its name stands before what each is."""
    return lambda what: f"{name}: {what}"


def data_of(known: Mapping[str, Given], names: Iterable[str] | None = None, of: Of = str) -> Iterator[Datum]:
    """Quantities as what is given, angles in degrees: all, or of the ``names`` those that are there and are something.

    A shift that is nothing is something too.
    """
    for name in known if names is None else names:
        given = known.get(name) or known.get(canonical(name))
        if given is None or (names is not None and not given.value and name[0] != "x"):
            continue
        assert isinstance(given.value, float)
        turned = given.unit == "rad"
        value, unit = (math.degrees(given.value), "deg") if turned else (given.value, given.unit)
        yield Datum(of(given.meaning), (name,), (value,), unit)


def between(interpolation: str) -> str:
    """How values go from point to point."""
    return {
        "linear": tr("straight lines"),
        "pchip": tr("smooth monotone curve"),
        "spline": tr("cubic spline"),
    }[interpolation]


def in_rows(*lists: Datum) -> Iterator[Datum]:
    """Lists of equal length under each other, long ones part by part; a text in place of a list stands before them."""
    yield from (each for each in lists if each.text)
    lists = tuple(each for each in lists if not each.text)
    count = len(lists[0].values)
    parts = -(-count // CELL)
    ends = [count * part // parts for part in range(parts + 1)]
    for begin, end in pairwise(ends):
        for each in lists:
            said = tr("{what}, points {first} to {last}", what=each.what, first=begin + 1, last=end)
            yield each._replace(what=each.what if parts == 1 else said, values=each.values[begin:end])


def data_table(caption: str, data: Iterable[Block], key: str = "", digits: int = DIGITS) -> Table:
    """The data among these blocks as a table: what each is, its symbols, unit, and values or words.

    It has no column of units where none has one. Numbers that were written stand whole, others with ``digits``.
    """
    rows = []
    for each in data:
        if isinstance(each, Datum):
            unit, factor = printed_as(each.unit)
            scaled = [factor * value for value in each.values]
            values = "; ".join(cell(value, max(digits, digits_given(*scaled))) for value in scaled)
            shown = "°" if unit == "deg" else tr_unit(unit)
            rows.append((each.what, ", ".join(f"${name}$" for name in each.keys), shown, each.text or values))
    head = tr("Quantity"), tr("Designation"), tr("Unit"), tr("Value")
    if not any(unit for _, _, unit, _ in rows):
        return Table(caption, (*head[:2], head[3]), tuple((*row[:2], row[3]) for row in rows), key)
    return Table(caption, head, tuple(rows), key)


def drawn(caption: str, draw: Callable[[Drawing, Box], object], high: float, key: str) -> Figure:
    """A picture at the width of the note, ``high`` mm high, with words about as large as those of the text."""

    def lettered(drawing: Drawing, box: Box) -> object:
        with drawing.lettered(LETTERED):
            return draw(drawing, box)

    return Figure(caption, lettered, (WIDE, high), key)


def titled(heading: str) -> str:
    """What a drawing has as its heading, as the caption of a figure: its letters as those of formulas.

    Letters that make no formula, as those of a name of several, stand as words.

    >>> titled("Diagrams of $ΔS$, $S''$"), titled("at $S_{0}$ = 45 mm"), titled("$ψ$, $M_{54}/l_5$")
    ("Diagrams of $DeltaS$, $S''$", 'at $S_0$ = 45 mm', '$psi$, M54/l5')
    """
    parts = heading.replace("\n", " ").split("$")
    return "".join(_lettered(part) if k % 2 else part for k, part in enumerate(parts))


def _lettered(letters: str) -> str:
    """A name in letters of a drawing, as a formula has it."""
    spelt_out = "".join(LATIN.get(letter, letter) for letter in letters)
    name = re.fullmatch(NAME, spelt_out.replace("′", "'"))
    return f"${canonical(name[0])}$" if name else message(f"${letters}$")


def pictured(piece: Piece, *, key: str = "", wide: float = WIDE) -> Figure:
    """A picture of a sheet at the width of the note, as high as its proportions want."""
    least, good = piece.least, piece.good
    factor = max(wide / good[0], least[1] / good[1])
    return Figure(titled(piece.heading), piece.draw, (wide, min(factor * good[1], HIGH)), key)


def points(items: Sequence[str]) -> Listing:
    """Points of a list that end with semicolons, the last with a full stop.

    >>> points(["first", "second."]).items
    ('first;', 'second.')
    """
    bare = [item.rstrip(".;") for item in items]
    return Listing((*(f"{item};" for item in bare[:-1]), f"{bare[-1]}."))


def span(blocks: Sequence[Table | Figure]) -> str:
    """The numbers of tables, or of figures, that follow each other: ``2.1``, ``2.1–2.4``."""
    kind = "tab" if isinstance(blocks[0], Table) else "fig"
    return "–".join(dict.fromkeys(f"{{{kind}:{each.key}}}" for each in (blocks[0], blocks[-1])))


def located(blocks: Sequence[Table | Figure]) -> str:
    """Where tables, or figures, that follow each other are: ``in table 2.1``, ``in figures 2.1–2.4``."""
    numbers, several = span(blocks), len(blocks) > 1
    if isinstance(blocks[0], Table):
        return tr("in tables {numbers}", numbers=numbers) if several else tr("in table {numbers}", numbers=numbers)
    return tr("in figures {numbers}", numbers=numbers) if several else tr("in figure {numbers}", numbers=numbers)


def two_sides(labels: Sequence[str], groups: Iterable[ArrayLike], same: float = SAME) -> Iterator[Paragraph]:
    """What is said of the first and the last row, two sides of one position, where a column differs in them.

    A group has the columns (k, n) or the column (n,) of one unit; less than ``same`` of its largest value is rounding.

    >>> [*two_sides(("0", "1", "2"), [((5.0, 6.0, 5.0), (1e-13, 0.0, -1e-13))])]
    []
    """
    for values in map(np.atleast_2d, groups):
        if np.any(np.abs(values[:, 0] - values[:, -1]) > same * np.nanmax(np.abs(values), initial=0.0)):
            words = {"first": labels[0], "last": labels[-1]}
            said = tr("Rows {first} and {last} are one position, just after its jump and just before it.", **words)
            yield Paragraph(said)
            return


def row_of(name: str, unit: str, values: Sequence[float]) -> tuple[str, ...]:
    """A row of a table: a quantity with its unit, then its values, each with its own digits."""
    printed, factor = printed_as(unit)
    head = f"{name}, {tr_unit(printed)}" if printed else name
    return head, *(column_of([factor * value])[0] for value in values)


def column_of(values: ArrayLike, digits: int = DIGITS) -> list[str]:
    """Numbers of a column as they are printed: all to one last digit, zero without a sign; a dash where one is nan.

    >>> column_of([1.0, -0.00001, -123.456])
    ['1.00', '0.00', '−123.46']
    """
    numbers = np.asarray(values, dtype=float)
    largest = np.max(np.abs(numbers[np.isfinite(numbers)]), initial=0.0)
    exponent = int(f"{largest:.{digits - 1}e}".partition("e")[2])  # of the largest as it is printed
    last = exponent - digits + 1
    if PLAIN[0] < exponent < PLAIN[1]:
        texts = [spelt(f"{round(each, -last) + 0.0:.{max(0, -last)}f}") for each in numbers]
    else:
        texts = [f"${rounded(each, 10.0**last)}$" if math.isfinite(each) else "" for each in numbers]
    return [text if math.isfinite(each) else "–" for text, each in zip(texts, numbers, strict=True)]
