"""An engine: forces and couples of its cylinders by orders of the shaft's speed, and the weights against them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial

from tmmcalc.machine.balance.cylinders import Cylinder
from tmmcalc.machine.balance.engines import EngineBalance, ShaftWeights
from tmmcalc.machine.balance.enginetask import Engine
from tmmcalc.machine.motors.model import RPM
from tmmcalc.machine.notes.counterweights import signed
from tmmcalc.machine.pictures.engine import draw_engine
from tmmcalc.machine.tables.tasks.balance import to_engine
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.numbers import NOISE
from tmmcalc.report.telling import drawn, lines, named, tabulated, vector

HIGH = 145.0  # of the picture [mm]
PLANES = (  # of a shaft: the projections of its weights
    "U_{<k>,I%} = -((z_II - z_0)*F_{<k>,%} - C_{<k>,%})/((z_II - z_I)*<rate>**2)",
    "U_{<k>,II%} = -((z_0 - z_I)*F_{<k>,%} + C_{<k>,%})/((z_II - z_I)*<rate>**2)",
)


def engine_blocks(order: Order, result: Engine) -> Iterator[Block]:
    """The cylinders, orders of forces and couples, weights on shafts, the picture."""
    task, balance = to_engine(order.spec), result.balance
    assert task is not None
    yield Heading(tr("Forces and couples of the engine"))
    yield Paragraph(tr("The cylinders are in table {tab:engine_cylinders}, with $z_j$ along the shaft."))
    yield _cylinders_table(task.cylinders)
    yield Paragraph(
        tr(
            "The inertia force of the pistons and cranks is a sum of harmonics of the shaft's speed. Those of the "
            "cylinders add up as vectors; table {tab:engine_orders} has the largest force $F_k$ and couple $C_k$ about "
            "the middle of the engine of each order $k$, and the sums $F_k^s$, $C_k^s$ of their sizes without "
            "directions."
        )
    )
    yield _orders_table(balance)
    lexicon = _quantities(task.cylinders, balance)
    if _alike(task.cylinders):
        yield from _sums(task.cylinders, balance, lexicon)
    yield from _shafts(result, lexicon)
    sheet = partial(draw_engine, result=result, across=False)
    yield Paragraph(tr("Forces and couples before and after balancing are shown in figure {fig:engine}."))
    yield drawn(tr("Force and couple of the engine"), sheet, HIGH, "engine")


def _cylinders_table(cylinders: Sequence[Cylinder]) -> Block:
    columns = {
        "$z_j$, m": [each.position_along_shaft for each in cylinders],
        "$gamma_j$, deg": [math.degrees(each.axis_angle) for each in cylinders],
        "$psi_j$, deg": [within_turn(each.crank_angle) for each in cylinders],
        "$r_j$, m": [each.crank_radius for each in cylinders],
        "$l_j$, m": [each.rod_length for each in cylinders],
        "$m_r$, kg": [each.reciprocating_mass for each in cylinders],
        "$m_t$, kg": [each.rotating_mass for each in cylinders],
    }
    labels = [str(k) for k in range(1, len(cylinders) + 1)]
    caption = tr("Cylinders: place, angles of axis and crank, sizes, reciprocating and rotating masses")
    return tabulated(caption, columns, labels, head="$j$", key="engine_cylinders")


def within_turn(angle: float) -> float:
    """An angle [rad] in degrees from -180 to 180, but for whole turns."""
    return round(math.degrees(math.remainder(angle, 2 * math.pi)), 9)


def _orders_table(balance: EngineBalance) -> Block:
    force, couple = balance.scales
    columns = {
        "$F_k$, N": [_told(each.largest_force, force) for each in balance.orders],
        "$F_k^s$, N": [each.force_alone for each in balance.orders],
        "$C_k$, N*m": [_told(each.largest_couple, couple) for each in balance.orders],
        "$C_k^s$, N*m": [each.couple_alone for each in balance.orders],
    }
    labels = [str(each.order) for each in balance.orders]
    return tabulated(tr("Forces and couples by orders"), columns, labels, head="$k$", key="engine_orders")


def _told(value: float, peak: float) -> float:
    return value if value > NOISE * peak else 0.0


def _alike(cylinders: Sequence[Cylinder]) -> bool:
    """Whether all have one direction and one crank gear, so that their vectors differ in direction alone."""
    first = cylinders[0]
    return all(
        (each.axis_angle, each.crank_radius, each.rod_length, each.reciprocating_mass, each.rotating_mass, each.offset)
        == (
            first.axis_angle,
            first.crank_radius,
            first.rod_length,
            first.reciprocating_mass,
            first.rotating_mass,
            first.offset,
        )
        for each in cylinders
    )


def _quantities(cylinders: Sequence[Cylinder], balance: EngineBalance) -> Lexicon:
    return named(
        {
            "psi_j": Given([within_turn(each.crank_angle) for each in cylinders], "deg", tr("angle of the crank")),
            "z_j": Given([each.position_along_shaft for each in cylinders], "m", tr("place of the cylinder")),
            "z_0": Given(balance.reference, "m", tr("middle of the engine")),
            "i_c": Given(float(len(cylinders)), "", tr("number of cylinders")),
            "n_e": Given(balance.speed * RPM, "rpm", tr("speed of the shaft")),
            "omega": Given(balance.speed, "rad/s", tr("angular velocity of the shaft")),
        }
    )


def _sums(cylinders: Sequence[Cylinder], balance: EngineBalance, lexicon: Lexicon) -> Iterator[Block]:
    """The vector sums of the forces that are left of each order."""
    left = [each for each in balance.orders if not each.forces_balanced]
    for each in left:
        k = each.order
        words = {"order": k}
        lexicon |= named(
            {
                f"F_{k}": Given(each.largest_force, "N", tr("force of order {order}", **words)),
                f"F_{{{k}}}^s": Given(each.force_alone, "N", tr("sum of the sizes of order {order}", **words)),
            }
        )
        angle = "psi_j" if k == 1 else f"{k}*psi_j"
        size = f"sqrt(sum(cos({angle}), j)**2 + sum(sin({angle}), j)**2)"
        yield from lines([f"F_{k} = F_{k}^s/i_c*{size}"], [Place("", lexicon)])


def _shafts(result: Engine, lexicon: Lexicon) -> Iterator[Block]:
    """Weights in two planes of every shaft that needs them."""
    balance = result.balance
    made = [shaft for shaft in result.shafts if _needed(balance, shaft)]
    if not made:
        yield Paragraph(tr("Forces and couples of the first and the second order are balanced: no weights are needed."))
        return
    yield Heading(tr("Weights on the crankshaft and on balance shafts"))
    yield Paragraph(
        tr(
            "A shaft that turns $k$ times as fast as the crankshaft (against it for $k < 0$) takes the part of force "
            "and couple away that turns with it, by weights in two planes, $z_I$ and $z_{II}$. Their static moments, "
            "with projections where the angle of the crankshaft is zero:"
        )
    )
    yield from lines(["omega = pi*n_e/30"], [Place("", lexicon)])
    for shaft in made:
        yield from _shaft_lines(balance, shaft, lexicon)
    rows = (
        (tr("as it is"), balance),
        (tr("weights on the crankshaft"), result.with_crankshaft),
        (tr("balance shafts"), result.with_shafts),
    )
    columns = {
        "$F_q$, N": [_told(each.force_size.rms, balance.scales[0]) for _, each in rows],
        "$F_{max}$, N": [_told(each.force_size.largest, balance.scales[0]) for _, each in rows],
        "$C_q$, N*m": [_told(each.couple_size.rms, balance.scales[1]) for _, each in rows],
        "$C_{max}$, N*m": [_told(each.couple_size.largest, balance.scales[1]) for _, each in rows],
    }
    labels = [name for name, _ in rows]
    yield Paragraph(
        tr(
            "Table {tab:engine_left} has root mean squares ($q$) and largest values of force and couple without and "
            "with the weights."
        )
    )
    yield tabulated(tr("Force and couple that are left"), columns, labels, head=tr("Balancing"), key="engine_left")
    for head, unit, said in (("F_{max}", "N", tr("largest force")), ("C_{max}", "N*m", tr("largest couple"))):
        largest = columns[f"${head}$, {unit}"]
        if any(largest):
            yield from (Result(head, Given(largest[k], unit, said), place=labels[k]) for k in (0, -1))


def _needed(balance: EngineBalance, shaft: ShaftWeights) -> bool:
    """Whether its weights are more than rounding."""
    return max(map(abs, shaft.moments)) * (shaft.order * balance.speed) ** 2 > NOISE * balance.scales[0]


def _shaft_lines(balance: EngineBalance, shaft: ShaftWeights, lexicon: Lexicon) -> Iterator[Block]:
    """The weights of one shaft, from its parts of force and couple."""
    k = shaft.order
    said = {"order": signed(k)}
    force, couple = balance.force.coefficient(k), balance.couple.coefficient(k)
    found = {
        **vector(
            f"F_{{{k},%}}", _clean(force, balance.scales[0]), "N", tr("force that turns with order {order}", **said)
        ),
        **vector(
            f"C_{{{k},%}}", _clean(couple, balance.scales[1]), "N*m", tr("couple that turns with order {order}", **said)
        ),
    }
    peak = max(map(abs, shaft.moments))
    for p, plane, moment in zip(("I", "II"), shaft.planes, shaft.moments, strict=True):
        of = tr("static moment of the weight in plane {plane}", plane=p)
        found[f"z_{p}"] = Given(plane, "m", tr("place of the plane"))
        found |= vector(f"U_{{{k},{p}%}}", _clean(moment, peak), "kg*m", tr("projections of this static moment"))
        found[f"U_{{{k},{p}}}"] = Given(abs(moment), "kg*m", of)
    lexicon |= named(found)
    words = {"k": str(k), "rate": "omega" if abs(k) == 1 else f"({abs(k)}*omega)"}
    for text, p in zip(PLANES, ("I", "II"), strict=True):
        size = f"U_{{<k>,{p}}} = sqrt(U_{{<k>,{p}x}}**2 + U_{{<k>,{p}y}}**2)"
        yield from lines([text.replace("%", "x"), text.replace("%", "y"), size], [Place("", lexicon)], words)


def _clean(value: complex, peak: float) -> complex:
    """A vector without projections that are rounding."""
    real, imag = (part if abs(part) > NOISE * peak else 0.0 for part in (value.real, value.imag))
    return complex(real, imag)
