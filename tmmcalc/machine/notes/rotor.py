"""A rotor: its unbalance, corrections in one plane and in two, the loads of its bearings, the grade that it keeps.

All stands in axes that turn with the rotor.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from tmmcalc.machine.balance.grades import INBOARD, LEAST, OUTBOARD
from tmmcalc.machine.balance.rotors import Rotor, RotorVerdict
from tmmcalc.machine.balance.rotortask import BalancedRotor
from tmmcalc.machine.balance.weights import Weight
from tmmcalc.machine.model import RotorTask
from tmmcalc.machine.motors.model import RPM
from tmmcalc.machine.tables.tasks.balance import to_rotor
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.numbers import NOISE
from tmmcalc.report.telling import column_of, lines, named, tabulated

MOMENT, COUPLE = "kg*m", "kg*m^2"
RESULTANT = (
    "U_x = sum(m_i*r_i*cos(alpha_i), i)",
    "U_y = sum(m_i*r_i*sin(alpha_i), i)",
    "U = sqrt(U_x**2 + U_y**2)",
    "e = 1000*U/m",
    "K_x = sum((z_i - z_S)*m_i*r_i*cos(alpha_i), i)",
    "K_y = sum((z_i - z_S)*m_i*r_i*sin(alpha_i), i)",
    "K = sqrt(K_x**2 + K_y**2)",
)
LOADS = (
    "omega = pi*n_R/30",
    "A_x = omega**2*sum((z_B - z_i)*m_i*r_i*cos(alpha_i), i)/(z_B - z_A)",
    "A_y = omega**2*sum((z_B - z_i)*m_i*r_i*sin(alpha_i), i)/(z_B - z_A)",
    "A = sqrt(A_x**2 + A_y**2)",
    "B_x = omega**2*sum((z_i - z_A)*m_i*r_i*cos(alpha_i), i)/(z_B - z_A)",
    "B_y = omega**2*sum((z_i - z_A)*m_i*r_i*sin(alpha_i), i)/(z_B - z_A)",
    "B = sqrt(B_x**2 + B_y**2)",
)
STATIC = ("U_s = U", "psi_s = atan2(-U_y, -U_x)")
PLANES = (
    "U_{<p>x} = -sum((<far> - z_i)*m_i*r_i*cos(alpha_i), i)/(<far> - z_<p>)",
    "U_{<p>y} = -sum((<far> - z_i)*m_i*r_i*sin(alpha_i), i)/(<far> - z_<p>)",
    "U_<p> = sqrt(U_{<p>x}**2 + U_{<p>y}**2)",
    "psi_<p> = atan2(U_{<p>y}, U_{<p>x})",
)


def rotor_blocks(order: Order, result: BalancedRotor) -> Iterator[Block]:
    """The unbalance, the loads of the bearings, both corrections, what is left, the grade."""
    task = to_rotor(order.spec)
    assert task is not None
    place = Place("", named(_quantities(task, result)))
    yield Heading(tr("Unbalance of the rotor"))
    yield Paragraph(tr("The unbalanced masses are in table {tab:rotor_masses}, in axes that turn with the rotor."))
    if any(each.moment is not None for each in order.spec.rotor.unbalances):
        yield Paragraph(tr("An unbalance that is given by its static moment is the mass that has it at 1 m."))
    yield _masses_table(task.rotor)
    yield Paragraph(tr("The resultant static moment, the shift of the centre of mass and the couple about it:"))
    yield from lines(RESULTANT, [place])
    yield Paragraph(tr("The loads of the bearings that turn with the rotor:"))
    yield from lines(LOADS, [place])
    yield Heading(tr("Balancing in one plane"))
    yield Paragraph(tr("A weight opposite to the resultant brings the centre of mass onto the axis:"))
    made = [] if result.static is None else ["m_s = U_s/r_k"]
    yield from lines([*STATIC, *made], [place])
    yield Heading(tr("Balancing in two planes"))
    yield Paragraph(tr("Weights in the planes I and II take resultant and couple away:"))
    for p, far in (("I", "z_II"), ("II", "z_I")):
        made = [f"m_{p} = U_{p}/r_k"] if result.dynamic else []
        yield from lines([*PLANES, *made], [place], {"p": p, "far": far})
        yield from (Result(f"{name}_{p}", place.lexicon[f"{name}_{p}"]) for name in ("m", "U") if made or name == "U")
    yield from _states(task.rotor, result)
    yield from _grade(task.rotor, result.grade, place)


def _quantities(task: RotorTask, result: BalancedRotor) -> Lexicon:
    rotor, balance = task.rotor, result.balance
    parts, before = rotor.unbalances, result.balance.before
    plane, bearing = tr("place of the plane of correction along the axis"), tr("place of the bearing along the axis")
    found: Lexicon = {
        "m_i": Given([each.mass for each in parts], "kg", tr("unbalanced mass")),
        "r_i": Given([each.radius for each in parts], "m", tr("its distance from the axis")),
        "alpha_i": Given([math.degrees(each.angle) for each in parts], "deg", tr("its angle")),
        "z_i": Given([each.position for each in parts], "m", tr("its place along the axis")),
        "m": Given(rotor.mass, "kg", tr("mass of the rotor")),
        "n_R": Given(rotor.speed * RPM, "rpm", tr("highest service speed")),
        "omega": Given(rotor.speed, "rad/s", tr("angular velocity of the rotor")),
        "z_S": Given(rotor.center, "m", tr("place of the centre of mass along the axis")),
        "z_A": Given(rotor.bearings[0], "m", bearing),
        "z_B": Given(rotor.bearings[1], "m", bearing),
        "z_I": Given(balance.planes[0], "m", plane),
        "z_II": Given(balance.planes[1], "m", plane),
        "e": Given(1000 * before.eccentricity, "mm", tr("shift of the centre of mass")),
        **_polar("U", before.resultant, MOMENT, tr("resultant static moment")),
        **_polar("K", before.couple, COUPLE, tr("couple of the unbalance")),
        **_polar("A", before.loads[0], "N", tr("load of bearing {bearing}", bearing="A")),
        **_polar("B", before.loads[1], "N", tr("load of bearing {bearing}", bearing="B")),
        **_correction("s", balance.static_moment, result.static),
    }
    made: Sequence[Weight | None] = result.dynamic or (None, None)
    for p, moment, weight in zip(("I", "II"), balance.moments, made, strict=True):
        found |= _correction(p, moment, weight)
    if task.radius is not None:
        found["r_k"] = Given(task.radius, "m", tr("radius of the correction weights"))
    return found


def _polar(name: str, value: complex, unit: str, meaning: str) -> Lexicon:
    """Projections and size of a vector."""
    return {
        f"{name}_x": Given(value.real, unit, tr("projections on the axes of the rotor")),
        f"{name}_y": Given(value.imag, unit, tr("projections on the axes of the rotor")),
        name: Given(abs(value), unit, meaning),
    }


def _correction(mark: str, moment: complex, weight: Weight | None) -> Lexicon:
    """A static moment of correction with its direction, and the mass that has it."""
    found = {
        f"U_{{{mark}x}}": Given(moment.real, MOMENT, tr("projections on the axes of the rotor")),
        f"U_{{{mark}y}}": Given(moment.imag, MOMENT, tr("projections on the axes of the rotor")),
        f"U_{mark}": Given(abs(moment), MOMENT, tr("static moment of the correction")),
        f"psi_{mark}": Given(math.degrees(cmath.phase(moment)), "deg", tr("angle of the correction")),
    }
    if weight is not None:
        found[f"m_{mark}"] = Given(weight.mass, "kg", tr("mass of the correction"))
    return found


def _masses_table(rotor: Rotor) -> Block:
    parts = rotor.unbalances
    columns = {
        "$m_i$, kg": [each.mass for each in parts],
        "$r_i$, m": [each.radius for each in parts],
        "$alpha_i$, deg": [math.degrees(each.angle) for each in parts],
        "$z_i$, m": [each.position for each in parts],
    }
    labels = [str(k) for k in range(1, len(parts) + 1)]
    return tabulated(tr("Unbalanced masses"), columns, labels, head="$i$", key="rotor_masses")


def _states(rotor: Rotor, result: BalancedRotor) -> Iterator[Block]:
    """What each balancing leaves."""
    balance = result.balance
    states = (balance.before, balance.static, balance.dynamic)
    peak = max(abs(each.moment) for each in rotor.unbalances)
    yield Paragraph(tr("Table {tab:rotor_states} has the shift of the centre of mass and the loads that are left."))
    columns = {
        "$e$, mm": [1000 * _told(each.eccentricity, peak / rotor.mass) for each in states],
        "$A$, N": [_told(each.load_a, peak * rotor.speed**2) for each in states],
        "$B$, N": [_told(each.load_b, peak * rotor.speed**2) for each in states],
    }
    labels = (tr("as it is"), tr("one plane"), tr("two planes"))
    yield tabulated(tr("The rotor before and after balancing"), columns, labels, head=tr("State"), key="rotor_states")


def _told(value: float, peak: float) -> float:
    return value if abs(value) > NOISE * peak else 0.0


def _grade(rotor: Rotor, grades: Sequence[RotorVerdict], place: Place) -> Iterator[Block]:
    """What the grade allows in the planes of the bearings, and which state keeps it."""
    if not grades:
        return
    first = grades[0]
    yield Heading(tr("Balance quality"))
    yield Paragraph(
        tr(
            "By ISO 21940-11 the grade $G$ is the permissible speed of the centre of mass about the axis, mm/s. The "
            "permissible unbalance is shared between the planes of the bearings by their distances from the centre of "
            "mass."
        )
    )
    place.lexicon.update(
        named(
            {
                "G": Given(first.grade, "mm/s", tr("grade of balance quality")),
                "U_p": Given(first.permissible, MOMENT, tr("permissible unbalance")),
                "U_{pA}": Given(first.allowed_a, MOMENT, _in_plane("A")),
                "U_{pB}": Given(first.allowed_b, MOMENT, _in_plane("B")),
            }
        )
    )
    speed = "omega" if rotor.speed > 0 else "abs(omega)"
    yield from lines([f"U_p = G*m/(1000*{speed})", *_shares(rotor)], [place])
    yield Paragraph(tr("The unbalance in the plane of a bearing is its load over $omega**2$; table {tab:rotor_grade}."))
    found = {
        tr("State"): [tr("as it is"), tr("one plane"), tr("two planes")],
        "$U_A$/$U_{pA}$, %": column_of([_told(each.part_a, 100.0) for each in grades]),
        "$U_B$/$U_{pB}$, %": column_of([_told(each.part_b, 100.0) for each in grades]),
        tr("Condition"): [tr("holds") if each.passed else tr("fails") for each in grades],
    }
    cells = tuple(zip(*found.values(), strict=True))
    yield Table(tr("Unbalance against the permissible one"), tuple(found), cells, "rotor_grade")
    for bearing, part in (("A", grades[-1].part_a), ("B", grades[-1].part_b)):
        left = Given(
            _told(part, 100.0),
            "%",
            tr("unbalance over the permissible one in the plane of bearing {bearing}", bearing=bearing),
        )
        yield Result(f"U_{bearing}/U_{{p{bearing}}}", left, 100.0, "<=", tr("two planes"))


def _in_plane(bearing: str) -> str:
    return tr("permissible unbalance in the plane of bearing {bearing}", bearing=bearing)


def _shares(rotor: Rotor) -> Iterator[str]:
    """The parts of the permissible unbalance, within their limits."""
    a, b = rotor.bearings
    most = INBOARD if min(a, b) <= rotor.center <= max(a, b) else OUTBOARD
    for name, way, arm in (("A", "z_B - z_S", b - rotor.center), ("B", "z_S - z_A", rotor.center - a)):
        share = abs(arm / (b - a))
        if LEAST <= share <= most:
            yield f"U_{{p{name}}} = U_p*abs(({way})/(z_B - z_A))"
        else:
            yield f"U_{{p{name}}} = {min(max(share, LEAST), most):g}*U_p"
