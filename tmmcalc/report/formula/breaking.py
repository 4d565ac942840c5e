"""A formula broken into lines: at relations, between terms, between factors, at last within what holds others."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cache, lru_cache

from tmmcalc.report.formula import layout

SMALL, AFTER = 0.78, 0.06  # width of an index against its letters, and what is free after it [em]
GAP, SPACE = 0.17, 0.56  # a thin space, a relation with its spaces, and such [em]
DIGIT, CAPITAL, LETTER = 0.5, 0.78, 0.55
WIDE = {
    "m": 0.88,
    "w": 0.72,
    "M": 0.97,
    "H": 0.9,
    "W": 1.03,
    "i": 0.28,
    "l": 0.3,
    "ш": 0.85,
    "ж": 0.8,
    "ω": 0.64,
    "σ": 0.6,
    "x": 0.58,
}
WIDE |= {"·": 0.28, ".": 0.28, ",": 0.28, "−": 0.78, "I": 0.38}

TERMS = {"+", "−"}


@lru_cache(maxsize=1 << 15)
def width(box: layout.Box) -> float:
    """About how wide it is [em], rather more than less."""
    match box:
        case layout.Row(boxes):
            return sum(map(width, boxes))
        case layout.Letter(text) | layout.Word(text) | layout.Digits(text):
            return sum(map(_letter, text))
        case layout.Sign(text, leads=leads):
            return {"·": 0.73, ";": 0.45}.get(text, 0.78 + (0.0 if leads else SPACE))
        case layout.Gap():
            return GAP
        case layout.Fraction(over, under):
            return max(width(over), width(under)) + 0.2
        case layout.Marked(inner, mark):
            return width(inner) + 0.4 * len(mark)
        case layout.Root(inner):
            return width(inner) + 1.0
        case layout.Script(base, lower, upper, primes):
            below = 0.0 if lower is None else width(lower)
            above = 0.3 * primes + (0.0 if upper is None else width(upper))
            return width(base) + SMALL * max(below, above) + AFTER
        case layout.Fenced(inner):
            return width(inner) + 0.85
        case layout.Big(_, lower, body):
            return max(1.5, SMALL * width(lower)) + width(body)
        case layout.Arrowed(inner):
            return width(inner) + 0.2


@cache
def _letter(letter: str) -> float:
    """About how wide a letter is [em]."""
    return WIDE.get(letter, DIGIT if letter.isdigit() else CAPITAL if letter.isupper() else LETTER)


def broken(parts: Sequence[layout.Row], wide: float) -> list[layout.Row]:
    """The parts of a line, joined by equality, as rows no wider than ``wide`` [em] as far as they can be broken.

    A row that goes on begins with the sign at which it was broken; the first part has at least one piece beside it.
    """
    joined = [(*([layout.Sign("=", main=True)] if k else []), *_flat(part)) for k, part in enumerate(parts)]
    whole = layout.Row(tuple(box for boxes in joined for box in boxes))
    if width(whole) <= wide:
        return [whole]
    rows: list[list[layout.Box]] = []
    free = wide
    for k, boxes in enumerate(joined):
        for j, piece in enumerate(_pieces(layout.Row(boxes), free if k == 1 else wide)):
            size = _wide(piece)
            if rows and (size <= free or (k == 1 and not j)):
                rows[-1] += piece
                free -= size
            else:
                rows.append(piece)
                free = wide - size
    return [layout.Row(tuple(row)) for row in rows]


def _flat(part: layout.Row) -> tuple[layout.Box, ...]:
    """The boxes of a row, those of a single row within it where it is all there is."""
    while len(part.boxes) == 1 and isinstance(part.boxes[0], layout.Row):
        part = part.boxes[0]
    return part.boxes


def _pieces(row: layout.Row, wide: float) -> list[list[layout.Box]]:
    """The row whole where it fits; else cut before its main signs, and before the points between factors."""
    if width(row) <= wide:
        return [list(row.boxes)]
    found: list[list[layout.Box]] = [[]]
    for box in row.boxes:
        if isinstance(box, layout.Sign) and box.main and found[-1]:
            found.append([])
        found[-1].append(box)
    return [part for piece in found for part in _by_factors(piece, wide)]


def _by_factors(piece: list[layout.Box], wide: float) -> list[list[layout.Box]]:
    if _wide(piece) <= wide:
        return [piece]
    boxes = [each for box in piece for each in (box.boxes if isinstance(box, layout.Row) else (box,))]
    found: list[list[layout.Box]] = [[]]
    for box in boxes:
        if isinstance(box, layout.Sign) and box.text == "·" and _wide(found[-1]) > wide / 2:
            found.append([])
        found[-1].append(box)
    return [part for each in found for part in _opened(each, wide)]


def _opened(piece: list[layout.Box], wide: float) -> list[list[layout.Box]]:
    """A piece that is too wide cut at the signs within its widest fraction, root or bracket, which is written out."""
    within = [k for k, box in enumerate(piece) if isinstance(box, layout.Fraction | layout.Root) or _fence(box)]
    if _wide(piece) <= wide or not within:
        return [piece]
    k = max(within, key=lambda k: width(piece[k]))
    found: list[list[layout.Box]] = [[]]
    for box in (*piece[:k], *_written_out(piece[k]), *piece[k + 1 :]):
        if isinstance(box, layout.Sign) and box.text in TERMS and not box.leads:
            found.append([])
        found[-1].append(box)
    return [part for each in found if each for part in _by_factors(each, wide)]


def _fence(box: layout.Box) -> layout.Fenced | None:
    """The bracket that a box is, or is a power of."""
    base = box.base if isinstance(box, layout.Script) else box
    return base if isinstance(base, layout.Fenced) else None


def _written_out(box: layout.Box) -> list[layout.Box]:
    """A fraction with a stroke, a root as a power, a bracket as signs of their own: what a line may end within."""
    if isinstance(box, layout.Fraction):
        return [*_operand(box.over, TERMS), layout.Word("/"), *_operand(box.under, {*TERMS, "·"})]
    if isinstance(box, layout.Root):
        exponent = layout.Row((layout.Word("1/"), layout.Digits("2") if box.degree is None else box.degree))
        box = layout.Script(layout.Fenced(box.inner), upper=exponent)
    fence = _fence(box)
    assert fence is not None
    closing: layout.Box = layout.Word(fence.closing)
    if isinstance(box, layout.Script):
        closing = box._replace(base=closing)
    return [layout.Word(fence.opening), *_boxes(fence.inner), closing]


def _operand(box: layout.Box, signs: Collection[str]) -> Sequence[layout.Box]:
    """What stands before or after a stroke: in brackets if one of these signs is in it."""
    boxes = _boxes(box)
    loose = any(isinstance(each, layout.Sign | layout.Gap) and getattr(each, "text", "·") in signs for each in boxes)
    return [layout.Fenced(box)] if loose else boxes


def _boxes(box: layout.Box) -> tuple[layout.Box, ...]:
    return _flat(box) if isinstance(box, layout.Row) else (box,)


def _wide(boxes: Iterable[layout.Box]) -> float:
    return sum(map(width, boxes))
