"""pydantic's report in the plain words of the house: one finding for each of its errors.

Loaded only when a spec has faults.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, get_args

from pydantic import ValidationError

from tmmcalc.linkage.tables.joints import NAME_TAG, POINT_TAG
from tmmcalc.machine.tables.engine import COUNT_TAG, LIST_TAG
from tmmcalc.project.examples import ARRAYS_OF_TABLES, INLINE, LISTS
from tmmcalc.project.required import MISSING
from tmmcalc.project.root import Spec
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.late import LateTable
from tmmcalc.spec.phrases import Path, either, listing, nearest, show
from tmmcalc.spec.table import Table
from tmmcalc.spec.units import UnitError

_TAGS = (NAME_TAG, POINT_TAG, COUNT_TAG, LIST_TAG, "[key]")  # what pydantic puts into places beside TOML keys

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
    """Return the TOML path of a pydantic location: without the tags of its unions."""
    steps = _without_tags(loc)
    if loc[:2] == ("mechanism", "joints") and len(loc) > 3:
        del steps[3]  # the kind of the joint
    return tuple(steps)


def _without_tags(loc: Path) -> list[str | int]:
    return [step for step in loc if step not in _TAGS]


def _pattern(path: Path) -> str:
    return ".".join(step for step in path if isinstance(step, str))


def _slot(path: Path) -> str:
    """Return the pattern of a place, with brackets for an element of a list."""
    return _pattern(path) + ("[]" if isinstance(path[-1], int) else "")


def _missing(item: Item, path: Path) -> Finding:
    rule, remedy = MISSING.get(_pattern(path), ("", ""))
    return Finding(path, f"missing key: {rule}", remedy)


def _no_kind(item: Item, path: Path) -> Finding:
    return _missing(item, (*path, "kind"))


def _wrong_kind(item: Item, path: Path) -> Finding:
    return Finding(
        (*path, "kind"),
        f"{show(item['input'].get('kind'))} is not a kind of joint",
        'write kind = "revolute" (a pin) or kind = "prismatic" (a slider and its guide)',
    )


def _quantity(item: Item, path: Path) -> Finding:
    fault = item["ctx"]["error"]
    return Finding(path, str(fault), fault.remedy if isinstance(fault, UnitError) else "")


def _not_a_table(item: Item, path: Path) -> Finding:
    pattern = _pattern(path)
    if pattern in INLINE:
        remedy = f"write {INLINE[pattern]}"
    elif pattern.endswith((".points", ".fixed", ".sketch")):
        remedy = "write points by name: A = [x, y]"
    elif pattern in ARRAYS_OF_TABLES:
        remedy = f"begin each with [[{pattern}]]"
    else:
        remedy = f"write a table: [{pattern}], then its keys"
    return Finding(path, f"{show(item['input'])} is not a table", remedy)


def _not_a_list(item: Item, path: Path) -> Finding:
    pattern, value = _pattern(path), item["input"]
    if pattern in ARRAYS_OF_TABLES:
        what = "a single table" if isinstance(value, dict) else show(value)
        return Finding(
            path, f"{what}, where a list of tables is needed", f"begin each with [[{pattern}]], two brackets"
        )
    rule, example = LISTS.get(_slot(path), ("a point", 'two coordinates, such as [0, "620 mm"]'))
    if _is_place(path):
        rule, example = "a point", 'the name of a point, such as "B", or two coordinates [x, y]'
    return Finding(path, f"{show(value)} is not {rule}", f"write {example}")


def _is_place(path: Path) -> bool:
    """Whether a value is the name of a point or its coordinates; in a list, it is the ends of a spring."""
    return path[-1] in ("through", "point") or _slot(path) == "springs.points[]"


def _wrong_length(item: Item, path: Path) -> Finding:
    pattern, value = _pattern(path), item["input"]
    if pattern in ARRAYS_OF_TABLES:
        return Finding(path, f"no {path[-1]}: {MISSING[pattern][0]}", MISSING[pattern][1])
    a_point = ("a point is two coordinates", '[x, y], such as [0, "620 mm"]')
    rule, example = a_point if _is_place(path) else LISTS.get(_slot(path), a_point)
    rule = "a joint connects two links" if pattern == "mechanism.joints.links" else rule
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
    return Finding(path, f"{show(item['input'])} is not allowed here; the value is {expected}", f"write {expected}")


def _too_small(item: Item, path: Path) -> Finding:
    limit, value, pattern = item["ctx"]["ge"], item["input"], _pattern(path)
    if value == 0 and pattern == "mechanism.links.id":
        return Finding(path, "0 is the frame, not a moving link", "its points stand in [mechanism.fixed]; count from 1")
    if value == 0 and pattern in ("mechanism.outputs.link", "loads.link", "balance.counterweights.link"):
        return Finding(path, "link 0 is the frame and does not move", "name a moving link")
    return Finding(path, f"{show(value)} is less than {limit}, the least allowed", f"write {limit} or more")


def _too_large(item: Item, path: Path) -> Finding:
    limit = item["ctx"]["le"]
    return Finding(path, f"{show(item['input'])} is more than {limit}, the most allowed", f"write {limit} or less")


def _other(item: Item, path: Path) -> Finding:
    return Finding(path, f"{show(item['input'])}: {item['msg']}")


def _unknown_key(item: Item, path: Path) -> Finding:
    key, table = str(path[-1]), _pattern(path[:-1])
    known = _keys_at(item["loc"])
    if joint := _of_other_joint(item["loc"], key):
        return Finding(path, *joint)
    message = f"unknown key {show(key)}{f' in {_header(table)}' if table else ''}"
    if guess := nearest(key, known) or _longer(key, known):
        return Finding(path, message, f'did you mean "{guess}"?')
    homes = [_header(home) for home, keys in _homes() if key in keys]
    remedy = f"{key} belongs in {either(homes)}" if homes else f"the keys here are: {listing(known)}"
    return Finding(path, message, remedy)


def _longer(key: str, known: list[str]) -> str | None:
    """Return the one known key that the written word is a part of, such as adjacency_gap for gap."""
    found = [name for name in known if key in name.split("_")]
    return found[0] if len(found) == 1 else None


def _meant(item: Item) -> Path | None:
    """Return the path that a misspelt key was meant to have, None if no key is near."""
    path, key = _place(item["loc"]), nearest(str(item["loc"][-1]), _keys_at(item["loc"]))
    return (*path[:-1], key) if key else None


def _of_other_joint(loc: Path, key: str) -> tuple[str, str] | None:
    """Return the message for a key that the other kind of joint has."""
    if loc[:2] != ("mechanism", "joints") or len(loc) != 5:
        return None
    if loc[3] == "revolute" and key in ("guide", "slider"):
        return f"a revolute joint has no {key}", f'remove {key}, or write kind = "prismatic"'
    if loc[3] == "revolute" and key == "length":
        return "a revolute joint has no length", "its size is the radius of the pin: radius"
    if loc[3] == "prismatic" and key == "radius":
        return "a prismatic joint has no radius", "its size is the length of the slider along the guide: length"
    if loc[3] == "prismatic" and key in ("point", "points"):
        line = 'guide = { through = "B" } and, where it needs one, slider = { through = "A" }'
        return f"a prismatic joint has no {key}", f"its lines are {line}"
    return None


def _header(pattern: str) -> str:
    return f"[[{pattern}]]" if pattern in ARRAYS_OF_TABLES else f"[{pattern}]"


def _keys_at(loc: Path) -> list[str]:
    """Return the keys that the table of an unknown key has, by walking the table classes along its place."""
    tables: list[type[Table]] = [Spec]
    for step in _without_tags(loc[:-1]):
        if step in ("revolute", "prismatic"):
            tables = [t for t in tables if "kind" in t.model_fields and _kind_of(t) == step]
        elif isinstance(step, str):
            tables = [
                sub for t in tables if step in t.model_fields for sub in _tables_in(t.model_fields[step].annotation)
            ]
    return [key for table in tables for key in _keys(table)]


def _keys(table: type[Table]) -> list[str]:
    """Return the keys of a table as TOML has them: from is a word of Python, so its field has another name."""
    return [field.alias or name for name, field in table.model_fields.items()]


def _kind_of(table: type[Table]) -> object:
    return get_args(table.model_fields["kind"].annotation)[0]


def _tables_in(annotation: Any) -> list[type[Table]]:
    if isinstance(annotation, LateTable):
        return [annotation.table]
    if isinstance(annotation, type) and issubclass(annotation, Table):
        return [annotation]
    return [table for part in get_args(annotation) for table in _tables_in(part)]


def _homes(table: type[Table] = Spec, pattern: str = "") -> Iterator[tuple[str, list[str]]]:
    """Yield every table of the spec as its dotted name and its keys."""
    for key, field in table.model_fields.items():
        for sub in _tables_in(field.annotation):
            name = f"{pattern}.{key}" if pattern else key
            yield name, _keys(sub)
            yield from _homes(sub, name)


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
