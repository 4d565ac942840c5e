"""The documents of the flywheel stage: what is needed, by all methods side by side, what is there, the rim.

Inertias are reduced to the input shaft unless said otherwise. J_F is the whole constant inertia that keeps the
unevenness; the flywheel is what of it the machine does not have yet.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed, quantities, table
from tmmcalc.linkage.facts.places import Shaft, phi_of
from tmmcalc.machine.facts.motion import inertia_fact, unevenness
from tmmcalc.machine.flywheel.materials import RECOMMENDED
from tmmcalc.machine.flywheel.methods import FlywheelMethod
from tmmcalc.machine.flywheel.placement import Wheel
from tmmcalc.machine.flywheel.results import Flywheel, RequiredInertia, Trial
from tmmcalc.report.document import Document, Fact, View, untold
from tmmcalc.report.numbers import angle, number

CALLED = {"book": "textbook", "mertsalov": "Mertsalov", "artobolevsky": "Artobolevsky"}
STALLS = "stalls"  # in place of a delta that a machine does not reach

MAX_AT = Quantity("max_at[deg]", "phi where the tangent of the largest speed touches")
MIN_AT = Quantity("min_at[deg]", "phi where the tangent of the least speed touches")
ERROR, _ = quantities(FlywheelMethod)["error"].shown("%")
BY_TABLE = Quantity("J_F_by_table[kg*m^2]", "total constant inertia by the textbook's table of positions")


def summary(result: Flywheel, title: str) -> Document:
    """Facts and notes with the table of methods, which is short."""
    facts = (
        _allowed_fact(result),
        inertia_fact("inertia at hand", keyed(result, "without"), result.at_hand),
        _needed_fact(result),
        *_existing_facts(result),
        *([] if result.rim is None else _rim_facts(result)),
        *(_elsewhere_fact(wheel) for wheel in result.wheels[1:] if result.addition > 0),
    )
    facts += (*untold(facts, result, but=("existing",)), _legend_fact(result))
    return Document(title, facts, tuple(str(verdict) for verdict in result.verdicts), _methods_view(result))


def document(result: Flywheel, title: str) -> Document:
    """The summary with what the methods say, the tangents, the search and the textbook's correction."""
    told = summary(result, title)
    *facts, legend = told.facts
    required = result.required
    return replace(
        told,
        facts=(
            *facts,
            _tangents_fact(result),
            *_nodal_facts(result),
            *([] if required is None else _search_facts(required, result.delta)),
            *_correction_facts(result.history),
            *(Fact(f"method {called(row.positional)}", row.positional.remark) for row in result.rows),
            legend,
        ),
    )


def _allowed_fact(result: Flywheel) -> Fact:
    """The unevenness to keep, and the machines for which it is customary."""
    delta = result.delta
    for_whom = [kind.machine for kind in RECOMMENDED if kind.smallest * 0.999 <= delta <= kind.largest * 1.001]
    usual = f"customary for {'; '.join(for_whom)}" if for_whom else "not customary for any kind of machine"
    return Fact("allowed delta", f"{unevenness(delta)}, {usual}", keyed(result, "delta"))


def _needed_fact(result: Flywheel) -> Fact:
    """The flywheel, on the input shaft and on its own shaft."""
    reached = () if result.reached is None else ("reached",)
    values = keyed(result, "inertia", "addition", "own", "ratio", "fastest", *reached)
    if result.addition <= 0:
        under = f" under {result.under}" if result.required is not None else ""
        without = "" if result.reached is None else f": with what is at hand delta is {number(result.reached)}{under}"
        return Fact("flywheel needed", f"none{without}", values)
    lines = [
        f"{number(result.addition)} kg*m^2 at the input shaft",
        f"J_F = {number(result.inertia)} kg*m^2 with what is at hand",
    ]
    if result.required is None:
        lines.append("by the exact tangents, for forces of position")
    else:
        regime = result.required.regime
        lines.append(f"delta = {number(result.required.delta)} under {result.under} at {number(regime.mean)} rad/s")
        values |= keyed(regime, "mean")
    if result.ratio != 1:
        lines.append(f"{number(result.own)} kg*m^2 on its own shaft, turning {number(result.ratio)} times as fast")
    return Fact("flywheel needed", "\n".join(lines), values)


def _existing_facts(result: Flywheel) -> list[Fact]:
    """The flywheel that the spec gives, and whether it does."""
    if not result.existing:
        return []
    text = f"{number(result.existing)} kg*m^2 at the input shaft"
    if result.ratio != 1:
        text += f", {number(result.existing / result.ratio**2)} kg*m^2 on its own shaft"
    lacking = result.addition - result.existing
    text += ": it does" if result.sufficient else f": too light by {number(lacking)} kg*m^2"
    return [Fact("flywheel there", text, keyed(result, "existing", "sufficient"))]


def _rim_facts(result: Flywheel) -> list[Fact]:
    """Sizes, inertia, mass, speed and stress of the rim of the needed flywheel."""
    rim = result.rim
    assert rim is not None
    material = rim.material
    sizes = {"mean": rim.diameter, "outer": rim.outer, "inner": rim.inner}
    diameters = ", ".join(f"{word} {number(1e3 * value, 5)}" for word, value in sizes.items())
    section = {"width": rim.width, "thickness": rim.thickness}
    sections = ", ".join(f"{word} {number(1e3 * value, 5)} mm" for word, value in section.items())
    named = keyed(rim, "diameter", "outer", "inner", "width", "thickness")
    return [
        Fact("its rim", f"diameters: {diameters} mm\n{sections}", named),
        Fact(
            "inertia of the rim",
            f"{number(rim.inertia)} kg*m^2, {number(100 * rim.inertia / result.own, 3)} % of the wheel's"
            "\n(arms and hub are to give the rest)",
            keyed(rim, "inertia"),
        ),
        Fact(
            "mass of the rim",
            f"{number(rim.mass)} kg, {number(rim.total_mass)} kg with arms and hub"
            f"\n(4 J/D^2 = {number(rim.thin_mass)} kg as a thin rim alone)",
            keyed(rim, "mass", "total_mass", "thin_mass"),
        ),
        Fact(
            "speed of the rim",
            f"{number(rim.speed, 5)} m/s at its edge, {number(material.rim_speed)} m/s allowed for {material.name}",
            {
                **keyed(rim, "speed"),
                **keyed(material, "rim_speed"),
                **keyed(rim, "allowed"),
                **keyed(material, "name", "density", "strength", "source"),
            },
        ),
        Fact(
            "stress in the rim",
            f"{number(rim.stress / 1e6, 5)} MPa as a thin ring, {number(rim.peak_stress / 1e6, 5)} MPa inside"
            f"\nsafety {number(rim.safety, 4)} against {number(material.strength / 1e6)} MPa",
            keyed(rim, "stress", "peak_stress", "safety"),
        ),
    ]


ELSEWHERE = (  # a flywheel on another shaft than the input
    Quantity("{shaft}_shaft_rim_mean_diameter[m]", "mean diameter of the rim on the {shaft} shaft"),
    Quantity("{shaft}_shaft_rim_mass[kg]", "mass of the rim on the {shaft} shaft"),
    Quantity("{shaft}_shaft_rim_speed[m/s]", "speed of the rim on the {shaft} shaft"),
)


def _elsewhere_fact(wheel: Wheel) -> Fact:
    """The same flywheel on another shaft, with a rim of the usual proportions."""
    rim, label = wheel.rim, Phrase("or on the {shaft} shaft", shaft=wheel.shaft)
    values = keyed(wheel, "inertia", shaft=wheel.shaft)
    faster = "" if wheel.ratio == 1 else f", turning {number(wheel.ratio)} times as fast as the input"
    lines = [f"{number(wheel.inertia)} kg*m^2{faster}"]
    if rim is not None:
        lines.append(f"rim: mean diameter {number(1e3 * rim.diameter, 4)} mm, {number(rim.mass, 4)} kg")
        sizes = (rim.diameter, rim.mass, rim.speed)
        values |= {told.of(shaft=wheel.shaft).key: size for told, size in zip(ELSEWHERE, sizes, strict=True)}
    return Fact(label, "\n".join((*lines, *(verdict.message for verdict in wheel.verdicts))), values)


def _methods_view(result: Flywheel) -> View:
    """One row a method: what it asks for, where its tangents touch, what comes of it."""
    rows, motor, shaft = result.rows, result.required is not None, _shaft(result)
    found = [row.positional for row in rows]
    columns: dict[str, list[Any]] = {
        "method": [called(method) for method in found],
        **table(found, FlywheelMethod, "inertia", *(("addition",) if result.addition > 0 else ())),
        MAX_AT.key: [phi_of(shaft, method.theta_max) for method in found],
        MIN_AT.key: [phi_of(shaft, method.theta_min) for method in found],
    }
    if result.addition <= 0:
        return View(list(columns), list(columns.values()))
    columns["delta"] = _deltas([method.delta for method in found])
    if motor:
        columns[_reached(result)] = _deltas([row.delta for row in rows])
    errors = [row.error if row.error is not None else row.positional.error for row in rows]
    columns[ERROR] = [100 * error for error in errors]
    return View(list(columns), list(columns.values()))


def _reached(result: Flywheel) -> str:
    """The column of what a method reaches under what the machine really runs under."""
    return "delta_loads" if result.undriven else "delta_motor"


def _legend_fact(result: Flywheel) -> Fact:
    """What stands in the columns of the table of methods."""
    places = "max_at, min_at: phi where the tangents touch"
    if result.addition <= 0:
        asked = "J_F all constant inertia that the method asks for"
        if result.required is not None:
            asked += " under forces of position,\nwhere no slip of a motor evens the speed"
        return Fact("in the table", f"{asked}\n{places}")
    lines = ["J_F all constant inertia, J_add the flywheel alone", places]
    if result.required is None:
        lines += ["delta reached with it", "error of J_F against the exact one"]
    else:
        lines += ["delta reached under forces of position", f"{_reached(result)} reached under {result.under}"]
        lines.append(f"error of J_F against the one needed under {result.under}")
    return Fact("in the table", "\n".join(lines))


def called(method: FlywheelMethod) -> str:
    """The name of a method for people."""
    return CALLED.get(method.method, method.method)


def _deltas(values: Sequence[float | None]) -> list[float | str]:
    return [STALLS if value is None else value for value in values]


def _shaft(result: Flywheel) -> Shaft:
    return Shaft(np.array([0.0, result.sense]))


def _tangents_fact(result: Flywheel) -> Fact:
    """The tangents of the energy-mass curve and the segment between their intercepts."""
    picture, shaft = result.picture, _shaft(result)
    (fast, slow), (high, low), (at_fast, at_slow) = picture.slopes, picture.intercepts, picture.touching
    lines = (
        f"tangents touch at phi = {angle(phi_of(shaft, at_fast))} and {angle(phi_of(shaft, at_slow))} deg",
        f"slopes {number(fast)} and {number(slow)} rad^2/s^2",
        f"intercepts G = {number(high, peak=low)} J, H = {number(low, peak=high)} J",
        f"J_F = GH/(delta omega^2) = {number(picture.inertia)} kg*m^2",
        f"T_0 = {number(picture.energy)} J, mean moment of the drive {number(picture.drive)} N*m",
    )
    parts = ("slope_max", "slope_min", "upper", "lower", "inertia", "energy", "drive")
    return Fact("energy-mass curve", "\n".join(lines), keyed(picture, *parts))


def _nodal_facts(result: Flywheel) -> list[Fact]:
    """The textbook's method as it is done by hand, and how far that is off."""
    nodal, exact = result.nodal, result.rows[0].positional.inertia
    if nodal is None or result.addition <= 0:
        return []
    off = f", {100 * (nodal.inertia / exact - 1):+.3g} % against the exact tangents" if exact else ""
    lines = (
        f"J_F = {number(nodal.inertia)} kg*m^2{off}",
        "(on the positions alone, the work by the trapezoid rule)",
    )
    return [Fact("textbook by its table", "\n".join(lines), BY_TABLE.value(nodal.inertia))]


def _search_facts(required: RequiredInertia, delta: float) -> list[Fact]:
    """Between which inertias the needed one lies, and whether more inertia was always better."""
    too_small = [trial for trial in required.trials if trial.inertia < required.inertia]
    count, falls = required.evaluations, "falls" if required.monotone else "does not always fall"
    lines = [f"{count} motions computed; delta {falls} as the inertia grows"]
    if required.needed and too_small:
        below = too_small[-1]
        reached = "stalls" if below.delta is None else f"delta = {number(below.delta)}"
        lines.append(f"{number(below.inertia)} kg*m^2: {reached}, too little")
        lines.append(f"{number(required.inertia)} kg*m^2: delta = {number(required.delta)}, enough")
    error = required.regime.error
    return [
        Fact("bounds of J_F", "\n".join(lines), {"trials": _trials(required.trials), **keyed(required, "monotone")}),
        Fact("error of its speed (est.)", f"{error:.0e} (relative)", {"error": {"speed": error}}),
    ]


def _trials(trials: Sequence[Trial]) -> list[dict[str, float]]:
    """Trials for programs; one that stalls has no delta."""
    return [keyed(trial, "inertia", *(() if trial.delta is None else ("delta",))) for trial in trials]


def _correction_facts(history: Sequence[Trial]) -> list[Fact]:
    """The textbook's correction J := J delta/[delta] (3.60), which comes near from above."""
    if len(history) < 2:
        return []
    steps = [f"{number(trial.inertia, 4)} ({number(trial.delta or 0.0, 4)})" for trial in history]
    text = f"J := J delta/[delta], from what is at hand\nJ in kg*m^2 (delta): {', '.join(steps)}"
    return [Fact("correction (3.60)", text, {"correction": _trials(history)})]
