"""What a load does along the motion: its value, its power, its work over the cycle."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc import solve_kinematics
from tmmcalc.core.numerics.panels import Panels, panels
from tmmcalc.linkage.loading import Load, Loading, Spring
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.model import Mechanism

Array = NDArray[Any]


def scene_of(mechanism: Mechanism, *loads: Load, springs: tuple[Spring, ...] = ()) -> Scene:
    return compile_scene(mechanism, Loading(loads=loads, springs=springs), solve_kinematics(mechanism))


def value(scene: Scene, theta: Array) -> Array:
    """Value of the only load of a scene: its force along its direction, or its moment."""
    (source,) = scene.sources
    place = scene.place(np.asarray(theta, float))
    action = source.actions(place)[0]
    load = next(load for load in scene.loading.loads if load.name == source.name)
    if load.kind == "moment":
        return np.broadcast_to(action.moment, np.shape(theta))
    direction = load.direction * place.configuration.motions[load.follows].u
    return np.broadcast_to((np.conj(direction) * action.force).real, np.shape(theta))


def power(scene: Scene, theta: Array) -> Array:
    """Power of all sources together in time, at the speed of the input."""
    travel, place = scene.travel, scene.place(np.asarray(theta, float))
    total = np.zeros(np.shape(theta))
    for source in scene.sources:
        for action in source.actions(place):
            total = total + source.factor(travel.speed) * action.power(place.configuration) * travel.speed
    return total


def dense(scene: Scene, widest: float = np.pi / 36) -> Panels:
    return panels(0.0, scene.travel.period, scene.edges(), widest)


def work(scene: Scene) -> float:
    """Work of all sources over the cycle [J]."""
    on = dense(scene)
    rate = power(scene, on.x.ravel()) / abs(scene.travel.speed)
    return float(on.total(rate.reshape(on.x.shape)))
