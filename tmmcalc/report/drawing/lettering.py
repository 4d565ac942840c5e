"""Lettering: words with indices, Greek letters and operators, as pieces of one font, measured.

Words stand as they are. Between two ``$`` stands a formula: letters of quantities are italic, digits, capital Greek
letters, operators and words of several letters upright, as is a Δ before its letter; ``_`` lowers the letter or the
braces after it, ``^`` raises them, both upright. ``\\$`` is the sign itself.

    Position 6', $φ$ = 45°       $μ_l$ = 0.004 m/mm       $R_{21}$       $ω_1^2$

A height is that of capital letters, as standards of lettering count it (ISO 3098, GOST 2.304): 3.5, 5, 7 mm.
"""

from __future__ import annotations

import json
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from tmmcalc.core.errors import UsageError

FONTS = Path(__file__).parent.parent / "fonts"
FAMILY = "TMM Text"
SMALLER = 0.7  # height of an index to that of its letter
LOWERED, RAISED = -0.28, 0.48  # of the height of capitals
HIGHER = 0.12  # and so much more is raised what stands over an index
NUMBERED = re.compile("([A-Za-z])([0-9]+'*)")  # a name that reads as a letter with an index
UNKNOWN = {"\u2060": 0.0, "\u202f": 0.12}  # signs that the font has not: one that joins words, a thin space [em]
LEADING = 1.75  # from line to line, of the height of capitals


class Piece(NamedTuple):
    """Letters of one face, size and level."""

    text: str
    italic: bool = False
    size: float = 1.0  # of the height of the words
    rise: float = 0.0  # of the baseline, of the height of the words


class Placed(NamedTuple):
    """A piece with its place on the line, lengths in heights of the words."""

    piece: Piece
    start: float
    width: float


@cache
def faces() -> dict[str, Any]:
    """Sizes of both faces in parts of the em."""
    found: dict[str, Any] = json.loads((FONTS / "widths.json").read_text(encoding="utf-8"))
    return found


@cache
def pieces(text: str) -> tuple[Piece, ...]:
    """The pieces of a line; raises `UsageError` for a letter that the font has not, or a formula without end.

    >>> [(p.text, p.italic, p.size) for p in pieces("$R_{21}$, N")]
    [('R', True, 1.0), ('21', False, 0.7), (', N', False, 1.0)]
    """
    parts = text.replace("\\$", "\0").split("$")
    if len(parts) % 2 == 0:
        raise UsageError(f"a formula of {text!r} has no end", remedy="write $ on both sides of it")
    found: list[Piece] = []
    for k, part in enumerate(parts):
        if part:
            found += _formula(part.replace("'", "′"), 1.0, 0.0) if k % 2 else [Piece(part.replace("\0", "$"))]
    for piece in found:
        if lacking := sorted(set(piece.text) - set(faces()[_face(piece)]["advance"])):
            raise UsageError(f"the font of drawings has no letter {', '.join(map(repr, lacking))} of {text!r}")
    return tuple(found)


def _formula(text: str, size: float, rise: float) -> Iterator[Piece]:
    at = 0
    while at < len(text):
        if text[at] in "_^" and at + 1 < len(text):
            inner, end = _argument(text, at + 1)
            yield from _index(inner, size, rise + size * (LOWERED if text[at] == "_" else RAISED))
            at = end
            continue
        end = at + 1
        if text[at].isalpha():
            while text[at] != "Δ" and end < len(text) and text[end].isalpha():
                end += 1
            word = text[at:end]
            yield Piece(word, len(word) == 1 and not "Α" <= word <= "Ω", size, rise)
        else:
            while end < len(text) and not text[end].isalpha() and text[end] not in "_^":
                end += 1
            yield Piece(text[at:end], False, size, rise)
        at = end


def _argument(text: str, at: int) -> tuple[str, int]:
    """What is lowered or raised, and where the text goes on."""
    if text[at] != "{":
        return text[at], at + 1
    depth = 0
    for end in range(at, len(text)):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if depth == 0:
            return text[at + 1 : end], end + 1
    raise UsageError(f"a brace of {text!r} is not closed")


def _index(text: str, size: float, rise: float) -> Iterator[Piece]:
    """An index, upright, which may have one of its own."""
    head, mark, rest = text.partition("_")
    if head:
        yield Piece(head, False, size * SMALLER, rise)
    if mark and rest:
        inner, end = _argument(rest, 0)
        yield from _index(inner, size * SMALLER, rise + LOWERED * size * SMALLER)
        if rest[end:]:
            yield from _index(rest[end:], size, rise)


def _face(piece: Piece) -> str:
    return "italic" if piece.italic else "regular"


def em(piece: Piece) -> float:
    """Size of the font of a piece, in heights of the words."""
    return float(piece.size / faces()[_face(piece)]["capital"])


@cache
def line(text: str) -> tuple[Placed, ...]:
    """The pieces of a line with their places; an index below and one above the same letter stand one over the other."""
    found: list[Placed] = []
    at = start = 0.0
    before: Piece | None = None
    for piece in pieces(text):
        over = before is not None and before.rise * piece.rise < 0
        begin = start if over else at
        if over and before is not None and before.rise > 0:
            found[-1] = found[-1]._replace(piece=before._replace(rise=before.rise + HIGHER))
        width = em(piece) * sum(faces()[_face(piece)]["advance"][letter] for letter in piece.text)
        found.append(Placed(piece, begin, width))
        start, at, before = begin, max(at, begin + width), piece
    return tuple(found)


def advance(text: str) -> float:
    """Width of upright letters as they are, without formulas [em]; a letter that is not known is as wide as a digit.

    >>> round(advance("3.15 m"), 3)
    2.817
    """
    return sum(map(_advances().__getitem__, text))


@cache
def _advances() -> dict[str, float]:
    known = faces()["regular"]["advance"]
    return defaultdict(lambda: float(known["0"]), UNKNOWN | known)


def width(text: str, height: float = 1.0) -> float:
    """Width of the widest line of words of this height.

    >>> round(width("mm", 5.0), 2)
    12.97
    """
    return height * max(max((p.start + p.width for p in line(row)), default=0.0) for row in text.split("\n"))


def wrapped(text: str, wide: float, height: float) -> list[str]:
    """The words of a text in lines no wider than this [mm], as far as single words allow; a formula stays whole.

    >>> wrapped("sum of shifts: $x_1 + x_2$", 25.0, 2.5)
    ['sum of shifts:', '$x_1 + x_2$']
    """
    rows: list[str] = []
    for word in text.split(" "):
        joined = f"{rows[-1]} {word}" if rows else word
        whole = not rows or not _unclosed(rows[-1])
        if rows and whole and width(joined + "$" * _unclosed(joined), height) > wide:
            rows.append(word)
        else:
            rows[-1:] = [joined]
    return rows


def _unclosed(text: str) -> bool:
    """Whether a formula has begun in it and not ended."""
    return text.replace("\\$", "").count("$") % 2 == 1


def extent(text: str, height: float = 1.0) -> tuple[float, float]:
    """How far the first line reaches above its baseline, and the last one below its own, as letters are drawn."""
    rows = [line(row) for row in text.split("\n")]
    above = max((p.piece.rise + p.piece.size * _tall(p.piece) for p in rows[0]), default=1.0)
    below = max((p.piece.size * _deep(p.piece) - p.piece.rise for p in rows[-1]), default=0.0)
    return height * above, height * max(below, 0.0)


def _tall(piece: Piece) -> float:
    """Height of its letters in that of capitals."""
    low = set(piece.text) <= set("acegmnopqrsuvwxyzαγεηικμνοπρστυφχψωагєеиноптшмвлкя.,·− ")
    sizes = faces()[_face(piece)]
    return float(sizes["small"] / sizes["capital"]) if low else 1.08


def _deep(piece: Piece) -> float:
    return 0.33 if set(piece.text) & set("gjpqyβγζημξρφχψςQ,;()[]{}/|уцщрфґї") else 0.02


def minus(text: str) -> str:
    """A number with a true minus sign."""
    return text.replace("-", "−")


def plain(text: str) -> str:
    """A text that somebody gave, as it is: no formula begins in it."""
    return text.replace("$", "\\$")


def message(text: str) -> str:
    """What is drawn, in the letters of a message.

    >>> message("$M_{54}/l_5$, $a_{BA}^n$")
    'M54/l5, aBAn'
    """
    return " ".join("".join(piece.text for piece in pieces(row)) for row in text.split("\n"))


def symbol(letter: str, index: str = "") -> str:
    """The sign of a quantity as a formula: one letter with its index, or a longer name as it is.

    >>> symbol("R", "21"), symbol("Q5"), symbol("gas")
    ('$R_{21}$', '$Q_{5}$', 'gas')
    """
    numbered = NUMBERED.fullmatch(letter)
    if not index and numbered:
        letter, index = numbered[1], numbered[2]
    if len(letter) > 1:
        return letter
    return f"${letter}_{{{index}}}$" if index else f"${letter}$"


def point_name(name: str) -> str:
    """The name of a point, italic: its first letter with the rest as an index where that is a number.

    >>> point_name("B"), point_name("S3"), point_name("B_0"), point_name("pivot")
    ('$B$', '$S_{3}$', '$B_{0}$', 'pivot')
    """
    numbered = NUMBERED.fullmatch(name.replace("_", "", 1))
    return f"${numbered[1]}_{{{numbered[2]}}}$" if numbered else f"${name}$" if len(name) == 1 else name
