"""Checks of ``[optimize]``: something is sought, each key is a number that varies once, limits leave room."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.design.tables.checks.ranges import check_keys, check_values, listed
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, tables
from tmmcalc.spec.phrases import Path, show

SENSES = ("least", "greatest")


def check_optimize(outline: Outline) -> Iterator[Finding]:
    """One result at least is sought and none twice; variables are numbers of the spec, none twice."""
    optimize = outline.document.get("optimize", {})
    if not isinstance(optimize, dict):
        return
    sought = [name for sense in SENSES for name in listed(optimize.get(sense))]
    if not sought:
        rule = "missing key: least or greatest, the result that is sought"
        yield Finding(("optimize",), rule, 'add least = "kinematics.max(aS_D)"')
    for name in {*listed(optimize.get("least"))} & {*listed(optimize.get("greatest"))}:
        rule = f"{show(name)} is to be least and greatest"
        yield Finding(("optimize", "greatest"), rule, "remove it from one of them")
    seen: dict[Path, str] = {}
    for index, variable in tables(optimize, "variables"):
        path: Path = ("optimize", "variables", index)
        units = yield from check_keys(path, variable, outline.document, seen, "varied", "the variables")
        yield from check_values(path, variable, units, "sought", "the variable")


CHECKS = (check_optimize,)
