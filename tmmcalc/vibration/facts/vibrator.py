"""The documents of the vibratory device: springs, natural frequencies, steady vibration, starts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, pi
from typing import Any

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import headed, keyed, quantity_of
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number
from tmmcalc.vibration.facts.rows import all_rows, spaced_rows
from tmmcalc.vibration.vibrator.columns import vibrator_columns
from tmmcalc.vibration.vibrator.forced import Steady
from tmmcalc.vibration.vibrator.paths import PointPath
from tmmcalc.vibration.vibrator.results import COORDINATE, HEADERS, Curve, MotorStart, Start, VibratorResult
from tmmcalc.vibration.vibrator.runup import DeviceMotion
from tmmcalc.vibration.vibrator.task import COORDINATES, UNITS

MORE = "--format csv prints modes, curve, a turn of the steady motion and the starts in SI"


def summary(result: VibratorResult, title: str) -> Document:
    """Springs, frequencies, steady motion, starts and what is to be said of them."""
    return Document(title, tuple(_facts(result)), result.notes)


def document(result: VibratorResult, title: str, *, patterns: Sequence[str] = (), everything: bool = False) -> Document:
    """The summary with the modes as a table and the courses in time; with ``everything`` all series in SI."""
    if everything:
        table = all_rows(vibrator_columns(result), patterns)
        return Document(title, tuple(_facts(result)), result.notes, table)
    return Document(
        title,
        tuple(_facts(result)),
        result.notes,
        _modes(result),
        more=MORE,
        parts=tuple(_parts(result, patterns)),
    )


def _modes(result: VibratorResult) -> View:
    """One row a mode: frequency, damping, shape with its largest displacement 1 mm or 1 mrad a metre."""
    shown: dict[str, Any] = {"mode": list(range(1, 8))}
    shown |= {header: column.tolist() for header, column in headed(result, "hertz", "speeds", "ratio").items()}
    for name, unit, shape in zip(COORDINATES, UNITS, result.shapes.tolist(), strict=True):
        shown[COORDINATE.of(coordinate=name, unit="-" if unit == "m" else "1/m").key] = shape
    return View(list(shown), list(shown.values()))


def _parts(result: VibratorResult, patterns: Sequence[str]) -> Iterator[Document]:
    for name, start in (("start", result.run_up), ("start by the motor", result.drive)):
        if start is None:
            continue
        course = start.course
        shown = headed(course, "t", "omega") | dict(zip(HEADERS, course.q, strict=True))
        if isinstance(start, MotorStart):
            shown |= headed(start, "motor")
        yield Document(f"course of the {name}", table=spaced_rows(shown, patterns), wide=not patterns, more=MORE)


def _facts(result: VibratorResult) -> Iterator[Fact]:
    yield from _springs(result)
    hertz = ", ".join(number(f, 6) for f in result.hertz.tolist())
    text = f"{hertz} Hz\nrelative error at most {result.frequency_error:.0e}"
    values = keyed(result, "hertz", "frequency_error", "ratio", "mass", "stiffness", "damping", "modes")
    yield Fact("natural frequencies", text, values)
    if result.curve is not None:
        yield _curve(result.curve)
    if result.steady is not None:
        yield _steady(result.steady, result)
    for path in result.paths:
        yield _path(path)
    if result.run_up is not None:
        yield _start("start", result.run_up)
    if result.drive is not None:
        yield _start("drive", result.drive)
        yield _motor(result.drive)


def _springs(result: VibratorResult) -> Iterator[Fact]:
    s = result.springs
    yield Fact("rod", f"c = {number(s.rod)} N/m, four of them", keyed(s, "rod"))
    text = f"c1 = {number(s.vertical)} N/m, against a tilt c_t = {number(s.tilt)} N*m/rad"
    values = keyed(s, "vertical", "tilt")
    if s.push is not None and s.bend is not None and s.twist is not None and s.weight is not None:
        text += f"\na = {number(s.push)} N/rad, d = {number(s.bend)}, d1 = {number(s.twist)} N*m/rad"
        text += f", weight {number(s.weight)} N*m/rad"
        values |= keyed(s, "push", "bend", "twist", "weight")
    yield Fact("flat springs", text, values)
    yield Fact("plate", f"c2 = {number(s.plate)} N*m/rad", keyed(s, "plate"))


def _size(value: float, unit: str) -> str:
    return f"{number(1e3 * value, 5)} mm" if unit == "m" else f"{number(degrees(value), 5)} deg"


def _rpm(omega: float) -> str:
    return f"{number(omega, 6)} rad/s ({number(omega * 30 / pi, 6)} rpm)"


def _curve(curve: Curve) -> Fact:
    units = dict(zip(COORDINATES, UNITS, strict=True))
    lines = [
        f"{each.coordinate} {_size(each.amplitude, units[each.coordinate])} at {_rpm(each.speed)}"
        for each in curve.peaks
    ]
    values = {
        f"{each.coordinate}_peak": keyed(each, "amplitude", "speed", unit=units[each.coordinate])
        for each in curve.peaks
    }
    return Fact("largest on the curve", "\n".join(lines) or "nothing moves", values)


def _steady(steady: Steady, result: VibratorResult) -> Fact:
    moved = [
        f"{name} {_size(size, unit)}, {number(degrees(phase), 4)} deg behind"
        for name, unit, size, phase in zip(
            COORDINATES, UNITS, steady.amplitude.tolist(), steady.phase.tolist(), strict=True
        )
        if size
    ]
    lines = [f"at {_rpm(steady.speed)}", *moved]
    lines.append(f"dampers take {number(steady.power, 5)} W, {number(steady.moment, 5)} N*m of the rotor")
    lines.append(
        f"power of unbalance and dampers differ by {abs(steady.balance):.0e}; error est. {result.amplitude_error:.0e}"
    )
    values = {
        **keyed(steady, "speed"),
        "amplitude": dict(zip(HEADERS, steady.amplitude.tolist(), strict=True)),
        quantity_of(Steady, "phase").key: dict(zip(COORDINATES, steady.phase.tolist(), strict=True)),
        **keyed(steady, "power", "moment", "balance"),
        **keyed(result, "amplitude_error"),
    }
    return Fact("steady motion", "\n".join(lines), values)


def _path(path: PointPath) -> Fact:
    x, y, z = (number(1e3 * size, 5) for size in path.amplitude.tolist())
    text = f"{x}, {y}, {z} mm along x, y, z\nellipse {number(1e3 * path.major, 5)} by {number(1e3 * path.minor, 5)} mm"
    values = keyed(path, "amplitude", "major", "minor", "direction", "normal")
    return Fact(Phrase("path of {point}", point=path.name), text, {f"path_{path.name}": values})


def _start(name: str, start: Start | MotorStart) -> Fact:
    course: DeviceMotion = start.course
    moved = [
        f"{each} {_size(size, unit)}"
        for each, unit, size in zip(COORDINATES, UNITS, start.largest.tolist(), strict=True)
    ]
    lines = [
        f"{number(float(course.t[-1]))} s, to {_rpm(course.end_omega)}",
        f"largest {', '.join(moved)}",
        f"work {number(float(course.work[-1]), 5)} J, taken by dampers {number(float(course.lost[-1]), 5)} J, stored "
        f"{number(float(course.energy[-1]), 5)} J\nenergy is open by {course.error:.0e} of its largest",
    ]
    largest = dict(zip(HEADERS, start.largest.tolist(), strict=True))
    values = {"largest": largest, **keyed(course, "end_omega", "error")}
    return Fact("start" if name == "start" else "start by the motor", "\n".join(lines), {name: values})


def _motor(start: MotorStart) -> Fact:
    lines = [f"mean {_rpm(start.mean)} at the end"]
    lines += [
        f"{'stable' if each.stable else 'unstable'} at {_rpm(each.speed)}, {number(each.moment, 5)} N*m"
        for each in start.regimes
    ]
    lines += [
        f"resonance {each.mode}: asks {number(each.load, 4)} N*m of {number(each.motor, 4)} N*m"
        for each in start.barriers
    ]
    values = {
        **keyed(start, "mean", "stuck"),
        "regimes": [keyed(each, "speed", "moment", "stable") for each in start.regimes],
        "resonances": [keyed(each, "mode", "speed", "load", "motor") for each in start.barriers],
    }
    return Fact("steady regimes", "\n".join(lines), values)
