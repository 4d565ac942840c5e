"""Reduced moments and inertia of many variants over one turn, at their mean speeds, on panels that resolve them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.kinks import NEWTON, NOISE, SIDE, SLIVER, faces
from tmmcalc.linkage.forces.verification import friction_power
from tmmcalc.linkage.loads.sources import Action, Source
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.reduction.inertia import reduced_inertia
from tmmcalc.linkage.stacked.ragged import Cut, Ragged, cut, first
from tmmcalc.linkage.stacked.scene import Block
from tmmcalc.linkage.stacked.tables import SAFE, turning_of
from tmmcalc.linkage.stacked.zeros import Flags
from tmmcalc.numerics.gauss import ORDER, rule
from tmmcalc.numerics.roots import Indices

ROWS = 16384  # that are computed together
PARTS = 12  # of a turn: no first panel is wider
HALF = np.array([0.5])  # where a panel that resolves nothing is cut
TOLERANCE = 1e-12  # of the panels: last coefficients against the largest value
ROUNDS = 8  # of cutting panels that do not resolve everything
FUNCTIONS = 4  # J, dJ/dtheta, moment of position, factor of the speed


class Cycles(NamedTuple):
    """What the machine needs of V variants, on the points of their panels."""

    panels: Ragged
    values: Real  # (4, P, N) J [kg*m^2], dJ/dtheta, moment [N*m], moment per speed [N*m*s]
    clear: Flags  # (v,)


class _Sample(NamedTuple):
    """Everything on panels."""

    values: Real  # (4, P, N)
    faces: Real  # (F, P, N) forces whose signs the friction of sliders depends on
    size: Real  # (1, P, 1) largest moment of one cause
    growth: Real  # (1, P, 1) largest growth of errors in the friction

    def with_cut(self, by: Cut, fresh: _Sample) -> _Sample:
        """The same on panels some of which are cut."""
        return _Sample(*(by.merged(old, new) for old, new in zip(self, fresh, strict=True)))


def cycles_of(block: Block, variants: Indices) -> Cycles:
    """The cycles of some variants (v,); their panels are owned by numbers from 0 to v - 1."""
    scene = block.same.scene
    assert scene is not None
    count = len(variants)
    breaks = np.concatenate((np.tile(scene.angles, (count, 1)), turning_of(block, variants)), axis=1)
    on = first(TURN, np.maximum(breaks, 0.0), TURN / PARTS)
    sample = _sampled(block, variants, on)
    for _ in range(ROUNDS):
        rough = _rough(on, sample, count)
        halves = (on.low[rough, None] + on.width[rough, None] * HALF).ravel()
        panel, place = _kinks(on, sample.faces)
        by = cut(
            on,
            np.concatenate((np.repeat(np.flatnonzero(rough), len(HALF)), panel)),
            np.concatenate((halves, place)),
            SLIVER * TURN,
        )
        if not by.fresh.any():
            break
        on, sample = by.panels, sample.with_cut(by, _sampled(block, variants, by.panels.at(by.fresh)))
    clear = _most(np.where(_rough(on, sample, count), np.inf, sample.growth[0, :, 0]), on, count) < SAFE
    return Cycles(on, sample.values, clear)


def _most(values: Real, on: Ragged, count: int) -> Real:
    """Largest value (v,) of the panels (P,) of every variant."""
    found = np.zeros(count)
    np.maximum.at(found, on.owner, values)
    return found


def _rough(on: Ragged, sample: _Sample, count: int) -> Flags:
    """Panels (P,) that do not resolve a function; each counts by what it adds to an integral."""
    inertia = _most(np.max(np.abs(sample.values[0]), axis=1), on, count)
    moment = _most(sample.size[0, :, 0], on, count)
    scales = np.stack((inertia, inertia, moment, moment))
    scales = np.where(scales > 0, scales, 1.0)[:, on.owner]
    last = np.abs(sample.values @ rule(ORDER).coefficients[-3:].T)
    tail = np.max(np.max(last, axis=2) / scales, axis=0)
    return np.asarray(tail * on.width > TOLERANCE * _most(on.width, on, count)[on.owner])


def _sampled(block: Block, variants: Indices, on: Ragged) -> _Sample:
    """Everything on the points of panels."""
    size = ROWS // ORDER
    parts = [_at(block, variants, on.at(np.s_[at : at + size])) for at in range(0, len(on.owner), size)]  # type: ignore[arg-type]
    return _Sample(*(np.concatenate(column, axis=1) for column in zip(*parts, strict=True)))


def _at(block: Block, variants: Indices, on: Ragged) -> _Sample:
    theta = on.x.ravel()
    n, shape = len(theta), on.x.shape
    statics = block.statics(np.repeat(variants[on.owner], ORDER))
    scene = statics.scene
    sense, place = scene.travel.sense, scene.place(theta)
    bodies = [body for body in scene.loading.bodies if body.mass or body.inertia]
    values = np.zeros((FUNCTIONS, n))
    if bodies:
        values[:2] = reduced_inertia(bodies, place.configuration, n)
        values[1] *= sense
    largest = np.zeros(n)
    sources = [_known(source, source.actions(place)) for source in statics.sources]
    for source in sources[: len(scene.sources)]:
        moment = sum(action.power(place.configuration) for action in source.actions(place))
        row = values[2 + source.order]
        row += moment if source.order else moment * sense
        np.maximum(largest, np.abs(moment), out=largest)
    growth: Real = np.ones(n)
    on_faces: Real = np.zeros((0, n))
    if statics.scales:
        state = statics._replace(sources=tuple(sources)).solve(place, 1.0)
        lost = sense * sum(friction_power(statics, state, place).values())
        values[2] += lost
        np.maximum(largest, np.abs(lost), out=largest)
        growth = np.max([solution.amplification for solution in state.solutions.values()], axis=0)
        on_faces = faces(statics, state, n)
    sizes = (np.max(row.reshape(shape), axis=1)[None, :, None] for row in (largest, growth))
    return _Sample(values.reshape(-1, *shape), on_faces.reshape(-1, *shape), *sizes)


def _known(source: Source, actions: list[Action]) -> Source:
    """A source whose actions at the place that is looked at are known."""
    return source._replace(actions=lambda _: actions)


def _kinks(on: Ragged, forces: Real) -> tuple[Indices, Real]:
    """Panels (m,) and places (m,) of the zeros of forces (F, P, N) on faces."""
    if not len(forces):
        return np.zeros(0, np.intp), np.zeros(0)
    low, high = rule(ORDER).ends
    v = np.concatenate(((forces @ low)[..., None], forces, (forces @ high)[..., None]), axis=-1)
    largest = np.zeros((len(forces), on.owner[-1] + 1))
    for row, force in zip(largest, forces, strict=True):
        np.maximum.at(row, on.owner, np.max(np.abs(force), axis=1))
    loud = np.maximum(np.abs(v[..., :-1]), np.abs(v[..., 1:])) > NOISE * largest[:, on.owner, None]
    force, panel, cell = np.nonzero((np.signbit(v[..., :-1]) != np.signbit(v[..., 1:])) & loud)
    place = _zeros(forces[force, panel], cell)
    inside = (place > 0) & (place < 1)
    panel, place = panel[inside], place[inside]
    return panel, on.low[panel] + on.width[panel] * place


def _zeros(force: Real, before: Indices) -> Real:
    """Zeros (m,) of forces (m, N) between their points ``before`` - 1 and ``before``, each from its longer side."""
    points = rule(ORDER).points
    late = before > ORDER // 2
    start = np.where(late, before - SIDE, before)
    side = start[:, None] + np.arange(SIDE)
    near = points[np.where(late, before - 1, before)]
    powers = (points[side] - near[:, None])[:, :, None] ** np.arange(SIDE - 1, -1, -1)
    fit = np.linalg.solve(powers, np.take_along_axis(force, side, axis=1)[:, :, None])[:, :, 0]
    at = np.zeros(len(force))
    for _ in range(NEWTON):
        value, slope = np.zeros(len(force)), np.zeros(len(force))
        for c in fit.T:
            slope = slope * at + value
            value = value * at + c
        at = at - value / np.where(slope == 0, 1.0, slope)
    inner = (before > 0) & (before < ORDER)
    bounds = points[np.maximum(before - 1, 0)], points[np.minimum(before, ORDER - 1)]
    return np.where(inner, np.clip(near + at, *bounds), near + at)
