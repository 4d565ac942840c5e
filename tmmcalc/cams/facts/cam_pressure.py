"""The documents of the pressure angle: extremes on rise and return beside their limits, the table over the turn.

People read degrees; programs get the same under headers that say so, as everywhere with angles.
"""

from __future__ import annotations

from math import degrees
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.pressure.angle import Reached
from tmmcalc.cams.pressure.solve import Pressure, pressure_columns
from tmmcalc.core.quantity import Quantity, keyed, quantity_of
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number

ROWS = 40  # of the table for people
STEPS = (1.0, 2.0, 5.0, 10.0, 15.0)  # [deg] of its rows
STILL, NEAR = 1e-12, 1e-6
AT = Quantity("{what}_at_phi[deg]", "angle of the cam where {what} stands")
EXTREMES = (
    *("theta_min[deg]", "theta_min_phi[deg]", "theta_max[deg]", "theta_max_phi[deg]"),
    *("limit[deg]", "gamma_min", "exceeded[deg]"),
)
VERDICTS = {"ok": "within the limits", "pressure_angle_exceeded": "a limit is exceeded"}


def summary(result: Pressure, title: str) -> Document:
    """Facts and warnings without the table."""
    return Document(title, _facts(result), result.notes)


def document(result: Pressure, title: str, *, everything: bool = False) -> Document:
    """Facts, warnings, and theta with the transmission angle; people get rows of the moving phases, some forty."""
    columns, notes = pressure_columns(result), result.notes
    if not everything:
        if result.follower.kind == "flat":
            return Document(title, _facts(result), notes)
        kept = _told(result)
        if len(kept) < len(result.phi):
            columns = {header: column[kept] for header, column in columns.items()}
            notes = (*notes, "note: the table leaves rows out; --format csv prints all")
    return Document(title, _facts(result), notes, View(list(columns), [each.tolist() for each in columns.values()]))


def _told(result: Pressure) -> list[int]:
    """Rows that people read: ends of the moving phases, and of the others those at round angles."""
    theta, phi, count = result.theta, np.degrees(result.phi), len(result.phi)
    still = np.abs(np.diff(theta, prepend=theta[-1], append=theta[0])) < STILL
    moving = np.flatnonzero(~(still[:-1] & still[1:]))
    ends = set(np.flatnonzero(still[:-1] != still[1:]).tolist())
    step = next((step for step in STEPS if np.sum(_round(phi[moving], step)) <= ROWS), STEPS[-1])
    every = count <= ROWS
    return [k for k in range(count) if every or k in ends or (k in moving and _round(phi[k], step))]


def _round(phi: NDArray[np.floating], step: float) -> NDArray[np.bool_]:
    return np.asarray(np.abs(phi / step - np.round(phi / step)) < NEAR)


def _facts(result: Pressure) -> tuple[Fact, ...]:
    facts = [Fact("verdict", VERDICTS[result.verdict], {"verdict": result.verdict})]
    if result.follower.kind == "flat":
        return (*facts, Fact("pressure angle", "0 everywhere: the force on a flat face is along the follower"))
    return (*facts, reached_fact("rise", result.rise), reached_fact("return", result.back))


def extreme_values(of: object, name: str) -> dict[str, Any]:
    """An extreme value that is a field of a record by its key, and the angle of the cam where it stands."""
    told, extreme = quantity_of(type(of), name), getattr(of, name)
    return {told.key: extreme.value, AT.of(what=told.name).key: degrees(extreme.phi)}


def reached_fact(phase: str, on: Reached) -> Fact:
    """The extremes of theta on a phase, its limit, the least transmission angle, where the limit is exceeded."""
    limit = "not limited" if on.limit is None else f"limit {angle(degrees(on.limit))} deg"
    lines = [
        f"{word} {angle(degrees(extreme.value))} deg at phi = {angle(degrees(extreme.phi))} deg"
        for word, extreme in (("min", on.least), ("max", on.largest))
    ]
    lines.append(f"{limit}; transmission angle at least {number(on.gamma_min)} deg")
    lines += [f"beyond it for phi from {angle(degrees(a))} to {angle(degrees(b))} deg" for a, b in on.exceeded]
    return Fact(f"pressure angle, {phase}", "\n".join(lines), keyed(on, *EXTREMES, phase=phase))
