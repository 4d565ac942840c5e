"""The table classes of the spec along dotted names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any, get_args, get_origin

from tmmcalc.project.root import Spec
from tmmcalc.spec.deferred import DeferredTable
from tmmcalc.spec.table import Table


def tables_in(annotation: Any) -> list[type[Table]]:
    """The table classes that an annotation names."""
    if isinstance(annotation, DeferredTable):
        return [annotation.table]
    if isinstance(annotation, type) and issubclass(annotation, Table):
        return [annotation]
    return [table for part in get_args(annotation) for table in tables_in(part)]


def tables_at(steps: Iterable[str]) -> list[type[Table]]:
    """The classes that a table may have at the end of the keys; among them stand kinds, each of which chooses one."""
    tables: list[type[Table]] = [Spec]
    for step in steps:
        chosen = [table for table in tables if _kind_of(table) == step]
        tables = chosen or [
            sub for t in tables if step in t.model_fields for sub in tables_in(t.model_fields[step].annotation)
        ]
    return tables


def homes(table: type[Table] = Spec, pattern: str = "") -> Iterator[tuple[str, type[Table]]]:
    """Yield every table of the spec by its dotted name, with its class."""
    for key, field in table.model_fields.items():
        for sub in tables_in(field.annotation):
            name = f"{pattern}.{key}" if pattern else key
            yield name, sub
            yield from homes(sub, name)


@cache
def is_list(pattern: str) -> bool:
    """Whether a dotted name is that of a list of tables.

    >>> is_list("mechanism.links"), is_list("mechanism.input")
    (True, False)
    """
    *steps, key = pattern.split(".")
    fields = [table.model_fields[key] for table in tables_at(steps) if key in table.model_fields]
    return any(_lists_tables(field.annotation) for field in fields)


def _lists_tables(annotation: Any) -> bool:
    if get_origin(annotation) is list:
        return bool(tables_in(annotation))
    return any(_lists_tables(part) for part in get_args(annotation))


def _kind_of(table: type[Table]) -> object:
    """The kind that is the only one of a table."""
    kinds = get_args(table.model_fields["kind"].annotation) if "kind" in table.model_fields else ()
    return kinds[0] if len(kinds) == 1 else None
