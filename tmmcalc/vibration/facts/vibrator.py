"""The documents of the vibratory device: springs, natural frequencies, steady vibration, starts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, pi

import numpy as np

from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number
from tmmcalc.vibration.facts.rows import some, whole
from tmmcalc.vibration.vibrator.columns import HEADERS, vibrator_columns
from tmmcalc.vibration.vibrator.forced import Steady
from tmmcalc.vibration.vibrator.paths import PointPath
from tmmcalc.vibration.vibrator.results import Curve, MotorStart, Start, VibratorResult
from tmmcalc.vibration.vibrator.runup import Course
from tmmcalc.vibration.vibrator.task import COORDINATES, UNITS

MORE = "--format csv prints modes, curve, a turn of the steady motion and the starts in SI"


def summary(result: VibratorResult, title: str) -> Document:
    """Springs, frequencies, steady motion, starts and what is to be said of them."""
    return Document(title, tuple(_facts(result)), result.notes)


def document(result: VibratorResult, title: str, *, patterns: Sequence[str] = (), everything: bool = False) -> Document:
    """The summary with the modes as a table and the courses in time; with ``everything`` all series in SI."""
    if everything:
        table = whole(vibrator_columns(result), patterns)
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
    hertz = (result.frequency / (2 * pi)).tolist()
    columns = [row.tolist() for row in result.shapes]
    shown = [f"{name}[{'-' if unit == 'm' else '1/m'}]" for name, unit in zip(COORDINATES, UNITS, strict=True)]
    return View(
        ["mode", "f[Hz]", "n[rpm]", "zeta", *shown],
        [list(range(1, 8)), hertz, [60 * f for f in hertz], result.ratio.tolist(), *columns],
    )


def _parts(result: VibratorResult, patterns: Sequence[str]) -> Iterator[Document]:
    for name, start in (("start", result.run_up), ("start by the motor", result.drive)):
        if start is None:
            continue
        course = start.course
        columns = {"t[s]": course.t, "omega[rad/s]": course.omega, **dict(zip(HEADERS, course.q, strict=True))}
        if isinstance(start, MotorStart):
            columns["M_motor[N*m]"] = start.motor
        yield Document(f"course of the {name}", table=some(columns, patterns), wide=not patterns, more=MORE)


def _facts(result: VibratorResult) -> Iterator[Fact]:
    yield from _springs(result)
    hertz = result.frequency / (2 * pi)
    error = result.error["frequencies"]
    text = f"{', '.join(number(f, 6) for f in hertz.tolist())} Hz\nrelative error at most {error:.0e}"
    values = {"natural_frequencies[Hz]": hertz.tolist(), "frequency_error": error, "zeta": result.ratio.tolist()}
    matrices = {"M": result.mass.tolist(), "C": result.stiffness.tolist(), "B": result.damping.tolist()}
    yield Fact("natural frequencies", text, values | matrices | {"modes": result.shapes.T.tolist()})
    if result.curve is not None:
        yield _curve(result.curve)
    if result.steady is not None:
        yield _steady(result.steady, result.error["amplitudes"])
    for path in result.paths:
        yield _path(path)
    if result.run_up is not None:
        yield _start("start", result.run_up)
    if result.drive is not None:
        yield _start("drive", result.drive)
        yield _motor(result.drive)


def _springs(result: VibratorResult) -> Iterator[Fact]:
    s = result.springs
    yield Fact("rod", f"c = {number(s.rod)} N/m, four of them", {"c_rod[N/m]": s.rod})
    text = f"c1 = {number(s.vertical)} N/m, against a tilt c_t = {number(s.tilt)} N*m/rad"
    values = {"c1[N/m]": s.vertical, "ct[N*m/rad]": s.tilt}
    if s.push is not None and s.bend is not None and s.twist is not None and s.weight is not None:
        text += f"\na = {number(s.push)} N/rad, d = {number(s.bend)}, d1 = {number(s.twist)} N*m/rad"
        text += f", weight {number(s.weight)} N*m/rad"
        values |= {"a[N/rad]": s.push, "d[N*m/rad]": s.bend, "d1[N*m/rad]": s.twist, "m2gl[N*m/rad]": s.weight}
    yield Fact("flat springs", text, values)
    yield Fact("plate", f"c2 = {number(s.plate)} N*m/rad", {"c2[N*m/rad]": s.plate})


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
        f"{each.coordinate}_peak": {f"amplitude[{units[each.coordinate]}]": each.amplitude, "omega[rad/s]": each.speed}
        for each in curve.peaks
    }
    return Fact("largest on the curve", "\n".join(lines) or "nothing moves", values)


def _steady(steady: Steady, error: float) -> Fact:
    moved = [
        f"{name} {_size(size, unit)}, {number(degrees(phase), 4)} deg behind"
        for name, unit, size, phase in zip(
            COORDINATES, UNITS, steady.amplitude.tolist(), steady.phase.tolist(), strict=True
        )
        if size
    ]
    lines = [f"at {_rpm(steady.speed)}", *moved]
    lines.append(f"dampers take {number(steady.power, 5)} W, {number(steady.moment, 5)} N*m of the rotor")
    lines.append(f"power of unbalance and dampers differ by {abs(steady.balance):.0e}; error est. {error:.0e}")
    values = {
        "omega[rad/s]": steady.speed,
        "amplitude": dict(zip(HEADERS, steady.amplitude.tolist(), strict=True)),
        "phase[deg]": dict(zip(COORDINATES, np.degrees(steady.phase).tolist(), strict=True)),
        "power[W]": steady.power,
        "rotor_moment[N*m]": steady.moment,
        "power_balance": steady.balance,
        "amplitude_error": error,
    }
    return Fact("steady motion", "\n".join(lines), values)


def _path(path: PointPath) -> Fact:
    x, y, z = (number(1e3 * size, 5) for size in path.amplitude.tolist())
    text = f"{x}, {y}, {z} mm along x, y, z\nellipse {number(1e3 * path.major, 5)} by {number(1e3 * path.minor, 5)} mm"
    values = {
        "amplitude[m]": path.amplitude.tolist(),
        "major[m]": path.major,
        "minor[m]": path.minor,
        "direction": path.direction.tolist(),
        "normal": path.normal.tolist(),
    }
    return Fact(f"path of {path.name}", text, {f"path_{path.name}": values})


def _start(name: str, start: Start | MotorStart) -> Fact:
    course: Course = start.course
    moved = [
        f"{each} {_size(size, unit)}"
        for each, unit, size in zip(COORDINATES, UNITS, start.largest.tolist(), strict=True)
    ]
    lines = [
        f"{number(float(course.t[-1]))} s, to {_rpm(float(course.omega[-1]))}",
        f"largest {', '.join(moved)}",
        f"work {number(float(course.work[-1]), 5)} J, taken by dampers {number(float(course.lost[-1]), 5)} J, stored "
        f"{number(float(course.energy[-1]), 5)} J\nenergy is open by {course.error:.0e} of its largest",
    ]
    values = {
        "largest": dict(zip(HEADERS, start.largest.tolist(), strict=True)),
        "end_omega[rad/s]": float(course.omega[-1]),
        "energy_error": course.error,
    }
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
    regimes = [{"omega[rad/s]": e.speed, "M[N*m]": e.moment, "stable": e.stable} for e in start.regimes]
    barriers = [
        {"mode": e.mode, "omega[rad/s]": e.speed, "load[N*m]": e.load, "M[N*m]": e.motor} for e in start.barriers
    ]
    values = {
        "mean_omega[rad/s]": start.mean,
        "stuck_at_mode": start.stuck,
        "regimes": regimes,
        "resonances": barriers,
    }
    return Fact("steady regimes", "\n".join(lines), values)
