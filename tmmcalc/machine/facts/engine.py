"""The document of an engine: forces and couples by order, firing intervals, what weights leave.

Largest forces and couples are those over a turn of the shaft. Weights are given by their static moments where the
angle of the shaft is 0, in the planes z along it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from tmmcalc.core.numerics.fourier import Magnitude
from tmmcalc.core.quantity import Quantity, keyed, quantities, table
from tmmcalc.machine.balance.engines import EngineBalance, Order, ShaftWeights
from tmmcalc.machine.balance.enginetask import Engine
from tmmcalc.machine.balance.firing import Firing
from tmmcalc.machine.facts.weights import DIRECTION, MOMENT, PLANE, direction, size_text, size_values
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import NOISE, angle, number

NAMES = {1: "primary", 2: "secondary"}

FORCE = Quantity("F[N]", "force of the engine over a turn")
COUPLE = Quantity("C[N*m]", "couple of the engine over a turn")
FORCE_LEFT = Quantity("F_{shafts}[N]", "force left by weights on {shafts}")
COUPLE_LEFT = Quantity("C_{shafts}[N*m]", "couple left by weights on {shafts}")
WEIGHTS = Quantity("weights_{shafts}", "weights on {shafts}")
FIRING, ANGLE = quantities(Firing)["order"], DIRECTION.of(name="")


def engine_document(result: Engine, title: str) -> Document:
    """Facts, and the table of orders."""
    balance = result.balance
    speed = f"{number(balance.speed)} rad/s ({number(balance.speed * 30 / math.pi)} rpm)"
    head = {**keyed(result, "cylinders"), **keyed(balance, "speed", "reference")}
    facts = (
        Fact("engine", f"{result.cylinders} cylinder{'s' if result.cylinders > 1 else ''} at {speed}", head),
        *_shaking_facts(balance),
        *_order_facts(balance.orders),
        *_firing_facts(result.firing),
        _weights_fact("crankshaft weights", "crankshaft", result, (result.crankshaft,), result.with_crankshaft),
        _weights_fact("with balance shafts", "shafts", result, result.shafts, result.with_shafts),
        *_legend_facts(result),
        Fact("error of force (est.)", f"{balance.error:.0e} (relative)", {"error": {"shaking": balance.error}}),
    )
    return Document(title, facts, table=_orders_view(balance))


def _legend_facts(result: Engine) -> Iterator[Fact]:
    """How weights are told, and what stands in the table."""
    if any(_needed(result.balance, shaft) for shaft in result.shafts):
        yield Fact("order of a weight", "speed of its shaft over that of the crankshaft; negative: against it")
    text = "F, C: largest force and couple of an order; F_alone, C_alone: those of the cylinders singly, added up"
    yield Fact("columns", text)


def _sizes(told: Quantity, size: Magnitude, peak: float) -> tuple[str, dict[str, float]]:
    degrees = math.degrees(size.at)
    return size_text(size, told.unit, peak, f" at {angle(degrees)} deg"), size_values(size, told, "", degrees)


def _shaking_facts(balance: EngineBalance) -> Iterator[Fact]:
    """Force and couple of all orders together."""
    yield Fact("force of the engine", *_sizes(FORCE, balance.force_size, balance.scales[0]))
    text, values = _sizes(COUPLE, balance.couple_size, balance.scales[1])
    yield Fact("couple of the engine", f"{text}\nabout the plane z = {number(1e3 * balance.reference)} mm", values)


def _order_facts(orders: Sequence[Order]) -> Iterator[Fact]:
    """Which forces and couples cancel, and which are left."""
    kept, left = [], []
    for order in orders:
        name = NAMES.get(order.order, f"order {order.order}")
        states = (("forces", order.forces_balanced), ("couples", order.couples_balanced))
        none = [word for word, balanced in states if balanced]
        if none:
            kept.append(f"{name} {' and '.join(none)}")
        if not order.forces_balanced:
            left.append(f"{name} forces {number(order.largest_force, 5)} N")
        if not order.couples_balanced:
            left.append(f"{name} couples {number(order.largest_couple, 5)} N*m")
    yield Fact("balanced", ", ".join(kept) or "nothing")
    yield Fact("left", ", ".join(left) or "nothing")


def _firing_facts(firing: Firing | None) -> list[Fact]:
    if firing is None:
        return []
    degrees = [math.degrees(interval) for interval in firing.intervals]
    order = "-".join(map(str, firing.order))
    text = f"every {angle(degrees[0])}" if firing.even else f"unevenly: after {', '.join(map(angle, degrees))}"
    intervals, _ = quantities(Firing)["intervals"].shown("deg")
    values = {FIRING.key: list(firing.order), intervals: degrees, **keyed(firing, "even")}
    return [Fact("firing order", f"{order}, {text} deg", values)]


def _weights_fact(label: str, key: str, result: Engine, shafts: Sequence[ShaftWeights], after: EngineBalance) -> Fact:
    """Weights in two planes of every shaft, and what they leave."""
    balance = result.balance
    made = [shaft for shaft in shafts if _needed(balance, shaft)]
    force, values = _sizes(FORCE_LEFT.of(shafts=key), after.force_size, after.scales[0])
    couple, more = _sizes(COUPLE_LEFT.of(shafts=key), after.couple_size, after.scales[1])
    weights = [_weight_values(shaft, k) for shaft in made for k in range(2)]
    every = {**(WEIGHTS.of(shafts=key).value(weights) if weights else {}), **values, **more}
    if not made:
        none = (
            "none: no force or couple turns with the shaft" if len(shafts) == 1 else "none: orders 1 and 2 are balanced"
        )
        return Fact(label, none, every)
    lines = [line for shaft in made for line in _lines(shaft)]
    return Fact(label, "\n".join((*lines, f"force left: {force}", f"couple left: {couple}")), every)


def _needed(balance: EngineBalance, shaft: ShaftWeights) -> bool:
    """Whether its weights are more than rounding."""
    rate2 = (shaft.order * balance.speed) ** 2
    return max(map(abs, shaft.moments)) * rate2 > NOISE * balance.scales[0]


def _lines(shaft: ShaftWeights) -> Iterator[str]:
    """A line for the weight in each plane of the shaft."""
    peak = max(map(abs, shaft.moments))
    for z, moment in zip(shaft.planes, shaft.moments, strict=True):
        size = f"{number(abs(moment), 5, peak)} kg*m at {direction(cmath.phase(moment))} deg"
        yield f"order {shaft.order}, z = {number(1e3 * z)} mm: {size}"


def _weight_values(shaft: ShaftWeights, k: int) -> dict[str, float]:
    moment = shaft.moments[k]
    told = zip((PLANE, MOMENT, ANGLE), (shaft.planes[k], abs(moment), math.degrees(cmath.phase(moment))), strict=True)
    return {**keyed(shaft, "order"), **{each.key: value for each, value in told}}


def _orders_view(balance: EngineBalance) -> View:
    """One row an order."""
    orders = balance.orders
    columns = table(orders, Order, "order", "largest_force", "force_alone", "largest_couple", "couple_alone")
    columns["balanced"] = [_balanced(o) for o in orders]
    peaks = (0.0, balance.scales[0], 0.0, balance.scales[1], 0.0, 0.0)
    return View(list(columns), list(columns.values()), peaks)


def _balanced(order: Order) -> str:
    words = [word for word, is_so in (("forces", order.forces_balanced), ("couples", order.couples_balanced)) if is_so]
    return " and ".join(words) or "nothing"
