"""A spec in which what was found stands in the place of what was asked: the text for a file, the tables for a run."""

from __future__ import annotations

import os.path
from collections.abc import Iterator
from pathlib import Path as FilePath
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.naming.language import is_name, parse
from tmmcalc.project.filekeys import keys, places
from tmmcalc.project.loader import parse_spec
from tmmcalc.project.root import Spec
from tmmcalc.spec.outline import subtable, tables, word
from tmmcalc.spec.phrases import Path, show_path
from tmmcalc.spec.rewrite import Change, Found, changed, rewritten, toml, value_at, worded
from tmmcalc.spec.syntax import read_toml


@record
class Settled:
    """The text of a spec with what was found, and what was put where, a line each."""

    text: str
    told: tuple[str, ...]
    of: str  # the text that it was made of


def text_of(spec: Spec) -> str:
    """The text that a spec was read from, with its overrides."""
    written = spec._written
    assert written is not None
    return rewritten(written.text, [Change(path, value_at(written.document, path)) for path in written.changed], "")


def settled_text(spec: Spec, target: FilePath, found: Found) -> Settled:
    """The text that a spec was read from, with its overrides and with what was found, to be written to ``target``.

    What the overrides set is written too, and paths of files count from the new folder: the new spec gives the numbers
    that were found. Raises SpecError if it does not pass the checks, UsageError if the text cannot take a change.
    """
    written = spec._written
    if written is None:
        raise UsageError("the spec was not read from a text", where="--spec", remedy="take load_spec or parse_spec")
    text, folders = written.text, (written.folder.resolve(), target.resolve().parent)
    document = read_toml(text, written.file)
    changes = [Change(path, value_at(written.document, path)) for path in written.changed]
    set_by_hand = changed(document, changes)
    moved = list(_moved(set_by_hand, *folders)) if folders[0] != folders[1] else []
    asked = [*found.changes, *_judged(set_by_hand, found)]
    settled = [each for each in asked if _alters(set_by_hand, each)]
    made = rewritten(text, [*changes, *moved, *settled], found.tables)
    parse_spec(made, str(target), (), target.parent)
    told = [_told(set_by_hand, each) for each in settled]
    if found.tables:
        told.insert(0, f"[{next(iter(read_toml(found.tables, '')))}] is {found.of}")
    elif found.of and told:
        told.insert(0, found.of)
    over = [each.path for each in settled]
    kept = [each for each in changes if not any(each.path[: len(path)] == path for path in over)]
    told += [_told(document, each, " by --set") for each in kept]
    told += [_told(set_by_hand, each) for each in moved]
    return Settled(made, tuple(told), text)


def _alters(document: dict[str, Any], change: Change) -> bool:
    """Whether there is anything to change: what goes has to be there, what comes has to differ."""
    return worded(document, change) != value_at(document, change.path)


def _judged(document: dict[str, Any], found: Found) -> Iterator[Change]:
    """The constraints on stages that are no more, which the search has kept.

    A rule that names one of them goes with all that it combines.
    """
    constraints = list(tables(document, "constraints"))
    gone = [index for index, each in constraints if _stage_of(each) in found.ends]
    rule = word(subtable(document, "feasibility"), "rule")
    if rule and gone:
        gone = [index for index, _ in constraints]
    if gone and len(gone) == len(constraints):
        yield Change(("feasibility",))
    yield from (Change(("constraints", index)) for index in gone)


def _stage_of(constraint: dict[str, Any]) -> object:
    """The stage that a constraint is on, by its key or by the name that stands as its value."""
    named = constraint.get("value")
    return parse(named).stage if "stage" not in constraint and is_name(named) else constraint.get("stage")


def _told(document: dict[str, Any], change: Change, how: str = "") -> str:
    """One line on a change: what stands where, and what stood there."""
    *table, key = change.path
    old, home = value_at(document, change.path), f"[{show_path(tuple(table))}] " if table else ""
    if change.value is None:
        if isinstance(key, int):
            return f"[[{show_path(tuple(table))}]] {old.get('name', key)} is a comment now"
        name = f"[{show_path(change.path)}]" if isinstance(old, dict) else f"{home}{key} = {toml(old)}"
        return f"{name} is a comment now"
    was = "searched" if old is None and not how else "absent" if old is None else toml(old)
    return f"{home}{key} = {toml(worded(document, change))}{how} (was: {was})"


def _moved(document: dict[str, Any], folder: FilePath, target: FilePath) -> Iterator[Change]:
    """The keys that name files, their paths counted from the new folder."""
    for entry, steps, key in keys():
        for path, table in places(document, entry, steps):
            name = table.get(key)
            if isinstance(name, str) and not FilePath(name).is_absolute():
                there: Path = (*path, key)
                yield Change(there, FilePath(os.path.relpath(folder / name, target)).as_posix())
