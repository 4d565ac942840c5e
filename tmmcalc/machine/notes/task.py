"""What is given of a machine: its motor, the gears to it, the unevenness of its speed, its flywheel."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from tmmcalc.machine.notes.motors import motor_data
from tmmcalc.machine.power import Power
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum


def blocks(order: Order) -> Iterator[Block]:
    """The data, without those that the program has found."""
    spec, power = order.spec, order.results.get("power")
    if power is not None and power.duty is not None and not power.duty.chosen:
        yield from _motor(power, given_ratio=spec.transmission is not None and spec.transmission.ratio is not None)
    if spec.motion is not None and spec.motion.inertia:
        said = tr("further constant moment of inertia of the input link")
        yield Datum(said, ("J_e",), (spec.motion.inertia,), "kg*m^2")
    flywheel = spec.flywheel
    if flywheel is None:
        return
    words: Mapping[str, tuple[float | None, str, str]] = {
        "delta_0": (flywheel.delta, "", tr("allowed coefficient of speed fluctuation")),
        "J_f": (flywheel.inertia, "kg*m^2", tr("moment of inertia of the flywheel")),
        "D": (flywheel.diameter, "m", tr("mean diameter of the rim")),
        "b": (flywheel.width, "m", tr("width of the rim")),
    }
    for key, (value, unit, meaning) in words.items():
        if value is not None:
            yield Datum(meaning, (key,), (value,), unit)


def _motor(power: Power, *, given_ratio: bool) -> Iterator[Datum]:
    """The plate of the motor."""
    assert power.duty is not None
    left_out = {"eta_u"} if given_ratio else {"eta_u", "u"}
    known = motor_data(power.duty.motor, power)
    if power.duty.motor.inertia:
        known["J_R"] = Given(power.duty.motor.inertia, "kg*m^2", tr("moment of inertia of the rotor"))
    for key, given in known.items():
        if key not in left_out and isinstance(given.value, float) and given.value:
            yield Datum(given.meaning, (key,), (given.value,), given.unit)
