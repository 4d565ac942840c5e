"""Texts from outside, such as names of files and values of a spec, made fit to be shown.

A text may hold characters that steer a terminal, that turn the order of those after them, or that have no form at all.
Shown as they are they could hide what stands there or say what nobody has written; an XML file cannot hold most.
"""

from __future__ import annotations

import re

_HIDDEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f"  # controls of terminals, but tab and line break
    "\u200b\u2060-\u2064\ufeff"  # no width
    "\u061c\u200e\u200f\u202a-\u202e\u2066-\u206f"  # order of writing
    "\u2028\u2029"  # breaks of lines that only some programs see
    "\ufff9-\ufffb\ufffe\uffff\ud800-\udfff"  # no characters; bytes of a file name that are no UTF-8
    "\U000e0000-\U000e007f]"  # tags
)


def printable(text: str) -> str:
    r"""Return a text whose hidden characters are written out; line breaks, which part the lines of messages, stay.

    >>> print(printable("a\x1b[31m\u202eb"))
    a\x1b[31m\u202eb
    """
    return _HIDDEN.sub(lambda match: escape(match.group()), text).replace("\t", "\\t")


def escaped(text: str) -> str:
    """The same for a file of JSON or TOML, both of which read ``\\u202e`` in quotes as the character that it names."""
    return _HIDDEN.sub(lambda match: _in_quotes(match.group()), text)


def hidden(text: str) -> str:
    """The first hidden character of a text, tabs and line breaks among them; empty if there is none."""
    found = _HIDDEN.search(text)
    return found.group() if found else next((sign for sign in "\n\t" if sign in text), "")


def escape(character: str) -> str:
    """How a hidden character is written: ``\\x1b``, ``\\u202e``."""
    return character.encode("unicode_escape").decode()


def _in_quotes(character: str) -> str:
    """A character beyond the first plane, and half of a pair, have no form that both JSON and TOML read."""
    code = ord(character)
    return f"\\\\u{code:04x}" if 0xD800 <= code <= 0xDFFF or code > 0xFFFF else f"\\u{code:04x}"
