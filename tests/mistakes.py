"""What comes of mistakes in a spec: asked results by name, and the values with a mistake."""

from __future__ import annotations

import math
from pathlib import Path

from tmmcalc.classroom.keying import key_of, told_of
from tmmcalc.classroom.model import Item, Key
from tmmcalc.project import load_spec, parse_spec

CONFIGS = Path(__file__).parents[1] / "configs"


def item(result: str, unit: str, *, either: bool = False, within: float = 0.0, tolerance: float = 0.01) -> Item:
    """An asked result of this name."""
    return Item(result, (), result, unit, tolerance, within, 0.03, 1.0, 4, (), either)


def items(*asked: str) -> tuple[Item, ...]:
    """Asked results, each "name unit"."""
    return tuple(item(*each.rpartition(" ")[::2]) for each in asked)


def key(spec: str, asked: tuple[Item, ...], *mistakes: str, sets: tuple[str, ...] = ()) -> Key:
    """The key of a ready spec, or of a text, with these mistakes."""
    ready = CONFIGS / f"{spec}.toml"
    found = parse_spec(spec, overrides=sets) if "\n" in spec else load_spec(ready, sets)
    return key_of(1, "", found, asked, tuple(map(told_of, mistakes)))


def wrong(spec: str, mistake: str, *asked: str, sets: tuple[str, ...] = ()) -> list[float]:
    """The values of asked results with a mistake; those that it does not change are the right ones."""
    found = key(spec, items(*asked), mistake, sets=sets)
    return [right if math.isnan(own) else own for own, right in zip(found.mistaken[0], found.values, strict=True)]


def right(spec: str, *asked: str, sets: tuple[str, ...] = ()) -> list[float]:
    """The right values."""
    return list(key(spec, items(*asked), sets=sets).values)
