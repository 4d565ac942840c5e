"""TOML text to a mapping, with syntax errors in plain words."""

from __future__ import annotations

import re
import tomllib
from typing import Any

from tmmcalc.core.errors import Fault, SpecError

_PLACE = re.compile(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", re.DOTALL)

_TWO_BRACKETS = "several links or joints begin, each of them, with two brackets: [[mechanism.links]]"

# Slips seen on the line itself: what stands there tells more than the parser's words. Groups fill the remedy.
_LINE_REMEDIES = (
    (r"=\s*([+-]?\d+),(\d+)\s*(?:#.*)?$", r"numbers have a decimal point: \1.\2"),
    (r"=\s*([+-]?[\d.]+)\s*([A-Za-zµ°][^,\]}#\s]*)", r'a quantity with a unit stands in quotes: "\1 \2"'),
    (r"[=\[,]\s*(\.\d+)", r"a number begins with a digit: 0\1"),
    (r"[=\[,]\s*([+-]?\d+\.)(?:\D|$)", r"a number has a digit after its point: \g<1>0"),
    (r"[=\[,]\s*[+-]?0\d", "a number has no leading zeros"),
    (r"^\s*(\w+')\s*=", r'a key with a prime stands in double quotes: "\1" = [0, 0]'),
    (r"[“”„«»]", 'quotes are the plain ones: "'),
    (r"=\s*(?:True|False|yes|no)\b", "write true or false"),
    (r"=\s*([A-Za-z]\w*)\s*(?:#.*)?$", r'a text stands in quotes: "\1"'),
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


def read_toml(text: str, file: str) -> dict[str, Any]:
    """Return the mapping of a TOML text; raise SpecError with line, column and a remedy."""
    try:
        return tomllib.loads(text.removeprefix("\ufeff"))
    except tomllib.TOMLDecodeError as error:
        raise SpecError(file, [_fault(text, str(error))]) from None
    except RecursionError:
        raise SpecError(file, [too_deep()]) from None
    except ValueError as error:  # an integer of thousands of digits, a date such as 30 February
        raise SpecError(file, [Fault("", None, f"not valid TOML: {error}", "correct the number or date")]) from None


def too_deep() -> Fault:
    """Return the fault of a document nested beyond reason."""
    return Fault("", None, "lists or tables are nested too deeply", "a spec needs no more than five levels")


def _fault(text: str, message: str) -> Fault:
    match = _PLACE.fullmatch(message)
    what, line, column = match.groups() if match else (message, None, None)
    lines = text.splitlines()
    number = int(line) if line else max(len(lines), 1)
    # Text that ends at a line break is reported on the next line; the slip is on the line before.
    on_line = lines[number - 1] if number <= len(lines) else ""
    at = f", column {column}" if column else ""
    return Fault("", number, f"not valid TOML{at}: {what[:1].lower()}{what[1:]}", _remedy(on_line, what))


def _remedy(line: str, what: str) -> str:
    code = re.sub(r'"[^"]*"', '""', line)
    if "overwrite" in what or "twice" in what:
        is_header = line.lstrip().startswith("[")
        return f"each table stands once; {_TWO_BRACKETS}" if is_header else "each key stands once in its table"
    for pattern, remedy in _LINE_REMEDIES:
        if match := re.search(pattern, code):
            return match.expand(remedy)
    return next((remedy for fragment, remedy in _MESSAGE_REMEDIES if fragment in what), "")
