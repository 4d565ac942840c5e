"""Derivatives of what kinematics and forces give out, by the names under which they tell it."""

from __future__ import annotations

import math
from collections.abc import Collection, Container, Iterator, Mapping
from typing import Any

from tmmcalc.core.derivatives import Derivative, Derivatives
from tmmcalc.core.quantity import keyed, quantity_of
from tmmcalc.linkage.derivatives.closure import EPS, Slopes
from tmmcalc.linkage.derivatives.forces import differentiate_forces
from tmmcalc.linkage.derivatives.kinematics import KinematicsDerivatives, differentiate_kinematics
from tmmcalc.linkage.derivatives.summaries import OutputDerivatives
from tmmcalc.linkage.forces.columns import drive_of
from tmmcalc.linkage.forces.results import Forces, PairForces
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import GroupQuality, Kinematics, OutputSummary

EXACT = frozenset({"closed", "projection"})  # methods whose columns are exact derivatives of positions
Told = Iterator[tuple[str, Derivative | None]]


def of_kinematics(
    mechanism: Mechanism, results: Mapping[str, Any], slopes: Slopes, asked: Container[str]
) -> Derivatives | None:
    """Of the columns and of the facts: strokes, their angles and ratio, extremes of outputs, transmission."""
    result: Kinematics = results["kinematics"]
    if result.method.name not in EXACT:
        return None
    found = differentiate_kinematics(mechanism, result, slopes)
    facts = [*_drive(result, found)]
    for summary, own in zip(result.summaries, found.outputs, strict=True):
        facts += _output(summary, own)
    for quality in result.qualities:
        facts += _quality(quality, found.transmission.get(quality.group))
    return Derivatives(found.columns, {key: each for key, each in facts if each and key in asked})


def of_forces(
    inputs: tuple[Mechanism, Loading], results: Mapping[str, Any], slopes: Slopes, asked: Collection[str]
) -> Derivatives | None:
    """Of the columns and of the largest reactions, couples, edge reactions and drives."""
    result: Forces = results["forces"]
    found = differentiate_forces(*inputs, results["kinematics"], result, slopes, extremes=bool(asked))
    if found is None:
        return None
    if found.extremes is None:
        return Derivatives(found.columns, {})
    facts: list[tuple[str, Derivative | None]] = []
    for pair in result.pairs:
        for field in ("force", "couple", "pressure"):
            told = quantity_of(PairForces, field, joint=pair.joint)
            facts.append((told.key, getattr(found.extremes, field).get(pair.joint)))
    drive = drive_of(result.turns)
    for told, each in ((drive, found.extremes.drive), (quantity_of(Forces, "power"), found.extremes.power)):
        facts += [(told.marked(word).key, own) for word, own in zip(("min", "max"), each, strict=True)]
    return Derivatives(found.columns, {key: each for key, each in facts if each and key in asked})


def _drive(result: Kinematics, found: KinematicsDerivatives) -> Told:
    """Speed and acceleration of the input."""
    unit = "rad" if result.turns else "m"
    for name, change in (("speed", found.speed), ("acceleration", found.acceleration)):
        yield quantity_of(Kinematics, name, unit=unit).key, Derivative(change, EPS * abs(change))


def _output(summary: OutputSummary, own: OutputDerivatives) -> Told:
    """Of one output, in the units in which the facts tell it."""
    unit = "rad" if summary.angular else "m"
    stroke = "stroke[deg]" if summary.angular else "stroke"
    yield _key(summary, stroke, output=summary.name, unit=unit), _degrees(own.stroke) if summary.angular else own.stroke
    for name, each in (("working_angle[deg]", own.working_angle), ("idle_angle[deg]", own.idle_angle)):
        yield _key(summary, name, output=summary.name), _degrees(each)
    yield _key(summary, "time_ratio", output=summary.name), own.time_ratio
    for name, pair in (("velocity", own.velocity), ("acceleration", own.acceleration)):
        told = quantity_of(OutputSummary, name, output=summary.name, unit=unit)
        for word, each in zip(("min", "max"), pair, strict=True):
            yield told.marked(word).key, each


def _quality(quality: GroupQuality, own: Derivative | None) -> Told:
    """Of the transmission angle of a dyad, and of the pressure angle that it leaves to a right one."""
    if own is not None:
        yield _key(quality, "transmission[deg]", group=quality.group), _degrees(own)
        yield _key(quality, "pressure[deg]", group=quality.group), _degrees(Derivative(-own.value, own.error))


def _key(of: Any, name: str, **places: object) -> str:
    """The key of a field, as the facts write it."""
    (key,) = keyed(of, name, **places)
    return key


def _degrees(each: Derivative | None) -> Derivative | None:
    factor = math.degrees(1.0)
    return None if each is None else Derivative(factor * each.value, factor * each.error)
