"""Arms and paths that the tests of the manipulators share."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.manipulators.task import (
    ArcRoute,
    ArcThrough,
    Arm,
    Drive,
    ManipulatorTask,
    Obstacle,
    PathTask,
    PolyRoute,
    Route,
)

ARMS = {
    "spherical": Arm("spherical", height=0.3),
    "cylindrical": Arm("cylindrical", height=0.3),
    "elbow up": Arm("angular", upper=0.9, forearm=0.8, elbow=1, height=0.3),
    "elbow down": Arm("angular", upper=0.9, forearm=0.8, elbow=-1, height=0.3),
    "spherical, base": Arm("spherical", True, height=0.3),
    "cylindrical, base": Arm("cylindrical", True, height=0.3),
    "elbow up, base": Arm("angular", True, upper=0.9, forearm=0.8, elbow=1, height=0.3),
    "elbow down, base": Arm("angular", True, upper=0.9, forearm=0.8, elbow=-1, height=0.3),
}
PLANE: dict[str, Route] = {
    "arc": ArcRoute((1.2, 0.3), (0.5, 1.1), 0.8, -1),
    "arc, left": ArcRoute((1.2, 0.3), (0.5, 1.1), 0.8, 1),
    "through": ArcThrough((1.2, 0.3), (1.1, 0.9), (0.5, 1.1)),
    "line": PolyRoute(((1.2, 0.3), (0.5, 1.1))),
    "stops": PolyRoute(((1.2, 0.3), (0.7, 0.5), (0.5, 1.1))),
    "rounded": PolyRoute(((1.2, 0.3), (0.7, 0.5), (0.5, 1.1), (0.9, 1.2)), 0.12),
}
SPACE: dict[str, Route] = {
    "arc": ArcRoute((1.1, -0.4, 0.2), (0.6, 0.7, 0.6), 0.9, 1, (0.1, 0.2, 1.0)),
    "through": ArcThrough((1.1, -0.4, 0.2), (1.0, 0.3, 0.9), (0.6, 0.7, 0.6)),
    "line": PolyRoute(((1.1, -0.4, 0.2), (0.6, 0.7, 0.6))),
    "rounded": PolyRoute(((1.1, -0.4, 0.2), (1.0, 0.2, 0.9), (0.6, 0.7, 0.6)), 0.1),
}


def task(arm: str | Arm, route: str | Route, obstacles: tuple[Obstacle, ...] = (), **more: object) -> ManipulatorTask:
    """A path under 2 m/s^2 and 0.6 m/s, or under other limits."""
    own = ARMS[arm] if isinstance(arm, str) else arm
    way = (SPACE if own.spatial else PLANE)[route] if isinstance(route, str) else route
    limits = {"acceleration": 2.0, "speed": 0.6, **{k: v for k, v in more.items() if k in Drive.__dataclass_fields__}}
    rest = {k: v for k, v in more.items() if k not in Drive.__dataclass_fields__}
    return ManipulatorTask(own, PathTask(way, Drive(**limits)), obstacles=obstacles, **rest)


def derivative(f: Callable[[Values], Values], t: Values, h: float) -> Values:
    """Of the eighth order, centred."""
    weights = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
    return np.asarray(sum(w * (f(t + k * h) - f(t - k * h)) for k, w in enumerate(weights, 1)) / h)
