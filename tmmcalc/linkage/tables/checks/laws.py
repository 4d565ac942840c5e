"""Checks of ``[[loads]]``: a load has one law, acts in one window; a force has a point, a law what it asks for."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.loadlaws import laws
from tmmcalc.linkage.tables.checks.loads import loads
from tmmcalc.linkage.tables.checks.windows import check_windows
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw
from tmmcalc.spec.phrases import Path, either

_OF_A_FORCE = ("point", "direction", "axes")


def check_laws(outline: Outline) -> Iterator[Finding]:
    """A load has exactly one law, and a force has a point."""
    for path, load in loads(outline):
        given = [key for key in laws() if key in load]
        if not given:
            text = f"missing key: a load has one law: {either(tuple(laws()))}"
            yield Finding(path, text, 'add force = "1500 N", for example')
        for key in given[1:]:
            yield Finding(
                (*path, key), f"{' and '.join(given)} together: a load has one law", "write one [[loads]] for each"
            )
        if len(given) == 1:
            yield from _check_kind(load, given[0], path)


def _check_kind(load: Raw, key: str, path: Path) -> Iterator[Finding]:
    law = laws()[key]
    faults = list(law.check_kind(load, key, path))
    yield from faults
    if faults:
        return
    kind = law.kind_of(load, key)
    if kind == "force" and "point" not in load:
        yield Finding(path, "missing key: a force acts at a point of its link", 'add point = "D"')
    for name in _OF_A_FORCE if kind == "moment" else ():
        if name in load:
            yield Finding((*path, name), f"a moment has no {name}", "remove it, or give a force")


def check_data(outline: Outline) -> Iterator[Finding]:
    """What the law of a load asks for, law by law."""
    for key, law in laws().items():
        for path, load in loads(outline):
            if key in load:
                yield from law.check(outline, load, path)


CHECKS = (check_laws, check_windows, check_data)
