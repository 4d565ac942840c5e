"""What is asked of the path of a point: the points that it is to pass, and when."""

from __future__ import annotations

from tmmcalc.core.records import record


@record
class WantedPath:
    """The wanted path of a point of the linkage: n points of a figure [m], in their order, and where it stands."""

    name: str
    point: str
    through: tuple[complex, ...]
    at: tuple[float, ...] = ()  # input coordinates of the points from position 0 [rad or m]; empty: none are prescribed
    turn: float = 0.0  # of the figure about the origin [rad]
    shift: complex = 0j  # of the turned figure [m]
