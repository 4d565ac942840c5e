"""Plans of the linkage at every position: velocities, accelerations, forces of each free body, the lever."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.rows import Rows
from tmmcalc.linkage.freebody import FreeBody, Solved, bodies_at
from tmmcalc.linkage.lever import Lever, LeverForce, levers, working
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.vectors import designation, vertex_name
from tmmcalc.linkage.polygons import polygons_of_all
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.vectors import PolygonOverAll
from tmmcalc.report.drawing.lettering import symbol
from tmmcalc.report.moving import Edge, Plan

SHORT = 1e-6  # a vector that is shorter in all positions, against the largest, is nothing
ARROW = 0.45  # of the plan: how long the largest force of the lever is drawn


def plans_of_motion(mechanism: Mechanism, result: Kinematics) -> Iterator[Plan]:
    """The plans of velocities and of accelerations."""
    velocity, acceleration, fixed = polygons_of_all(mechanism, result)
    for name, letter, title, unit, plan in (
        ("plan-v", "v", "Plan of velocities", "m/s", velocity),
        ("plan-a", "a", "Plan of accelerations", "m/s^2", acceleration),
    ):
        yield _plan_of_motion(name, letter, title, unit, plan, fixed)


def _plan_of_motion(name: str, letter: str, title: str, unit: str, plan: PolygonOverAll, fixed: Sequence[str]) -> Plan:
    tips = plan.vertices
    names = list(tips)
    size = max(float(np.abs(tip).max()) for tip in tips.values())
    edges = tuple(
        Edge(names.index(each.tail), names.index(each.head), designation(each, letter).strip("$"), each.kind)
        for each in plan.vectors
        if float(np.abs(tips[each.head] - tips[each.tail]).max()) > SHORT * size
    )
    pole = ", ".join([vertex_name(plan.pole), *map(vertex_name, fixed)])
    said = {each: pole if each == plan.pole else vertex_name(each) for each in names}
    return Plan(name, title, unit, tuple((said[each].replace("$", ""), tips[each]) for each in names), edges)


def plans_of_forces(rows: Rows, found: Solved, per: float) -> Iterator[Plan]:
    """The polygon of forces of each free body, the lever of Zhukovsky; ``per`` is the unit of the places."""
    result = rows.result
    places = result.phi / per
    bodies = [bodies_at(found, row) for row in range(len(result.labels))]
    for k, body in enumerate(bodies[0]):
        yield _polygon(f"forces-{k}", [each[k] for each in bodies], body.name, places)
    yield _lever(levers(rows.statics, rows.kinematics, result.theta, rows.side, 1.0), places)


def _polygon(name: str, bodies: Sequence[FreeBody], title: str, places: Real) -> Plan:
    """The forces of a body one after another; one that is nothing somewhere has no length there."""
    order: dict[tuple[str, str], None] = {}
    for body in bodies:
        for each in body.forces:
            order.setdefault((symbol(each.letter, each.index), each.kind))
    values = {key: np.zeros(len(bodies), complex) for key in order}
    for row, body in enumerate(bodies):
        for each in body.forces:
            values[symbol(each.letter, each.index), each.kind][row] += each.value
    corners = [np.zeros(len(bodies), complex), *np.cumsum([*values.values()], axis=0)]
    edges = [Edge(k, k + 1, sign.strip("$"), kind) for k, (sign, kind) in enumerate(order)]
    return Plan(
        name,
        Phrase("Forces on {body}", body=title),
        "N",
        tuple(("", corner) for corner in corners),
        tuple(edges),
        places,
    )


def _lever(found: Sequence[Lever], places: Real) -> Plan:
    """Turned velocities of the points of the forces from the pole, the forces at their ends, their arms."""
    shown = [{_key(force): force for force in working([*lever.forces, *lever.balancing])} for lever in found]
    keys = list(dict.fromkeys(key for each in shown for key in each))
    tips = {key: np.array([_tip(each.get(key)) for each in shown]) for key in keys}
    size = max((float(np.abs(tip).max()) for tip in tips.values()), default=0.0)
    largest = max((force.force for each in shown for force in each.values()), default=1.0)
    vertices: list[tuple[str, Plane]] = [("p", np.zeros(len(found), complex))]
    edges: list[Edge] = []
    for key in keys:
        along = np.array([_along(each.get(key)) for each in shown])
        strength = np.array([each[key].force if key in each else 0.0 for each in shown]) / largest
        arm = np.array([each[key].arm if key in each else 0.0 for each in shown])
        at = len(vertices)
        vertices += [("", tips[key]), ("", tips[key] + ARROW * size * strength * along), ("", -1j * along * arm)]
        edges.append(Edge(0, at, "", "turned"))
        edges.append(Edge(at, at + 1, _sign(key), key[1]))
        edges.append(Edge(0, at + 2, "", "arm"))
    return Plan(
        "lever",
        "Lever of Zhukovsky",
        "m/s",
        tuple(vertices),
        tuple(edges),
        places,
        "velocities turned by 90° clockwise; arrows of forces are longer for larger forces, but not to scale",
    )


_Key = tuple[str, str, int, str]  # name, kind, link, point


def _key(force: LeverForce) -> _Key:
    return force.name, force.kind, force.link, force.point


def _sign(key: _Key) -> str:
    """The sign of a force; of a pair that stands for a couple with the point where it stands."""
    name, _, _, point = key
    letter, index = name[:1], name[1:]
    index = ",".join(each for each in (index, point) if each)
    return f"{letter}_{{{index}}}" if index else letter


def _tip(force: LeverForce | None) -> complex:
    return complex(force.x, force.y) if force is not None else 0j


def _along(force: LeverForce | None) -> complex:
    return cmath.rect(1.0, math.radians(force.direction)) if force is not None else 0j
