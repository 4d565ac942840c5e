"""Checks of ``[torque]``: one law, a formula that can be read, points in order within the period."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.tables.checks.curves import Curve
from tmmcalc.linkage.tables.checks.input import followed_speed
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.identifiers import NAME
from tmmcalc.spec.outline import Outline, Raw, subtable, tables, word
from tmmcalc.spec.phrases import either, show
from tmmcalc.spec.quantities import BY_MOTOR
from tmmcalc.spec.units import FULL_TURN, dimension_of
from tmmcalc.spec.values import amount, amounts, check_bare_speed

LAWS = ("formula", "harmonics", "pieces", "table")
FEWEST = 3  # points of a spline
TURN = 2 * math.pi
_ANGLES = ("theta", "phi")
_JUMP = {"table": 'a jump needs interpolation = "linear"', "reduced_inertia": "an inertia does not jump"}
_PROBES = 360  # angles at which a formula has to have a value


def check_laws(outline: Outline) -> Iterator[Finding]:
    """A diagram has exactly one law; only a formula has constants; equal diagrams are counted once."""
    torque = subtable(outline.document, "torque")
    laws = [law for law in LAWS if law in torque]
    if not laws:
        rule = f"missing key: a torque diagram has one law: {either(LAWS)}"
        yield Finding(("torque",), rule, 'add formula = "500*sin(theta)^2 - 120", for example')
    for law in laws[1:]:
        said = f"{' and '.join(laws)} together: a torque diagram has one law"
        yield Finding(("torque", law), said, "keep one of them")
    if "constants" in torque and "formula" not in torque:
        yield Finding(("torque", "constants"), "constants without formula: nothing names them", "remove them")
    if "count" in torque and "delays" in torque:
        said = "delays and count together: the delays tell how many there are"
        yield Finding(("torque", "count"), said, "remove count, or remove delays for even ones")
    yield from check_bare_speed(torque.get("speed"), ("torque", "speed"))
    if torque.get("speed") == BY_MOTOR:
        yield from followed_speed(outline, ("torque", "speed"))


def check_formula(outline: Outline) -> Iterator[Finding]:
    """A formula can be read and has a value everywhere; its constants are not the angle itself."""
    torque = subtable(outline.document, "torque")
    formula, constants = torque.get("formula"), subtable(torque, "constants")
    for name in _ANGLES:
        if name in constants:
            said = f"{name} is the angle itself"
            yield Finding(("torque", "constants", name), said, "give the constant another name")
    numbers = {name: number for name, value in constants.items() if (number := amount(value)) is not None}
    if isinstance(formula, str) and len(numbers) == len(constants) and all(map(NAME.fullmatch, constants)):
        fault = _fault_of(formula, numbers, period(torque))
        if fault is not None:
            yield Finding(("torque", "formula"), fault.message, fault.remedy)


def _fault_of(formula: str, constants: Mapping[str, float], period: float) -> UsageError | None:
    """Return what is wrong with a formula, None if nothing is."""
    import numpy as np  # late: only formulas need it

    from tmmcalc.core.expression import parse
    from tmmcalc.machine.tables.torque import with_powers

    try:
        parse(with_powers(formula), constants)((np.arange(_PROBES) + 0.5) * (period / _PROBES))
    except UsageError as fault:
        return fault
    return None


def period(torque: Raw) -> float:
    """Return the angle of the cycle [rad], a turn if it is absent or faulty."""
    return amount(torque.get("period"), "angle") or TURN


def check_harmonics(outline: Outline) -> Iterator[Finding]:
    """Harmonics close in the period."""
    torque = subtable(outline.document, "torque")
    cycle = period(torque)
    for index, term in tables(subtable(torque, "harmonics"), "terms"):
        order = amount(term.get("order"))
        if order is not None and abs(order * cycle / TURN - round(order * cycle / TURN)) > 1e-9 * max(1.0, order):
            yield Finding(
                ("torque", "harmonics", "terms", index, "order"),
                f"the harmonic of order {show(term['order'])} does not close in a cycle of {math.degrees(cycle):g} deg",
                'write whole orders; in period = "720 deg", of a four-stroke engine, there are halves as well',
            )


def check_pieces(outline: Outline) -> Iterator[Finding]:
    """Every point is an angle and a moment; the angles ascend within the period, one may stand twice."""
    torque = subtable(outline.document, "torque")
    pieces = torque.get("pieces")
    pairs = [pair for pair in pieces if isinstance(pair, list) and len(pair) == 2] if isinstance(pieces, list) else []
    if not isinstance(pieces, list) or len(pairs) < len(pieces):
        return
    wrong = [
        Finding(
            ("torque", "pieces", index, place),
            f"{show(pair[place])} is {DIMENSIONS[found].noun}; a point is an angle, then a moment",
            'write ["90 deg", "100 N*m"], for example',
        )
        for index, pair in enumerate(pairs)
        for place, needed in enumerate(("angle", "moment"))
        if (found := dimension_of(pair[place])) in ("angle", "moment") and found != needed
    ]
    yield from wrong
    angles = amounts([pair[0] for pair in pairs], "angle", "moment")
    if wrong or angles is None or amounts([pair[1] for pair in pairs], "angle", "moment") is None:
        return
    curve = Curve(outline, torque, ("torque",), "angle")
    yield from _check_angles(curve, "pieces", [pair[0] for pair in pairs], angles, period(torque))


def _check_angles(
    curve: Curve, key: str, listed: list[object], angles: list[float], period: float, jumps: bool = True
) -> Iterator[Finding]:
    """Angles ascend from 0 to the period; two of them may be equal where the moment may jump."""
    for i, (value, angle) in enumerate(zip(listed, angles, strict=True)):
        place, at = curve.place(key, i), curve.at(i)
        back = i > 0 and not (angle > angles[i - 1] or (jumps and angle == angles[i - 1]))
        if back or (i > 1 and angle == angles[i - 2]):
            rule = "at most two points at one angle" if jumps and angle == angles[i - 1] else "the angles ascend"
            remedy = "put the points in order" if jumps else f"put them in order; {_JUMP[str(curve.path[-1])]}"
            yield Finding(place, f"{at}{show(value)} does not come after {show(listed[i - 1])}; {rule}", remedy)
            return
        if angle < 0 or angle > period * (1 + 1e-12):
            yield _after_the_period(curve, key, i, value, angle, period)
            return


def _after_the_period(curve: Curve, key: str, index: int, value: object, angle: float, period: float) -> Finding:
    place, at = curve.place(key, index), curve.at(index)
    if not isinstance(value, str) and angle > FULL_TURN:
        said = f"{show(value)} without a unit is in radians, more than the period"
        return Finding(place, said, f'write "{value} deg"')
    said = f"{at}{show(value)} lies outside the period, 0 to {math.degrees(period):g} deg"
    return Finding(place, said, "count from the beginning of the cycle, or give its period")


class Points(NamedTuple):
    """What a table of points is of: its place, the key of its values, words for faults, its period, its usual curve."""

    name: str
    key: str  # of the values, and their dimension
    noun: str
    several: str
    remedy: str  # where it has no values
    period: float
    usual: str


def check_table(outline: Outline) -> Iterator[Finding]:
    """A table of moments, and one of the reduced inertia, has its values or a file, one for each ascending angle."""
    torque = subtable(outline.document, "torque")
    cycle = period(torque)
    add = 'add moment = [0, "40 N*m", 0], or file = "m.csv"'
    yield from _check_source(outline, Points("table", "moment", "a torque diagram", "moments", add, cycle, "linear"))
    own = amount(subtable(torque, "reduced_inertia").get("period"), "angle") or cycle
    times = cycle / own
    if abs(times - round(times)) > 1e-9 or times < 0.5:
        said = f"a period of {math.degrees(own):g} deg does not divide the cycle of {math.degrees(cycle):g} deg"
        yield Finding(("torque", "reduced_inertia", "period"), said, "write the cycle or a whole part of it")
        return
    noun, several = "a reduced inertia", "moments of inertia"
    add = 'add inertia = ["4 kg*m^2", "5 kg*m^2", "4.5 kg*m^2"], or file = "j.csv"'
    yield from _check_source(outline, Points("reduced_inertia", "inertia", noun, several, add, own, "spline"))


def _check_source(outline: Outline, of: Points) -> Iterator[Finding]:
    table = subtable(outline.document, "torque").get(of.name)
    if not isinstance(table, dict):
        return
    curve = Curve(outline, table, ("torque", of.name), "angle")
    given = [key for key in ("theta", of.key) if key in curve.table]
    if "file" in curve.table and given and curve.path not in outline.rows:
        said = f"file together with {' and '.join(given)}: the file holds all values"
        yield Finding((*curve.path, "file"), said, f"remove file, or remove {' and '.join(given)}")
    elif "file" not in curve.table and of.key not in curve.table:
        yield Finding(curve.path, f"missing key: {of.noun} in a table has its {of.several}", of.remedy)
    yield from _check_points(curve, of)


def _check_points(curve: Curve, of: Points) -> Iterator[Finding]:
    theta, listed = curve.table.get("theta"), curve.table.get(of.key)
    kind = word(curve.table, "interpolation", of.usual)
    if not isinstance(listed, list):
        return
    if "theta" not in curve.table:
        if kind == "spline" and len(listed) < FEWEST:
            yield _too_few(curve, of.key)
        return
    if not isinstance(theta, list):
        return
    if len(theta) != len(listed) > 1 < len(theta):
        said = f"{len(listed)} {of.several} for {len(theta)} angles"
        yield Finding(curve.place(of.key), said, f"write one {of.several.replace('moments', 'moment')} for each angle")
    angles, values = amounts(theta, "angle"), amounts(listed, of.key)
    if not angles or min(angles) < 0:
        return
    jumps = kind == "linear" and of.key == "moment"
    wrong = list(_check_angles(curve, "theta", theta, angles, of.period, jumps=jumps))
    yield from wrong
    if wrong or jumps or not values or len(values) != len(angles):
        return
    whole = angles[-1] - angles[0] > of.period * (1 - 1e-12)
    if whole and abs(values[-1] - values[0]) > 1e-9 * max(map(abs, values)):
        yield Finding(
            curve.place(of.key, len(values) - 1),
            f"{curve.at(len(values) - 1)}the curve ends with {show(listed[-1])} and begins with {show(listed[0])} "
            "at the same position of the shaft",
            f"make the two equal; {_JUMP[of.name]}",
        )
    elif whole and len(angles) == 2:
        said = "one point of the cycle alone makes no curve"
        yield Finding(curve.place("theta"), said, "give points between the ends of the period")
    elif kind == "spline" and len(angles) - whole < FEWEST:
        yield _too_few(curve, "theta")


def _too_few(curve: Curve, key: str) -> Finding:
    said = "two points of the period make no cubic spline"
    return Finding(curve.place(key), said, 'give three points or more, or interpolation = "linear"')


def check_alone(outline: Outline) -> Iterator[Finding]:
    """A crank's moment has one source."""
    other = next((name for name in ("mechanism", "synthesis") if name in outline.document), "")
    if other and "torque" in outline.document:
        yield Finding(
            ("torque",),
            f"torque together with {other}: a torque diagram stands in place of a mechanism",
            "remove one of them; a moment on a link of the mechanism is a load, [[loads]]",
        )


CHECKS = (check_alone, check_laws, check_formula, check_harmonics, check_pieces, check_table)
