"""The small pieces that every message about a spec is built from."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

Said = tuple[str, str]  # words for a fault: a rule and a remedy, or a rule and an example
Path = tuple[str | int, ...]  # a place in a TOML document: keys and indices, as pydantic's ``loc``

_SHOWN = 60  # characters of a value that a message shows
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def show(value: object) -> str:
    """Return a value as a message shows it: as TOML writes it, cut to one short line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, list):
        text = "[" + ", ".join(show(item) for item in value[:8]) + (", ...]" if len(value) > 8 else "]")
    elif isinstance(value, str):
        text = f"'{value}'" if value.isprintable() else repr(value)
    elif isinstance(value, int) and value.bit_length() > 200:
        return "a number of more than 60 digits"
    else:
        text = str(value)
    return text if len(text) <= _SHOWN else text[: _SHOWN - 4] + " ..."


def show_key(key: str) -> str:
    """Return a key as TOML writes it: in quotes where it needs them."""
    if _BARE_KEY.fullmatch(key):
        return key
    return f'"{key}"' if key.isprintable() and '"' not in key else repr(key)


def show_path(path: Path) -> str:
    """Return a place as text.

    >>> show_path(("mechanism", "links", 2, "mass"))
    'mechanism.links[2].mass'
    """
    text = ""
    for step in path:
        text += f"[{step}]" if isinstance(step, int) else f".{show_key(step)}" if text else show_key(step)
    return text


def either(words: Iterable[str]) -> str:
    """Join words with commas and a last "or"."""
    *first, last = words
    return f"{', '.join(first)} or {last}" if first else last


def listing(words: Iterable[object]) -> str:
    """Join words with commas; "none" if there are none."""
    return ", ".join(str(word) for word in words) or "none"


def nearest(word: str, known: Sequence[str]) -> str | None:
    """Return the known word that the written one was meant to be, None if nothing is near."""
    folded = {name.casefold(): name for name in reversed(known)}
    if word.casefold() in folded:
        return folded[word.casefold()]
    from difflib import get_close_matches  # late: only faults need it

    found = get_close_matches(word.casefold(), folded, n=1, cutoff=0.6)
    return folded[found[0]] if found else None


def did_you_mean(word: str, known: Sequence[str]) -> str:
    """Return 'did you mean "x"?' for the nearest known word, else an empty text."""
    guess = nearest(word, known)
    return f'did you mean "{guess}"?' if guess else ""
