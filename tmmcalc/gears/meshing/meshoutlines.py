"""Pairs in mesh: where their members stand, and their outlines one beside the other, in metres."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import pi

import numpy as np

from tmmcalc.gears.involute.profile.mesh import Placing, placings, ring_placings
from tmmcalc.gears.meshing.geometry import external_pair, internal_pair, pinion_on_rack
from tmmcalc.gears.meshing.halftooth import fault_of
from tmmcalc.gears.meshing.members import both
from tmmcalc.gears.meshing.outlines import Track, repeated, track
from tmmcalc.gears.meshing.refusal import error_of_all
from tmmcalc.gears.meshing.results import MeshPair

APART = 0.05  # free room between two drawings, of the width of the second


def mesh_placings(found: MeshPair, phase: float = 0.0) -> tuple[Placing, Placing]:
    """Both members of a pair with their flanks in touch at the pitch point, in modules.

    The first one stands at the origin and has turned clockwise by ``phase`` [rad] since contact at P; its mate stands
    above it, the centre of a ring below it.
    """
    kind = found.task.kind
    if kind == "external":
        return placings(external_pair(found), phase)
    first, second = both(found)
    if kind == "internal":
        pair = internal_pair(found)
        pinion, ring = ring_placings(pair.pinion, second.wheel, pair.angle, pair.distance, phase)
        return pinion, Placing(ring.turn - second.half_pitch, ring.centre)  # a tooth, not a space, comes on +Y
    rack = pinion_on_rack(found)
    shift, slope = float(rack.pinion.shift), np.tan(rack.pinion.transverse_angle)
    offset = second.half_pitch / 2 - shift * float(slope)  # half the tooth of the rack on the rolling line
    travel = rack.pinion.reference * phase
    return Placing(-float(first.wheel.half_angle) - phase, 0j), Placing(pi, complex(travel - offset, rack.distance))


def mesh_tracks(found: MeshPair, tolerance: float, phase: float = 0.0, whole: bool = True) -> tuple[Track, ...]:
    """The members of a pair in mesh that have a profile; arguments as `mesh_placings` and `track`."""
    placed = zip(both(found), mesh_placings(found, phase), strict=True)
    return tuple(track(member, tolerance, placing, whole) for member, placing in placed if fault_of(member) is None)


def require_some(pairs: Sequence[MeshPair]) -> None:
    """Raise `NoSolutionError` with every reason if not one member of the pairs has a profile."""
    faults = [fault_of(member) for found in pairs for member in both(found)]
    errors = [fault for fault in faults if fault is not None]
    if errors and len(errors) == len(faults):
        raise error_of_all(errors, len(faults))


def beside(groups: Sequence[Sequence[Track]]) -> tuple[Track, ...]:
    """Groups of tracks moved beside each other along X, so that none overlaps the one before it; not empty ones."""
    row: list[Track] = []
    edge = None
    for group in filter(None, groups):
        x = np.concatenate([each.polygon.real for each in group])
        low, high = float(x.min()), float(x.max())
        by = 0.0 if edge is None else edge + APART * (high - low) - low
        row += [_shifted(each, by) for each in group]
        edge = high + by
    return tuple(row)


def _shifted(one: Track, by: float) -> Track:
    place = [Placing(0.0, complex(by))]
    pieces = tuple(moved for piece in one.pieces for moved in repeated(piece, place, 1.0))
    return replace(one, pieces=pieces, polygon=one.polygon + by)
