"""What is reduced: every source of load by itself, and friction; their moments and the inertia at any angle."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.mesh import Cut, Mesh
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics
from tmmcalc.linkage.forces.kinks import faces, pins
from tmmcalc.linkage.forces.verification import friction_power
from tmmcalc.linkage.loads.scene import Scene
from tmmcalc.linkage.loads.sources import Place, Source
from tmmcalc.linkage.trace import BLOCK
from tmmcalc.machine.reduction.inertia import reduced_inertia

MOMENTS = 3  # rows of a sample before those of the causes
LOADED = np.array([[1.0], [0.0]])  # cases of friction: with the technological loads, and without

Names = tuple[tuple[str, str, int], ...]
Named = Callable[[NDArray[np.intp]], list[str]]


class Sample(NamedTuple):
    """Everything at n angles, or at the points of panels (P, N), along the motion: a positive moment drives."""

    rows: Real  # (3 + S, n) J [kg*m^2], dJ/dtheta, idle friction [N*m], moments of all causes per power of the speed
    faces: Real  # (F, n) forces whose signs the friction of sliders depends on, with the loads and without
    pins: Plane  # (P, n) forces whose sizes the friction in pins depends on, the same
    growth: Real  # (n,) largest growth of errors in the friction; infinite where friction locks the linkage

    @property
    def inertia(self) -> Real:
        """Reduced inertia (n,)."""
        return self.rows[0]

    @property
    def slope(self) -> Real:
        """Its derivative against theta (n,)."""
        return self.rows[1]

    @property
    def idle(self) -> Real:
        """Moment of friction without technological loads (n,)."""
        return self.rows[2]

    @property
    def moments(self) -> Real:
        """Moments of all causes (S, n), per power of the speed."""
        return self.rows[MOMENTS:]

    def columns(self, which: slice) -> Sample:
        """The same at some of the angles."""
        parts: list[Any] = [part[..., which] for part in self]
        return Sample(*parts)

    def over(self, on: Mesh) -> Sample:
        """The same, at the points of panels one behind the other, in the shape of these."""
        parts: list[Any] = [part.reshape(*part.shape[:-1], *on.x.shape) for part in self]
        return Sample(*parts)

    def with_cut(self, by: Cut, fresh: Sample) -> Sample:
        """The same on panels some of which are cut, with the values on the fresh ones."""
        return Sample(*(by.merged(old, new) for old, new in zip(self, fresh, strict=True)))


def joined(parts: Sequence[Sample]) -> Sample:
    """Samples one behind the other."""
    columns: list[Any] = [np.concatenate(column, axis=-1) for column in zip(*parts, strict=True)]
    return parts[0] if len(parts) == 1 else Sample(*columns)


class Causes(NamedTuple):
    """The sources of a scene, merged by name, and friction as the last if any pair rubs.

    The rows of the scene are those of one linkage, or of several variants of it.
    """

    scene: Scene
    statics: Statics  # in the cases with and without technological loads, where friction differs in them
    names: Names  # name, kind, order in the speed of every contribution

    @property
    def alone(self) -> bool:
        """Whether friction is that with the technological loads alone."""
        return self.statics.cases is None

    @property
    def orders(self) -> Indices:
        """Order in the speed of every contribution (S,)."""
        return orders_of(self.names)

    @property
    def powers(self) -> Real:
        """What each contribution is multiplied by at the mean speed (S,)."""
        return np.asarray(abs(self.scene.travel.speed) ** self.orders)

    @property
    def loaded(self) -> bool:
        """Whether there is a technological load."""
        return any(kind == "load" for _, kind, _ in self.names)

    def on(self, chain: Chain) -> Causes:
        """The same causes on a chain whose metric differs from that of the scene in its digits alone."""
        return self._replace(scene=self.scene._replace(chain=chain), statics=self.statics.on(chain))

    def sampled(self, theta: Real, side: Real, named: Named) -> Sample:
        """Everything at theta (n,), each from its side, in blocks that stay in cache; ``named`` tells locked rows."""

        def part(at: int) -> Sample:
            its = side[at : at + BLOCK]
            return self.at(self.scene.place(theta[at : at + BLOCK], its), its, lambda rows: named(rows + at))

        return joined([part(at) for at in range(0, len(theta), BLOCK)])

    def along(self, theta: Real) -> Sample:
        """The same at theta (n,) between the positions."""
        return self.sampled(theta, np.ones(len(theta)), lambda rows: self.scene.travel.named(theta[rows]))

    def at(self, place: Place, side: Real, named: Named | None = None) -> Sample:
        """Everything at one place, all of it at once.

        With ``named``, which words rows, self-locking under the loads raises `NoSolutionError`.
        """
        scene, sense, n = self.scene, self.scene.travel.sense, len(place.theta)
        rows = np.zeros((MOMENTS + len(self.names), n), place.theta.dtype)
        if bodies := scene.loading.heavy:
            rows[:2] = reduced_inertia(bodies, place.configuration, n)
        rows[1] *= sense
        known = {source: _computed_once(source, place) for source in self.statics.sources}
        for source in scene.sources:
            k = MOMENTS + self.names.index((source.name, source.kind, source.order))
            moment = sum(action.power(place.configuration) for action in known[source].actions(place))
            rows[k] += moment * (sense if source.order == 0 else 1.0)
        if not self.statics.scales:
            none = np.zeros((0, n))
            return Sample(rows, none, none + 0j, np.ones(n))
        statics = self.statics._replace(sources=tuple(known[source] for source in self.statics.sources))
        state, shape, count = statics.solve(place, side), statics.shape(place), 1 if self.alone else len(LOADED)
        if named is not None:
            from tmmcalc.linkage.forces.locking import refuse_locked  # only what rubs needs it

            loaded = state.solutions if self.alone else {k: found.rows(0) for k, found in state.solutions.items()}
            refuse_locked(statics, loaded, named)
        lost = np.broadcast_to(sense * sum(friction_power(statics, state, place).values()), shape).reshape(count, n)
        rows[-1] = lost[0]
        if not self.alone:
            rows[2] = lost[1]
        forces: list[Any] = [faces(statics, state, shape), pins(statics, state, shape)]
        on_faces, in_pins = (np.moveaxis(part.reshape(-1, count, n), 1, 0).reshape(-1, n) for part in forces)
        growths = [np.where(found.locked, np.inf, found.amplification) for found in state.solutions.values()]
        growth = np.max(growths, axis=0).reshape(count, n).max(axis=0)
        return Sample(rows, on_faces, in_pins, growth)

    def possible(self, theta: Real) -> Real:
        """What the moment of a source could be at theta (n,) if its forces lay along the motion of their points."""
        place, speed, found = self.scene.place(theta), self.scene.travel.speed, np.zeros(len(theta))
        motions = place.configuration.motions
        for source in self.scene.sources:
            actions = source.actions(place)
            turning = sum(np.abs(action.moment * motions[action.link].omega) for action in actions)
            pushing = sum(np.abs(action.force) * np.abs(action.at.v) for action in actions)
            found = np.maximum(found, abs(source.factor(speed)) * (turning + pushing))
        return found


def _computed_once(source: Source, place: Place) -> Source:
    """A source whose actions at a place are computed once: for moments, and for friction with and without loads."""
    actions = source.actions(place)
    return source._replace(actions=lambda _: actions)


def orders_of(names: Names) -> Indices:
    """Order in the speed of every contribution (S,)."""
    return np.array([order for _, _, order in names], dtype=np.intp)


def causes_of(scene: Scene) -> Causes:
    """The causes of a scene, in the order of its sources."""
    return causes_in(compile_statics(scene))


def causes_in(statics: Statics) -> Causes:
    """The same of a scene whose force analysis is compiled."""
    names = dict.fromkeys((source.name, source.kind, source.order) for source in statics.scene.sources)
    friction = (("friction", "friction", 0),) if statics.scales else ()
    kinds = {source.kind for source in statics.sources}
    apart = friction and "load" in kinds and len(kinds) > 1
    return Causes(statics.scene, statics._replace(cases=LOADED) if apart else statics, (*names, *friction))
