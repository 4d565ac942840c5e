"""pydantic's report in the plain words of the house: one finding for each of its errors.

Loaded only when a spec has faults.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pydantic import ValidationError

from tmmcalc.project.tables import homes, is_list, tables_at
from tmmcalc.project.words import words_of
from tmmcalc.spec.cyrillic import latin_key, stranger
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path, either, listing, nearest, show
from tmmcalc.spec.table import TAGS, Table
from tmmcalc.spec.units import UnitError

Item = Any  # one entry of ValidationError.errors(): type, loc, input, ctx, msg


def findings(error: ValidationError, checked: list[Finding]) -> list[Finding]:
    """Return one finding for each error, then those of the checks, without missing keys that are only misspelt."""
    items = error.errors(include_url=False)
    meant = {path for item in items if item["type"] == "extra_forbidden" and (path := _meant(item))}
    misspelt = meant | {path[:-1] for path in meant}  # a table may lack any one of several keys
    found = [*map(_finding, items), *checked]
    return [finding for finding in found if not (finding.path in misspelt and finding.message.startswith("missing"))]


def _finding(item: Item) -> Finding:
    path = _place(item["loc"])
    return _WORDING.get(item["type"], _other)(item, path)


def _place(loc: Path) -> Path:
    """Return the TOML path of a pydantic location: without the tags of its unions, and the kinds of its elements."""
    steps = _without_tags(loc)
    for key in words_of(loc[0]).kinds:
        at = len(key.split(".")) + 2  # after the table, the key and the number of the element
        if _key(tuple(steps[: at - 1])) == key and len(loc) > at:
            del steps[at]
    return tuple(steps)


def _without_tags(loc: Path) -> list[str | int]:
    return [step for step in loc if step not in TAGS]


def _pattern(path: Path) -> str:
    return ".".join(step for step in path if isinstance(step, str))


def _key(path: Path) -> str:
    """Return the pattern of a place within its table."""
    return _pattern(path[1:])


def _slot(path: Path) -> str:
    """Return the pattern of a place within its table, with brackets for an element of a list."""
    return _key(path) + ("[]" if isinstance(path[-1], int) else "")


def _missing(item: Item, path: Path) -> Finding:
    rule, remedy = words_of(path[0]).missing.get(_key(path), ("", ""))
    return Finding(path, f"missing key: {rule}", remedy)


def _no_kind(item: Item, path: Path) -> Finding:
    return _missing(item, (*path, "kind"))


def _wrong_kind(item: Item, path: Path) -> Finding:
    what, remedy = words_of(path[0]).kinds[_key(path)]
    kind = item["input"].get("kind")
    alike = stranger(kind) if isinstance(kind, str) else ""
    return Finding((*path, "kind"), f"{show(kind)} is not {what}{alike}", remedy)


def _quantity(item: Item, path: Path) -> Finding:
    fault = item["ctx"]["error"]
    return Finding(path, str(fault), fault.remedy if isinstance(fault, UnitError) else "")


def _not_a_table(item: Item, path: Path) -> Finding:
    pattern, inline = _pattern(path), words_of(path[0]).inline.get(_key(path))
    if inline is not None:
        remedy = f"write {inline}"
    elif is_list(pattern):
        remedy = f"begin each with [[{pattern}]]"
    else:
        remedy = f"write a table: [{pattern}], then its keys"
    return Finding(path, f"{show(item['input'])} is not a table", remedy)


def _not_a_list(item: Item, path: Path) -> Finding:
    pattern, value = _pattern(path), item["input"]
    if is_list(pattern):
        what = "a single table" if isinstance(value, dict) else show(value)
        return Finding(
            path, f"{what}, where a list of tables is needed", f"begin each with [[{pattern}]], two brackets"
        )
    rule, example = words_of(path[0]).lists.get(_slot(path), ("a point", 'two coordinates, such as [0, "620 mm"]'))
    if _is_place(path):
        rule, example = "a point", 'the name of a point, such as "B", or two coordinates [x, y]'
    return Finding(path, f"{show(value)} is not {rule}", f"write {example}")


def _is_place(path: Path) -> bool:
    """Whether a value is the name of a point or its coordinates."""
    return _slot(path) in words_of(path[0]).places


def _wrong_length(item: Item, path: Path) -> Finding:
    key, value, words = _key(path), item["input"], words_of(path[0])
    if is_list(_pattern(path)):
        rule, remedy = words.missing[key]
        return Finding(path, f"no {path[-1]}: {rule}", remedy)
    a_point = ("a point is two coordinates", '[x, y], such as [0, "620 mm"]')
    rule, example = a_point if _is_place(path) else words.lists.get(_slot(path), a_point)
    rule = words.lengths.get(key, rule)
    count = "no values" if not value else "1 value" if len(value) == 1 else f"{len(value)} values"
    return Finding(path, f"{show(value)} has {count}; {rule}", f"write {example}")


def _not_text(item: Item, path: Path) -> Finding:
    return Finding(path, f"{show(item['input'])} is not a text", "write a text in quotes")


def _not_whole(item: Item, path: Path) -> Finding:
    value = item["input"]
    whole = isinstance(value, float) and value.is_integer()
    digits = str(int(value)) if whole else value.strip() if isinstance(value, str) else ""
    plain = digits.removeprefix("-").isdecimal() and len(digits) < 20
    return Finding(path, f"{show(value)} is not a whole number", f"write {digits}" if plain else "write a whole number")


def _not_bool(item: Item, path: Path) -> Finding:
    return Finding(path, f"{show(item['input'])} is neither true nor false", "write true or false, without quotes")


def _not_listed(item: Item, path: Path) -> Finding:
    expected = item["ctx"]["expected"].replace("'", '"')
    value = item["input"]
    alike = stranger(value) if isinstance(value, str) else ""
    return Finding(path, f"{show(value)} is not allowed here{alike}; the value is {expected}", f"write {expected}")


def _too_small(item: Item, path: Path) -> Finding:
    limit, value, zeros = item["ctx"]["ge"], item["input"], words_of(path[0]).zeros
    if value == 0 and _key(path) in zeros:
        return Finding(path, *zeros[_key(path)])
    return Finding(path, f"{show(value)} is less than {limit}, the least allowed", f"write {limit} or more")


def _too_large(item: Item, path: Path) -> Finding:
    limit = item["ctx"]["le"]
    return Finding(path, f"{show(item['input'])} is more than {limit}, the most allowed", f"write {limit} or less")


def _other(item: Item, path: Path) -> Finding:
    return Finding(path, f"{show(item['input'])}: {item['msg']}")


def _unknown_key(item: Item, path: Path) -> Finding:
    key, table = str(path[-1]), _pattern(path[:-1])
    known = _keys_at(item["loc"])
    if foreign := _of_other_kind(item["loc"], key):
        return Finding(path, *foreign)
    message = f"unknown key {show(key)}{f' in {_header(table)}' if table else ''}{stranger(key)}"
    if guess := nearest(key, known) or _longer(key, known) or nearest(latin_key(key), known):
        return Finding(path, message, f'did you mean "{guess}"?')
    others = [_header(home) for home, table in homes() if key in _keys(table)]
    remedy = f"{key} belongs in {either(others)}" if others else f"the keys here are: {listing(known)}"
    return Finding(path, message, remedy)


def _longer(key: str, known: list[str]) -> str | None:
    """Return the one known key that the written word is a part of, such as adjacency_gap for gap."""
    found = [name for name in known if key in name.split("_")]
    return found[0] if len(found) == 1 else None


def _meant(item: Item) -> Path | None:
    """Return the path that a misspelt key was meant to have, None if no key is near."""
    path, known = _place(item["loc"]), _keys_at(item["loc"])
    key = nearest(str(item["loc"][-1]), known) or nearest(latin_key(str(item["loc"][-1])), known)
    return (*path[:-1], key) if key else None


def _of_other_kind(loc: Path, key: str) -> tuple[str, str] | None:
    """Return what is said of a key that another kind of the element has."""
    for home, kinds in words_of(loc[0]).foreign.items():
        at = len(home.split(".")) + 2  # where the kind stands
        if len(loc) == at + 2 and _key(loc[: at - 1]) == home:
            return kinds.get(str(loc[at]), {}).get(key)
    return None


def _header(pattern: str) -> str:
    return f"[[{pattern}]]" if is_list(pattern) else f"[{pattern}]"


def _keys_at(loc: Path) -> list[str]:
    """Return the keys that the table of an unknown key has, by walking the table classes along its place."""
    steps = (step for step in _without_tags(loc[:-1]) if isinstance(step, str))
    return [key for table in tables_at(steps) for key in _keys(table)]


def _keys(table: type[Table]) -> list[str]:
    """Return the keys of a table as TOML has them: from is a word of Python, so its field has another name."""
    return [field.alias or name for name, field in table.model_fields.items()]


_WORDING: dict[str, Callable[[Item, Path], Finding]] = {
    "missing": _missing,
    "extra_forbidden": _unknown_key,
    "value_error": _quantity,
    "model_type": _not_a_table,
    "model_attributes_type": _not_a_table,
    "dict_type": _not_a_table,
    "list_type": _not_a_list,
    "too_short": _wrong_length,
    "too_long": _wrong_length,
    "string_type": _not_text,
    "int_type": _not_whole,
    "int_from_float": _not_whole,
    "bool_type": _not_bool,
    "literal_error": _not_listed,
    "greater_than_equal": _too_small,
    "less_than_equal": _too_large,
    "union_tag_not_found": _no_kind,
    "union_tag_invalid": _wrong_kind,
}
