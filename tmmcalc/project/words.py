"""What the rooms say of faults in their tables: ``<room>.tables.words.<key>``, loaded only when a spec has faults.

    MISSING    what a missing key is for, and what to write
    LISTS      what a list that is no point holds, and an example; ``key[]``: a list that is an element of a list
    INLINE     a table that is written in one line
    PLACES     keys that are the name of a point, or its coordinates
    ELEMENTS   lists whose elements have a name: the key that holds it, and how a message calls one; "": the table
    LENGTHS    the rule for a list of another length than the words of LISTS say
    ZEROS      what is said of a 0 that is less than the least
    KINDS      lists of tables of several kinds, told by ``kind``: what a kind is of, and which there are
    FOREIGN    of these, by kind, what is said of a key that another kind has
    BEGIN      the tables that a spec about it begins with

Keys are dotted, from the table on. A table that needs no words has no module.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import NamedTuple

from tmmcalc.rooms import TABLES
from tmmcalc.spec.phrases import Said


class Words(NamedTuple):
    """The words of a table, none by default."""

    missing: Mapping[str, Said] = {}
    lists: Mapping[str, Said] = {}
    inline: Mapping[str, str] = {}
    places: tuple[str, ...] = ()
    elements: Mapping[str, Said] = {}
    lengths: Mapping[str, str] = {}
    zeros: Mapping[str, Said] = {}
    kinds: Mapping[str, Said] = {}
    foreign: Mapping[str, Mapping[str, Mapping[str, Said]]] = {}
    begin: str = ""


@cache
def words_of(table: object) -> Words:
    """The words of a table of the root; none of what is no table."""
    entry = TABLES.get(table) if isinstance(table, str) else None
    module = "" if entry is None else f"{entry.home}.tables.words.{entry.module}"
    if entry is None or find_spec(f"{entry.home}.tables.words") is None or find_spec(module) is None:
        return Words()
    found = vars(import_module(module))
    return Words(**{name: found[name.upper()] for name in Words._fields if name.upper() in found})
