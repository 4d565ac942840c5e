"""Characters that nobody sees in the keys and texts of a spec: they are refused, with their places."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.printable import escape
from tmmcalc.core.printable import hidden as hidden_in
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Raw
from tmmcalc.spec.phrases import Path, show

_MARKS = ("\\", '"""', "'''", "\t")  # without them an ASCII text that is valid TOML can name no hidden character
_NAMES = {"\t": "a tab", "\n": "a line break", "\r": "a line break"}


def may_hide(text: str) -> bool:
    """Whether a TOML text can name a hidden character at all: a first glance at every spec."""
    return any(mark in text for mark in _MARKS) or not (text.isascii() or text.isprintable())


def hidden(data: Raw) -> list[Finding]:
    """Findings of all hidden characters in the keys and texts of a document."""
    return list(_of_value(data, ()))


def _of_value(value: object, path: Path) -> Iterator[Finding]:
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from _of_text(key, (*path, key), "the key ")
            yield from _of_value(inner, (*path, key))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from _of_value(inner, (*path, index))
    elif isinstance(value, str):
        yield from _of_text(value, path, "")


def _of_text(text: str, path: Path, what: str) -> Iterator[Finding]:
    if sign := hidden_in(text):
        remedy = "write it on one line" if sign in "\r\n" else "write it without this character"
        yield Finding(path, f"{what}{show(text)} holds {_described(sign)}", remedy)


def _described(sign: str) -> str:
    r"""What a hidden character is called.

    >>> _described("\x1b"), _described("\u202e")
    ('the control character \\x1b', 'the hidden character \\u202e, right-to-left override')
    """
    if sign in _NAMES:
        return _NAMES[sign]
    from unicodedata import name  # late: only faults need it

    called = name(sign, "")
    return (
        f"the hidden character {escape(sign)}, {called.lower()}" if called else f"the control character {escape(sign)}"
    )
