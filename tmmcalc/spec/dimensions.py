"""The closed table of dimensions and units.

As is usual in the field, ``1/min`` counts revolutions (it is rpm) and ``1/s`` counts radians (it is rad/s).
Each factor is an exact ratio of integers, times pi where the unit needs it.
"""

from __future__ import annotations

from typing import NamedTuple


class Dimension(NamedTuple):
    """A kind of quantity: its name with the article, its SI unit, and an example of a string."""

    noun: str
    si: str
    example: str


class Factor(NamedTuple):
    """SI value of one unit: ``num / den``, times pi if ``pi``."""

    num: int = 1
    den: int = 1
    pi: bool = False


DIMENSIONS = {
    "length": Dimension("a length", "m", "200 mm"),
    "mass": Dimension("a mass", "kg", "55 kg"),
    "time": Dimension("a time", "s", "0.5 s"),
    "angle": Dimension("an angle", "rad", "30 deg"),
    "angular speed": Dimension("an angular speed", "rad/s", "55 rpm"),
    "angular acceleration": Dimension("an angular acceleration", "rad/s^2", "2 rad/s^2"),
    "speed": Dimension("a speed", "m/s", "0.2 m/s"),
    "acceleration": Dimension("an acceleration", "m/s^2", "9.81 m/s^2"),
    "force": Dimension("a force", "N", "1.5 kN"),
    "moment": Dimension("a moment", "N*m", "40 N*m"),
    "inertia": Dimension("a moment of inertia", "kg*m^2", "4.5 kg*m^2"),
    "static moment": Dimension("a static moment", "kg*m", "12 g*mm"),
    "power": Dimension("a power", "W", "1.1 kW"),
    "energy": Dimension("an energy", "J", "250 J"),
    "area": Dimension("an area", "m^2", "50 cm^2"),
    "pressure": Dimension("a pressure", "Pa", "600 MPa"),
    "stiffness": Dimension("a stiffness", "N/m", "30 N/mm"),
    "torsional stiffness": Dimension("a torsional stiffness", "N*m/rad", "5000 N*m/rad"),
    "damping": Dimension("a damping coefficient", "N*s/m", "20 N*s/m"),
    "torsional damping": Dimension("a torsional damping coefficient", "N*m*s/rad", "0.5 N*m*s/rad"),
    "quadratic damping": Dimension("a coefficient of quadratic resistance", "N*s^2/m^2", "3.5 N*s^2/m^2"),
    "torsional quadratic damping": Dimension(
        "a torsional coefficient of quadratic resistance", "N*m*s^2/rad^2", "0.02 N*m*s^2/rad^2"
    ),
    # GD^2 of the catalogues: its unit is the technical one by custom, and a quarter of the number is kg*m^2
    "flywheel moment": Dimension("a flywheel moment GD^2", "kgf*m^2", "0.11 kgf*m^2"),
    "voltage": Dimension("a voltage", "V", "220 V"),
    "resistance": Dimension("an electrical resistance", "ohm", "0.5 ohm"),
    "motor constant": Dimension("a motor constant", "V*s/rad", "1.4 V*s/rad"),
    "frequency": Dimension("a frequency", "Hz", "50 Hz"),
    "density": Dimension("a density", "kg/m^3", "7850 kg/m^3"),
}

_RPM = Factor(1, 30, pi=True)

UNITS: dict[str, dict[str, Factor]] = {
    "length": {
        "m": Factor(),
        "mm": Factor(1, 1000),
        "cm": Factor(1, 100),
        "um": Factor(1, 10**6),
        "km": Factor(1000),
    },
    "mass": {"kg": Factor(), "g": Factor(1, 1000), "t": Factor(1000)},
    "time": {"s": Factor(), "ms": Factor(1, 1000), "min": Factor(60), "h": Factor(3600)},
    "angle": {
        "rad": Factor(),
        "deg": Factor(1, 180, pi=True),
        "°": Factor(1, 180, pi=True),
        "arcmin": Factor(1, 10800, pi=True),
        "rev": Factor(2, pi=True),
    },
    "angular speed": {
        "rad/s": Factor(),
        "1/s": Factor(),
        "s^-1": Factor(),
        "rpm": _RPM,
        "1/min": _RPM,
        "min^-1": _RPM,
        "rev/min": _RPM,
        "rev/s": Factor(2, pi=True),
        "deg/s": Factor(1, 180, pi=True),
    },
    "angular acceleration": {
        "rad/s^2": Factor(),
        "1/s^2": Factor(),
        "s^-2": Factor(),
        "deg/s^2": Factor(1, 180, pi=True),
    },
    "speed": {"m/s": Factor(), "mm/s": Factor(1, 1000), "m/min": Factor(1, 60), "km/h": Factor(5, 18)},
    "acceleration": {"m/s^2": Factor(), "mm/s^2": Factor(1, 1000)},
    "force": {"N": Factor(), "kN": Factor(1000), "MN": Factor(10**6)},
    "moment": {"N*m": Factor(), "kN*m": Factor(1000), "N*mm": Factor(1, 1000)},
    "inertia": {
        "kg*m^2": Factor(),
        "kg*cm^2": Factor(1, 10**4),
        "kg*mm^2": Factor(1, 10**6),
        "g*cm^2": Factor(1, 10**7),
    },
    "static moment": {
        "kg*m": Factor(),
        "kg*cm": Factor(1, 100),
        "kg*mm": Factor(1, 1000),
        "g*m": Factor(1, 1000),
        "g*cm": Factor(1, 10**5),
        "g*mm": Factor(1, 10**6),
    },
    "power": {"W": Factor(), "kW": Factor(1000), "MW": Factor(10**6)},
    "energy": {"J": Factor(), "kJ": Factor(1000)},
    "area": {"m^2": Factor(), "cm^2": Factor(1, 10**4), "mm^2": Factor(1, 10**6)},
    "pressure": {
        "Pa": Factor(),
        "kPa": Factor(1000),
        "MPa": Factor(10**6),
        "N/mm^2": Factor(10**6),
        "bar": Factor(10**5),
    },
    "stiffness": {"N/m": Factor(), "N/mm": Factor(1000), "kN/m": Factor(1000)},
    "torsional stiffness": {"N*m/rad": Factor(), "kN*m/rad": Factor(1000)},
    "damping": {"N*s/m": Factor(), "kN*s/m": Factor(1000), "kg/s": Factor()},
    "torsional damping": {"N*m*s/rad": Factor(), "N*m*s": Factor()},
    "quadratic damping": {"N*s^2/m^2": Factor(), "kg/m": Factor()},
    "torsional quadratic damping": {"N*m*s^2/rad^2": Factor(), "N*m*s^2": Factor()},
    "flywheel moment": {"kgf*m^2": Factor(), "N*m^2": Factor(10**5, 980665)},
    "voltage": {"V": Factor(), "kV": Factor(1000)},
    "resistance": {"ohm": Factor(), "Ω": Factor()},
    "motor constant": {"V*s/rad": Factor(), "V*s": Factor()},
    "frequency": {"Hz": Factor()},
    "density": {"kg/m^3": Factor()},
}
