"""What the tests of faults share: hostile values, and what a refused spec has to say."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.project import parse_spec

Faults = Callable[[str], list[Fault]]

# values of every TOML type, none of which may break a check
HOSTILE = [
    "1",
    "true",
    '"x"',
    "[]",
    "{}",
    "[[]]",
    "[1]",
    "[{}]",
    "1979-01-01",
    "{ A = [] }",
    "nan",
    '["a", 1]',
]


def faults_of(text: str) -> list[Fault]:
    """The faults of a spec that is refused."""
    with pytest.raises(SpecError) as caught:
        parse_spec(text, "shaper.toml")
    assert caught.value.exit_code == 2
    return caught.value.faults


def check_fault(text: str, path: str, message: str, remedy: str) -> None:
    """A spec has one fault, at this place and with these pieces in its message and remedy; and it has a line."""
    (fault,) = faults_of(text)
    assert fault.path == path
    assert message in fault.message
    assert remedy in fault.remedy
    assert fault.line


def check_only_fault(text: str, faults: list[Fault], path: str, message: str, remedy: str) -> None:
    """There is one fault, with exactly these words, and its line is that of its key."""
    assert [(fault.path, fault.message, fault.remedy) for fault in faults] == [(path, message, remedy)]
    line = text.splitlines()[(faults[0].line or 0) - 1]
    keys = re.findall("[a-z_]+", path)
    if message.startswith("missing"):
        assert any(key in line for key in keys)
    else:
        assert keys[-1] in line


def check_lines(text: str) -> None:
    """A spec is read, or refused with faults that all have their lines."""
    faults: list[Fault] = []
    try:
        parse_spec(text)
    except SpecError as error:
        faults = error.faults
    assert all(fault.line for fault in faults), text
