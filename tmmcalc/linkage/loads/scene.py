"""A linkage with everything that acts on it, ready to be evaluated at any angle along its motion."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import Chain, Configuration, chain_of
from tmmcalc.linkage.crossings import crossings
from tmmcalc.linkage.loading import Load, Loading
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.linkage.loads.sources import Place, Source, resisting, springs, technological, weights
from tmmcalc.linkage.loads.travel import Travel, surveyed, travel_of
from tmmcalc.linkage.loads.values import Acting, Knot
from tmmcalc.linkage.loads.windows import Inside, handed_over, window_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Grade, Kinematics
from tmmcalc.linkage.survey import Survey


class Scene(NamedTuple):
    """A chain, what acts on it, and the way it goes."""

    chain: Chain
    loading: Loading
    travel: Travel
    survey: Survey
    sources: tuple[Source, ...]
    angles: tuple[float, ...]  # theta where a load jumps or bends [rad or m]
    knots: tuple[Knot, ...]
    grades: tuple[Grade, ...] = ()  # what the loads do not do

    def place(self, theta: Real, side: Real | float = 1.0) -> Place:
        """The configuration at theta (n,), seen from its ``side``."""
        return Place(theta, self.chain.evaluate(self.travel.x(theta)), side)

    def loaded(self, place: Place) -> Real:
        """What the technological loads do at a place (n,): the sum of the sizes of their reduced moments [N*m or N]."""
        found = np.zeros(len(place.theta))
        for source in self.sources:
            if source.kind == "load":
                moment = sum(action.power(place.configuration) for action in source.actions(place))
                found += np.abs(source.factor(self.travel.speed) * moment)
        return found

    def edges(self, more: Iterable[Knot] = ()) -> list[float]:
        """Every theta within the period at which a load, or one of ``more``, is not smooth."""
        own, zeros = self.breaks(list(more))
        return sorted((*own, *zeros))

    def breaks(self, more: list[Knot]) -> tuple[list[float], list[float]]:
        """Every theta within the period at which a load is not smooth; and the zeros of ``more``."""
        knots = [*self.knots, *more]
        if not knots:
            return list(self.angles), []
        found = crossings(
            self.chain, lambda c: [knot.rate(c) for knot in knots], [knot.scale for knot in knots], self.survey
        )
        theta = [self.travel.repeated(self.travel.theta(x).tolist()) for x in found]
        own = len(self.knots)
        return [*self.angles, *chain.from_iterable(theta[:own])], list(chain.from_iterable(theta[own:]))


class _Part(NamedTuple):
    """What compiling one load gives."""

    source: Source
    angles: list[float]
    knots: list[Knot]
    grades: tuple[Grade, ...] = ()


def compile_scene(mechanism: Mechanism, loading: Loading, kinematics: Kinematics, turns: int = 1) -> Scene:
    """The scene of a mechanism whose kinematics is solved; raises `NoSolutionError` for a load without a place.

    ``turns`` of the crank are those after which all that is beside it repeats.
    """
    compiled = chain_of(mechanism, kinematics)
    travel = travel_of(compiled, kinematics, loading.loads, turns)
    return scene_of(compiled, loading, travel, surveyed(compiled, travel), kinematics)


def scene_of(compiled: Chain, loading: Loading, travel: Travel, dense: Survey, kinematics: Kinematics) -> Scene:
    """The scene of a compiled chain, whose rows may be those of several variants.

    Of the survey and of the kinematics is taken what is the same for all.
    """
    acting = [load for load in loading.loads if load.factor]
    windows = {
        load.name: window_of(compiled, kinematics, travel, load) for load in acting if isinstance(load.law, Placed)
    }
    parts = [_part(compiled, kinematics, travel, dense, load, windows, acting) for load in acting]
    sources = [*weights(loading), *(part.source for part in parts)]
    sources += [source for spring in loading.springs for source in springs(spring, dense)]
    return Scene(
        compiled,
        loading,
        travel,
        dense,
        tuple(sources),
        tuple(a for part in parts for a in part.angles),
        tuple(k for part in parts for k in part.knots),
        tuple(grade for part in parts for grade in part.grades),
    )


def _part(
    chain: Chain,
    kinematics: Kinematics,
    travel: Travel,
    dense: Survey,
    load: Load,
    windows: dict[str, Inside],
    loads: list[Load],
) -> _Part:
    if not isinstance(load.law, Placed):
        return _resisting(load, dense)
    window = windows[load.name]
    value = load.law.along(Acting(chain, kinematics, travel, dense, load, window))
    beside = [o for o in loads if o.name in windows and (o.link, o.kind) == (load.link, load.kind)]
    inside = handed_over(travel, window, [windows[o.name] for o in beside if o is not load])

    def acting(place: Place) -> Real:
        return np.where(inside(place), load.factor * value.at(place), 0.0)

    grades = (*window.grades, *value.grades)
    return _Part(technological(load, acting), [*value.angles, *window.edges], value.knots, grades)


def _resisting(load: Load, dense: Survey) -> _Part:
    if load.window is not None:
        raise NoSolutionError(
            "a resistance against the velocity acts all the time",
            where=f"load {load.name}",
            remedy="leave its stroke, between or positions out",
        )
    source = resisting(load)
    if source.order == 1:
        return _Part(source, [], [])

    def rate(configuration: Configuration) -> Real:
        """The load along its own direction, which changes sign with the velocity."""
        action = source.actions(Place(np.zeros(()), configuration))[0]
        if load.kind == "moment":
            return action.moment
        direction = load.direction * configuration.motions[load.follows].u
        return (np.conj(action.force) * direction).real

    return _Part(source, [], [Knot(rate, float(np.max(np.abs(rate(dense.configuration)))))])
