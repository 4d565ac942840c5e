"""What tests of the given data share: every number of a spec changed by itself, letters that stand for several things.

What is given has to change with every number, but for settings of the program.
"""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

from tmmcalc.core.errors import TmmError
from tmmcalc.project import Spec
from tmmcalc.project.loader import Variants
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.manuscript import Block, Datum

QUANTITY = re.compile(r"\s*([-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)(\s+\S.*)?")
OTHER = (1.07, 0.95, 1.5, 0.5)  # of a number: the first that the spec allows
SMALL = (0.013, -0.013, 1e-4)  # in place of nothing
PARTS = re.compile(r", points \d+ to \d+$")  # of a long list
ALONG = re.compile(r"(angle of the crank|travel of the drive) from the first position")  # phi and Deltas of places


def data_of(blocks: Iterable[Block]) -> list[Datum]:
    """The rows of the table."""
    return [block for block in blocks if isinstance(block, Datum)]


def numbers_of(node: Any, path: str = "") -> Iterator[tuple[str, float, str]]:
    """Keys, numbers and units of a document; whole ones are int."""
    if isinstance(node, dict):
        for key, own in node.items():
            name = key if re.fullmatch(r"\w+", key) else json.dumps(key)
            yield from numbers_of(own, f"{path}.{name}" if path else name)
    elif isinstance(node, list):
        for k, own in enumerate(node):
            yield from numbers_of(own, f"{path}[{k}]")
    elif isinstance(node, str) and (found := QUANTITY.fullmatch(node)):
        yield path, float(found[1]), found[2] or ""
    elif isinstance(node, int | float) and not isinstance(node, bool):
        yield path, node, ""


def changed(value: float) -> Iterator[float]:
    """Other numbers than this one, whole ones first where it is whole."""
    if isinstance(value, int):
        yield from (value + 1, value - 1, *((-value,) if value else ()))
    yield from (value * each for each in OTHER) if value else SMALL


class Untold(NamedTuple):
    """Keys of numbers whose change leaves what is given as it is, and of those that cannot be changed."""

    same: list[str]
    refused: list[str]


def untold(words: str, variants: Variants, first: list[Datum], told: Callable[[Spec], list[Datum]]) -> Untold:
    """Every number of a spec in turn; ``told`` is what is given of a changed one, ``first`` that of the spec itself."""
    found = Untold([], [])
    for path, value, unit in numbers_of(tomllib.loads(words)):
        for other in changed(value):
            written = json.dumps(f"{other}{unit}") if unit else str(other)
            try:
                data = told(variants.spec([f"{path}={written}"]))
            except TmmError:
                continue
            if data == first:
                found.same.append(path)
            break
        else:
            found.refused.append(path)
    return found


def ambiguous(data: Iterable[Datum], thing: Callable[[str], str] = str) -> dict[str, set[str]]:
    """Letters that stand for several things; ``thing`` of what a datum is.

    Lists in parts have one letter, and what is counted along the motion, whatever stands there.
    """
    things: dict[str, set[str]] = {}
    for each in data:
        for key in each.keys:
            along = ALONG.search(each.what) if key in ("phi", "Deltas") else None
            things.setdefault(canonical(key), set()).add(along[0] if along else thing(PARTS.sub("", each.what)))
    return {key: found for key, found in things.items() if len(found) > 1}
