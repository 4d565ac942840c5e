"""Which figures and tables of a chapter no text before them names."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tmmcalc.report.manuscript import Block, Figure, Listing, Paragraph, Table

NAMED = re.compile(r"\{(tab|fig):(\w+)\}(?:–\{\1:(\w+)\})?")


def unnamed(blocks: Sequence[Block]) -> Iterator[str]:
    """The captions of what no text before it names; of a span of numbers the first and the last stand in the text."""
    keys = {
        kind: [each.key for each in blocks if isinstance(each, of)] for kind, of in (("tab", Table), ("fig", Figure))
    }
    known: set[tuple[str, str]] = set()
    for block in blocks:
        match block:
            case Paragraph(text):
                known |= set(named(text, keys))
            case Listing(items):
                known |= {found for item in items for found in named(item, keys)}
            case Table() | Figure():
                kind = "tab" if isinstance(block, Table) else "fig"
                if (kind, block.key) not in known:
                    yield f"{kind}:{block.key} {block.caption}"


def named(text: str, keys: dict[str, list[str]]) -> Iterator[tuple[str, str]]:
    """What a text names, with all between the ends of a span."""
    for kind, first, last in NAMED.findall(text):
        every = keys[kind]
        if last:
            yield from ((kind, key) for key in every[every.index(first) : every.index(last) + 1])
        elif first in every:
            yield kind, first
