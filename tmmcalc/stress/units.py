"""Units of length, mass and time changed together: what a number becomes, by the unit that it has.

The equations of mechanics know no unit, so a scene whose lengths, masses and times are multiplied by three factors has
the same dimensionless results. Currents stay as they are, and voltages follow the power.
"""

from __future__ import annotations

import re

from tmmcalc.core.records import record

Powers = tuple[float, float, float]  # of length, mass and time

_BASE: dict[str, Powers] = {
    "m": (1, 0, 0),
    "kg": (0, 1, 0),
    "s": (0, 0, 1),
    "N": (1, 1, -2),
    "Pa": (-1, 1, -2),
    "J": (2, 1, -2),
    "W": (2, 1, -3),
    "Hz": (0, 0, -1),
    "V": (2, 1, -3),
    "ohm": (2, 1, -3),
    "kgf": (0, 1, 0),  # of the GD^2 of the catalogues, a mass by custom
    "g": (0, 1, 0),
    "t": (0, 1, 0),
    "rpm": (0, 0, -1),
    "rad": (0, 0, 0),
    "deg": (0, 0, 0),
    "%": (0, 0, 0),
    "-": (0, 0, 0),
    "": (0, 0, 0),
    "1": (0, 0, 0),
}
_PREFIXES = "numkMG"
_TOKEN = re.compile(r"([*/]?)\s*([A-Za-z%\-]+|1)(?:\^(-?\d+(?:\.\d+)?))?")


@record
class Factors:
    """What lengths, masses and times are multiplied by."""

    length: float = 1.0
    mass: float = 1.0
    time: float = 1.0

    def of(self, unit: str) -> float:
        """The factor of a number in ``unit``; raises KeyError for a unit that is not known.

        >>> Factors(2, 3, 5).of("kg*m^2"), Factors(2, 3, 5).of("N*mm"), Factors(2, 3, 5).of("rad/s")
        (12.0, 0.48, 0.2)
        """
        length, mass, time = powers(unit)
        return float(self.length**length * self.mass**mass * self.time**time)


def powers(unit: str) -> Powers:
    """Powers of length, mass and time in a unit.

    >>> powers("N*m*s^2/rad^2")
    (2.0, 1.0, 0.0)
    """
    total = [0.0, 0.0, 0.0]
    for sign, name, power in _TOKEN.findall(unit):
        exponent = float(power or 1) * (-1 if sign == "/" else 1)
        for k, each in enumerate(_base(name)):
            total[k] += exponent * each
    return total[0], total[1], total[2]


def _base(name: str) -> Powers:
    return _BASE[name] if name in _BASE else _BASE[name[1:]] if name[0] in _PREFIXES else _BASE[name]
