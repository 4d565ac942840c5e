"""What is given of the flywheel: the unevenness that it keeps, its shaft, its rim."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from tmmcalc.machine.flywheel.materials import Material
from tmmcalc.machine.flywheel.placement import rim_material
from tmmcalc.machine.flywheel.rim import DEFAULT
from tmmcalc.machine.tables.flywheel import FlywheelTable
from tmmcalc.machine.tables.tasks.machine import to_flywheel
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Datum


def of_flywheel(order: Order) -> Iterator[Datum]:
    """The flywheel that is asked for, or the one that is there."""
    table: FlywheelTable | None = order.spec.flywheel
    if table is None:
        return
    words: Mapping[str, tuple[float | None, str, str]] = {
        "delta_0": (table.delta, "", tr("allowed coefficient of speed fluctuation")),
        "J_f": (table.inertia, "kg*m^2", tr("moment of inertia of the flywheel")),
        "D": (table.diameter, "m", tr("mean diameter of the rim")),
        "b_r": (table.width, "m", tr("width of the rim")),
        "h_r": (table.thickness, "m", tr("thickness of the rim")),
    }
    for key, (value, unit, meaning) in words.items():
        if value is not None:
            yield Datum(meaning, (key,), (value,), unit)
    if table.shaft == "motor":
        yield Datum(tr("shaft of the flywheel"), text=tr("that of the motor"))
    if table.ratio is not None:
        yield Datum(tr("speed of the flywheel over the speed of the input link"), ("u_M",), (table.ratio,))
    if "flywheel" in order.results:
        proportioned = table.width is None and table.thickness is None
        task = to_flywheel(order.spec)
        assert task is not None
        yield from _rim(rim_material(task), proportioned=proportioned)


def _rim(material: Material, *, proportioned: bool) -> Iterator[Datum]:
    """What is taken for a rim, beyond its sizes, whether one is found to be needed or not."""
    yield Datum(tr("what the rim is made of"), text=tr_name(material.name))
    yield Datum(tr_name("density of the rim"), ("rho_r",), (material.density,), "kg/m^3")
    yield Datum(tr("highest allowed speed of the rim"), ("v_a",), (material.rim_speed,), "m/s")
    yield Datum(tr("share of the rim in the moment of inertia"), ("c_J",), (DEFAULT.rim_inertia,))
    yield Datum(tr("share of the rim in the mass"), ("c_m",), (DEFAULT.rim_mass,))
    if proportioned:
        yield Datum(tr("ratio of width and thickness"), ("c_b",), (DEFAULT.width_to_thickness,))
