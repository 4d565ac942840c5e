"""The documents of the pendulum-rotor: whirl, critical speeds, torsion, Campbell diagram, motion in time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, pi

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import headed, keyed, keys
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import number
from tmmcalc.vibration.facts.rows import all_rows, spaced_rows
from tmmcalc.vibration.pendulum.columns import campbell_columns, pendulum_columns
from tmmcalc.vibration.pendulum.results import PendulumResult, WhirlModes
from tmmcalc.vibration.pendulum.swing import SwingCourse

MORE = "--format csv prints shapes, diagram and motion in SI"


def summary(result: PendulumResult, title: str) -> Document:
    """Frequencies, critical speeds, torsion, motion and what is to be said of them."""
    return Document(title, tuple(_facts(result)), result.notes)


def document(result: PendulumResult, title: str, *, patterns: Sequence[str] = (), everything: bool = False) -> Document:
    """The summary with the modes as a table, diagram and motion; with ``everything`` all series in SI."""
    facts = tuple(_facts(result))
    if everything:
        return Document(title, facts, result.notes, all_rows(pendulum_columns(result), patterns))
    parts = []
    if result.campbell is not None:
        view = spaced_rows(campbell_columns(result.campbell), patterns)
        parts.append(Document("Campbell diagram", table=view, wide=not patterns, more=MORE))
    if result.swing is not None:
        path = headed(result.swing, "t", "v", "w", "carrier_x", "carrier_y")
        parts.append(Document("motion of the lower end", table=spaced_rows(path, patterns), more=MORE))
    return Document(title, facts, result.notes, _modes(result), parts=tuple(parts), more=MORE)


def _modes(result: PendulumResult) -> View:
    """One row a mode."""
    rows = [
        (modes.name, k, *values)
        for modes in result.modes
        for k, values in enumerate(
            zip(modes.hertz.tolist(), modes.frequency.tolist(), modes.speed.tolist(), modes.nodes, strict=True), 1
        )
    ]
    headers = ["whirl", "mode", *keys(WhirlModes, "hertz", "frequency", "speed"), "nodes"]
    return View(headers, [list(column) for column in zip(*rows, strict=True)])


def _speeds(values: Values) -> str:
    return f"{', '.join(number(w * 30 / pi, 6) for w in values.tolist())} rpm" if len(values) else "none"


def _facts(result: PendulumResult) -> Iterator[Fact]:
    spin = result.spin
    if spin:
        yield Fact("spin", f"{number(spin, 6)} rad/s ({number(spin * 30 / pi, 6)} rpm)", keyed(result, "spin"))
    (omega,) = keys(WhirlModes, "frequency")
    values = {omega: {modes.name.replace(" ", "_"): modes.frequency.tolist() for modes in result.modes}}
    text = "\n".join(f"{modes.name}: {_hertz(modes.frequency)} Hz" for modes in result.modes)
    text += f"\n{result.functions} functions, relative error about {result.frequency_error:.0e}"
    yield Fact("natural frequencies", text, values | keyed(result, "frequency_error"))
    if result.rigid is not None:
        forward, backward = result.rigid
        text = f"{number(forward / (2 * pi), 6)} Hz"
        text += f" forward, {number(backward / (2 * pi), 6)} Hz backward" if spin else ""
        yield Fact("the same of a rigid rod", text, keyed(result, "rigid"))
    if len(result.backward_critical):
        text = f"forward {_speeds(result.forward_critical)}\nbackward {_speeds(result.backward_critical)}"
        yield Fact("critical speeds", text, keyed(result, "critical"))
    if result.deflection is not None:
        side = "on the heavy side" if result.deflection > 0 else "on the light side: it centres itself"
        text = f"{number(1e3 * abs(result.deflection), 5)} mm at the lower end, {side}"
        yield Fact("whirl of the unbalance", text, keyed(result, "deflection"))
    if len(result.torsion):
        yield Fact("torsion", f"{_hertz(result.torsion)} Hz", keyed(result, "torsion"))
    if result.swing is not None:
        yield _swing(result.swing)


def _hertz(omega: Values) -> str:
    return ", ".join(number(f, 6) for f in (omega / (2 * pi)).tolist())


def _swing(swing: SwingCourse) -> Fact:
    text = (
        f"lower end up to {number(1e3 * swing.distance, 5)} mm from under the joint, at t = "
        f"{number(swing.distance_at, 5)} s\nslope there up to {number(degrees(swing.slope), 4)} deg\n"
        f"energy and work differ by {swing.balance:.0e}; error of the path about {swing.error:.0e}"
    )
    values = keyed(swing, "distance", "distance_at", "slope", "balance", "error")
    return Fact("motion in time", text, {"swing": values})
