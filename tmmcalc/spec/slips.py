"""Slips of TOML in plain words: what stands on the line tells more than the parser's words do.

Loaded only when a text is no TOML.
"""

from __future__ import annotations

import re

from tmmcalc.core.errors import Fault
from tmmcalc.spec.cyrillic import LETTERS, latin_key, latin_units, stranger
from tmmcalc.spec.phrases import show

_SEEN = 1000  # characters of a line in which slips are looked for
_CYRILLIC_KEY = re.compile(rf"""[\s\[]*+((?=[\w.-]*[{LETTERS}])[\w.-]++)\s*+[=\]"']""")  # without quotes
_PLACE = re.compile(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", re.DOTALL)

_TWO_BRACKETS = "several links or joints begin, each of them, with two brackets: [[mechanism.links]]"

# Slips seen on the line itself: what stands there tells more than the parser's words. Groups fill the remedy.
_LINE_REMEDIES = (
    (r"=\s*([+-]?\d+),(\d+)\s*(?:#.*)?$", r"numbers have a decimal point: \1.\2"),
    (
        rf"[=\[,]\s*([+-]?\d+),(\d+)\s*([A-Za-zµ°{LETTERS}][^,\]}}#\s]*)",
        r'a quantity with a unit stands in quotes, with a decimal point: "\1.\2 \3"',
    ),
    (
        rf"[=\[,]\s*([+-]?[\d.]+)\s*((?![eExob][+-]?\d)[A-Za-zµ°{LETTERS}][^,\]}}#\s]*)",
        r'a quantity with a unit stands in quotes: "\1 \2"',
    ),
    (r"[=\[,]\s*(\.\d+)", r"a number begins with a digit: 0\1"),
    (r"[=\[,]\s*([+-]?\d+\.)(?:\D|$)", r"a number has a digit after its point: \g<1>0"),
    (r"[=\[,]\s*[+-]?0\d", "a number has no leading zeros"),
    (r"^\s*(\w+')\s*=", r'a key with a prime stands in double quotes: "\1" = [0, 0]'),
    (r"[“”„«»]", 'quotes are the plain ones: "'),
    (r"=\s*(?:True|False|yes|no)\b", "write true or false"),
    (r"=\s*([^\W\d][\w -]*?)\s*(?:#.*)?$", r'a text stands in quotes: "\1"'),
    (r"^\s*([\w.-]+)\s*:", r"a key and its value are joined by =: \1 = ..."),
)
_MESSAGE_REMEDIES = (
    ("Cannot mutate immutable", "a list or table closed by its bracket takes no more elements"),
    ("Expected '='", 'write key = value, such as speed = "55 rpm"'),
    ("Unclosed array", "close the list with ]"),
    ("Unclosed inline table", "close the table with }"),
    ("inline table", 'an inline table stands on one line: { through = "B", angle = "0 deg" }'),
    ("Illegal character '\\n'", "close the quotes on the line"),
    ("Unterminated string", "close the quotes"),
    ("Unescaped '\\\\'", "write a backslash twice"),
    ("after a statement", "one key = value a line, a text in quotes"),
    ("Invalid value", "a value is a number, a text in quotes, true or false, a list [ ] or a table { }"),
)


def fault_of(text: str, message: str) -> Fault:
    """The fault that the parser tells in ``message``: its place, and what to write instead."""
    match = _PLACE.fullmatch(message)
    what, line, column = match.groups() if match else (message, None, None)
    lines = text.splitlines()
    number = int(line) if line else max(len(lines), 1)
    # Text that ends at a line break is reported on the next line; the slip is on the line before.
    on_line = lines[number - 1] if number <= len(lines) else ""
    at = int(column) if column else len(on_line) + 1
    if (key := _CYRILLIC_KEY.match(on_line[:_SEEN])) is not None:
        name, start = key[1].strip("."), key.start(1) + 1
        latin = ".".join(map(latin_key, name.split(".")))
        remedy = f"write it in Latin letters: {latin}" if latin.isascii() else "the keys of a spec are in Latin letters"
        return Fault("", number, f"not valid TOML: the key {show(name)} is not Latin{stranger(name)}", remedy, start)
    return Fault("", number, f"not valid TOML: {what[:1].lower()}{what[1:]}", _remedy(on_line[:_SEEN], what), at)


def _remedy(line: str, what: str) -> str:
    code = re.sub(r'"[^"]*"', '""', line)
    if "overwrite" in what or "twice" in what:
        is_header = line.lstrip().startswith("[")
        return f"each table stands once; {_TWO_BRACKETS}" if is_header else "each key stands once in its table"
    for pattern, remedy in _LINE_REMEDIES:
        if match := re.search(pattern, code):
            told = match.expand(remedy)
            return latin_units(told) if "a quantity" in remedy else told
    return next((remedy for fragment, remedy in _MESSAGE_REMEDIES if fragment in what), "")
