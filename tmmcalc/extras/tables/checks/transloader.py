"""``[transloader]``: each load is given once, parts are loaded by loads that are known, K1 is known."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.extras.loadcases import MECHANISMS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, tables, word
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount

_FOUND = ("inertia", "wind", "equivalent_wind", "hurricane")  # loads that have a table


def check_transloader(outline: Outline) -> Iterator[Finding]:
    """Loads, what is set into motion, and the parts."""
    if not isinstance(outline.document.get("transloader"), dict):
        return
    table = subtable(outline.document, "transloader")
    path: Path = ("transloader",)
    loads = subtable(table, "loads")
    for name in _FOUND:
        if name in table and name in loads:
            rule = f"{name} together with [transloader.{name}], which gives it"
            yield Finding((*path, "loads", name), rule, "remove one of them")
    yield from _check_start(table, path)
    if "deflection" in table and "span" not in table:
        yield Finding(path, "missing key: a deflection is measured by the span", 'add span = "60 m"')
    known = {*loads, *(name for name in _FOUND if name in table), "rated_load"}
    if "mass" in table:
        known.add("dead_weight")
    seen: set[str] = set()
    for k, part in tables(table, "parts"):
        yield from _check_part(part, (*path, "parts", k), known)
        called = word(part, "name")
        if called and called in seen:
            yield Finding((*path, "parts", k, "name"), f"a second part is named {called!r}", "give it another name")
        seen.add(called)


def _check_start(table: Raw, path: Path) -> Iterator[Finding]:
    start = subtable(table, "inertia")
    if amount(table.get("gravity", 9.81), "acceleration") == 0 and "inertia" in table:
        yield Finding((*path, "gravity"), "without gravity weights tell no masses", "write a gravity")
    if "inertia" not in table or not isinstance(table["inertia"], dict) or "trolley" in table:
        return
    for key, example in (("speed", '"60 m/min"'), ("time", '"4 s"')):
        if key not in start:
            rule = f"missing key: without [transloader.trolley] the {key} is not known"
            yield Finding((*path, "inertia"), rule, f"add {key} = {example}")


def _check_part(part: Raw, path: Path, known: set[str]) -> Iterator[Finding]:
    mechanism = part.get("mechanism", "hoist")
    known_mechanism = MECHANISMS.get(mechanism) if isinstance(mechanism, str) else None
    if known_mechanism is not None and "importance" not in part and known_mechanism.importance[0] is None:
        rule = f"missing key: the source has no K1 of the mechanism {mechanism!r}"
        yield Finding(path, rule, "add importance = [1.2, 1.1, 1.1], K1 in the cases A, B and V")
    influence = part.get("influence")
    if not isinstance(influence, dict):
        return
    if not influence:
        yield Finding((*path, "influence"), "no load acts on this part", "add dead_weight = 0.5, for example")
    for name in influence:
        if name not in known and amount(influence[name]):
            place = f"[transloader.{name}] or " if name in _FOUND else "mass or " if name == "dead_weight" else ""
            yield Finding(
                (*path, "influence", name),
                f"the load {name} is not known",
                f"give {place}{name} in [transloader.loads]",
            )


CHECKS = (check_transloader,)
