"""All methods for the flywheel in one table: what each asks for, how far it is off, what the real drive makes of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.errors import NoSolutionError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.positional import FlywheelMethod, positional_flywheels
from tmmcalc.machine.flywheel.trials import RequiredInertia
from tmmcalc.records import record

if TYPE_CHECKING:
    from tmmcalc.machine.motors.characteristics import Characteristic


@record
class Row:
    """One method in the comparison; the last two are None without a motor, or where the machine stalls."""

    positional: FlywheelMethod  # what it asks for under forces of position
    delta: float | None  # coefficient reached under the motor's characteristic [-]
    error: float | None  # relative error of the total constant inertia against the true one [-]


@record
class Comparison:
    """The methods for forces of position beside the true flywheel."""

    rows: tuple[Row, ...]
    required: RequiredInertia | None  # None without a motor


def compared(
    cycle: Cycle,
    constant_inertia: float,
    delta: float,
    *,
    speed: float | None = None,
    characteristic: Characteristic | None = None,
    time_constant: float = 0.0,
    sense: float = 1.0,
) -> Comparison:
    """Every method of `positional_flywheels`, and with a motor each tried under it beside `required_inertia`.

    ``speed`` [rad/s] is the mean speed that the methods assume: by default the cycle's own, with a motor the
    mean speed that it really keeps with the true flywheel. ``sense`` is -1 where the input turns clockwise.
    """
    if characteristic is None:
        methods = positional_flywheels(cycle, constant_inertia, delta, speed)
        return Comparison(tuple(Row(method, None, None) for method in methods), None)
    from tmmcalc.machine.flywheel.required import required_inertia

    true = required_inertia(cycle, characteristic, delta, constant_inertia, time_constant, sense=sense)
    methods = positional_flywheels(cycle, constant_inertia, delta, true.regime.mean if speed is None else speed)
    rows = tuple(
        _row(method, cycle, constant_inertia + method.addition, characteristic, time_constant, true)
        for method in methods
    )
    return Comparison(rows, true)


def _row(
    method: FlywheelMethod,
    cycle: Cycle,
    inertia: float,
    characteristic: Characteristic,
    time_constant: float,
    true: RequiredInertia,
) -> Row:
    from tmmcalc.machine.steady import driven

    error = (inertia - true.inertia) / true.inertia
    try:
        regime = driven(cycle, inertia, characteristic, time_constant=time_constant, guess=true.regime)
    except NoSolutionError:
        return Row(method, None, error)
    return Row(method, regime.delta, error)
