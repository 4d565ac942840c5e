"""The columns of the pendulum-rotor: mode shapes, Campbell diagram, motion in time.

series                    "modes", "campbell" or "swing"
a, <name>_1 ...           place along the rod; shapes of the modes of every sense of whirl or plane
spin                      speed of spin
f_forward_1, f_backward_1 frequencies of whirl
whirl                     displacement of the lower end by the eccentricity, turning with the rotor
t, v, w                   time; displacement of the lower end from under the joint along x and y
slope_v, slope_w          slopes there
x_O, y_O                  place of the joint
E                         energy against the carrier
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.quantity import headed
from tmmcalc.vibration.pendulum.results import SHAPE, WHIRL, Campbell, PendulumResult
from tmmcalc.vibration.series import stacked


def pendulum_columns(result: PendulumResult) -> dict[str, np.ndarray]:
    """All columns by header."""
    return stacked(dict(_series(result)))


def _series(result: PendulumResult) -> Iterator[tuple[str, dict[str, np.ndarray]]]:
    shapes = {
        SHAPE.of(whirl=modes.name.replace(" ", "_"), mode=k).key: shape
        for modes in result.modes
        for k, shape in enumerate(modes.shapes, 1)
    }
    yield "modes", headed(result, "place") | shapes
    if result.campbell is not None:
        yield "campbell", campbell_columns(result.campbell)
    if result.swing is not None:
        yield "swing", headed(result.swing, "t", "v", "w", "slope_v", "slope_w", "carrier_x", "carrier_y", "energy")


def campbell_columns(campbell: Campbell) -> dict[str, np.ndarray]:
    """The diagram by its headers."""
    found = headed(campbell, "spin")
    for name, rows in (("forward", campbell.forward), ("backward", campbell.backward)):
        found |= {WHIRL.of(whirl=name, mode=k).key: row / (2 * np.pi) for k, row in enumerate(rows, 1)}
    return found | (headed(campbell, "whirl") if len(campbell.whirl) else {})
