"""The note as plain text, for a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tmmcalc.note.tree import (
    Contents,
    Cover,
    Equation,
    Grid,
    Image,
    Points,
    Source,
    Text,
    Title,
    Written,
    plain_text,
)
from tmmcalc.report.formula.plain import plain

INDENT = "    "
UNDER = {1: "=", 2: "-"}


def text(blocks: Iterable[Written]) -> str:
    """The note, a formula a line; without contents."""
    return "\n".join(_block(block) for block in blocks if not isinstance(block, Contents)) + "\n"


def _block(block: Written) -> str:
    match block:
        case Cover(head, kind, title, people, foot, designation):
            told = [*head, *kind, title, designation, *(f"{what}: {name}" for what, name in people), foot]
            return "\n".join(line for line in told if line)
        case Title(_, _, level):
            line = str(block)
            return f"\n{line}\n{UNDER[level] * len(line)}" if level in UNDER else f"\n{line}"
        case Text():
            return plain_text(block)
        case Equation(parts, number, lead):
            formula = " = ".join(plain(part) for part in parts)
            said = f"{lead}: " if lead else ""
            return f"{INDENT}{said}{formula}{f'    ({number})' if number else ''}"
        case Grid(caption, head, rows):
            return f"{caption}\n{_grid([[plain_text(cell) for cell in row] for row in (head, *rows)])}"
        case Image(caption):
            return str(caption)
        case Points(items):
            return "\n".join(f"- {plain_text(item)}" for item in items)
        case Source(lines):
            return "\n".join(INDENT + line if line else "" for line in lines.splitlines())
        case Contents(title):
            return title


def _grid(rows: Sequence[Sequence[str]]) -> str:
    wide = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join(
        INDENT + "  ".join(cell.ljust(size) for cell, size in zip(row, wide, strict=True)).rstrip() for row in rows
    )
