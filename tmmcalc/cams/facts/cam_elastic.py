"""The documents of the elastic follower: natural frequency, vibration, contact, the laws compared."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import Any

import numpy as np

from tmmcalc.cams.elastic import ElasticResult, Spectrum, elastic_columns
from tmmcalc.cams.follower import along
from tmmcalc.cams.separation import Contact
from tmmcalc.core.quantity import keyed, quantity_of
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number
from tmmcalc.report.sizes import plain


def summary(result: ElasticResult, title: str) -> Document:
    """Frequency, vibration and warnings."""
    return Document(title, tuple(_facts(result)), result.notes)


def document(result: ElasticResult, title: str, *, everything: bool = False) -> Document:
    """The same with the laws compared; with ``everything`` the course along the turn, in SI."""
    table = plain(elastic_columns(result)) if everything else _laws_view(result)
    return Document(title, tuple(_facts(result)), result.notes, table)


def _length(result: ElasticResult, value: float) -> str:
    return f"{number(degrees(value), 5)} deg" if result.turns else f"{number(1e3 * value, 5)} mm"


def _facts(result: ElasticResult) -> Iterator[Fact]:
    places = along(result.turns)
    unit, force = places["size"], places["force"]
    text = f"{number(result.hertz, 6)} Hz, {number(result.multiple, 6)} times that of the cam"
    damping = f"\ndamping {number(result.damping, 4)} of critical" if result.damping else "\nno damping"
    yield Fact("natural frequency", text + damping, keyed(result, "hertz", "multiple", "damping"))
    for each in result.phases:
        text = (
            f"phase time / natural period = {number(each.ratio, 5)}\nresidual amplitude "
            f"{_length(result, each.residual)} ({number(100 * each.relative, 4)} % of the stroke)\n"
            f"in the steady motion {_length(result, each.steady)}"
        )
        values = keyed(each, "ratio", "residual", "steady", phase=each.kind, **places)
        yield Fact(f"after the {each.kind}", text, values)
    text = (
        f"{number(result.peak_response, 6)} {unit}/s^2 at phi = {angle(degrees(result.peak_phi))} deg, "
        f"{number(result.peak_response / result.peak_given, 5)} times that of the law"
    )
    values = keyed(result, "peak_response", "peak_given", "peak_phi[deg]", **places)
    yield Fact("largest acceleration", text, values)
    text = f"up to {number(result.train, 6)} {force}, deflection up to {_length(result, result.largest)}"
    yield Fact("force in the train", text, keyed(result, "train", "largest", **places))
    yield _contact_fact(result.contact, force)


def _contact_fact(contact: Contact, force: str) -> Fact:
    """Kept or lost; in a groove the changes of the wall."""
    values = keyed(contact, "largest", "judged", force=force)
    if contact.closure == "groove":
        text = f"two walls hold the roller; it goes from wall to wall {len(contact.reversals)} times a turn"
        return Fact("contact", text, values | keyed(contact, "reversals[deg]"))
    if not contact.judged:
        return Fact("contact", "not judged: what presses the follower on the cam is not known", values)
    text = f"{'lost' if contact.lost else 'kept'}: the load comes to {number(contact.largest, 5)} {force}"
    if contact.lost:
        text += f" and lifts off on {len(contact.lost)} interval{'s' if len(contact.lost) > 1 else ''}"
    return Fact("contact", text, values | keyed(contact, "lost[deg]"))


def _laws_view(result: ElasticResult) -> View:
    """Residual vibration of the laws at the ratio of the rise."""
    ratio = result.phases[0].ratio
    inside = bool(result.ratios[0] <= ratio <= result.ratios[-1])
    at = ratio if inside else float(result.ratios[-1])
    rows: list[tuple[float, float, str]] = sorted(
        (
            float(np.interp(at, result.ratios, each.residual)),
            float(np.interp(at, result.ratios, each.acceleration)),
            each.law,
        )
        for each in result.spectra
    )
    headers = ["law"]
    shown: list[list[Any]] = [[law for _, _, law in rows]]
    for name, sizes in (("residual", [size for size, _, _ in rows]), ("acceleration", [size for _, size, _ in rows])):
        header, factor = quantity_of(Spectrum, name, ratio=number(at, 4)).shown("%")
        headers.append(header)
        shown.append([round(factor * size, 4) for size in sizes])
    return View(headers, shown)
