"""Checks of ``[pair]``: teeth and modules that are there, shifts that are given once, keys that each kind of pair uses.

The rules are those of single pairs. A fault is told where its key is written; a key of ``[pair]`` that holds for
several pairs is of no use only if none of them uses it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmmcalc.gears.tables.checks.pair_shifts import check_shifts
from tmmcalc.gears.tables.checks.pair_train import check_train
from tmmcalc.gears.tables.checks.teeth import tool_faults
from tmmcalc.gears.tables.checks.written_pair import Written, entries, is_of_train, written_pairs
from tmmcalc.gears.tables.shifting import OF_KIND
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, is_integer, subtable, word
from tmmcalc.spec.phrases import listing, show
from tmmcalc.spec.values import amount, amounts

Rule = Callable[[Written], Iterator[Finding]]

_WITH = {"external": "two external wheels", "internal": "a pinion in a ring", "rack": "a pinion on a rack"}
# How many values a kind of pair has: a rack has no circles, a ring no span.
_COUNTS = {
    "tip_diameters": {"external": 2, "internal": 2, "rack": 1},
    "ball_diameters": {"external": 2, "internal": 2, "rack": 1},
    "span_teeth": {"external": 2, "internal": 1, "rack": 1},
}
_LIMITS = (
    ("contact_ratio_min", 1.0, "contact_ratio_wanted"),
    ("tip_thickness_min", 0.0, "tip_thickness_wanted"),
    ("contact_ratio_min", 1.0, "desired_contact_ratio"),
)


def check_pairs(outline: Outline) -> Iterator[Finding]:
    """All faults of the pairs, each once."""
    yield from faults(written_pairs(outline))


def faults(pairs: list[Written]) -> Iterator[Finding]:
    """The same of pairs as they are written."""
    found = [finding for pair in pairs for rule in RULES for finding in rule(pair)]
    yield from dict.fromkeys([*found, *_check_used(pairs)])


def check_names(outline: Outline) -> Iterator[Finding]:
    """Several pairs have names of their own."""
    found = entries(outline)
    if is_of_train(outline) or not found:
        return
    if "name" in subtable(outline.document, "pair"):
        rule = "name in [pair] together with [[pair.meshes]]: each of them is a pair"
        yield Finding(("pair", "name"), rule, "write the names in [[pair.meshes]]")
    taken: list[str] = []
    for index, entry in found:
        if (name := word(entry, "name")) in taken:
            yield Finding(("pair", "meshes", index, "name"), f"{show(name)} is the name of two pairs", "rename one")
        taken += [name] if name else []


def _check_teeth(pair: Written) -> Iterator[Finding]:
    """A pair by itself has its teeth and its module."""
    if pair.of_train:
        return
    if "mesh" in pair.own:
        rule = "mesh names a mesh of the train, and this pair has none: there is no [train], or teeth are given"
        yield Finding((*pair.path, "mesh"), rule, "remove it and write name, teeth and module; or add [train]")
        return
    if "teeth" not in pair.keys:
        yield Finding(pair.path, "missing key: a pair of gears has its numbers of teeth", "add teeth = [14, 17]")
    if "module" not in pair.keys:
        yield Finding(pair.path, "missing key: a pair of gears has its module", 'add module = "5 mm"')
    yield from _check_mate(pair)


def _check_mate(pair: Written) -> Iterator[Finding]:
    """A wheel has a mate, and a ring has room for its pinion; a rack has no teeth to count."""
    teeth = pair.keys.get("teeth")
    if not isinstance(teeth, list) or not all(map(is_integer, teeth)) or len(teeth) not in (1, 2) or not pair.kind:
        return
    if pair.kind == "rack" and len(teeth) == 2:
        yield Finding(pair.at("teeth"), f"{show(teeth)}: a rack has no number of teeth", f"write teeth = [{teeth[0]}]")
    elif pair.kind != "rack" and len(teeth) == 1:
        rule = f"{show(teeth)} has 1 value; {_WITH[pair.kind]} have two numbers of teeth"
        yield Finding(pair.at("teeth"), rule, 'write teeth = [14, 17], or kind = "rack"')
    elif pair.kind == "internal" and teeth[1] <= teeth[0]:
        rule = f"a pinion of {teeth[0]} teeth does not fit into a ring of {teeth[1]}"
        yield Finding(pair.at("teeth"), rule, "write the pinion first; a ring has more teeth than its pinion")
    elif pair.kind == "internal":
        cutter = subtable(pair.keys, "cutter").get("teeth")
        if is_integer(cutter) and cutter >= teeth[1]:
            rule = f"a cutter of {cutter} teeth does not fit into a ring of {teeth[1]}"
            yield Finding((*pair.at("cutter"), "teeth"), rule, "take a smaller cutter")


def _check_counts(pair: Written) -> Iterator[Finding]:
    """Lists have a value for every wheel that has the size."""
    for key, counts in _COUNTS.items():
        listed = pair.keys.get(key)
        count = counts.get(pair.kind)
        if count is None or not isinstance(listed, list) or len(listed) not in (1, 2) or len(listed) == count:
            continue
        rule = f"{key} has {len(listed)} value{'s' if len(listed) > 1 else ''}, {_WITH[pair.kind]} need {count}"
        yield Finding(pair.at(key), rule, "write one for each wheel" if count == 2 else "write that of the pinion")


def _check_strategy(pair: Written) -> Iterator[Finding]:
    """The shifts are chosen in a way that the kind of pair has."""
    chosen = word(pair.keys, "strategy")
    if chosen not in OF_KIND["external"] or not pair.kinds or any(chosen in OF_KIND[kind] for kind in pair.kinds):
        return
    kind = pair.kinds[0]
    ways = listing(f'"{each}"' for each in OF_KIND[kind])
    yield Finding(pair.at("strategy"), f'{_WITH[kind]} cannot have strategy = "{chosen}"', f"it has {ways}")


def _check_limits(pair: Written) -> Iterator[Finding]:
    """What is wanted is not less than what is needed."""
    for low, usual, high in _LIMITS:
        least, wanted = amount(pair.keys.get(low, usual)), amount(pair.keys.get(high))
        if least is not None and wanted is not None and wanted < least:
            rule = f"{high} = {wanted:g} is below {low} = {least:g}"
            yield Finding(pair.at(high), rule, f"write {least:g} or more, or a lower {low}")
    ends = amounts(pair.keys.get("angle_range"), "angle")
    if ends is not None and len(ends) == 2 and ends[0] >= ends[1]:
        rule = f"{show(pair.keys['angle_range'])} runs backwards"
        yield Finding(pair.at("angle_range"), rule, "write the smaller angle first")


def _check_tool(pair: Written) -> Iterator[Finding]:
    """The rack is a tool that can be made."""
    yield from tool_faults(pair.keys, pair.rack, pair.at)


def _splits(pair: Written) -> bool:
    return pair.strategy in ("given_aw", "equal_shift") and not {"x1", "x2"} & {*pair.keys}


def _slides_equally(pair: Written) -> bool:
    return pair.strategy == "equal_sliding"


def _has_ring(pair: Written) -> bool:
    return "internal" in pair.kinds or not pair.kinds


def _has_mate(pair: Written) -> bool:
    return pair.kind != "rack"


# key: which pairs use it, what the others lack, and what to write instead
_USES: dict[str, tuple[Callable[[Written], bool], str, str]] = {
    "cutter": (_has_ring, "it cuts a ring, and there is none", 'remove it; it belongs to kind = "internal"'),
    "x2": (_has_mate, "a rack has no shift", "remove it"),
    "centre_distance": (_has_mate, "a rack has no centre", "remove it; x1 sets the pinion's distance"),
    "split": (
        _splits,
        "nothing is left to be split",
        'remove it; it belongs to strategy = "given_aw" or "equal_shift" without x1 and x2',
    ),
    "desired_contact_ratio": (
        _slides_equally,
        "the shifts are not chosen for it",
        'write strategy = "equal_sliding", or remove it',
    ),
}


def _check_used(pairs: list[Written]) -> Iterator[Finding]:
    """Every key is one that a pair uses."""
    for key, (uses, lack, remedy) in _USES.items():
        taking = [pair for pair in pairs if key in pair.keys]
        places = {pair.at(key) for pair in taking}
        for place in sorted(places, key=str):
            if not any(uses(pair) for pair in taking if pair.at(key) == place):
                yield Finding(place, f"{key} is of no use: {lack}", remedy)


RULES: tuple[Rule, ...] = (
    _check_teeth,
    _check_counts,
    _check_strategy,
    check_shifts,
    _check_limits,
    _check_tool,
)
CHECKS = (check_pairs, check_names, check_train)
