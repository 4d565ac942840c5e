"""Checks of ``[engine]``: an arrangement with its keys, or cylinders each for itself, and cranks that can turn."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, tables, word
from tmmcalc.spec.phrases import Path, listing, show
from tmmcalc.spec.values import amount, check_bare_speed

_OF_ARRANGEMENT = ("arrangement", "angle", "spacing", "throws", "split", "stagger")
_OF_VEE = ("angle", "split", "stagger")
_MOST = 100  # cylinders; more is a fault of its own
_NEEDED = {
    "crank_radius": ("a crank", '"40 mm"'),
    "rod_length": ("a connecting rod", '"140 mm"'),
    "reciprocating_mass": ("a reciprocating mass", '"0.6 kg"'),
}
_LENGTHS = {"rod_length": None, "crank_radius": None, "offset": 0.0}  # and what they are where nothing is written


def check_form(outline: Outline) -> Iterator[Finding]:
    """Cylinders are counted in an arrangement, or listed without one."""
    engine = subtable(outline.document, "engine")
    cylinders = engine.get("cylinders")
    if isinstance(cylinders, list):
        for key in _OF_ARRANGEMENT:
            if key in engine:
                rule = f"{key} together with [[engine.cylinders]]: each cylinder tells its own place and crank"
                yield Finding(("engine", key), rule, f"remove {key}, or write cylinders = {len(cylinders)}")
    elif is_integer(cylinders) and "arrangement" not in engine:
        rule = "missing key: a number of cylinders needs their arrangement"
        yield Finding(("engine",), rule, 'add arrangement = "in-line" or arrangement = "vee"')
    yield from check_bare_speed(engine.get("speed"), ("engine", "speed"))


def check_arrangement(outline: Outline) -> Iterator[Finding]:
    """An arrangement has the keys of its kind; several cylinders stand at a distance."""
    engine = subtable(outline.document, "engine")
    kind, count = word(engine, "arrangement"), engine.get("cylinders")
    if kind == "in-line":
        for key in _OF_VEE:
            if key in engine:
                rule = f"cylinders in line have no {key}"
                yield Finding(("engine", key), rule, 'remove it, or write arrangement = "vee"')
    if kind == "vee" and "angle" not in engine:
        yield Finding(("engine",), "missing key: a vee has its angle", 'add angle = "90 deg"')
    if kind not in ("in-line", "vee") or not is_integer(count) or count < 1:
        return
    throws = count // 2 if kind == "vee" else count
    if kind == "vee" and count % 2:
        rule = f"{count} cylinders: two stand on every throw of a vee"
        yield Finding(("engine", "cylinders"), rule, f"write {count + 1}, or list them: [[engine.cylinders]]")
        return
    if throws > 1 and "spacing" not in engine:
        rule = "missing key: the throws stand at a distance along the shaft"
        yield Finding(("engine",), rule, 'add spacing = "90 mm"')
    yield from _check_throws(engine, kind, count, throws)


def _check_throws(engine: Raw, kind: str, count: int, throws: int) -> Iterator[Finding]:
    """There is an angle for every throw, or a custom that gives them."""
    given = engine.get("throws")
    if isinstance(given, list):
        if len(given) != throws:
            rule = f"{len(given)} throws for {count} cylinders" + (", two on each" if kind == "vee" else "")
            yield Finding(("engine", "throws"), rule, f"write {throws} angles")
        return
    from tmmcalc.machine.balance.arrangements import FIRING, THROWS  # late: they load numpy

    known = [2 * n for n in THROWS] if kind == "vee" else [*FIRING]
    if "throws" not in engine and count not in known and (kind == "vee" or "firing_order" not in engine):
        what = "throws" if kind == "vee" else "firing_order, or throws"
        rule = f"there are no customary cranks of {count} cylinders {'in a vee' if kind == 'vee' else 'in line'}"
        yield Finding(("engine", "cylinders"), rule, f"add {what}; they are known for {listing(known)} cylinders")


def check_firing(outline: Outline) -> Iterator[Finding]:
    """A firing order names every cylinder once."""
    engine = subtable(outline.document, "engine")
    order, cylinders = engine.get("firing_order"), engine.get("cylinders")
    count = len(cylinders) if isinstance(cylinders, list) else cylinders
    if not isinstance(order, list) or not all(map(is_integer, order)) or not is_integer(count) or count > _MOST:
        return
    if sorted(order) != list(range(1, count + 1)):
        rule = f"{show(order)} does not name every cylinder from 1 to {count} once"
        yield Finding(("engine", "firing_order"), rule, "write each number once, such as [1, 3, 4, 2]")


def check_orders(outline: Outline) -> Iterator[Finding]:
    """Every order is asked for once."""
    written = subtable(outline.document, "engine").get("orders")
    orders = written if isinstance(written, list) else []
    for index, order in enumerate(orders):
        if order in orders[:index]:
            yield Finding(("engine", "orders", index), f"{show(order)} is named twice", "remove one of them")


def check_sizes(outline: Outline) -> Iterator[Finding]:
    """Every cylinder has a crank, a rod and a piston, its own or those of the engine; its crank can turn."""
    engine = subtable(outline.document, "engine")
    cylinders = tables(engine, "cylinders")
    for key, (what, example) in _NEEDED.items():
        lacking = [index for index, cylinder in cylinders if key not in cylinder]
        if key in engine or (cylinders and not lacking):
            continue
        places: list[Path] = [("engine", "cylinders", index) for index in lacking]
        for path in places if len(places) < len(cylinders) else [("engine",)]:
            yield Finding(path, f"missing key: every cylinder has {what}", f"add {key} = {example}")
    yield from _check_crank(engine, ("engine",), engine)
    for index, cylinder in cylinders:
        if {*_LENGTHS} & {*cylinder}:
            yield from _check_crank({**engine, **cylinder}, ("engine", "cylinders", index), cylinder)


def _check_crank(sizes: Raw, path: Path, own: Raw) -> Iterator[Finding]:
    """The rod is longer than crank and offset; ``own`` holds those of the sizes that stand in the path's table."""
    rod, crank, offset = (amount(sizes.get(key, otherwise), "length") for key, otherwise in _LENGTHS.items())
    if not rod or not crank or offset is None or crank + abs(offset) < rod:
        return
    aside = " and offset" if offset else ""
    yield Finding(
        (*path, next(key for key in _LENGTHS if key in own)),
        f"the rod, {show(sizes['rod_length'])}, is not longer than the crank{aside}: the crank cannot turn",
        "change the lengths",
    )


CHECKS = (check_form, check_arrangement, check_firing, check_orders, check_sizes)
