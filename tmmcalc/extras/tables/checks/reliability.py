"""``[reliability]``: the loads differ, the strength is known."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount, amounts, check_one_of

_LIFE = ("items", "least_life", "mean_life")


def check_reliability(outline: Outline) -> Iterator[Finding]:
    """The loads differ; the strength is given, or a test that it is estimated from."""
    table = outline.document.get("reliability")
    if not isinstance(table, dict):
        return
    path: Path = ("reliability",)
    yield from check_one_of(path, table, ("load", "readings"), "add load = [2, 2.5]")
    given = [key for key in _LIFE if key in table]
    known = [key for key in ("strength", "decay") if key in table]
    if given and known:
        rule = f"{known[0]} together with {given[0]}: the test gives it"
        yield Finding((*path, known[0]), rule, "remove one of them")
    elif not given and len(known) < 2:
        rule = "missing key: the strength is known by strength and decay, or by a test"
        yield Finding(path, rule, "add strength = 2.56 and decay = 2.6e-4; or items, least_life and mean_life")
    elif given and len(given) < len(_LIFE):
        absent = next(key for key in _LIFE if key not in table)
        yield Finding(path, f"missing key: {given[0]} without {absent}", f"add {absent} = 150")
    least, mean = amount(table.get("least_life")), amount(table.get("mean_life"))
    if least is not None and mean is not None and least >= mean > 0:
        yield Finding((*path, "mean_life"), f"a mean life of {mean:g} is not above the shortest", "write a longer one")
    loads = amounts(table.get("load"))
    if loads is not None and len(loads) == 2 and loads[0] >= loads[1]:
        yield Finding((*path, "load"), f"loads from {loads[0]:g} to {loads[1]:g}", "write the smaller one first")
    readings = amounts(table.get("readings"))
    if readings and len({*readings}) < 2:
        yield Finding((*path, "readings"), "equal readings tell no range of loads", "write two different ones or more")


CHECKS = (check_reliability,)
