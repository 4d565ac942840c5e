"""The document of the plans of velocities and accelerations: the scale, how the links turn, a row a vector."""

from __future__ import annotations

from collections.abc import Sequence

from tmmcalc.core.quantity import keyed, table
from tmmcalc.linkage.columns import LINK
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.segments import PlanScale, Segment, crank_scale, longest, segments
from tmmcalc.linkage.vectors import VectorPolygons
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number, round_scale

REACH = 100.0  # longest segment at a round scale [mm]
STILL = 1e-12  # rad/s or rad/s^2 that have no sense


def polygons_document(
    mechanism: Mechanism, result: Kinematics, title: str, rows: Sequence[int], crank: float | None = None
) -> Document:
    """The plans of positions by their indices; ``crank`` is the length of the crank's segments [mm].

    Without it the factors are round, with the longest segment within 100 mm. Raises `UsageError` for the scale of
    the crank of a driven slider.
    """
    plans = [polygons(mechanism, result, row, special=True) for row in rows]
    scale = _round(plans) if crank is None else crank_scale(result, crank)
    found = [
        segment for row, plan in zip(rows, plans, strict=True) for segment in segments(plan, result.labels[row], scale)
    ]
    columns = table(found, Segment)
    columns = {key: ["" if cell is None else cell for cell in cells] for key, cells in columns.items()}
    facts = (
        _scale_fact(scale, crank),
        *(_rotation_fact(result.labels[row], plan) for row, plan in zip(rows, plans, strict=True)),
    )
    return Document(title, facts, table=View([*columns], [*columns.values()]))


def _round(plans: Sequence[VectorPolygons]) -> PlanScale:
    velocity, acceleration = longest(plans)
    return PlanScale(round_scale(velocity / REACH), round_scale(acceleration / REACH))


def _scale_fact(scale: PlanScale, crank: float | None) -> Fact:
    text = f"mu_v = {number(scale.velocity)} (m/s)/mm, mu_a = {number(scale.acceleration)} (m/s^2)/mm"
    text += "" if crank is None else f"\nof the crank: the segments of its pin are {number(crank)} mm"
    return Fact("scale", text, keyed(scale))


def _rotation_fact(position: str, plan: VectorPolygons) -> Fact:
    """omega and eps of the links that turn, with their senses."""
    _, omega, eps, *_ = LINK
    lines, values = [], dict[str, float]()
    for link, rate in plan.omega.items():
        turn = {"link": link, "omega": "rad/s", "eps": "rad/s^2"}
        values |= omega.of(**turn).value(rate) | eps.of(**turn).value(plan.eps[link])
        lines.append(f"link {link}: omega {_turn(rate, 'rad/s')}, eps {_turn(plan.eps[link], 'rad/s^2')}")
    return Fact(f"rotation in position {position}", "\n".join(lines), {f"rotation_in_{position}": values})


def _turn(value: float, unit: str) -> str:
    sense = "" if abs(value) < STILL else " ccw" if value > 0 else " cw"
    return f"{number(abs(value) if sense else 0.0, 6)} {unit}{sense}"
