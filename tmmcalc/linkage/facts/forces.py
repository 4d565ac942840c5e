"""The documents of the forces stage: what the drive must do, the largest reaction of every pair, checks, the table."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed, quantity_of
from tmmcalc.linkage.columns import PHI
from tmmcalc.linkage.facts.places import extreme_values, place, span_fact, speed_text
from tmmcalc.linkage.forces.columns import REACTION, columns, drive_of
from tmmcalc.linkage.forces.results import LEAST_ARM, Forces, PairForces
from tmmcalc.linkage.loading import GearDrive
from tmmcalc.linkage.results import Extreme
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.errors import digit_facts
from tmmcalc.report.numbers import NOISE, number
from tmmcalc.report.positions import with_positions

SMALL = 1e-6  # a normal force below this part of the largest has no arm worth a number
SHOWN = 8  # positions named in a line
ARM = Quantity("h_{joint}[m]", "arm of the normal force in {joint} where the reaction is the largest")
DRIVES = {
    "coupling": "a moment through a coupling",
    "gear": "a gear on the crank",
    "slider": "a force along the guide",
}


def summary(result: Forces, title: str) -> Document:
    """Facts and notes, without the table of positions."""
    facts = (
        *_drive_facts(result),
        *(_pair_fact(result, j) for j in range(len(result.pairs))),
        _friction_fact(result),
        *_check_facts(result),
    )
    return Document(title, facts, tuple(str(grade) for grade in result.grades))


def document(
    result: Forces,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """Summary and table of positions; drive and sizes of the reactions come first.

    ``patterns`` choose columns by name, header or wildcard, ``rows`` positions by index; ``everything`` takes all
    columns in their order (for csv, json, toml). ``where`` is the file that has them all. ``further`` columns are
    there if ``patterns`` name them.
    """
    available = columns(result)
    usual = available if everything else _first(result, available)
    told, example = summary(result, title), "phi,M_drive,R_*" if result.turns else "phi,F_drive,R_*"
    return with_positions(
        told,
        result.labels,
        available,
        patterns,
        rows,
        usual=usual,
        example=example,
        everything=everything,
        where=where,
        further=further,
    )


def _first(result: Forces, available: list[Column]) -> list[Column]:
    """Position, drive, sizes of all reactions; then the rest."""
    sizes = {REACTION[-1].of(joint=pair.joint).name for pair in result.pairs}
    rank = {PHI.name: 0, drive_of(result.turns).name: 1}
    return sorted(available, key=lambda column: rank.get(column.name, 2 if column.name in sizes else 3))


def _drive_facts(result: Forces) -> list[Fact]:
    """Kind, extremes and power of the drive."""
    drive, work, mean = drive_of(result.turns), quantity_of(Forces, "power"), result.power_mean
    power = span_fact(result, "power of the drive", work.name, work.unit, result.power_extremes)
    told = quantity_of(Forces, "power_mean")
    power = replace(
        power,
        text=f"{power.text}\nmean {number(mean.value, peak=_peak(result.power_extremes))} W, to {mean.error:.0e} W",
        values={**power.values, told.key: mean.value, told.marked("error").key: mean.error},
    )
    label = "moment" if result.turns else "force"
    facts = [
        Fact("drive", f"{DRIVES[result.drive_kind]}, at {speed_text(result)}", keyed(result, "drive_kind")),
        span_fact(result, f"{label} of the drive", drive.name, drive.unit, result.drive_extremes),
        power,
    ]
    if result.gear is not None:
        facts.append(_gear_fact(result.gear))
    if result.mesh is not None:
        facts.append(_mesh_fact(result, np.abs(result.mesh)))
    return facts


def _gear_fact(gear: GearDrive) -> Fact:
    """Pitch radius and pressure angle of the gear on the crank, and whose they are."""
    sizes = f"r_w = {number(1e3 * gear.radius)} mm, alpha_w = {number(math.degrees(gear.mesh_angle))} deg"
    text = f"{sizes}, of the {gear.open}" if gear.open else sizes
    return Fact("gear on the crank", text, keyed(gear, "radius", "mesh_angle[deg]", *(["open"] if gear.open else [])))


def _mesh_fact(result: Forces, mesh: np.ndarray) -> Fact:
    """The largest mesh force: it is proportional to the moment, so it stands where that is largest."""
    k = int(np.argmax(np.abs(result.drive)))
    ratio = float(mesh[k] / abs(result.drive[k])) if result.drive[k] else 0.0
    at = max(result.drive_extremes, key=lambda extreme: abs(extreme.value))
    largest = Extreme(ratio * abs(at.value), at.x)
    text = f"max {number(largest.value)} N at {place(result, at.x)}"
    return Fact("mesh force", text, _largest(result, quantity_of(Forces, "mesh").marked("max"), largest))


def _largest(result: Forces, told: Quantity, extreme: Extreme) -> dict[str, Any]:
    return extreme_values(result, told.name, told.unit, extreme)


def _peak(pair: tuple[Extreme, Extreme]) -> float:
    return max(abs(extreme.value) for extreme in pair)


def _pair_fact(result: Forces, j: int) -> Fact:
    """The largest reaction of a pair; of a prismatic one its couple, arm and edge reactions as well."""
    pair = result.pairs[j]
    largest = max(p.force.value for p in result.pairs)
    lines = [f"max {number(pair.force.value, peak=largest)} N at {place(result, pair.force.x)}"]
    values: dict[str, Any] = _largest(result, quantity_of(PairForces, "force", joint=pair.joint), pair.force)
    if pair.couple is not None:
        parts = [_couple(result, pair, pair.couple), _arm(result, j), _edges(result, pair)]
        lines += [line for line, _ in parts if line]
        values |= {key: value for _, found in parts for key, value in found.items()}
    low, high = pair.links
    label = Phrase("reaction in {joint} ({low}-{high})", joint=pair.joint, low=low, high=high)
    return Fact(label, "\n".join(lines), values)


def _couple(result: Forces, pair: PairForces, couple: Extreme) -> tuple[str, dict[str, Any]]:
    values = _largest(result, quantity_of(PairForces, "couple", joint=pair.joint), couple)
    if couple.value <= _no_couple(result):
        return "no couple: the resultant goes through the slider's point", values
    return f"max couple {number(couple.value)} N*m at {place(result, couple.x)}", values


def _no_couple(result: Forces) -> float:
    """A couple that is noise against the largest moment [N*m]."""
    couples = [pair.couple.value for pair in result.pairs if pair.couple is not None]
    drive = _peak(result.drive_extremes) if result.turns else 0.0
    return max(NOISE * max(*couples, drive, 0.0), LEAST_ARM * max(pair.force.value for pair in result.pairs))


def _arm(result: Forces, j: int) -> tuple[str, dict[str, Any]]:
    """The arm h of the normal force in the position of the largest reaction, where both it and the couple count."""
    pair, k = result.pairs[j], int(np.argmax(np.abs(result.reaction[j])))
    normal, couple = float(result.normal[j, k]), float(result.couple[j, k])
    if abs(normal) <= SMALL * max(p.force.value for p in result.pairs) or abs(couple) <= _no_couple(result):
        return "", {}
    told = ARM.of(joint=pair.joint)
    values = {told.key: couple / normal, f"{told.name}_in_position": result.labels[k]}
    return f"arm h = {number(1e3 * couple / normal, 5)} mm in position {result.labels[k]}", values


def _edges(result: Forces, pair: PairForces) -> tuple[str, dict[str, Any]]:
    """Edge reactions of a slider of known length, and where the resultant leaves it."""
    if pair.pressure is None:
        return "", {}
    values = _largest(result, quantity_of(PairForces, "pressure", joint=pair.joint), pair.pressure)
    values |= keyed(pair, "tips", joint=pair.joint)
    text = f"max edge reaction {number(pair.pressure.value)} N at {place(result, pair.pressure.x)}"
    tips = f"bears on two opposite edges in {_positions(pair.tips)}" if pair.tips else "bears on one side throughout"
    return f"{text}\n{tips}", values


def _positions(labels: Sequence[str]) -> str:
    more = " ..." if len(labels) > SHOWN else ""
    return f"position{'s' if len(labels) > 1 else ''} {', '.join(labels[:SHOWN])}{more}"


FRICTION = Quantity("friction", "whether there is friction")
PASSES = Quantity("friction_passes", "passes in which friction settles")


def _friction_fact(result: Forces) -> Fact:
    """Coefficients, the positions where friction jumps, and the work that it took."""
    rubbing = [pair for pair in result.pairs if pair.friction and (pair.kind == "prismatic" or pair.radius)]
    if not rubbing:
        return Fact("friction", "none", FRICTION.value(False))
    every = set(result.labels)
    jumps = [label for label in result.labels if f"{label}-" in every]
    passes = result.counters["passes"]
    joints: dict[float, list[str]] = {}
    for pair in rubbing:
        joints.setdefault(pair.friction, []).append(pair.joint)
    text = "; ".join(f"f = {number(f)} in {', '.join(names)}" for f, names in joints.items())
    if jumps:
        text += f"\njumps in {_positions(jumps)}: the row marked - is the limit before"
    text += f"\nsolved in {passes} pass{'es' if passes != 1 else ''} at most"
    return Fact("friction", text, {**FRICTION.value(True), "friction_jumps": jumps, **PASSES.value(passes)})


def _check_facts(result: Forces) -> list[Fact]:
    """Residuals and the estimated error; one digit is enough for people."""
    balance, virtual = float(np.max(result.equilibrium)), float(np.max(np.abs(result.virtual)))
    text = f"equilibrium {balance:.0e}, drive by virtual power {virtual:.0e} (relative)"
    return [
        Fact("residuals", text, {"residual": {"equilibrium": balance, "virtual_power": virtual}}),
        Fact("error of reactions (est.)", f"{result.error:.0e} (relative)", {"error": keyed(result, "error")}),
        *digit_facts({} if result.last_digit is None else keyed(result, "last_digit")),
    ]
