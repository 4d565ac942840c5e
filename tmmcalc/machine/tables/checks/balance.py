"""Checks of ``[balance]``: weights are measured once, on links and points that exist."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.checks import places
from tmmcalc.linkage.tables.checks.written_linkage import FRAME, written_linkage
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, tables
from tmmcalc.spec.phrases import Path, show


def check_crank(outline: Outline) -> Iterator[Finding]:
    """What is balanced turns; weights have a mass or a radius; moments are about a point of the frame."""
    linkage = written_linkage(outline)
    balance = subtable(outline.document, "balance")
    if linkage.slides and linkage.input_joint is not None:
        joint = f'the input joint "{linkage.input_joint.name}" is prismatic'
        yield Finding(("balance",), f"{joint}; balancing is that of a mechanism with a crank", "remove [balance]")
    yield from _check_measure(balance, ("balance",), needed=False)
    yield from places.check_point(outline, FRAME, balance.get("point"), ("balance", "point"))
    written = balance.get("schemes")
    schemes = written if isinstance(written, list) else []
    for index, scheme in enumerate(schemes):
        if scheme in schemes[:index]:
            yield Finding(("balance", "schemes", index), f"{show(scheme)} is named twice", "remove one of them")


def check_counterweights(outline: Outline) -> Iterator[Finding]:
    """A counterweight is on a link that exists, one on each, with a mass or a radius."""
    first: dict[int, int] = {}
    for index, weight in tables(subtable(outline.document, "balance"), "counterweights"):
        path: Path = ("balance", "counterweights", index)
        link = weight.get("link")
        yield from places.check_link(outline, link, (*path, "link"))
        if is_integer(link) and link in first:
            line = outline.at_line(("balance", "counterweights", first[link]))
            yield Finding((*path, "link"), f"link {link} has a counterweight already{line}", "one link has one")
        if is_integer(link):
            first.setdefault(link, index)
        yield from _check_measure(weight, path, needed=True)


def _check_measure(weight: Raw, path: Path, *, needed: bool) -> Iterator[Finding]:
    if "mass" in weight and "radius" in weight:
        rule = "mass and radius together: one is chosen, the other follows from the balance"
        yield Finding((*path, "radius"), rule, "remove one of them")
    if needed and not {"mass", "radius"} & {*weight}:
        yield Finding(path, "missing key: a counterweight has its mass or its radius", 'add radius = "60 mm"')


def check_added(outline: Outline) -> Iterator[Finding]:
    """A rotating weight turns; that of order 1 sits on the crank."""
    for index, weight in tables(subtable(outline.document, "balance"), "add"):
        path: Path = ("balance", "add", index)
        order = weight.get("order")
        if is_integer(order) and order == 0:
            rule = "0 is no order: a weight that stands still balances nothing"
            yield Finding((*path, "order"), rule, "write 1 for the crank itself, -1 for a shaft that turns against it")
        if order == 1 and "axis" in weight:
            rule = "a weight of order 1 sits on the crank and has no axis of its own"
            yield Finding((*path, "axis"), rule, "remove axis")


CHECKS = (check_crank, check_counterweights, check_added)
