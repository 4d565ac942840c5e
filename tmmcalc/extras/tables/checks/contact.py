"""``[contact]``: what is given once, and a table of the gap."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amounts, check_one_of, first_disorder

_GAPS = ("radii", "gap", "table")


def check_contact(outline: Outline) -> Iterator[Finding]:
    """The gap is given in one way, and so is the modulus; a formula has its grid."""
    table = outline.document.get("contact")
    if not isinstance(table, dict):
        return
    yield from check_one_of(("contact",), table, _GAPS, 'add radii = "20 mm", for example')
    if "modulus" in table and {"young", "poisson"} & {*table}:
        key = "young" if "young" in table else "poisson"
        yield Finding(("contact", key), f"{key} together with modulus: it is that of both bodies", "remove one of them")
    if "gap" in table and "size" not in table:
        rule = "missing key: a formula does not tell how far the contact reaches"
        yield Finding(("contact",), rule, 'add size = "2 mm"')
    radii = table.get("radii")
    if isinstance(radii, list) and len(radii) > 2:
        yield Finding(("contact", "radii"), f"{len(radii)} radii: there are two planes", "write one, or two")
    if isinstance(table.get("gap"), str):
        from tmmcalc.core.expression import parse_field  # late: only formulas need it

        try:
            parse_field(table["gap"], ("x", "y"), "contact.gap")
        except UsageError as fault:
            yield Finding(("contact", "gap"), fault.message, fault.remedy)
    if isinstance(table.get("table"), dict):
        yield from _check_gap_table(table["table"])


def _check_gap_table(table: Raw) -> Iterator[Finding]:
    path: Path = ("contact", "table")
    axes = {key: amounts(table.get(key), "length") for key in ("x", "y")}
    for key, places in axes.items():
        if places is not None and len(places) < 2:
            yield Finding((*path, key), "one place is no table", "write two or more")
        disorder = None if places is None else first_disorder(places)
        if disorder is not None:
            yield Finding((*path, key, disorder), "places ascend", "put them in order")
    x, y, h = axes["x"], axes["y"], table.get("h")
    if x is None or y is None or not isinstance(h, list):
        return
    if len(h) != len(y):
        yield Finding((*path, "h"), f"{len(h)} rows for {len(y)} places along y", "write one for each")
    for k, row in enumerate(h):
        if isinstance(row, list) and len(row) != len(x):
            yield Finding((*path, "h", k), f"{len(row)} values for {len(x)} places along x", "write one for each")


CHECKS = (check_contact,)
