"""What is reduced, of many variants: reduced inertia and the moments of all causes at any rows."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.kinks import faces, pins
from tmmcalc.linkage.forces.verification import friction_power
from tmmcalc.linkage.loads.sources import Action, Place, Source
from tmmcalc.linkage.stacked.scene import Block, Same
from tmmcalc.machine.reduction.causes import most_of, power_of
from tmmcalc.machine.reduction.inertia import reduced_inertia

AT_ONCE = 16384  # rows that are computed together: calls cost nothing then
MOMENTS = 3  # rows before those of the causes: J, dJ/dtheta, friction without technological loads

Names = tuple[tuple[str, str, int], ...]


class Sample(NamedTuple):
    """Everything at n places, along the motion: a positive moment drives."""

    rows: Real  # (3 + S, n) J [kg*m^2], dJ/dtheta, idle friction, moments of all causes per power of the speed
    faces: Real  # (F, n) forces whose signs the friction of sliders depends on, with the loads and without
    pins: Plane  # (P, n) forces whose sizes the friction in pins depends on, the same
    growth: Real  # (n,) largest growth of errors in the friction


def names_of(same: Same) -> Names:
    """Name, kind and order in the speed of every cause: the sources, merged by name, and friction as the last."""
    assert same.scene is not None
    assert same.statics is not None
    names = dict.fromkeys((source.name, source.kind, source.order) for source in same.scene.sources)
    return (*names, *((("friction", "friction", 0),) if same.statics.scales else ()))


def sampled(block: Block, owner: Indices, theta: Real, side: Real, names: Names, *, idle: bool) -> Sample:
    """Everything at theta (n,) of the variants ``owner`` (n,); ``idle``: friction without technological loads too."""
    parts = [
        _at(block.statics(owner[some]), theta[some], side[some], names, idle)
        for some in (slice(at, at + AT_ONCE) for at in range(0, len(theta), AT_ONCE))
    ]
    return Sample(*(np.concatenate(column, axis=-1) for column in zip(*parts, strict=True)))


def most(block: Block, variants: Indices, theta: Real) -> Real:
    """What the moment of a source could be (v,) over theta (n,) if its forces lay along the motion of their points."""
    scene = block.statics(np.repeat(variants, len(theta))).scene
    place = scene.place(np.tile(theta, len(variants)))
    rows = [np.broadcast_to(most_of(source, place), place.theta.size) for source in scene.sources]
    return np.max([np.zeros(place.theta.size), *rows], axis=0).reshape(len(variants), -1).max(axis=1)


def _at(statics: Statics, theta: Real, side: Real, names: Names, idle: bool) -> Sample:
    scene, n = statics.scene, len(theta)
    sense, place = scene.travel.sense, scene.place(theta, side)
    rows = np.zeros((MOMENTS + len(names), n))
    if bodies := scene.loading.heavy:
        rows[:2] = reduced_inertia(bodies, place.configuration, n)
        rows[1] *= sense
    sources = tuple(_known(source, source.actions(place)) for source in statics.sources)
    for source in sources[: len(scene.sources)]:
        k = MOMENTS + names.index((source.name, source.kind, source.order))
        rows[k] += power_of(source, place) * (1.0 if source.order else sense)
    if not statics.scales:
        return Sample(rows, np.zeros((0, n)), np.zeros((0, n), complex), np.ones(n))
    rows[-1], on_faces, in_pins, growth = _lost(statics._replace(sources=sources), place, side)
    others = tuple(source for source in sources if source.kind != "load")
    if not idle or not others or len(others) == len(sources):
        return Sample(rows, on_faces, in_pins, growth)
    rows[2], *more, further = _lost(statics._replace(sources=others), place, side)
    on_faces, in_pins = (np.concatenate(pair) for pair in zip((on_faces, in_pins), more, strict=True))
    return Sample(rows, on_faces, in_pins, np.maximum(growth, further))


def _lost(statics: Statics, place: Place, side: Real) -> tuple[Real, Real, Plane, Real]:
    """Moment of friction along the motion (n,), forces on faces (F, n) and in pins (P, n), growth of errors (n,)."""
    state, n = statics.solve(place, side), len(place.theta)
    lost = np.asarray(statics.scene.travel.sense * sum(friction_power(statics, state, place).values()))
    growth = np.max([solution.amplification for solution in state.solutions.values()], axis=0)
    return lost, faces(statics, state, n), pins(statics, state, n), growth


def _known(source: Source, actions: list[Action]) -> Source:
    """A source whose actions at the place that is looked at are known."""
    return source._replace(actions=lambda _: actions)
