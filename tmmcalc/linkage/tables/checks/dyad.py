"""Checks of ``[dyad]``: the metric of its kind, a turning where there is a guide, names of points."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.tables.dyad import METRIC
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable
from tmmcalc.spec.phrases import show
from tmmcalc.spec.values import check_bare_speed

_PORTS = (("first", "a", 0), ("second", "b", 2))  # the table, the link, the place of its letter in the kind
_TURNING = ("angle", "omega", "eps")
_TOLD = ("first", "inner", "second")  # names that the results have for the joints


def check_dyad(outline: Outline) -> Iterator[Finding]:
    """The keys are those of the kind; points have names of their own."""
    dyad = subtable(outline.document, "dyad")
    kind = dyad.get("kind")
    if isinstance(kind, str) and kind in METRIC:
        yield from _check_metric(dyad, kind)
        yield from _check_ports(dyad, kind)
    yield from _check_points(dyad)


def _check_metric(dyad: Raw, kind: str) -> Iterator[Finding]:
    own = METRIC[kind]
    for key in own:
        if key.startswith("length") and key not in dyad:
            yield Finding(("dyad",), f"missing key: {key}: {kind} has this length", f'add {key} = "700 mm"')
    for key in dict.fromkeys(key for keys in METRIC.values() for key in keys):
        if key in dyad and key not in own:
            others = " and ".join(other for other, keys in METRIC.items() if key in keys)
            rule = f"{key} is a key of {others}; {kind} has {', '.join(own)}"
            yield Finding(("dyad", key), rule, "remove it, or change the kind")


def _check_ports(dyad: Raw, kind: str) -> Iterator[Finding]:
    for name, link, place in _PORTS:
        port = subtable(dyad, name)
        if kind[place] == "P":
            yield from check_bare_speed(port.get("omega"), ("dyad", name, "omega"))
            continue
        for key in _TURNING:
            if key in port:
                rule = f"{key} of a pin: the outer joint of {link} in {kind} is revolute, its state is that of a point"
                yield Finding(("dyad", name, key), rule, "remove it, or change the kind")


def _check_points(dyad: Raw) -> Iterator[Finding]:
    of_a = subtable(dyad, "points_a")
    for key in ("points_a", "points_b"):
        for name in subtable(dyad, key):
            if name in _TOLD:
                rule = f"{show(name)} is the name of a joint in the results"
                yield Finding(("dyad", key, name), rule, "choose another name")
            elif key == "points_b" and name in of_a:
                yield Finding(("dyad", key, name), f"{show(name)} is already a point of a", "choose another name")


CHECKS = (check_dyad,)
