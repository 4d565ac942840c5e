"""The documents of the elastic follower: natural frequency, vibration, contact, the laws compared."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, pi
from typing import Any

import numpy as np

from tmmcalc.cams.elastic import ElasticResult, elastic_columns
from tmmcalc.cams.separation import Contact
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
    unit, force = ("rad", "N*m") if result.turns else ("m", "N")
    text = f"{number(result.frequency / (2 * pi), 6)} Hz, {number(result.multiple, 6)} times that of the cam"
    damping = f"\ndamping {number(result.damping, 4)} of critical" if result.damping else "\nno damping"
    values = {"frequency[Hz]": result.frequency / (2 * pi), "multiple": result.multiple, "zeta": result.damping}
    yield Fact("natural frequency", text + damping, values)
    for each in result.phases:
        text = (
            f"phase time / natural period = {number(each.ratio, 5)}\nresidual amplitude "
            f"{_length(result, each.residual)} ({number(100 * each.relative, 4)} % of the stroke)\n"
            f"in the steady motion {_length(result, each.steady)}"
        )
        name = each.kind
        values = {f"ratio_{name}": each.ratio, f"residual_{name}[{unit}]": each.residual}
        yield Fact(f"after the {name}", text, values | {f"steady_{name}[{unit}]": each.steady})
    text = (
        f"{number(result.peak_response, 6)} {unit}/s^2 at phi = {angle(degrees(result.peak_phi))} deg, "
        f"{number(result.peak_response / result.peak_given, 5)} times that of the law"
    )
    values = {f"a_x_max[{unit}/s^2]": result.peak_response, f"a_y_max[{unit}/s^2]": result.peak_given}
    yield Fact("largest acceleration", text, values | {"a_x_max_at_phi[deg]": degrees(result.peak_phi)})
    text = f"up to {number(result.train, 6)} {force}, deflection up to {_length(result, result.largest)}"
    yield Fact("force in the train", text, {f"train_max[{force}]": result.train, f"z_max[{unit}]": result.largest})
    yield _contact_fact(result.contact, force)


def _contact_fact(contact: Contact, force: str) -> Fact:
    """Kept or lost; in a groove the changes of the wall."""
    values: dict[str, Any] = {f"P_c_max[{force}]": contact.largest, "judged": contact.judged}
    if contact.closure == "groove":
        places = [degrees(phi) for phi in contact.reversals]
        text = f"two walls hold the roller; it goes from wall to wall {len(places)} times a turn"
        return Fact("contact", text, values | {"reversals[deg]": places})
    if not contact.judged:
        return Fact("contact", "not judged: what presses the follower on the cam is not known", values)
    text = f"{'lost' if contact.lost else 'kept'}: the load comes to {number(contact.largest, 5)} {force}"
    if contact.lost:
        text += f" and lifts off on {len(contact.lost)} interval{'s' if len(contact.lost) > 1 else ''}"
    return Fact("contact", text, values | {"lost[deg]": [[degrees(a), degrees(b)] for a, b in contact.lost]})


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
    return View(
        ["law", f"A/h_at_{number(at, 4)}[%]", "a_residual/a_max[%]"],
        [
            [law for _, _, law in rows],
            [round(100 * size, 4) for size, _, _ in rows],
            [round(100 * size, 4) for _, size, _ in rows],
        ],
    )
