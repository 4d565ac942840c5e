"""The document of what the cam asks of the shaft: how it is driven, its inertia and torque, the work of all causes."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, fsum
from typing import Any

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity, keyed
from tmmcalc.machine.attached import Attached
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import angle, number

TORQUE = Quantity("M_{name}_{end}[N*m]", "{end} torque that the {name} asks of the input shaft at the mean speed")
WORK = Quantity("work_{name}[J]", "work of the {name} on the shaft while it repeats once")
ENDS = ("min", "max")


def summary(result: Attached, title: str) -> Document:
    """Facts and notes; the moments over the cycle stand in the table of the reduction."""
    return Document(title, tuple(_facts(result)), tuple(Phrase("note: {note}", note=note) for note in result.notes))


def _facts(result: Attached) -> Iterator[Fact]:
    name = result.name
    turns = "a turn" if result.turns == 1 else f"{result.turns} turns"
    how = "as the crank turns" if result.ratio == 1 else f"at {number(result.ratio)} of the speed of the crank"
    text = f"{how}, {number(result.speed)} rad/s; repeats after {turns}"
    yield Fact("driven", text, keyed(result, "ratio", "turns", "speed", name=name))
    largest = f"up to {number(result.inertia_max)} kg*m^2"
    yield Fact("inertia at the crank", largest, keyed(result, "inertia_max", name=name))
    peak = max(abs(end.value) for end in result.torque)
    lines = [
        f"{word} {number(end.value, peak=peak)} N*m at theta = {angle(degrees(end.x))} deg"
        for word, end in zip(ENDS, result.torque, strict=True)
    ]
    values: dict[str, Any] = {}
    for word, end in zip(ENDS, result.torque, strict=True):
        values |= TORQUE.of(name=name, end=word).value(end.value)
    yield Fact("torque asked of the crank", "\n".join(lines), values)
    scale = peak * result.period
    for cause in result.causes:
        own = keyed(cause, "work", cause=cause.name.replace(" ", "_"))
        yield Fact(f"work of {cause.name}", f"{number(cause.work, peak=scale)} J", own)
    whole = fsum(cause.work for cause in result.causes)
    yield Fact(f"work of the {name}", f"{number(whole, peak=scale)} J in {turns}", WORK.of(name=name).value(whole))
