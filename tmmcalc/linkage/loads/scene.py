"""A linkage with everything that acts on it, ready to be evaluated at any angle along its motion."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from tmmcalc.errors import NoSolutionError
from tmmcalc.linkage.chain import Chain, Configuration, compile_chain
from tmmcalc.linkage.crossings import crossings
from tmmcalc.linkage.loading import Load, Loading, Quadratic, Viscous
from tmmcalc.linkage.loads.sources import Place, Source, resisting, springs, technological, weights
from tmmcalc.linkage.loads.travel import Travel, surveyed, travel_of
from tmmcalc.linkage.loads.values import Knot, value_of
from tmmcalc.linkage.loads.windows import window_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.results import Kinematics
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

    def place(self, theta: Real) -> Place:
        """The configuration at theta (n,)."""
        return Place(theta, self.chain.evaluate(self.travel.x(theta)))

    def edges(self, more: Iterable[Knot] = ()) -> list[float]:
        """Every theta within the period at which a load, or one of ``more``, is not smooth."""
        knots = [*self.knots, *more]
        if not knots:
            return sorted(self.angles)
        found = crossings(
            self.chain, lambda c: [knot.rate(c) for knot in knots], [knot.scale for knot in knots], self.survey
        )
        return sorted((*self.angles, *self.travel.repeated(self.travel.theta(np.concatenate(found)).tolist())))


class _Part(NamedTuple):
    """What compiling one load gives."""

    source: Source
    angles: list[float]
    knots: list[Knot]


def compile_scene(mechanism: Mechanism, loading: Loading, kinematics: Kinematics) -> Scene:
    """The scene of a mechanism whose kinematics is solved; raises `NoSolutionError` for a load without a place."""
    chain = compile_chain(mechanism, kinematics.structure, kinematics.variants)
    travel = travel_of(chain, kinematics, loading.loads)
    dense = surveyed(chain, travel)
    parts = [_part(chain, kinematics, travel, dense, load) for load in loading.loads if load.factor]
    sources = [*weights(loading), *(part.source for part in parts)]
    sources += [source for spring in loading.springs for source in springs(spring, dense)]
    return Scene(
        chain,
        loading,
        travel,
        dense,
        tuple(sources),
        tuple(a for part in parts for a in part.angles),
        tuple(k for part in parts for k in part.knots),
    )


def _part(chain: Chain, kinematics: Kinematics, travel: Travel, dense: Survey, load: Load) -> _Part:
    if isinstance(load.law, Viscous | Quadratic):
        return _resisting(load, dense)
    window = window_of(chain, kinematics, travel, load)
    value = value_of(chain, kinematics, travel, dense, load, window)

    def acting(place: Place) -> Real:
        return np.where(window.inside(place), load.factor * value.at(place), 0.0)

    return _Part(technological(load, acting), [*value.angles, *window.edges], value.knots)


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
