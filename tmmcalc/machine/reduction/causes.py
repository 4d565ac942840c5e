"""What is reduced: every source of load by itself, and friction; their moments and the inertia at any angle."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.kinetostatics import State, Statics, compile_statics
from tmmcalc.linkage.forces.kinks import Cut, faces, pins
from tmmcalc.linkage.forces.verification import friction_power
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.loads.sources import Place, Source
from tmmcalc.linkage.trace import BLOCK
from tmmcalc.machine.reduction.inertia import reduced_inertia


class Sample(NamedTuple):
    """Everything at n angles, along the motion: a positive moment drives."""

    inertia: Real  # (n,)
    slope: Real  # (n,) against theta
    moments: Real  # (S, n) per power of the speed
    idle: Real  # (n,) moment of friction without technological loads
    faces: Real  # (F, n) forces whose signs the friction of sliders depends on, with the loads and without
    pins: Plane  # (P, n) forces whose sizes the friction in pins depends on, the same
    stuck: bool  # whether friction locks the linkage somewhere without the loads

    @property
    def rows(self) -> Real:
        """The functions that are held on panels (3 + S, n)."""
        return np.vstack((self.inertia, self.slope, self.idle, self.moments))

    def columns(self, which: slice) -> Sample:
        """The same at some of the angles."""
        parts: tuple[Any, ...] = self[:-1]
        inertia, slope, moments, idle, on_faces, in_pins = (part[..., which] for part in parts)
        return Sample(inertia, slope, moments, idle, on_faces, in_pins, self.stuck)

    def with_cut(self, cut: Cut, fresh: Sample) -> Sample:
        """The same on panels with further edges, with the values on the fresh ones."""
        parts = (cut.merged(old, new) for old, new in zip(self[:-1], fresh[:-1], strict=True))
        inertia, slope, moments, idle, on_faces, in_pins = parts
        return Sample(inertia, slope, moments, idle, on_faces, in_pins, self.stuck or fresh.stuck)


class Causes(NamedTuple):
    """The sources of a scene, merged by name, and friction as the last if any pair rubs."""

    scene: Scene
    statics: Statics
    quiet: Statics | None  # without technological loads; None if nothing rubs, or nothing but them is there
    names: tuple[tuple[str, str, int], ...]  # name, kind, order in the speed of every contribution

    @property
    def orders(self) -> Indices:
        """Order in the speed of every contribution (S,)."""
        return np.array([order for _, _, order in self.names], dtype=np.intp)

    @property
    def powers(self) -> Real:
        """What each contribution is multiplied by at the mean speed (S,)."""
        return np.asarray(abs(self.scene.travel.speed) ** self.orders)

    @property
    def loaded(self) -> bool:
        """Whether there is a technological load."""
        return any(kind == "load" for _, kind, _ in self.names)

    def sampled(self, theta: Real, side: Real, named: Callable[[NDArray[np.intp]], list[str]]) -> Sample:
        """Everything at theta (n,), each from its side, in blocks that stay in cache; ``named`` tells locked rows."""

        def named_from(first: int) -> Callable[[NDArray[np.intp]], list[str]]:
            return lambda rows: named(rows + first)

        parts = [
            self.at(
                self.scene.place(theta[at : at + BLOCK], side[at : at + BLOCK]), side[at : at + BLOCK], named_from(at)
            )
            for at in range(0, len(theta), BLOCK)
        ]
        if len(parts) == 1:
            return parts[0]
        inertia, slope, moments, idle, on_faces, in_pins = (
            np.concatenate(column, axis=-1) for column in zip(*(part[:-1] for part in parts), strict=True)
        )
        return Sample(inertia, slope, moments, idle, on_faces, in_pins, any(part.stuck for part in parts))

    def most(self, theta: Real) -> float:
        """What the moment of a source could be over theta (n,) if its forces lay along the motion of their points."""
        place, speed = self.scene.place(theta), self.scene.travel.speed
        sizes = (abs(source.factor(speed)) * np.max(most_of(source, place)) for source in self.scene.sources)
        return max(map(float, sizes), default=0.0)

    def along(self, theta: Real) -> Sample:
        """The same at theta (n,) between the positions."""
        return self.sampled(theta, np.ones(len(theta)), lambda rows: self.scene.travel.named(theta[rows]))

    def at(self, place: Place, side: Real, named: Callable[[NDArray[np.intp]], list[str]]) -> Sample:
        """Everything at one place, all of it at once."""
        sense, n, kind = self.scene.travel.sense, len(place.theta), place.theta.dtype
        bodies = self.scene.loading.heavy
        inertia, slope = reduced_inertia(bodies, place.configuration, n) if bodies else np.zeros((2, n), kind)
        moments = np.zeros((len(self.names), n), kind)
        for source in self.scene.sources:
            k = self.names.index((source.name, source.kind, source.order))
            moments[k] += power_of(source, place) * (sense if source.order == 0 else 1.0)
        if not self.statics.scales:
            none = np.zeros((0, n))
            return Sample(inertia, slope * sense, moments, np.zeros(n), none, none + 0j, False)
        from tmmcalc.linkage.forces.locking import refuse_locked  # only what rubs needs it

        state = self.statics.solve(place, side)
        refuse_locked(self.statics, state.solutions, named)
        moments[-1] = self._lost(state, place)
        on_faces, in_pins = faces(self.statics, state, n), pins(self.statics, state, n)
        if self.quiet is None:
            return Sample(inertia, slope * sense, moments, np.zeros(n), on_faces, in_pins, False)
        state = self.quiet.solve(place, side)
        stuck = any(solution.locked.any() for solution in state.solutions.values())
        idle = self._lost(state, place)
        on_faces = np.concatenate((on_faces, faces(self.quiet, state, n)))
        in_pins = np.concatenate((in_pins, pins(self.quiet, state, n)))
        return Sample(inertia, slope * sense, moments, idle, on_faces, in_pins, stuck)

    def _lost(self, state: State, place: Place) -> Real:
        """Moment of friction along the motion (n,)."""
        return np.asarray(self.scene.travel.sense * sum(friction_power(self.statics, state, place).values()))


def power_of(source: Source, place: Place) -> Real:
    """Moment of a source (n,), per power of the speed."""
    return np.asarray(sum(action.power(place.configuration) for action in source.actions(place)))


def most_of(source: Source, place: Place) -> Real:
    """What it could be (n,) if its forces lay along the motion of their points."""
    motions = place.configuration.motions
    turning = (np.abs(action.moment * motions[action.link].omega) for action in source.actions(place))
    pushing = (np.abs(action.force) * np.abs(action.at.v) for action in source.actions(place))
    return np.asarray(sum(turning) + sum(pushing))


def causes_of(scene: Scene) -> Causes:
    """The causes of a scene, in the order of its sources."""
    statics = compile_statics(scene)
    names = dict.fromkeys((source.name, source.kind, source.order) for source in scene.sources)
    friction = (("friction", "friction", 0),) if statics.scales else ()
    others = tuple(source for source in statics.sources if source.kind != "load")
    apart = bool(friction and others) and len(others) < len(statics.sources)
    return Causes(scene, statics, statics._replace(sources=others) if apart else None, (*names, *friction))
