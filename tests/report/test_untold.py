"""A number that a record gives out is told even where no fact words it."""

from __future__ import annotations

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.report.document import Fact, untold


@record
class Wheel:
    mass: float = quantity("m[kg]", "mass of the wheel")
    radius: float = quantity("r[m]", "radius of the wheel")
    name: str = quantity("name", "name of the wheel")
    limit: float | None = quantity("v[m/s]", "speed that is allowed", default=None)

    @derived("J[kg*m^2]", "inertia of the wheel")
    def inertia(self) -> float:
        """Of a thin ring."""
        return self.mass * self.radius**2


def test_what_no_fact_tells_is_told() -> None:
    facts = [Fact("mass", "2 kg", {"m[kg]": 2.0})]
    found = list(untold(facts, Wheel(2.0, 0.5, "a")))
    assert [(fact.label, fact.text) for fact in found] == [
        ("radius of the wheel", "0.5 m"),
        ("inertia of the wheel", "0.5 kg*m^2"),
    ]
    assert found[1].values == {"J[kg*m^2]": 0.5}


def test_what_needs_no_fact_gets_none() -> None:
    assert [fact.label for fact in untold([], Wheel(2.0, 0.5, "a"), but=("mass", "radius"))] == ["inertia of the wheel"]
