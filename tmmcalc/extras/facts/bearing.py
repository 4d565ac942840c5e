"""The document of the rolling bearing: speeds, sizes, frequencies of defects, crest factors."""

from __future__ import annotations

from tmmcalc.core.quantity import keyed, quantities
from tmmcalc.extras.bearing import Bearing
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number
from tmmcalc.report.sizes import quantity

CREST = quantities(Bearing)["crest"]
FREQUENCIES = (
    ("cage", "cage"),
    ("outer raceway", "outer_race"),
    ("inner raceway", "inner_race"),
    ("rolling body", "roller"),
)


def summary(result: Bearing, title: str) -> Document:
    """Speeds, sizes, frequencies of defects, crest factors."""
    speed = f"{number(result.omega)} rad/s, n = {number(result.turns)} 1/s ({number(60 * result.turns)} rpm)"
    sizes = f"between the rings {quantity(result.width, 'm')}, half of it {quantity(result.half, 'm')}; mean radius "
    facts = [
        Fact("speed", speed, keyed(result, "omega", "turns")),
        Fact(
            "sizes",
            f"{sizes}{quantity(result.mean_radius, 'm')}",
            keyed(result, "width", "half", "mean_radius"),
        ),
        Fact("speed of the inner ring", f"{number(result.raceway_speed)} m/s", keyed(result, "raceway_speed")),
        *(_frequency_fact(result, label, name) for label, name in FREQUENCIES),
    ]
    if result.crest:
        text = ", ".join(number(each, 4) for each in result.crest)
        facts.append(Fact("crest factors", text, {CREST.key: list(result.crest)}))
    return Document(title, tuple(facts), result.notes)


def _frequency_fact(result: Bearing, label: str, name: str) -> Fact:
    told = quantities(Bearing)[name]
    return Fact(label, f"{told.name} = {number(getattr(result, name))} {told.unit}", keyed(result, name))
