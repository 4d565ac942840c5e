"""Limits of a TOML text, looked for before it is read: reading what is far beyond them takes hours or all memory.

A key of n parts takes time and memory as n^2, brackets within brackets take the stack, an integer of thousands of
digits Python itself refuses.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

MOST_BYTES = 1_000_000  # of a spec; one of a hundred links has some thirty thousand
MOST_PARTS = 16  # of a dotted key; the keys of a spec have up to five
MOST_DEPTH = 16  # of brackets; the values of a spec have up to four
MOST_SIGNS = 300  # of a number or a bare key; a float is less than 1e309

# Each alternative takes its signs for good, so that the time is that of one walk whatever the text.
_TOKEN = (
    r'"""(?:[^"\\]++|\\.|"(?!""))*+"{0,5}'
    r"|'''(?:[^']++|'(?!''))*+'{0,5}"
    r'|"(?:[^"\\\n]++|\\[^\n])*+"?'
    r"|'[^'\n]*+'?"
    r"|\#[^\n]*+"
    r"|[\[\]{}.,=\n]"
    r"|[\w+-]++"
)


class Beyond(NamedTuple):
    """What is beyond a limit: where it stands in the text, what it is, what to write instead."""

    at: int  # characters before it
    message: str
    remedy: str


def beyond(text: str) -> Beyond | None:
    """The first place of a text that is beyond a limit; None if all is within."""
    return next(_beyond(text), None)


def is_suspect(text: str) -> bool:
    """Whether a line could hold what is beyond a limit and would not be survived: a first glance at every text."""
    return any(len(line) > MOST_SIGNS or line.count(".") > MOST_PARTS for line in text.split("\n"))


def _beyond(text: str) -> Iterator[Beyond]:
    depth = dots = 0
    for match in re.finditer(_TOKEN, text, re.DOTALL):  # compiled when it is needed, which is seldom
        token, at = match.group(), match.start()
        if token == ".":
            dots += 1
            if dots >= MOST_PARTS:
                yield Beyond(at, f"a key of more than {MOST_PARTS} parts", "the keys of a spec have up to five")
        elif token in "[{":
            dots, depth = 0, depth + 1
            if depth > MOST_DEPTH:
                yield Beyond(
                    at,
                    f"lists or tables are nested too deeply, more than {MOST_DEPTH} within one another",
                    "a spec needs no more than five levels; look for a bracket that is not closed",
                )
        elif token in "]}":
            dots, depth = 0, depth - 1
        elif token in ",=\n":
            dots = 0
        elif len(token) > MOST_SIGNS and token[0] not in "\"'#":
            yield Beyond(
                at,
                f"a number or key of {len(token)} signs, more than {MOST_SIGNS}",
                "write a number of ordinary size, such as 1.5e6",
            )
