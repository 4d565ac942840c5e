"""Overrides of single values of a spec: ``mechanism.grid.positions=36``.

    mechanism.links[2].points.C=[1.0, 0]        an element by its index, from 0
    mechanism.links[id=3].mass=50               an element by one of its values
    mechanism.joints[name=D0].guide.angle="5 deg"
    loads[name=Q5].factor=1.2                   a name that the spec leaves out and the program gives

The value is TOML, so a quantity with a unit keeps its quotes.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from typing import Any, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.manifest import TABLES
from tmmcalc.core.stage import resolve
from tmmcalc.spec.limits import MOST_PARTS, beyond
from tmmcalc.spec.phrases import Path, listing, show, show_path

_KEY = re.compile(r"""[A-Za-z0-9_-]+|"[^"]*"|'[^']*'""")
_SELECTOR = re.compile(r"""\[((?:[^\]"']|"[^"]*+"|'[^']*+')++)\]""")
_INDEX = re.compile(r"-?[0-9]{1,9}")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


class _Where(NamedTuple):
    """The element of a list of tables whose ``key`` is ``value``."""

    key: str
    value: object


Step = str | int | _Where


def apply(data: dict[str, Any], assignments: Sequence[str]) -> tuple[dict[str, Any], list[Path]]:
    """Return the document with the assignments made, and the paths that they set.

    ``data`` stays as it is; what is not on the way to a value that is set is shared with it.
    Raises UsageError, which names the assignment: its path or value is not readable, or an element is absent.
    """
    paths = []
    for assignment in assignments:
        steps, value = _read(assignment)
        data, path = _put(data, steps, value, (), assignment)
        paths.append(path)
    return data, paths


def split(assignment: str) -> tuple[str, str]:
    """Path and text of the value of an assignment; raises UsageError if the path cannot be read.

    >>> split("mechanism.links[id=3].mass = 50")
    ('mechanism.links[id=3].mass', '50')
    """
    _, at = _path(assignment)
    return assignment[:at].rstrip(), assignment[at:].lstrip()[1:].strip()


def value_at(data: dict[str, Any], assignment: str) -> object:
    """What the document holds at the path of an assignment; raises UsageError if it holds nothing there."""
    here: Any = data
    path: Path = ()
    for step in _path(assignment)[0]:
        found = _resolve(here, step, path, assignment)
        if isinstance(found, str) and found not in here:
            raise _refusal(assignment, f"the spec has no {show_path((*path, found))}", "give the values themselves")
        here, path = here[found], (*path, found)
    return here


def _put(here: Any, steps: Sequence[Step], value: object, path: Path, assignment: str) -> tuple[Any, Path]:
    """A copy of a table or list with the value at the end of the steps, and the path to it."""
    step = _resolve(here, steps[0], path, assignment)
    changed, path = here.copy(), (*path, step)
    if len(steps) == 1:
        changed[step] = value
        return changed, path
    inner = here.get(step, {}) if isinstance(step, str) else here[step]
    changed[step], path = _put(inner, steps[1:], value, path, assignment)
    return changed, path


def _resolve(here: Any, step: Step, path: Path, assignment: str) -> str | int:
    """Return the key or index of a step in the value that holds it."""
    if isinstance(step, str):
        if not isinstance(here, dict):
            raise _refusal(
                assignment,
                f"{show_path(path)} is not a table",
                "an element of a list is named [0], [1], ...",
            )
        return step
    if not isinstance(here, list):
        raise _refusal(assignment, f"{show_path(path) or 'the spec'} is not a list", "name a key: .key")
    if isinstance(step, _Where):
        return _find(here, step, path, assignment)
    if not 0 <= step < len(here):
        raise _refusal(
            assignment, f"{show_path(path)} has no element [{step}]", f"it has {len(here)}, counted from [0]"
        )
    return step


def _find(here: list[Any], where: _Where, path: Path, assignment: str) -> int:
    values = [item.get(where.key) if isinstance(item, dict) else None for item in here]
    if where.key == "name":
        values = _named(path, here, values)
    found = [index for index, value in enumerate(values) if type(value) is type(where.value) and value == where.value]
    if len(found) == 1:
        return found[0]
    count = "no element" if not found else f"{len(found)} elements"
    known = listing(value for value in values if value is not None)
    raise _refusal(
        assignment,
        f"{show_path(path)} has {count} with {where.key} = {show(where.value)}",
        f"there are: {known}",
    )


def _named(path: Path, here: list[Any], names: list[Any]) -> list[Any]:
    """The names with those that elements without one get; as they are where something else stands in the list."""
    entry = TABLES.get(str(path[0])) if len(path) == 1 else None
    if not all(isinstance(item, dict) for item in here) or not all(isinstance(name, str | None) for name in names):
        return names
    if entry is None or not entry.named:
        return names
    function, *keys = entry.named
    found: list[Any] = resolve(f"{entry.home}.tables.names:{function}")(*([item.get(k) for item in here] for k in keys))
    return found


def _read(assignment: str) -> tuple[list[Step], object]:
    steps, at = _path(assignment)
    return steps, _value(assignment, assignment[at:].lstrip()[1:])


def _path(assignment: str) -> tuple[list[Step], int]:
    """The steps of the path, and where it ends."""
    steps: list[Step] = []
    at = 0
    while len(steps) <= MOST_PARTS:
        selector = _SELECTOR.match(assignment, at) if steps else None
        if selector:
            steps.append(_selector(selector[1].strip(), assignment))
        key = None if selector else _KEY.match(assignment, at)
        if key:
            steps.append(_plain(key.group()))
        match = selector or key
        if match is None:
            raise _unreadable(assignment)
        at = match.end()
        rest = assignment[at:].lstrip()
        if rest.startswith("="):
            return steps, at
        at += assignment[at:].startswith(".")
    raise _refusal(
        assignment,
        f"the path has more than {MOST_PARTS} parts",
        "the keys of a spec have up to five, with indices",
    )


def _unreadable(assignment: str) -> UsageError:
    from tmmcalc.spec.cyrillic import stranger  # late: only faults need it

    alike = stranger(assignment.partition("=")[0])
    return _refusal(assignment, f"the path cannot be read{alike}", "write it as mechanism.links[id=3].mass=50")


def _plain(key: str) -> str:
    return key[1:-1] if key[0] in "\"'" else key


def _selector(inside: str, assignment: str) -> Step:
    """What stands between brackets: an index, or a key and its value."""
    if _INDEX.fullmatch(inside):
        return int(inside)
    key, _, value = (part.strip() for part in inside.partition("="))
    quoted = value[:1] in ("'", '"') and value.find(value[0], 1) == len(value) - 1
    if not _BARE_KEY.fullmatch(key) or not value or (not quoted and any(sign in value for sign in "\"'")):
        raise _unreadable(assignment)
    try:
        return _Where(key, tomllib.loads(f"value = {value}")["value"] if beyond(value) is None else value)
    except ValueError:
        return _Where(key, value)  # a bare word: quotes inside a shell's quotes are a nuisance


def _value(assignment: str, text: str) -> object:
    if (found := beyond(text)) is not None:
        raise _refusal(assignment, found.message, found.remedy)
    try:
        document = tomllib.loads(f"value = {text.strip()}")
    except ValueError:
        document = {}
    if [*document] != ["value"]:
        quoted = f'"{text.strip()}"' if len(text) < 60 else '"..."'
        raise _refusal(
            assignment,
            f"{show(text.strip())} is not a TOML value",
            f"a text or a quantity keeps its quotes: '...={quoted}'",
        )
    return document["value"]


def _refusal(assignment: str, message: str, remedy: str) -> UsageError:
    return UsageError(message, where=f"override {show(assignment)}", remedy=remedy)
