"""The shaking moment before and after balancing: weights that take the force may well raise it."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.fourier import TURN, Magnitude
from tmmcalc.core.quantity import Quantity
from tmmcalc.machine.balance.columns import MOMENT_LEFT
from tmmcalc.machine.balance.schemes import Balance
from tmmcalc.machine.balance.solve import Balancing
from tmmcalc.machine.facts.weights import SAME, ratios, size_text, size_values
from tmmcalc.report.numbers import NOISE, angle, number


def phi_at(result: Balancing, at: float) -> float:
    """The crank angle ``at`` [rad] of a series as phi from position 0 along the motion [deg]."""
    sense = math.copysign(1.0, result.shaking.speed)
    way = (sense * (at - float(result.shaking.phi[0] - result.phi[0]))) % TURN
    return math.degrees(sense * (way if TURN - way > SAME else 0.0))


def moment(result: Balancing, told: Quantity, size: Magnitude, *, placed: bool = False) -> tuple[str, dict[str, float]]:
    """A moment for people and for programs; what rounding makes of all forces at an arm of a metre is noise."""
    phi = phi_at(result, size.at)
    text = size_text(size, told.unit, result.shaking.scale, f" at phi = {angle(phi)} deg" if placed else "")
    return text, size_values(size, told, "_phi", phi)


def moment_left(result: Balancing, scheme: str, before: Magnitude, after: Magnitude) -> tuple[str, dict[str, float]]:
    """The moment with the weights of a scheme and that without them."""
    told = MOMENT_LEFT.of(scheme=scheme)
    text, values = moment(result, told, after)
    noise = NOISE * result.shaking.scale
    if not changed(before, after) or max(before.largest, after.largest) <= noise:
        return f"moment as before: {text}", values
    was = f"\nmoment before: {moment(result, told, before)[0]}"
    if min(before.largest, after.largest) <= noise:
        return f"moment left: {text}{was}", values
    less_by = ratios("M_D", scheme, before, after)
    rms, largest = map(less, less_by.values())
    return f"moment left: {text}\nrms {rms}, max {largest}{was}", {**values, **less_by}


def less(ratio: float) -> str:
    """How many times less, or more, than before."""
    if abs(ratio - 1) <= SAME:
        return "as before"
    return f"{number(ratio, 4)} times less" if ratio > 1 else f"{number(1 / ratio, 4)} times more"


def moved(balance: Balance) -> bool:
    """Whether the weights change the moment."""
    return changed(balance.moment_before, balance.moment_after)


def changed(before: Magnitude, after: Magnitude) -> bool:
    """Whether one of two moments is not the other, but for rounding."""
    return (
        abs(after.rms - before.rms) > SAME * before.rms or abs(after.largest - before.largest) > SAME * before.largest
    )


def raised(result: Balancing) -> Iterator[str]:
    """The weights that shake the foundation by their moment more than the links did."""
    found = [(scheme.name, scheme.balance.moment_before, scheme.balance.moment_after) for scheme in result.schemes]
    if result.redistribution is not None:
        before, after = result.redistribution.before, result.redistribution.after
        found.append(("counterweights", before.moment_size, after.moment_size))
    for name, was, now in found:
        if now.largest <= NOISE * result.shaking.scale or not changed(was, now):
            continue
        if now.rms > was.rms or now.largest > was.largest:
            yield Phrase(
                "note: {name}: what takes the force raises the shaking moment: rms {rms} -> {rms_now} N*m, "
                "max {largest} -> {largest_now} N*m",
                name=name,
                rms=number(was.rms),
                rms_now=number(now.rms),
                largest=number(was.largest),
                largest_now=number(now.largest),
            )
