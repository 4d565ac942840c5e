"""The note as plain text, for a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tmmcalc.note.assembled import Equation, Grid, Image, Points, Text, Title, Written
from tmmcalc.report.formula.plain import plain

INDENT = "    "
UNDER = {1: "=", 2: "-"}


def text(blocks: Iterable[Written]) -> str:
    """The note, a formula a line."""
    return "\n".join(_block(block) for block in blocks) + "\n"


def _block(block: Written) -> str:
    match block:
        case Title(number, words, level):
            line = f"{number} {words}"
            return f"\n{line}\n{UNDER[level] * len(line)}" if level in UNDER else f"\n{line}"
        case Text():
            return _words(block)
        case Equation(parts, number, lead):
            formula = " = ".join(plain(part) for part in parts)
            said = f"{lead}: " if lead else ""
            return f"{INDENT}{said}{formula}{f'    ({number})' if number else ''}"
        case Grid(caption, head, rows):
            return f"{caption}\n{_grid([[_words(cell) for cell in row] for row in (head, *rows)])}"
        case Image(caption):
            return caption
        case Points(items):
            return "\n".join(f"- {_words(item)}" for item in items)


def _words(words: Text) -> str:
    return "".join(part if isinstance(part, str) else plain(part) for part in words.parts)


def _grid(rows: Sequence[Sequence[str]]) -> str:
    wide = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join(
        INDENT + "  ".join(cell.ljust(size) for cell, size in zip(row, wide, strict=True)).rstrip() for row in rows
    )
