"""The flywheel itself: its shaft, its rim with sizes, mass, speed and stress, and what it would be elsewhere."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.machine.flywheel.placement import TOO_FAST, Wheel
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.rim import DEFAULT, POISSON, Rim
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.stages.motion import wheel_of
from tmmcalc.machine.tables.tasks.machine import to_flywheel
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import held, lines, named, row_of

MEGA = 1e6


def of_wheel(order: Order) -> Iterator[Block]:
    """Where the needed flywheel stands, its rim, the other shafts; without one the flywheel that is there."""
    result: Flywheel = order.results["flywheel"]
    task = to_flywheel(order.spec)
    assert task is not None
    if result.addition > 0:
        yield Heading(tr("Sizes of the flywheel"), 2)
        reduced = Given(result.addition, "kg*m^2", tr("moment of inertia of the flywheel, reduced to the input link"))
        yield from _sized(result.wheels[0], task, "J_M", reduced)
        if len(result.wheels) > 1:
            yield from _elsewhere(result)
        if result.existing:
            yield Paragraph(tr("The flywheel that is there, $J_f$, against the needed one:"))
            sides = (result.existing, result.addition)
            yield held("J_f >= J_M", sides, "kg*m^2", holds=bool(result.sufficient))
    elif "motion" in order.results and (wheel := wheel_of(order.results["motion"], task, order.results)) is not None:
        yield Heading(tr("Sizes of the flywheel that is there"), 2)
        yield from _sized(wheel, task, "J_f", Given(result.existing, "kg*m^2", tr("moment of inertia of the flywheel")))


def _sized(wheel: Wheel, task: FlywheelTask, name: str, reduced: Given) -> Iterator[Block]:
    """Its shaft, and its rim, if it has one; ``reduced`` to the input link its inertia has this name."""
    own, inertia = name, reduced
    if wheel.ratio == 1:
        yield Paragraph(tr("The flywheel stands on the input shaft."))
    else:
        own, said = f"{name}1", tr("moment of inertia of the flywheel on its own shaft")
        inertia = Given(wheel.inertia, "kg*m^2", said)
        yield Paragraph(
            tr("The flywheel stands on the shaft of the motor.")
            if wheel.shaft == "motor"
            else tr("The flywheel stands on a shaft of its own.")
        )
        ratio = Given(wheel.ratio, "", tr("speed of the flywheel over the speed of the input link"))
        at = Place("", named({own: inertia, name: reduced, "u_M": ratio}))
        yield from lines((f"{own} = {name}/u_M**2",), [at])
    for verdict in wheel.verdicts:
        if verdict.name != TOO_FAST:  # which is told with the speed
            said = tr_name(verdict.message)
            yield Paragraph(f"{said[:1].upper()}{said[1:]}.")
    if wheel.rim is not None:
        yield from _rim(wheel, wheel.rim, task, (own, inertia))


def _rim(wheel: Wheel, rim: Rim, task: FlywheelTask, whole: tuple[str, Given]) -> Iterator[Block]:
    """Its sizes, mass, speed and stresses; ``whole`` is the name of the flywheel's inertia with its value."""
    own, inertia = whole
    material = rim.material
    lexicon = named({own: inertia, **_of_rim(wheel, rim)})
    place = [Place("", lexicon)]
    yield Paragraph(
        tr("The rim is of {material}; it carries this part of the moment of inertia:", material=tr_name(material.name))
    )
    yield from lines((f"J_r = c_J*{own}",), place)
    yield Paragraph(_sizes_said(task))
    fixed = () if task.width is not None or task.thickness is not None else ("b_r = c_b*h_r",)
    yield from lines((*fixed, "J_r = pi*rho_r*b_r*h_r*D*(D**2 + h_r**2)/4", "D_o = D + h_r", "D_i = D - h_r"), place)
    yield Paragraph(tr("Mass of the rim, and of the whole flywheel with hub and arms:"))
    yield from lines(("m_r = pi*rho_r*b_r*h_r*D", "m_M = m_r/c_m"), place)
    yield Paragraph(tr("A thin rim that carries the whole moment of inertia would have the mass"))
    yield from lines((f"m_t = 4*{own}/D**2",), place)
    yield Paragraph(tr("Speed of the edge of the rim, against the permissible speed $v_a$ of the material:"))
    yield from lines(("v_o = omega_M*D_o/2",), place)
    yield held("v_o <= v_a", (rim.speed, material.rim_speed), "m/s", holds=rim.allowed)
    yield Result("m_M", lexicon["m_M"])
    limit = max(material.rim_speed, rim.speed) if rim.allowed else material.rim_speed
    yield Result("v_o", lexicon["v_o"], limit, "<=")
    yield Paragraph(
        tr("Stress in the rim as in a thin ring, the largest one in it as in a full ring, and the safety factor:")
    )
    texts = (
        "sigma_t = rho_r*(omega_M*D/2)**2/10**6",
        "sigma_r = rho_r*omega_M**2*((3 + nu)*D_o**2 + (1 - nu)*D_i**2)/(16*10**6)",
        "n_s = sigma_B/sigma_r",
    )
    yield from lines(texts, place)


def _sizes_said(task: FlywheelTask) -> str:
    """Which sizes are given, and which follows."""
    given = [
        word for word, size in (("D", task.diameter), ("b", task.width), ("h", task.thickness)) if size is not None
    ]
    return {
        "Db": tr("With the given mean diameter $D$ and width $b_r$ the thickness $h_r$ follows from the equation"),
        "Dh": tr("With the given mean diameter $D$ and thickness $h_r$ the width $b_r$ follows from the equation"),
        "bh": tr("With the given width $b_r$ and thickness $h_r$ the mean diameter $D$ follows from the equation"),
        "D": tr("With the given mean diameter $D$ and the customary ratio of width and thickness these follow from"),
        "": tr("With customary proportions of the rim its sizes follow from"),
    }["".join(given)]


def _of_rim(wheel: Wheel, rim: Rim) -> Lexicon:
    """The sizes of the rim and what it is loaded with, by their letters."""
    material = rim.material
    share = tr("share of the rim in the moment of inertia")
    return {
        "J_r": Given(rim.inertia, "kg*m^2", tr("moment of inertia of the rim")),
        "c_J": Given(DEFAULT.rim_inertia, "", share),
        "c_m": Given(DEFAULT.rim_mass, "", tr("share of the rim in the mass")),
        "c_b": Given(DEFAULT.width_to_thickness, "", tr("ratio of width and thickness")),
        "rho_r": Given(material.density, "kg/m^3", tr("density")),
        "b_r": Given(rim.width, "m", tr("width of the rim")),
        "h_r": Given(rim.thickness, "m", tr("thickness of the rim")),
        "D": Given(rim.diameter, "m", tr("mean diameter of the rim")),
        "D_o": Given(rim.outer, "m", tr("outer diameter of the rim")),
        "D_i": Given(rim.inner, "m", tr("inner diameter of the rim")),
        "m_r": Given(rim.mass, "kg", tr("mass of the rim")),
        "m_M": Given(rim.total_mass, "kg", tr("mass of the flywheel")),
        "m_t": Given(rim.thin_mass, "kg", tr("mass of a thin rim")),
        "v_o": Given(rim.speed, "m/s", tr("speed of the edge of the rim")),
        "omega_M": Given(wheel.speed, "rad/s", tr("largest angular velocity of the flywheel")),
        "sigma_t": Given(rim.stress / MEGA, "MPa", tr("stress as in a thin ring")),
        "sigma_r": Given(rim.peak_stress / MEGA, "MPa", tr("largest stress as in a full ring")),
        "sigma_B": Given(material.strength / MEGA, "MPa", tr("tensile strength")),
        "nu": Given(POISSON, "", tr("Poisson's ratio")),
        "n_s": Given(rim.safety, "", tr("safety factor")),
    }


def _elsewhere(result: Flywheel) -> Iterator[Block]:
    """The same flywheel on the other shafts."""
    yield Paragraph(
        tr(
            "On another shaft the flywheel would have other sizes, because its moment of inertia falls with the "
            "square of the speed ratio, table {tab:flywheel_shafts}."
        )
    )
    names = {"input": tr("input shaft"), "motor": tr("shaft of the motor"), "other": tr("shaft of its own")}

    def of_rims(what: str) -> list[float]:
        return [math.nan if wheel.rim is None else getattr(wheel.rim, what) for wheel in result.wheels]

    rows = (
        row_of("$u_M$", "", [wheel.ratio for wheel in result.wheels]),
        row_of("$J_M1$", "kg*m^2", [wheel.inertia for wheel in result.wheels]),
        row_of("$D$", "m", of_rims("diameter")),
        row_of("$m_r$", "kg", of_rims("mass")),
        row_of("$v_o$", "m/s", of_rims("speed")),
    )
    head = (tr("Quantity"), *(names[wheel.shaft] for wheel in result.wheels))
    yield Table(tr("The flywheel on different shafts"), head, rows, "flywheel_shafts")
