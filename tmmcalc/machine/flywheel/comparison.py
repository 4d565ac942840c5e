"""All methods for the flywheel in one table: what each asks for, how far it is off, what the real drive makes of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.methods import positional_flywheels
from tmmcalc.machine.flywheel.results import Comparison, RequiredInertia, Row

if TYPE_CHECKING:
    from tmmcalc.machine.flywheel.search import Model
    from tmmcalc.machine.motors.characteristics import Characteristic


def compared(
    cycle: Cycle,
    constant_inertia: float,
    delta: float,
    *,
    speed: float | None = None,
    characteristic: Characteristic | None = None,
    time_constant: float = 0.0,
    sense: float = 1.0,
    tried: bool = True,
) -> Comparison:
    """Every method of `positional_flywheels`, and with a motor each ``tried`` under it beside `required_inertia`.

    ``speed`` [rad/s] is the mean speed that the methods assume: by default the cycle's own, with a motor the
    mean speed that it really keeps with the true flywheel. ``sense`` is -1 where the input turns clockwise. Untried
    methods take most of the time away, and with them what would just carry a machine that stalls without a flywheel.
    """
    if characteristic is None:
        methods = positional_flywheels(cycle, constant_inertia, delta, speed)
        return Comparison(tuple(Row(method, None, None) for method in methods), None)
    from tmmcalc.machine.flywheel.required import required_inertia
    from tmmcalc.machine.steady import driven

    true = required_inertia(cycle, characteristic, delta, constant_inertia, time_constant, sense=sense, remarked=tried)

    def reached(inertia: float) -> float | None:
        try:
            return driven(cycle, inertia, characteristic, time_constant=time_constant, guess=true.regime).delta
        except NoSolutionError:
            return None

    return comparison_with(cycle, constant_inertia, delta, true, reached if tried else None, speed)


def comparison_with(
    cycle: Cycle,
    constant_inertia: float,
    delta: float,
    true: RequiredInertia,
    reached: Model | None = None,
    speed: float | None = None,
) -> Comparison:
    """The methods beside the ``true`` flywheel; ``reached`` tells what delta an inertia leads to, if tried."""
    methods = positional_flywheels(cycle, constant_inertia, delta, true.regime.mean if speed is None else speed)
    inertias = [constant_inertia + method.addition for method in methods]
    rows = (
        Row(method, reached and reached(inertia), (inertia - true.inertia) / true.inertia)
        for method, inertia in zip(methods, inertias, strict=True)
    )
    return Comparison(tuple(rows), true)
