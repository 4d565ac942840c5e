"""Checks of ``[unsteady]``: what settles the motion, and quantities that suit the input or the output."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, tables, word
from tmmcalc.spec.phrases import did_you_mean, listing, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.values import check_bare_speed

_TURNING = {"coordinate": "angle", "speed": "angular speed", "acceleration": "angular acceleration"}
_SLIDING = {"coordinate": "length", "speed": "speed", "acceleration": "acceleration"}
_ENDS = ("from", "to")


def check_settled(outline: Outline) -> Iterator[Finding]:
    """The end, the travel or the duration is there, and a largest speed where they leave it open."""
    table = _table(outline)
    if "to" in table and "travel" in table:
        rule = "travel together with to: they say the same"
        yield Finding(("unsteady", "travel"), rule, "remove one of them")
    if not {"to", "travel", "duration"} & {*table}:
        rule = "missing key: neither an end, a travel nor a duration is given"
        yield Finding(("unsteady",), rule, 'add to, travel, or duration = "12 s"')
    elif "speed" not in table and not ("duration" in table and {"to", "travel"} & {*table}):
        rule = "missing key: the largest speed of the input is needed"
        yield Finding(("unsteady", "speed"), rule, "add speed, or give both the duration and the end")
    if "travel" in table and "sense" in table:
        yield Finding(("unsteady", "sense"), "sense together with travel: the travel has its sign", "remove sense")


def check_output(outline: Outline) -> Iterator[Finding]:
    """The output is one of the mechanism's."""
    table = _table(outline)
    name = table.get("output")
    if not isinstance(name, str):
        return
    known = [_name(output) for _, output in tables(written_linkage(outline).table, "outputs")]
    if name not in known:
        guess = did_you_mean(name, known)
        remedy = f"{guess} outputs: {listing(known)}; add [[mechanism.outputs]] for another".strip()
        yield Finding(("unsteady", "output"), f"there is no output {show(name)}", remedy)
    elif not {*_ENDS} & {*table}:
        rule = f"output = {show(name)} has no effect: neither from nor to is given"
        yield Finding(("unsteady", "output"), rule, "add to, or remove output")


def check_dimensions(outline: Outline) -> Iterator[Finding]:
    """Speeds and coordinates are those of the input joint, the ends those of the output where one is named."""
    linkage = written_linkage(outline)
    joint = linkage.input_joint
    if joint is None or joint.kind not in ("revolute", "prismatic"):
        return
    table, own = _table(outline), _SLIDING if joint.kind == "prismatic" else _TURNING
    who = f'the input joint "{joint.name}" is {joint.kind}'
    wanted = {"speed": own["speed"], "acceleration": own["acceleration"], "travel": own["coordinate"]}
    if "output" not in table:
        wanted |= dict.fromkeys(_ENDS, own["coordinate"])
    for key, dimension in wanted.items():
        yield from _of(table, key, dimension, who)
    output = next((each for _, each in tables(linkage.table, "outputs") if _name(each) == table.get("output")), None)
    if output is not None:
        turns = "link" in output
        who = f"output {table['output']} is {'an angle' if turns else 'a length'}"
        for key in _ENDS:
            yield from _of(table, key, "angle" if turns else "length", who)
    if own is _TURNING:
        yield from check_bare_speed(table.get("speed"), ("unsteady", "speed"))


def _of(table: Raw, key: str, dimension: str, who: str) -> Iterator[Finding]:
    """A written unit is one of the dimension; what has none of the known dimensions the table reports."""
    written = dimension_of(table.get(key))
    allowed = {_TURNING[kind] for kind in _TURNING} | {_SLIDING[kind] for kind in _SLIDING}
    if written in allowed and written != dimension:
        needed, example = DIMENSIONS[dimension].noun, DIMENSIONS[dimension].example
        rule = f"{show(table[key])} is {DIMENSIONS[written].noun}; {who}, so {needed} is needed"
        yield Finding(("unsteady", key), rule, f'write {needed}, such as "{example}"')


def _name(output: Raw) -> str:
    """The name of an output as the results have it."""
    for key in ("name", "point", "joint"):
        if isinstance(output.get(key), str):
            return word(output, key)
    return str(output.get("link"))


def _table(outline: Outline) -> Raw:
    return subtable(outline.document, "unsteady")


CHECKS = (check_settled, check_output, check_dimensions)
