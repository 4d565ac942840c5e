"""The rack swept through all its positions: what it leaves of a tooth, without any envelope formula."""

from __future__ import annotations

import json
from math import cos, sin, tan
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.wheel import Wheel

CASES: dict[str, Any] = {
    case["id"]: case
    for case in json.loads((Path(__file__).parents[3] / "cases" / "involute-geometry.json").read_text())
    if case["verified"]
}


def half_angles(wheel: Wheel, radii: np.ndarray, shape: Shape) -> np.ndarray:
    """Half the angle of the tooth [rad] left at ``radii``.

    A point at the polar angle omega of the wheel and nu of the frame enters the rack where it lies left of the rack's
    edge f: R sin(nu) + r phi <= f(R cos(nu) - r), omega = nu + phi. The largest omega is the flank.
    """
    rack, r, x, helix = wheel.rack, wheel.reference, float(wheel.shift), wheel.helix
    slope, lowest = tan(rack.angle) / cos(helix), x - rack.addendum - rack.clearance
    # the rounding touches the flat and the straight flank: in the normal section, or as a circle of equal height
    angle = np.arctan(slope) if shape == "circle" else rack.angle
    radius = rack.radius * (1 - sin(rack.angle)) / (1 - sin(angle))
    stretch = 1.0 if shape == "circle" else 1 / cos(helix)
    end = lowest + radius * (1 - sin(angle))
    centre = end * slope - stretch * radius * cos(angle)

    def edge(y: np.ndarray) -> np.ndarray:
        round_off = np.sqrt(np.maximum(radius**2 - (y - lowest - radius) ** 2, 0.0))
        return np.where(y >= end, y * slope, centre + stretch * round_off)

    found = []
    for R in radii:
        limit = np.arccos(np.clip((r + lowest) / R, -1, 1))
        # finely at first: near the form radius two positions of the rack cut almost equally deep
        low, high, steps = -limit, limit, 40000
        for _ in range(8):
            nu = np.linspace(low, high, steps + 1)
            omega = nu + (edge(R * np.cos(nu) - r) - R * np.sin(nu)) / r
            best, step = int(np.argmax(omega)), (high - low) / steps
            low, high, steps = max(nu[best] - 2 * step, -limit), min(nu[best] + 2 * step, limit), 400
        found.append(float(wheel.half_angle) - omega[best])
    return np.array(found)
